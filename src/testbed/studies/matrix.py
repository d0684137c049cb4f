"""A failure matrix: every actuator of an aircraft by every failure that fits it, what is expected of each, and what came of it.

It is loaded from a file of its own, or made from a scenario or an aircraft that is to be broken in every way.
"""

from __future__ import annotations

import csv
import math
import os
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.description import Aircraft, AnyActuator, load_aircraft
from testbed.aircraft.shipped import aircraft_names, find_aircraft, find_scenario
from testbed.common.text import text_of, with_article
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.controllers.user.own import OwnController
from testbed.failures import TABLE
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.input_file import MEGABYTE, read_text
from testbed.inputs.problems import OWN_PART, BadInput, Problem, did_you_mean, guess
from testbed.inputs.yaml_source import Source
from testbed.studies.drawing.builder import Builder, Task
from testbed.studies.drawing.distributions import hashed
from testbed.studies.load import name_of, study_of
from testbed.studies.model import MOST_FLIGHTS, RESULTS, Expected, Matrix, Result
from testbed.studies.plan import Plan
from testbed.studies.verdicts import said_of, state

if TYPE_CHECKING:
    import pandas as pd

_AT_S, _DURATION_S, _LOG_HZ = 10.0, 60.0, 50
_HELD_S, _HELD_DEG = 0.55, 20.0
"""An aircraft is held while it is no further from its references than it flies in this time, and by this angle of heading."""
Summary = dict[str, Any]
_OF_A_STATE = {"passed": "held", "missed": "survived", "lost": "lost", "no result": "no result",
               "not judged": "survived"}  # fmt: skip


@dataclass(frozen=True)
class Cell:
    """A failure of an actuator, in one kind of weather.

    Attributes:
        failure: its type, and the values that differ from the catalogue's.
        broken: the failure as a scenario has it; None where it is not possible.
        reason: why it is not possible.
    """

    actuator: str
    failure: str
    severity: float
    weather: str
    broken: Mapping[str, Any] | None = None
    reason: str = ""


@dataclass(frozen=True, kw_only=True)
class MatrixPlan(Plan):
    """A resolved matrix. As a plan it is a table of cases: `seeds` runs of each cell that is possible, one after the other."""

    study: Matrix
    cells: tuple[Cell, ...]

    @property
    def flown(self) -> list[Cell]:
        """The cells that are possible, in the order of the runs."""
        return [cell for cell in self.cells if cell.broken is not None]

    @property
    def labels(self) -> list[str]:
        """The names of the controllers, or of whatever else is compared."""
        alone = str((self.builder.base.tree.get("controller") or {}).get("type", "adaptive_inversion"))
        return [variant.label or alone for variant in self.variants]

    def variant_of(self, controller: str) -> str:
        """The label of the variant that this controller flies: empty where nothing is compared."""
        return self.variants[self.labels.index(controller)].label

    def expected(self, cell: Cell, label: str) -> Result:
        """What the baseline says of a cell that this controller flies; else that it is held, if it is possible."""
        said = [each.result for each in self.study.baseline if about(each, cell, label)]
        return said[-1] if said else "held" if cell.broken is not None else "not possible"


def about(expected: Expected, cell: Cell, label: str) -> bool:
    """Whether an entry of a baseline is about a cell that this controller flies."""
    asked = expected.model_dump(exclude={"result"}, exclude_none=True)
    return all(
        (label if key == "controller" else getattr(cell, key)) == value for key, value in asked.items()
    )


def cells(matrix: Matrix, aircraft: Aircraft, at_s: float, rate_hz: float) -> Iterator[Cell]:
    """Every cell, by weather, actuator, failure and severity. Raises BadInput for a failure that is none."""
    kinds = [_asked(each) for each in matrix.failures or _types()]
    for weather in matrix.weather or [""]:
        for name, actuator in aircraft.actuators.items():
            for label, kind, given in kinds:
                for severity, values in _strengths(matrix, kind, given, actuator):
                    broken = {"type": kind, "actuator": name, "at_s": at_s, **values}
                    why = _misfit(kind, broken, aircraft, rate_hz)
                    shown = weather if isinstance(weather, str) else f"{weather:g}"
                    yield Cell(name, label, severity, shown, None if why else broken, why)


