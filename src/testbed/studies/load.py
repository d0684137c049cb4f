"""Load a sweep file: read its YAML, apply `--set`, validate its keys, and resolve it into a plan. A search loads its study too.

Runs may be in a CSV table instead: a row for each run, columns named by dotted paths, cells with YAML values.
"""

from __future__ import annotations

import copy
import csv
import itertools
import json
import math
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from testbed.aircraft.shipped import find_scenario
from testbed.controllers.user.own import OwnController
from testbed.inputs import overrides
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.input_file import MEGABYTE, read_text
from testbed.inputs.kinds import refuse_other
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source, TreePath, describe
from testbed.scenario.load import default_at
from testbed.studies.drawing.builder import TYPE, Builder, Variant
from testbed.studies.model import MOST_FLIGHTS, MOST_LEVELS, Study, Sweep
from testbed.studies.plan import Plan

DEFAULT_RUNS = 1000
_MAPPINGS = ("set", "vary", "compare")
"""Keys of a study that hold a mapping from dotted paths of the scenario."""
AnyStudy = TypeVar("AnyStudy", bound=Study)


def load_sweep(
    path: str | Path, settings: Iterable[str] = (), own: Mapping[str, OwnController] | None = None
) -> Plan:
    """Read and resolve a sweep file; raises BadInput with every problem of its own keys.

    `settings` are KEY=VALUE. KEY is a key of the sweep (`runs=10`), or else a dotted path of the scenario
    (`duration_s=2`), which is then set for all runs. `own` are controllers of the user's, which are compared with those of
    the sweep. `checks.check` checks the scenarios that the plan draws.
    """
    source = yamlfile.read(find_scenario(path))
    refuse_other(source, "sweep")
    sweep, builder = study_of(Sweep, source, settings, own)
    cases, text = None, None
    if sweep.cases is not None:
        file = Path(source.file).parent / sweep.cases
        cases, text, places = read_cases(file, source.problem(("cases",), "there is no such file"))
        builder = replace(builder, places={**builder.places, **places})
        complete(cases, builder.base.tree, places)
    runs = _runs(sweep, source, cases)
    return Plan(
        study=sweep.model_copy(update={"runs": runs}),
        name=name_of(sweep, path),
        builder=builder,
        runs=runs,
        sampling=sweep.sampling,
        levels=sweep.levels,
        stop_when=sweep.stop_when,
        cases=cases,
        cases_text=text,
    )


def name_of(study: Study, path: str | Path) -> str:
    """The title of a study: its name, else that of its file."""
    return study.name or Path(path).stem.replace("_", " ")


def study_of(
    model: type[AnyStudy],
    source: Source,
    settings: Iterable[str] = (),
    own: Mapping[str, OwnController] | None = None,
) -> tuple[AnyStudy, Builder]:
    """The study of this model in a file that was read, and the builder of its scenarios; as `load_sweep`."""
    _apply(model, source, settings)
    study = validated(model, source, stand_ins={"scenario": "?"})
    _refuse_overwritten(study, source)
    base = _base(study, source)
    for key, value in study.set.items():
        overrides.set_value(base, key.split("."), value, _place(source, ("set", key)), default_at)
    if own:
        study = _comparing(own, study, source, base)
    unknown = {name: OwnController(name, *_split(text)) for name, text in study.controllers.items()}
    paths = [("vary", path) for path in study.vary] + [("compare", path) for path in study.compare]
    places = {path: _place(source, (kind, path)) for kind, path in paths}
    return study, Builder(base, tuple(_variants(study)), places, {**unknown, **(own or {})})


def _apply(model: type[Study], source: Source, settings: Iterable[str]) -> None:
    """Set keys of the study (`runs`, or `vary.` and a dotted path of the scenario); any other path goes into `set`."""
    for setting in settings:
        key, equals, text = setting.partition("=")
        first, _, rest = key.strip().partition(".")
        if equals and first not in model.model_fields:
            first, rest = "set", key.strip()
        if not equals or first not in _MAPPINGS or not rest:
            overrides.apply(source, [setting])
            continue
        place = overrides.place_of(setting)
        value = yamlfile.parse(text)
        if source.tree.get(first) is None:
            source.tree[first] = {}
        overrides.set_value(source, [first, rest], value.tree, place)


