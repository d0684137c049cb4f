"""A flight as a limit state: its robustness as a function of the coordinates of what varies; at or below 0 it fails."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from testbed.inputs.problems import BadInput, Problem
from testbed.studies.record import Record
from testbed.studies.run import Flights
from testbed.studies.search.plan import Part, Point, SearchPlan, key_of

_LEAST = 1e-12
"""What a requirement that is met exactly at its limit counts as."""


class LimitState:
    """The limit state of one part of a search. It flies what the store does not have, and keeps the order of points.

    Attributes:
        points: every point that was asked for, with its number, in the order of its first time.
    """

    def __init__(self, plan: SearchPlan, part: Part, flights: Flights) -> None:
        self.part = part
        self.points: dict[Point, int] = {}
        self._plan, self._flights = plan, flights
        self._nearest = math.inf

    def __call__(self, u: np.ndarray) -> np.ndarray:
        """[n] robustness of the flights at points [n, dimensions]; NaN for a flight without a result."""
        rows = [tuple(map(float, row)) for row in np.atleast_2d(u)]
        new = [row for row in dict.fromkeys(rows) if row not in self.points]
        if new:
            self._fly(new)
        return np.array([robustness(self.record(row)) for row in rows])

    def record(self, point: Point) -> Record:
        """The record of the flight at a point that was asked for, whose number is its run."""
        record = self._flights.store.record(key_of(self.part, point))
        if record.variant != self.part.variant:
            what = f"has variant {record.variant} in place of {self.part.variant}"
            raise BadInput([Problem(what, str(self._flights.store.folder))])
        return replace(record, run=self.points[point])

    def _fly(self, points: list[Point]) -> None:
        tasks = self._plan.tasks(self.part, np.array(points), len(self.points))
        for task, point in zip(tasks, points, strict=True):
            self.points[point] = task.run
        at = {task.run: point for task, point in zip(tasks, points, strict=True)}
        self._flights.words = self._words
        for task, record in self._flights.fly(tasks, lambda task: key_of(self.part, at[task.run])):
            if failed(record):
                self._nearest = min(self._nearest, math.hypot(*at[task.run]))

    def _words(self) -> str:
        """`ACTUATOR: nearest failure at distance 2.31`, of the flights that have been flown."""
        label, distance = self._plan.label(self.part), self._nearest
        found = "no failure yet" if distance == math.inf else f"nearest failure at distance {distance:.2f}"
        return f"{label}: {found}" if label else found


def robustness(record: Record) -> float:
    """The robustness in a flight's record, with the sign of its verdict: above 0 exactly if it passed; NaN without a result, or
    where nothing was judged."""
    if record.passed is None:
        return math.nan
    return max(record.robustness, _LEAST) if record.passed else min(record.robustness, 0.0)


def failed(record: Record) -> bool:
    """Whether a flight has a result, and a requirement was not met."""
    return robustness(record) <= 0.0
