"""Scenario, sweep, search or matrix: which of them a file is, by the keys that only one kind has."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import Source

_SCENARIO, _STUDY = ("aircraft", "duration_s"), ("vary", "cases", "scenario")
_MATRIX = ("failures", "severities", "weather", "seeds", "at_s", "baseline")


def study_in(tree: Mapping[str, Any]) -> str:
    """The kind of study that the tree of a YAML file is; "" for one that has no key of a study, as a scenario has none."""
    if "scenario" in tree and any(key in tree for key in _MATRIX):
        return "matrix"
    if "goal" in tree:
        return "search"
    return "sweep" if any(key in tree for key in _STUDY) else ""


def refuse_other(source: Source, wanted: str) -> None:
    """Raise BadInput when a file is clearly of another kind: else each of its keys would be refused by itself."""
    kind = study_in(source.tree)
    if any(key in source.tree for key in _SCENARIO):
        kind = "" if kind else "scenario"
    if kind in ("", wanted):
        return
    expected = f"a {wanted}; `testbed {'run' if kind == 'scenario' else kind}` takes this file"
    if (kind, wanted) == ("sweep", "search"):
        expected += ", and so does `testbed search --goal`"
    raise BadInput([source.problem((), f"is a {kind}", expected)])