def _refuse_overwritten(study: Study, source: Source) -> None:
    """Raise BadInput for keys of `set` without effect, because `vary` or `compare` replaces their value in every flight."""
    later = {path: kind for kind in ("vary", "compare") for path in getattr(study, kind)}
    problems = [
        source.problem(("set", key), f"has no effect: {kind} sets {path} in every flight", f"no {key} in set")
        for key in study.set
        for path, kind in later.items()
        if f"{key}.".startswith(f"{path}.")
    ]
    if problems:
        raise BadInput(problems)


def _base(study: Study, source: Source) -> Source:
    """The base scenario, from its own file or from inside the study's file; places are those where it is written."""
    if isinstance(study.scenario, dict):
        places = {path[1:]: place for path, place in source.places.items() if path[:1] == ("scenario",)}
        return Source(source.file, copy.deepcopy(study.scenario), places)
    beside = Path(source.file).parent / study.scenario
    try:
        base = yamlfile.read(beside if os.path.exists(beside) else find_scenario(study.scenario))
    except BadInput as error:
        raise BadInput([_named(source, p) if p.line is None else p for p in error.problems]) from None
    refuse_other(base, "scenario")
    return base


def _named(source: Source, problem: Problem) -> Problem:
    """The problem of a scenario's file that cannot be read, where it is named."""
    name = str(source.tree["scenario"])
    what = problem.what.replace("there is no such file", f"there is no file {name!r}")
    what = what if what != problem.what else f"{name} {what}"
    return source.problem(("scenario",), what, problem.expected, problem.suggestion)


def _comparing(own: Mapping[str, OwnController], study: AnyStudy, source: Source, base: Source) -> AnyStudy:
    """The study with these controllers among those compared; raises BadInput where they cannot be."""
    if "controller" in study.compare:
        what = "compares whole controllers, beside which --controller has no place"
        expected = f"{TYPE} in compare, or a list of types"
        raise BadInput([source.problem(("compare", "controller"), what, expected)])
    chosen = base.tree.get("controller")
    flown = [chosen["type"]] if isinstance(chosen, dict) and "type" in chosen else []
    types = [*study.compare.get(TYPE, flown), *own]
    source.tree["compare"] = {**study.compare, TYPE: list(dict.fromkeys(types))}
    source.tree["controllers"] = {**study.controllers, **{name: o.reference for name, o in own.items()}}
    return validated(type(study), source, stand_ins={"scenario": "?"})


def _split(reference: str) -> tuple[str, str]:
    file, colon, made_by = reference.rpartition(":")
    return (file, made_by) if colon else (reference, "")


def _place(source: Source, path: TreePath) -> str:
    file, line = source.place(path)
    return file if line is None else f"{file}:{line}"


def _variants(study: Study) -> Iterator[Variant]:
    for values in itertools.product(*study.compare.values()):
        chosen = dict(zip(study.compare, values, strict=True))
        words = (v if isinstance(v, str) else f"{path} {_shown(v)}" for path, v in chosen.items())
        yield Variant(", ".join(words), chosen)


def _shown(value: Any) -> str:
    """A compared value in a label: a mapping or a list as JSON, as the table has it."""
    return json.dumps(value, ensure_ascii=False) if isinstance(value, dict | list) else str(value)


def _runs(sweep: Sweep, source: Source, cases: list[dict[str, Any]] | None) -> int:
    total: int | None = None if cases is None else len(cases)
    if cases is None and sweep.sampling == "grid":
        sizes = [distribution.grid_size(sweep.levels) for distribution in sweep.vary.values()]
        total = math.prod(sizes)
        if total > MOST_FLIGHTS or max(sizes) > MOST_LEVELS:
            expected = f"at most {MOST_FLIGHTS}, and {MOST_LEVELS} levels"
            raise BadInput([source.problem(("sampling",), f"a grid of {total:.3g} runs", expected)])
    if total is not None and sweep.runs is not None and sweep.runs > total:
        what = f"is {describe(sweep.runs)}, there are {total}"
        raise BadInput([source.problem(("runs",), what, f"at most {total}, or no runs for all")])
    runs = sweep.runs or total or DEFAULT_RUNS
    flights = runs * math.prod(map(len, sweep.compare.values()))
    if flights > MOST_FLIGHTS:
        what = f"is {runs}, which is {flights} flights with what is compared"
        raise BadInput([source.problem(("runs",), what, f"at most {MOST_FLIGHTS} flights")])
    return runs


