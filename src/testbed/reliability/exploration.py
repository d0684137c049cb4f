"""The exploration of a search for the smallest failure: a survey of directions and then, in few dimensions, kriging.

The survey asks in all directions from the origin, just nearer than the nearest failure known, for other regions that fail.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from testbed.reliability.kriging import krige
from testbed.reliability.surface import Search

Fold = Callable[[np.ndarray], np.ndarray]
"""Takes points [n, d] and returns those of the half, or the smaller share, of the space that holds every value there is."""
BATCH = 16
NEARER = 0.97
"""Radius of the survey, as a share of the nearest failure's distance."""
DENSE = 0.12
"""Angle, rad, to a direction surveyed before, below which a new one tells nothing."""
FEW_DIMENSIONS = 4
"""In more, no number of random directions that can be asked is dense, and only the axes are surveyed."""
CANDIDATES = 400
"""Random directions among which the next one is chosen."""
CLOSING = 4
"""Halvings of the interval in which the nearest of several failing directions begins to fail."""
SURVEYED, KRIGED = 0.1, 0.4
"""Shares of the budget for each survey, and for the first kriging."""
MOST_KRIGED = 300
"""Evaluations chosen by kriging at a time: beyond them the searches do better."""
FARTHEST = 5.0
"""Radius to look within before the first failure, in few dimensions: a probability of 3e-7 on one side."""
MOST_DIMENSIONS = 6
"""In more, some hundred points are too far apart for kriging to know anything between them."""


class Directions:
    """Unit vectors as far apart as can be: first both ways along every axis, if `axes`, then among random ones."""

    def __init__(self, dimensions: int, axes: bool, folded: Fold) -> None:
        both = folded(np.vstack([np.eye(dimensions), -np.eye(dimensions)]))
        both = both[np.sort(np.unique(both, axis=0, return_index=True)[1])]
        self.folded = folded
        self.waiting = both if axes else both[:0]
        self.chosen = both[:0]
        self.candidates = CANDIDATES if dimensions <= FEW_DIMENSIONS else 0

    def next(self, n: int, random: np.random.Generator) -> np.ndarray:
        """At most n more [k, d]; fewer, or none, once all are dense."""
        first, self.waiting = self.waiting[:n], self.waiting[n:]
        known = np.vstack([self.chosen, first])
        self.chosen = np.vstack([known, self._between(known, n - len(first), random)])
        return self.chosen[len(known) - len(first) :]

    def _between(self, known: np.ndarray, n: int, random: np.random.Generator) -> np.ndarray:
        """The candidates farthest from all that are known and from each other [k, d]."""
        candidates = random.standard_normal((self.candidates if n else 0, known.shape[1]))
        candidates = self.folded(candidates / np.linalg.norm(candidates, axis=1, keepdims=True))
        closest = np.max(candidates @ known.T, axis=1, initial=-1.0)
        found: list[np.ndarray] = []
        while len(found) < min(n, len(candidates)) and closest.min() < math.cos(DENSE):
            found.append(candidates[int(np.argmin(closest))])
            closest = np.maximum(closest, candidates @ found[-1])
        return np.array(found).reshape(-1, known.shape[1])


def _survey(search: Search, directions: Directions, outer: float, random: np.random.Generator) -> None:
    """Ask in further directions until the evaluations are spent or the directions dense, nearer after every failure found.

    The radius is `outer` before the first failure.
    """
    while search.left:
        chosen = directions.next(min(BATCH, search.left), random)
        if not len(chosen):
            return
        radius = min(outer, NEARER * search.nearest)
        failing = chosen[search(radius * chosen) <= 0]
        if len(failing):
            _close_in(search, failing, radius)


def _close_in(search: Search, failing: np.ndarray, radius: float) -> None:
    """Find which of several directions that fail at `radius` does so nearest to the origin, by bisection of all at once.

    A direction is left as soon as it passes at a distance where another one fails.
    """
    low, high = 0.4, 1.0
    for _ in range(CLOSING):
        middle = (low + high) / 2
        still = search(middle * radius * failing) <= 0
        if still.any():
            failing, high = failing[still], middle
        else:
            low = middle


@dataclass
class Exploration:
    """Looks for failures nearer than the nearest one known, in all directions."""

    search: Search
    scale: float
    random: np.random.Generator
    directions: Directions = field(init=False)

    def __post_init__(self) -> None:
        asked = self.search.asked
        axes = 2 * asked.dimensions <= SURVEYED * asked.budget
        self.directions = Directions(asked.dimensions, axes, self.search.folded)

    @property
    def kriges(self) -> bool:
        """Whether there are few enough dimensions for kriging."""
        return self.search.asked.dimensions <= MOST_DIMENSIONS

    def explore(self, kriged: float = 1.0) -> None:
        """Survey further directions, and krige with this share of the budget, or what is left of it."""
        asked = self.search.asked
        outer = max(FARTHEST, 2 + math.sqrt(asked.dimensions))
        self.search.begin(int(SURVEYED * asked.budget))
        _survey(self.search, self.directions, outer, self.random)
        if self.kriges:
            share = kriged if self.search.path else kriged / 2  # the searches have to find the first failure
            self.search.begin(min(MOST_KRIGED, int(share * asked.budget)))
            krige(self.search, outer, self.scale, self.random)