def _asked(said: str | dict[str, Any]) -> tuple[str, str, dict[str, Any]]:
    """(label, type, values) of a failure as the file has it."""
    given = {"type": said} if isinstance(said, str) else dict(said)
    kind = str(given.pop("type", ""))
    if kind not in _types():
        what = f"is {kind!r} ({OWN_PART})"
        raise BadInput([Problem(what, "", None, "failures", *guess(kind, _types()))])
    own = {"actuator", "at_s", "until_s", "when"} & set(given)
    if own:
        what = f"has {', '.join(sorted(own))}"
        raise BadInput([Problem(what, path="failures", expected="type and values: the matrix sets the rest")])
    return " ".join([kind, *(f"{key}={value}" for key, value in given.items())]), kind, given


def _types() -> list[str]:
    """Those that break an actuator."""
    return [name for name, kind in TABLE.items() if kind.examples]


def _strengths(
    matrix: Matrix, kind: str, given: Mapping[str, Any], actuator: AnyActuator
) -> Iterator[tuple[float, dict[str, Any]]]:
    """(severity, values) of a failure of this actuator; a single one of severity 1 where severity has no meaning."""
    examples = TABLE[kind].examples
    usual = examples.get(actuator.kind, examples.get("motor" if actuator.kind == "engine" else "", {}))
    full = {**usual, **given}
    none = TABLE[kind].neutral(actuator) or {}
    scaled = [
        key for key in full if _is_number(full[key]) and _is_number(none.get(key)) and full[key] != none[key]
    ]
    for severity in matrix.severities if scaled else [1.0]:
        between = {key: none[key] + severity * (full[key] - none[key]) for key in scaled}
        yield severity, full | {key: round(value, 9) for key, value in between.items()}


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _misfit(kind: str, broken: Mapping[str, Any], aircraft: Aircraft, rate_hz: float) -> str:
    """Why a failure does not fit its actuator; "" where it does."""
    actuator = aircraft.actuators[broken["actuator"]]
    if actuator.kind not in TABLE[kind].kinds:
        fitting = " or ".join(map(with_article, TABLE[kind].kinds))
        return f"{fitting} can fail so, and this is {with_article(actuator.kind)}"
    try:
        issues = TABLE[kind].model_validate(broken).faults(aircraft, rate_hz)
        return "; ".join(issue.what for issue in issues)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        return f"{'.'.join(map(str, first['loc']))}: {first['msg']}"


def summarize(plan: MatrixPlan, frame: pd.DataFrame) -> Summary:
    """The summary of a matrix whose every flight is in the table, in the order of runs and variants."""
    rows = frame.fillna({"robustness": 0.0}).to_dict("records")  # NaN without a result
    numbers = iter(range(len(plan.flown)))
    found = [
        one
        for cell in plan.cells
        for one in _of_each(plan, cell, None if cell.broken is None else next(numbers), rows)
    ]
    found.sort(key=lambda one: plan.labels.index(one["controller"]))
    counted = Counter(one["result"] for one in found)
    return {
        "matrix": plan.name,
        "aircraft": plan.aircraft_names[0],
        "seeds": plan.study.seeds,
        "flights": len(rows),
        "counts": {result: counted[result] for result in RESULTS if counted[result]},
        "better": sum(one["against"] == "better" for one in found),
        "worse": sum(one["against"] == "worse" for one in found),
        "cells": found,
    }


def _of_each(
    plan: MatrixPlan, cell: Cell, number: int | None, rows: Sequence[Mapping[Any, Any]]
) -> Iterator[Summary]:
    """A cell as each of the controllers flew it; `number` is its place among those that are flown."""
    for variant, label in enumerate(plan.labels):
        about = {key: getattr(cell, key) for key in ("actuator", "failure", "severity", "weather")}
        about |= {"controller": label}
        outcome = _impossible(cell) if number is None else _flown(plan, number, variant, rows)
        expected = plan.expected(cell, label)
        better = RESULTS.index(outcome["result"]) - RESULTS.index(expected)
        against = "as expected" if not better else "better" if better < 0 else "worse"
        yield {**about, **outcome, "expected": expected, "against": against}


