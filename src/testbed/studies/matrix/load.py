"""Load a matrix: from a file of its own, or from a scenario or an aircraft that is to be broken in every way."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.shipped import aircraft_names, find_aircraft, find_scenario
from testbed.common.text import text_of
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.controllers.user.own import OwnController
from testbed.failures import TABLE
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.input_file import MEGABYTE, read_text
from testbed.inputs.problems import BadInput, Problem, did_you_mean, guess
from testbed.inputs.yaml_source import Source
from testbed.studies.drawing.builder import Builder, Task
from testbed.studies.drawing.distributions import hashed
from testbed.studies.load import name_of, study_of
from testbed.studies.matrix.plan import Cell, MatrixPlan, cells
from testbed.studies.model import MOST_FLIGHTS, Expected, Matrix

_AT_S, _DURATION_S, _LOG_HZ = 10.0, 60.0, 50
_HELD_S, _HELD_DEG = 0.55, 20.0
"""An aircraft is held while it is no further from its references than it flies in this time, and by this angle of heading."""


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
    found = _cells(matrix, builder)
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


def _cells(matrix: Matrix, builder: Builder) -> tuple[Cell, ...]:
    scenario = builder.scenario(Task(0, 0, 2, {}))
    return tuple(cells(matrix, load_with_changes(scenario.aircraft), matrix.at_s or 0.0, scenario.rate_hz))


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