LARGEST_TABLE = 20 * MEGABYTE
"""Largest table of cases that is read [bytes]."""

_NUMBER = re.compile(r"-?(0|[1-9][0-9]{0,14})(\.[0-9]{1,15})?")
"""Numbers that YAML reads as Python does, in a hundredth of the time."""

Cases = tuple[list[dict[str, Any]], str, dict[str, str]]
"""The values of each run by dotted paths, the text of the table, and the place of each column."""


def read_cases(file: Path, missing: Problem) -> Cases:
    """Read a table of runs; an empty cell is left out of its case (see `complete`).

    Raises BadInput: with `missing` when there is no such file, else with every column and cell that cannot be used.
    """
    if not os.path.lexists(file):
        raise BadInput([missing])
    text = read_text(file, LARGEST_TABLE, "a CSV table")
    _refuse_other(text, str(file))
    try:
        rows = list(csv.reader(text.splitlines(), strict=True))
    except csv.Error as error:
        raise BadInput([Problem(f"is no CSV table: {error}", str(file))]) from None
    header = [name.strip() for name in rows[0]] if rows else []
    problems = [
        Problem(f"column {j + 1} has no name" if not name else f"column {name} is there twice", str(file), 1)
        for j, name in enumerate(header)
        if not name or name in header[:j]
    ]
    cases = [
        _case(header, row, str(file), line, problems) for line, row in enumerate(rows[1:], 2) if any(row)
    ]
    if not cases:
        problems.append(
            Problem("has no runs", str(file), expected="a header of dotted paths and a row for each run")
        )
    if problems:
        raise BadInput(problems)
    return cases, text, {name: str(file) for name in header}


def complete(cases: list[dict[str, Any]], tree: Mapping[str, Any], places: Mapping[str, str]) -> None:
    """Put what is flown into the empty cells of a table: the value that the scenario's tree has.

    So a case says what its flight was flown with, whatever becomes of the scenario. Raises BadInput where the scenario has none.
    """
    problems = []
    for path, file in places.items():
        empty = [case for case in cases if path not in case and path != "seed"]
        try:
            value: Any = tree
            for part in path.split(".") if empty else ():
                value = value[int(part) if isinstance(value, list) else part]
            for case in empty:
                case[path] = value
        except (KeyError, IndexError, TypeError, ValueError):
            what, expected = "has empty cells, and the scenario has no value for them", "a value in each cell"
            problems.append(Problem(what, file, 1, path, expected))
    if problems:
        raise BadInput(problems)


def _refuse_other(text: str, file: str) -> None:
    """Raise BadInput for a table as a spreadsheet writes it, with other separators than commas."""
    first = text.partition("\n")[0]
    if first.lower().startswith("sep="):
        what, expected = f"is {first!r}, which only a spreadsheet reads", "the header: remove this line"
        raise BadInput([Problem(what, file, 1, expected=expected)])
    for character, name in ((";", "semicolons"), ("\t", "tabs")):
        if character in first and "," not in first:
            what, expected = f"has {name} between its cells", "commas: save it as CSV with commas"
            raise BadInput([Problem(what, file, 1, expected=expected)])


def _case(header: list[str], row: list[str], file: str, line: int, problems: list[Problem]) -> dict[str, Any]:
    if len(row) != len(header):
        expected = f"{len(header)}, as the header"
        problems.append(Problem(f"has {len(row)} cells", file, line, expected=expected))
        return {}
    case = {}
    for name, cell in zip(header, row, strict=True):
        if not cell.strip():
            continue
        if _NUMBER.fullmatch(cell):
            case[name] = float(cell) if "." in cell else int(cell)
            continue
        try:
            value = yamlfile.parse(cell)
        except BadInput as error:
            problems += [Problem(p.what, file, line, name) for p in error.problems]
            continue
        problems += [Problem(p.what, file, line, name, p.expected) for p in value.problems]
        case[name] = value.tree
    seed = case.get("seed", 2)
    if not isinstance(seed, int) or isinstance(seed, bool) or seed < 0:
        problems.append(Problem(f"is {seed!r}", file, line, "seed", "a whole number, at least 0"))
    return case
