"""A resolved matrix: its cells, what is expected of each and the flights made of it, and what came of it in the end."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from testbed.aircraft.description import Aircraft, AnyActuator
from testbed.common.text import with_article
from testbed.failures import TABLE
from testbed.inputs.problems import OWN_PART, BadInput, Problem, guess
from testbed.studies.model import RESULTS, Expected, Matrix, Result
from testbed.studies.plan import Plan
from testbed.studies.verdicts import said_of, state

if TYPE_CHECKING:
    import pandas as pd

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
    full = {**_example(kind, actuator), **given}
    none = TABLE[kind].neutral(actuator) or {}
    scaled = [
        key for key in full if _is_number(full[key]) and _is_number(none.get(key)) and full[key] != none[key]
    ]
    for severity in matrix.severities if scaled else [1.0]:
        between = {key: none[key] + severity * (full[key] - none[key]) for key in scaled}
        yield severity, full | {key: round(value, 9) for key, value in between.items()}


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _example(kind: str, actuator: AnyActuator) -> Mapping[str, Any]:
    examples = TABLE[kind].examples
    return examples.get(actuator.kind, examples.get("motor" if actuator.kind == "engine" else "", {}))


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
    rows = frame.to_dict("records")
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
    worst = max(runs, key=lambda run: (RESULTS.index(results[run]), -_robustness(each[run])))
    flown = list(results.values())
    return {
        "result": results[worst],
        "flights": len(flown),
        "held": flown.count("held"),
        "lost": flown.count("lost"),
        "run": worst,
        "why": said_of(plan, each[worst]),
    }


def _robustness(row: Mapping[Any, Any]) -> float:
    value = row["robustness"]
    return value if value == value else 0.0  # NaN without a result
