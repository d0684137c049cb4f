"""The user's limit state: its arguments, and its values in batches, checked, counted, and with the nearest failure kept."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem
from testbed.reliability.results import FailureProbability, Level

LimitState = Callable[[np.ndarray], np.ndarray]
"""Takes [n, d] standard normal coordinates and returns [n] values; a value at or below 0 is a failure."""

_LEAST = {"dimensions": 1, "seed": 0, "budget": 10, "starts": 1}
_CALLED = "a function of [n, d] standard normals that returns [n] values"


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
        failure = nearest_of(points[values <= 0])
        if failure is not None and (
            self.nearest is None or np.linalg.norm(failure) < np.linalg.norm(self.nearest)
        ):
            self.nearest = failure.copy()
        return values

    def answer(
        self,
        method: str,
        probability: float,
        cov: float,
        interval: tuple[float, float],
        levels: Iterable[Level],
        converged: bool,
        reason: str,
    ) -> FailureProbability:
        """The answer of a method, with what is known here: the evaluations, and the failure nearest to the origin."""
        return FailureProbability(
            probability, cov, interval, self.evaluations, method, tuple(levels), self.nearest, converged, reason
        )  # fmt: skip


def nearest_of(points: np.ndarray) -> np.ndarray | None:
    """The one of points [n, d] that is nearest to the origin; None of none."""
    return np.asarray(points[np.argmin(np.linalg.norm(points, axis=1))]) if len(points) else None


def _checked(values: object, n: int) -> np.ndarray:
    """What a limit state returned, as numbers [n]."""
    what = f"a {type(values).__name__}"
    try:
        numbers = np.asarray(values, dtype=float)
        if numbers.shape == (n,):
            return numbers
        what = f"an array of shape {list(numbers.shape)}"
    except (TypeError, ValueError):
        pass
    raise refused("limit_state", f"returned {what}", f"{n} numbers, an array of shape [{n}]")


def refused(name: str, what: str, expected: str = "", suggestion: str = "") -> BadInput:
    """What is raised for an argument, by its name."""
    return BadInput([Problem(what, name, expected=expected, suggestion=suggestion)])


def check(limit_state: Any, most_dimensions: int, **given: Any) -> None:
    """Raise BadInput with every problem of the arguments, before the limit state is called.

    Those in _LEAST are whole numbers, the others numbers above 0.
    """
    problems = [] if callable(limit_state) else [Problem("cannot be called", "limit_state", expected=_CALLED)]
    for name, value in given.items():
        if expected := _expected(name, value, most_dimensions if name == "dimensions" else math.inf):
            problems.append(Problem(f"is {value!r}", name, expected=expected))
    if problems:
        raise BadInput(problems)


def _expected(name: str, value: Any, most: float) -> str:
    """What is expected of an argument, "" if the value is that."""
    if name in _LEAST:
        fits = hasattr(value, "__index__") and _LEAST[name] <= value <= most
        expected = f"a whole number from {_LEAST[name]} " + ("on" if most == math.inf else f"to {most}")
    else:
        fits = isinstance(value, (int, float)) and 0 < value < math.inf
        expected = "a number above 0"
    return "" if fits and not isinstance(value, bool) else expected
