"""Kriging of the limit state from the points asked so far, to choose the next where a nearer failure is to be expected.

As in active learning by kriging (Echard, Gayton and Lemaire 2011, Structural Safety 33:145), here with the expected improvement
of the nearest failure's distance (Jones, Schonlau and Welch 1998, Journal of Global Optimization 13:455).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.linalg import cho_factor, cho_solve, solve_triangular
from scipy.special import ndtr

from testbed.reliability.surface import Search

BATCH = 8
MOST_POINTS = 500
"""The nearest points to the origin that are used: the work grows with their number's cube."""
CANDIDATES = 1500
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
        chosen = _best(kriging, candidates, reach, min(BATCH, search.left))
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
    everywhere = random.standard_normal((CANDIDATES, dimensions))
    if search.path:
        centres = np.array([step.point for step in search.path[-4:]])
        turned = centres[random.integers(len(centres), size=CANDIDATES // 2)]
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