def _impossible(cell: Cell) -> Summary:
    return {"result": "not possible", "flights": 0, "held": 0, "lost": 0, "run": None, "why": cell.reason}


def _flown(plan: MatrixPlan, number: int, variant: int, rows: Sequence[Mapping[Any, Any]]) -> Summary:
    """What came of a cell's flights: the result of the worst, how many were held and lost, and why."""
    runs = range(number * plan.study.seeds, (number + 1) * plan.study.seeds)
    each = {run: rows[run * len(plan.variants) + variant] for run in runs}
    results = {run: _OF_A_STATE[state(row["outcome"], row["passed"])] for run, row in each.items()}
    worst = max(runs, key=lambda run: (RESULTS.index(results[run]), -each[run]["robustness"]))
    flown = list(results.values())
    return {
        "result": results[worst],
        "flights": len(flown),
        "held": flown.count("held"),
        "lost": flown.count("lost"),
        "run": worst,
        "why": said_of(plan, each[worst]),
    }


def load_matrix(
    path: str | Path,
    settings: Iterable[str] = (),
    own: Mapping[str, OwnController] | None = None,
    keys: Mapping[str, Any] | None = None,
) -> MatrixPlan:
    """Read and resolve a matrix, as `studies.load.load_sweep` does a sweep; raises BadInput with every problem.

    Args:
        path: a matrix file, a scenario's, or the name or folder of an aircraft.
        keys: of the file, in place of what it says.
    """
    source = _source(path)
    for key, value in (keys or {}).items():
        source.tree[key] = value
        source.places[(key,)] = (f"--{key}", None)
    matrix, builder = study_of(Matrix, source, settings, own)
    matrix = _begun(matrix, builder)
    scenario = builder.scenario(Task(0, 0, 2, {}))
    aircraft = load_with_changes(scenario.aircraft)
    found = tuple(cells(matrix, aircraft, matrix.at_s or 0.0, scenario.rate_hz))
    _refuse_useless(matrix, found, source)
    cases = [case for cell in found for case in _cases(cell, matrix, builder)]
    if not 0 < len(cases) * len(builder.variants) <= MOST_FLIGHTS:
        what = f"makes {len(cases)} flights of each controller"
        raise BadInput([source.problem(("failures",), what, f"1 to {MOST_FLIGHTS} flights")])
    builder = replace(builder, places={**builder.places, "failures": "matrix", "atmosphere": "matrix"})
    name = name_of(matrix, path)
    plan = MatrixPlan(study=matrix, name=name, builder=builder, runs=len(cases), cases=cases, cells=found)
    _refuse_unknown(plan, source)
    return plan


def read_baseline(file: str | Path) -> list[dict[str, Any]]:
    """What a file expects of the cells: a YAML list, or a CSV table such as the matrix.csv of an earlier matrix."""
    if Path(file).suffix != ".csv":
        source = yamlfile.parse(read_text(file, 10 * MEGABYTE), str(file))
        if source.problems or not isinstance(source.tree, list):
            what = Problem("is no list", str(file), expected="entries such as {failure: stuck, result: lost}")
            raise BadInput(source.problems or [what])
        return source.tree
    rows = csv.DictReader(read_text(file, 10 * MEGABYTE, "a CSV table").splitlines())
    if "result" not in (rows.fieldnames or ()):
        raise BadInput([Problem("has no column result", str(file), 1)])
    return [_entry(row) for row in rows]


def _entry(row: Mapping[str, Any]) -> dict[str, Any]:
    entry = {key: text_of(row[key]) for key in Expected.model_fields if row.get(key)}
    try:
        return entry | ({"severity": float(entry["severity"])} if "severity" in entry else {})
    except ValueError:
        return entry  # which the model refuses


