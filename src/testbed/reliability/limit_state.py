"""The user's limit state, asked in batches: checks what it returns, counts, and remembers the nearest failure."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from testbed.inputs.problems import BadInput, Problem

LimitState = Callable[[np.ndarray], np.ndarray]
"""Takes [n, d] standard normal coordinates and returns [n] values; a value at or below 0 is a failure."""


class Asked:
    """A limit state within a budget of evaluations. A value that is NaN counts as unknown, and never as a failure."""

    def __init__(self, limit_state: LimitState, dimensions: int, budget: int) -> None:
        self.limit_state = limit_state
        self.dimensions = dimensions
        self.budget = budget
        self.evaluations = 0
        self.unknown = 0
        self.nearest: np.ndarray | None = None

    @property
    def left(self) -> int:
        """How many evaluations the budget still has."""
        return self.budget - self.evaluations

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """Values [n] of the limit state at points [n, d]; raises BadInput if it returns anything else."""
        values = _checked(self.limit_state(points.copy()), len(points))
        self.evaluations += len(points)
        self.unknown += int(np.isnan(values).sum())
        self._remember(points[values <= 0])
        return values

    def _remember(self, failures: np.ndarray) -> None:
        """Keep the failure nearest to the origin."""
        if not len(failures):
            return
        nearest = failures[np.argmin(np.linalg.norm(failures, axis=1))]
        if self.nearest is None or np.linalg.norm(nearest) < np.linalg.norm(self.nearest):
            self.nearest = nearest.copy()


def _checked(values: object, n: int) -> np.ndarray:
    """What a limit state returned, as numbers [n]."""
    expected = f"{n} numbers, an array of shape [{n}]"
    try:
        numbers = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise BadInput(
            [Problem(f"returned a {type(values).__name__}", "limit_state", expected=expected)]
        ) from None
    if numbers.shape != (n,):
        raise BadInput(
            [Problem(f"returned an array of shape {list(numbers.shape)}", "limit_state", expected=expected)]
        )
    return numbers
