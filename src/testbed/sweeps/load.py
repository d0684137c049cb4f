"""Load a sweep file: read its YAML, apply `--set`, validate its keys, and resolve it into a plan."""

from __future__ import annotations

import copy
import itertools
import json
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.aircraft.shipped import find_scenario
from testbed.controllers.user.own import OwnController
from testbed.inputs import overrides
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source, TreePath, describe
from testbed.sweeps.drawing.builder import TYPE, Builder, Variant
from testbed.sweeps.drawing.cases import read_cases
from testbed.sweeps.model import MOST_FLIGHTS, MOST_LEVELS, Sweep
from testbed.sweeps.plan import Plan

DEFAULT_RUNS = 1000
_MAPPINGS = ("set", "vary", "compare")
"""Keys of a sweep that hold a mapping from dotted paths of the scenario."""


def load_sweep(
    path: str | Path, settings: Iterable[str] = (), own: Mapping[str, OwnController] | None = None
) -> Plan:
    """Read and resolve a sweep file; raises BadInput with every problem of its own keys.

    `settings` are KEY=VALUE. KEY is a key of the sweep (`runs=10`), or else a dotted path of the scenario
    (`duration_s=2`), which is then set for all runs. `own` are controllers of the user's, which are compared with those of
    the sweep. `checks.check` checks the scenarios that the plan draws.
    """
    source = yamlfile.read(find_scenario(path))
    _apply(source, settings)
    sweep = validated(Sweep, source, stand_ins={"scenario": "?"})
    _refuse_overwritten(sweep, source)
    base = _base(sweep, source)
    for key, value in sweep.set.items():
        overrides.set_value(base, key.split("."), value, _place(source, ("set", key)))
    if own:
        sweep = _comparing(own, sweep, source, base)
    unknown = {name: OwnController(name, *_split(text)) for name, text in sweep.controllers.items()}
    paths = [("vary", path) for path in sweep.vary] + [("compare", path) for path in sweep.compare]
    places = {path: _place(source, (kind, path)) for kind, path in paths}
    cases, text = None, None
    if sweep.cases is not None:
        file = Path(source.file).parent / sweep.cases
        cases, text, case_places = read_cases(file, source.problem(("cases",), "there is no such file"))
        places |= case_places
    variants = tuple(_variants(sweep))
    name = sweep.name or Path(path).stem.replace("_", " ")
    runs = _runs(sweep, source, cases)
    return Plan(sweep, name, Builder(base, variants, places, {**unknown, **(own or {})}), runs, cases, text)


def _apply(source: Source, settings: Iterable[str]) -> None:
    """Set keys of the sweep (`runs`, or `vary.` and a dotted path of the scenario); any other path goes into `set`."""
    for setting in settings:
        key, equals, text = setting.partition("=")
        first, _, rest = key.strip().partition(".")
        if equals and first not in Sweep.model_fields:
            first, rest = "set", key.strip()
        if not equals or first not in _MAPPINGS or not rest:
            overrides.apply(source, [setting])
            continue
        place = f"--set {setting}"
        value = yamlfile.parse(text)
        if source.tree.get(first) is None:
            source.tree[first] = {}
        overrides.set_value(source, [first, rest], value.tree, place)


def _refuse_overwritten(sweep: Sweep, source: Source) -> None:
    """Raise BadInput for keys of `set` without effect, because `vary` or `compare` replaces their value in every flight."""
    later = {path: kind for kind in ("vary", "compare") for path in getattr(sweep, kind)}
    problems = [
        source.problem(("set", key), f"has no effect: {kind} sets {path} in every flight", f"no {key} in set")
        for key in sweep.set
        for path, kind in later.items()
        if f"{key}.".startswith(f"{path}.")
    ]
    if problems:
        raise BadInput(problems)


def _base(sweep: Sweep, source: Source) -> Source:
    """The base scenario, from its own file or from inside the sweep file; places are those where it is written."""
    if isinstance(sweep.scenario, dict):
        places = {path[1:]: place for path, place in source.places.items() if path[:1] == ("scenario",)}
        return Source(source.file, copy.deepcopy(sweep.scenario), places)
    beside = Path(source.file).parent / sweep.scenario
    try:
        return yamlfile.read(beside if os.path.exists(beside) else find_scenario(sweep.scenario))
    except BadInput as error:
        missing = [p for p in error.problems if p.line is None and p.what == "there is no such file"]
        if not missing:
            raise
        raise BadInput([source.problem(("scenario",), f"there is no file {sweep.scenario!r}", "",
                                       missing[0].suggestion)]) from None  # fmt: skip


def _comparing(own: Mapping[str, OwnController], sweep: Sweep, source: Source, base: Source) -> Sweep:
    """The sweep with these controllers among those compared; raises BadInput where they cannot be."""
    if "controller" in sweep.compare:
        what = "compares whole controllers, beside which --controller has no place"
        raise BadInput(
            [source.problem(("compare", "controller"), what, f"{TYPE} in compare, or a list of types")]
        )
    chosen = base.tree.get("controller")
    flown = [chosen["type"]] if isinstance(chosen, dict) and "type" in chosen else []
    types = [*sweep.compare.get(TYPE, flown), *own]
    source.tree["compare"] = {**sweep.compare, TYPE: list(dict.fromkeys(types))}
    source.tree["controllers"] = {**sweep.controllers, **{name: o.reference for name, o in own.items()}}
    return validated(Sweep, source, stand_ins={"scenario": "?"})


def _split(reference: str) -> tuple[str, str]:
    file, _, made_by = reference.rpartition(":")
    return file, made_by


def _place(source: Source, path: TreePath) -> str:
    file, line = source.place(path)
    return file if line is None else f"{file}:{line}"


def _variants(sweep: Sweep) -> Iterator[Variant]:
    for values in itertools.product(*sweep.compare.values()):
        label = ", ".join(
            v if isinstance(v, str) else f"{path} {_shown(v)}"
            for path, v in zip(sweep.compare, values, strict=True)
        )
        yield Variant(label, dict(zip(sweep.compare, values, strict=True)))


def _shown(value: Any) -> str:
    """A compared value in a label: a mapping or a list as JSON, as the table has it."""
    return json.dumps(value, ensure_ascii=False) if isinstance(value, dict | list) else str(value)


def _runs(sweep: Sweep, source: Source, cases: list[dict[str, Any]] | None) -> int:
    total: int | None = None if cases is None else len(cases)
    if cases is None and sweep.sampling == "grid":
        sizes = [distribution.grid_size(sweep.levels) for distribution in sweep.vary.values()]
        total = math.prod(sizes)
        if total > MOST_FLIGHTS or max(sizes) > MOST_LEVELS:
            what, expected = (
                f"a grid of {total:.3g} runs",
                f"at most {MOST_FLIGHTS}, and {MOST_LEVELS} levels",
            )
            raise BadInput([source.problem(("sampling",), what, expected)])
    if total is not None and sweep.runs is not None and sweep.runs > total:
        what = f"is {describe(sweep.runs)}, there are {total}"
        raise BadInput([source.problem(("runs",), what, f"at most {total}, or no runs for all")])
    runs = sweep.runs or total or DEFAULT_RUNS
    flights = runs * math.prod(map(len, sweep.compare.values()))
    if flights > MOST_FLIGHTS:
        what = f"is {runs}, which is {flights} flights with what is compared"
        raise BadInput([source.problem(("runs",), what, f"at most {MOST_FLIGHTS} flights")])
    return runs
