"""What came of each cell of a matrix, against what was expected: its summary.json and its table, matrix.csv."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from testbed.studies.matrix.model import RESULTS
from testbed.studies.matrix.plan import Cell, MatrixPlan
from testbed.studies.verdicts import said_of, state

if TYPE_CHECKING:
    import pandas as pd

Summary = dict[str, Any]
_OF_A_STATE = {"passed": "held", "missed": "survived", "lost": "lost", "no result": "no result",
               "not judged": "survived"}  # fmt: skip


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
