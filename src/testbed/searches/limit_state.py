"""A flight as a limit state: its robustness as a function of the coordinates of what varies; at or below 0 it fails."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from testbed.searches.flying import Flying
from testbed.searches.folder import Store
from testbed.searches.plan import Part, SearchPlan, key_of
from testbed.searches.progress import Progress

_LEAST = 1e-12
"""What a requirement that is met exactly at its limit counts as."""


class LimitState:
    """The limit state of one part of a search. It flies what the store does not have, and keeps the order of points.

    Attributes:
        points: every point that was asked for, once, in the order of its first time.
    """

    def __init__(
        self, plan: SearchPlan, part: Part, store: Store, flying: Flying, progress: Progress
    ) -> None:
        self.part = part
        self.points: list[tuple[float, ...]] = []
        self._plan, self._store, self._flying, self._progress = plan, store, flying, progress
        self._known: set[tuple[float, ...]] = set()

    def __call__(self, u: np.ndarray) -> np.ndarray:
        """[n] robustness of the flights at points [n, dimensions]; NaN for a flight without a result."""
        rows = [tuple(map(float, row)) for row in np.atleast_2d(u)]
        new = [row for row in dict.fromkeys(rows) if row not in self._known]
        self._fly(new)
        self.points += new
        self._known.update(new)
        return np.array([robustness(self.record(row)) for row in rows])

    def record(self, point: tuple[float, ...]) -> dict[str, Any]:
        """The record of the flight at a point that was asked for."""
        return self._store.record(key_of(self.part, point))

    def _fly(self, points: list[tuple[float, ...]]) -> None:
        if not points:
            return
        tasks = self._plan.tasks(self.part, np.array(points), len(self.points))
        keys = {task.run: key_of(self.part, point) for task, point in zip(tasks, points, strict=True)}
        for task, flown in self._flying.fly([t for t in tasks if keys[t.run] not in self._store]):
            self._store.add(keys[task.run], flown.record)
            self._progress.add(self.part, keys[task.run][1], failed(flown.record))


def robustness(record: Mapping[str, Any]) -> float:
    """The robustness in a flight's record, with the sign of its verdict: above 0 exactly if it passed; NaN without a result."""
    value = float(record.get("robustness", math.nan))
    return max(value, _LEAST) if record["passed"] else min(value, 0.0)


def failed(record: Mapping[str, Any]) -> bool:
    """Whether a flight has a result, and a requirement was not met."""
    return robustness(record) <= 0.0