def _source(path: str | Path) -> Source:
    """The tree of a matrix file; one is made for a scenario's and for an aircraft."""
    aircraft = str(path) in aircraft_names() or os.path.isdir(path)
    if aircraft:
        name = str(path) if str(path) in aircraft_names() else os.path.realpath(path)
        return Source("", {"name": Path(name).name, "scenario": _mission(name)})
    try:
        file = find_scenario(path)
    except BadInput as error:
        if not Path(path).suffix and not error.problems[0].suggestion:
            find_aircraft(str(path))  # which says what was meant
        raise
    source = yamlfile.read(file)
    if "scenario" in source.tree:
        return source
    return Source("", {"scenario": os.path.realpath(file)})


def _mission(name: str) -> dict[str, Any]:
    """What an aircraft flies: level with a turn after the failure, held as far as its airspeed lets one ask."""
    reference = load_aircraft(name).reference
    held_m = math.ceil(_HELD_S * reference.airspeed_m_s)
    heading = reference.model_dump().get("heading_deg", 0.0)
    return {
        "name": f"{Path(name).name} broken",
        "aircraft": name,
        "duration_s": _DURATION_S,
        "log_hz": _LOG_HZ,
        "commands": [{"at_s": 2 * _AT_S, "heading_deg": (heading + 30.0) % 360.0}],
        "requirements": [
            {"metric": "altitude_excursion_failed_m", "at_most": held_m},
            {"metric": "heading_excursion_failed_deg", "at_most": _HELD_DEG},
        ],
    }


def _begun(matrix: Matrix, builder: Builder) -> Matrix:
    """The matrix with the time at which each failure starts; the scenario's own failures are taken out."""
    base = builder.base
    said = base.tree.pop("failures", None) or [{}]
    first = said[0].get("at_s", _AT_S) if isinstance(said, list) and isinstance(said[0], dict) else _AT_S
    base.problems[:] = [problem for problem in base.problems if not problem.path.startswith("failures")]
    return matrix if matrix.at_s is not None else matrix.model_copy(update={"at_s": first})


def _cases(cell: Cell, matrix: Matrix, builder: Builder) -> Iterable[dict[str, Any]]:
    """The values of each flight of a cell; those of one seed meet the same turbulence in every cell."""
    if cell.broken is None:
        return
    for number in range(matrix.seeds):
        seed = hashed(matrix.seed, "seed", number)
        yield {"failures": [dict(cell.broken)], **_air(cell.weather, builder), "seed": seed}


def _air(weather: str, builder: Builder) -> dict[str, Any]:
    if not weather:
        return {}
    own = {} if weather == "calm" else builder.base.tree.get("atmosphere") or {}
    said = {key: value for key, value in own.items() if not key.startswith("turbulence")}
    if weather != "calm":
        is_word = weather.isalpha()
        said |= {"turbulence": weather} if is_word else {"turbulence_w20_m_s": float(weather)}
    return {"atmosphere": said}


def _refuse_useless(matrix: Matrix, found: tuple[Cell, ...], source: Source) -> None:
    """Raise BadInput for failures that were asked for and fit no actuator, with why."""
    possible = {cell.failure for cell in found if cell.broken is not None}
    why = {cell.failure: cell.reason for cell in found if cell.failure not in possible}
    if why and matrix.failures:
        said = (f"{failure}: {reason}" for failure, reason in why.items())
        raise BadInput(source.problem(("failures",), each) for each in said)


def _refuse_unknown(plan: MatrixPlan, source: Source) -> None:
    """Raise BadInput for names in the baseline that nothing has. It may be of more cells than are flown this time.

    Of a failure its type is looked at, without the values that may follow.
    """
    known: dict[str, list[str]] = {
        "actuator": list(dict.fromkeys(cell.actuator for cell in plan.cells)),
        "failure": list(TABLE),
        "controller": [*plan.labels, *CONTROLLERS],
    }
    problems = [
        source.problem(("baseline", i, key), f"there is no {key} {name!r}", *guess(name, known[key]))
        for i, each in enumerate(plan.study.baseline)
        for key, said in each.model_dump(include=set(known), exclude_none=True).items()
        if (name := said.partition(" ")[0] if key == "failure" else said) not in known[key]
        and (key != "controller" or did_you_mean(name, known[key]))
    ]  # a controller of the user's own is known only where it is flown
    if problems:
        raise BadInput(problems)
