"""The exploration of a search for the smallest failure: a survey of directions and then, in few dimensions, kriging.

The survey asks in all directions from the origin, just nearer than the nearest failure known, for other regions that fail.
Kriging of the limit state from all points asked so far then chooses the next where a nearer failure is to be expected: as in active
learning by kriging (Echard, Gayton and Lemaire 2011, Structural Safety 33:145), here with the expected improvement of the nearest
failure's distance (Jones, Schonlau and Welch 1998, Journal of Global Optimization 13:455).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from scipy.linalg import cho_factor, cho_solve, solve_triangular
from scipy.special import ndtr

from testbed.reliability.surface import Search

CHOSEN = 8
"""Points that kriging chooses at a time."""
MOST_POINTS = 500
"""The nearest points to the origin that are used: the work grows with their number's cube."""
KRIGED_CANDIDATES = 1500
ROUGH = 0.2
"""Correlation length, in standard deviations, of what is rough: losses, jumps and what a requirement's worst instant adds."""
HOPELESS = 1e-9
"""Expected improvement, as a share of the distance to be improved, below which nothing is asked."""
NUGGET = 1e-5
"""Variance that is added to each point's, as a share of the whole: the limit state may jump."""


@dataclass(frozen=True)
class Correlation:
    """Correlation of two values by the distance of their points: a smooth share (Matern 3/2), and a rough rest (Matern 1/2)."""

    length: float
    share: float

    def __call__(self, apart: np.ndarray) -> np.ndarray:
        scaled = math.sqrt(3) / self.length * apart
        smooth = (1 + scaled) * np.exp(-scaled)
        return (
            smooth if self.share == 1.0 else self.share * smooth + (1 - self.share) * np.exp(-apart / ROUGH)
        )


CORRELATIONS = (
    *(Correlation(length, 1.0) for length in (0.25, 0.5, 1.0, 2.0)),
    *(Correlation(length, share) for length in (1.0, 2.0, 4.0) for share in (0.8, 0.95)),
)
"""Of these the likeliest is taken: a limit state that is smooth is known farther around a point than a rough one."""


class Kriging:
    """Mean and standard deviation of the limit state between points [n, d], `apart` [n, n] from each other, with values [n]."""

    def __init__(self, points: np.ndarray, apart: np.ndarray, values: np.ndarray, correlation: Correlation):
        self.points, self.mean, self.correlation = points, float(np.mean(values)), correlation
        rest = values - self.mean
        self.factor = cho_factor(correlation(apart) + NUGGET * np.eye(len(values)), lower=True)
        self.weights = cho_solve(self.factor, rest)
        self.variance = max(float(rest @ self.weights) / len(values), 1e-12)

    @property
    def likelihood(self) -> float:
        """Logarithm of the likelihood of the values, but for a constant."""
        determinant = float(np.sum(np.log(np.diag(self.factor[0]))))
        return -len(self.points) / 2 * math.log(self.variance) - determinant

    def __call__(self, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Mean [m] and standard deviation [m] at points [m, d]."""
        near = self.correlation(_distances(at, self.points))
        known = solve_triangular(self.factor[0], near.T, lower=True)
        share = np.maximum(1.0 - np.sum(known**2, axis=0), 1e-9)
        return self.mean + near @ self.weights, np.sqrt(self.variance * share)


def _distances(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    squares = np.sum(a**2, axis=1)[:, None] + np.sum(b**2, axis=1) - 2 * a @ b.T
    return np.sqrt(np.maximum(squares, 0.0))


def krige(search: Search, outer: float, scale: float, random: np.random.Generator) -> None:
    """Ask where a nearer failure is expected, in batches, until the evaluations are spent.

    `outer` is the radius before the first failure. Nothing is asked while fewer than three values are known, or where no failure
    is to be expected at all.
    """
    while search.left:
        points, values = _known(search, scale)
        if len(values) < 3:
            return
        apart = _distances(points, points)
        fits = [Kriging(points, apart, values, kind) for kind in CORRELATIONS]
        kriging = max(fits, key=lambda fit: fit.likelihood)
        reach = min(outer, search.nearest)
        candidates = _candidates(search, reach, random)
        chosen = _best(kriging, candidates, reach, min(CHOSEN, search.left))
        if not len(chosen):
            return
        search(chosen)


def _known(search: Search, scale: float) -> tuple[np.ndarray, np.ndarray]:
    """The nearest points, and their values squeezed between -1 and 1, so that a loss is not a cliff."""
    points, values = np.concatenate(search.points), np.concatenate(search.values)
    known = np.isfinite(values)
    points, values = points[known], values[known]
    order = np.argsort(np.linalg.norm(points, axis=1), kind="stable")[:MOST_POINTS]
    return points[order], values[order] / (np.abs(values[order]) + 0.5 * scale)


def _candidates(search: Search, reach: float, random: np.random.Generator) -> np.ndarray:
    """Points nearer than `reach`, uniform in the volume: in all directions, and around the nearest failures."""
    dimensions = search.asked.dimensions
    everywhere = random.standard_normal((KRIGED_CANDIDATES, dimensions))
    if search.path:
        centres = np.array([step.point for step in search.path[-4:]])
        turned = centres[random.integers(len(centres), size=KRIGED_CANDIDATES // 2)]
        spread = 10 ** random.uniform(-2, -0.3, (len(turned), 1))
        everywhere = np.vstack([everywhere, turned + reach * spread * random.standard_normal(turned.shape)])
    lengths = reach * random.uniform(0.0, 1.0, (len(everywhere), 1)) ** (1 / dimensions)
    return search.folded(lengths * everywhere / np.linalg.norm(everywhere, axis=1, keepdims=True))


def _best(kriging: Kriging, candidates: np.ndarray, reach: float, n: int) -> np.ndarray:
    """At most n candidates with the largest expected improvement, which falls near each that has been chosen."""
    mean, deviation = kriging(candidates)
    gain = ndtr(-mean / deviation) * (reach - np.linalg.norm(candidates, axis=1))
    chosen: list[np.ndarray] = []
    while len(chosen) < n and gain.max() > HOPELESS * reach:
        chosen.append(candidates[int(np.argmax(gain))])
        alike = kriging.correlation(_distances(candidates, chosen[-1][None])[:, 0])
        gain = gain * (1 - alike**2)
    return np.array(chosen).reshape(-1, candidates.shape[1])


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
