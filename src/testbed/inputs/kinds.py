"""Scenario, sweep, search or matrix: which of them a file is, by the keys that only one kind has."""

from __future__ import annotations

from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import Source

COMMANDS = {"scenario": "run", "sweep": "sweep", "search": "search", "matrix": "matrix"}
"""The command that takes each kind of file."""
_SCENARIO, _SWEEP, _SEARCH = ("aircraft", "duration_s"), ("vary", "cases", "scenario"), ("goal",)

_MATRIX = ("failures", "severities", "weather", "seeds", "at_s", "baseline")


def is_sweep(tree: object) -> bool:
    """Whether the tree of a YAML file is that of a study, a sweep or a search, which has a key that no scenario has."""
    return isinstance(tree, dict) and any(key in tree for key in _SWEEP)


def is_search(tree: object) -> bool:
    """Whether the tree of a YAML file is that of a search, which has a key that no sweep and no scenario has."""
    return isinstance(tree, dict) and any(key in tree for key in _SEARCH)


def is_matrix(tree: object) -> bool:
    """Whether the tree of a YAML file is that of a matrix: a study of a scenario, with a key that no other study has."""
    return isinstance(tree, dict) and "scenario" in tree and any(key in tree for key in _MATRIX)


def refuse_other(source: Source, wanted: str) -> None:
    """Raise BadInput when a file is clearly of another kind: else each of its keys would be refused by itself."""
    tree = source.tree
    if any(key in tree for key in _SCENARIO):
        kind = "" if is_sweep(tree) or is_search(tree) else "scenario"
    else:
        kind = "search" if is_search(tree) else "sweep" if is_sweep(tree) else ""
        kind = "matrix" if is_matrix(tree) else kind
    if kind in ("", wanted):
        return
    expected = f"a {wanted}; `testbed {COMMANDS[kind]}` takes this file"
    if (kind, wanted) == ("sweep", "search"):
        expected += ", and so does `testbed search --goal`"
    raise BadInput([source.problem((), f"is a {kind}", expected)])
