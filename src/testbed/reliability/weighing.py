"""Rounds of importance sampling, each from a density of its own: the estimate that they give together, and doubts about it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from testbed.reliability.limit_state import Asked
from testbed.reliability.mixture import Blend, Density
from testbed.reliability.subset_run import Run

FEWEST = 10
"""Number of failures from which on the scatter of their weights is an estimate of its own error."""
DIFFERS = 3.3
"""Standard deviations by which subset simulation and importance sampling may differ: one in a thousand."""


@dataclass
class Rounds:
    """All points drawn, which of them failed, and the densities that they were drawn from.

    A round's weights have the density that it was drawn from, which the round itself did not change: so they are unbiased.
    Against all densities together they would vary less, but those were fitted to the same points: the estimate was then 10 to
    25 % too low on known limit states. The rounds are averaged with sqrt(number), as the later ones are better (Owen and Zhou
    2020, ACM Transactions on Modeling and Computer Simulation 30:13).
    """

    densities: list[Density] = field(default_factory=list)
    points: list[np.ndarray] = field(default_factory=list)
    weights: list[np.ndarray] = field(default_factory=list)

    def draw(self, asked: Asked, density: Density, n: int, random: np.random.Generator) -> None:
        """Draw n points, and weigh those that fail: standard normal density over that of the round, else 0.

        They belong to the round before if that has the same density.
        """
        points = density.draw(n, random)
        weights = np.where(asked(points) <= 0, np.exp(-density.log_ratio(points)), 0.0)
        if self.densities and self.densities[-1] is density:
            points = np.vstack([self.points.pop(), points])
            weights = np.append(self.weights.pop(), weights)
        else:
            self.densities.append(density)
        self.points.append(points)
        self.weights.append(weights)

    @property
    def drawn(self) -> int:
        return sum(map(len, self.points))

    @property
    def terms(self) -> np.ndarray:
        """The contribution of each point to the estimate, which is their sum."""
        parts = zip(self._shares, self.weights, strict=True)
        return np.concatenate([share * w / len(w) for share, w in parts])

    @property
    def _shares(self) -> np.ndarray:
        """Weight of each round in the estimate; their sum is 1."""
        shares = np.array([math.sqrt(i + 1) * len(w) for i, w in enumerate(self.weights)])
        return shares / shares.sum()

    @property
    def probability(self) -> float:
        return float(self.terms.sum())

    @property
    def cov(self) -> float:
        """Coefficient of variation of the estimate; infinite before there are FEWEST failures."""
        if not self.enough:
            return math.inf
        parts = [share**2 * w.var() / len(w) for share, w in zip(self._shares, self.weights, strict=True)]
        return math.sqrt(sum(parts)) / self.probability

    @property
    def enough(self) -> bool:
        """Whether at least FEWEST of the points failed."""
        return sum(map(np.count_nonzero, self.weights)) >= FEWEST

    @property
    def heaviest(self) -> float:
        """The greatest term, as a share of the sum."""
        terms = self.terms
        return float(terms.max() / terms.sum()) if terms.any() else 1.0

    @property
    def effective(self) -> int:
        """Effective sample size: the number of terms of one size that have the same coefficient of variation."""
        terms = self.terms
        return int(effective_size(terms)) if terms.any() else 0

    def failures(self) -> tuple[np.ndarray, np.ndarray]:
        """Failures [n, d] with their weights [n] against all rounds together, which vary less than those against their own."""
        points = np.concatenate(self.points)[np.concatenate(self.weights) > 0]
        return points, self.weights_of(points)

    def weights_of(self, points: np.ndarray) -> np.ndarray:
        """Weights [n] of points [n, d] against all rounds together."""
        shares = np.array(list(map(len, self.points))) / self.drawn
        return np.asarray(np.exp(-Blend(self.densities, shares).log_ratio(points)))

    def doubt(self, run: Run, asked: Asked, about: str, heavy: float) -> str:
        """What speaks against the weights, in words; "" if nothing does.

        Args:
            about: what the points were drawn about, for the words.
            heavy: share of the sum that a single weight may have.
        """
        if not self.enough:
            return f"hardly any of the points drawn about {about} fail"
        if self.heaviest > heavy:
            return f"a single weight is {self.heaviest:.0%} of the sum"
        apart = abs(math.log(self.probability / run.probability))
        if apart > DIFFERS * math.sqrt(math.log1p(run.variance) + math.log1p(self.cov**2)):
            return (
                f"importance sampling gives {self.probability:.1e}, subset simulation {run.probability:.1e}"
            )
        return f"{asked.unknown} values were not a number" if asked.unknown else ""


def effective_size(weights: np.ndarray) -> float:
    """Effective sample size of weights [n] (Kish 1965)."""
    return float(weights.sum() ** 2 / np.sum(weights**2))


def regions_missed(region: np.ndarray, draws: np.ndarray, single: float) -> str:
    """Whether the failures seem to have regions that were not seen, in words; "" if they do not.

    The share of the failures in regions not seen is near that of the independent draws that are alone in theirs (Good 1953,
    Biometrika 40:237).

    Args:
        region: [n] number of the region of each failure.
        draws: [n] the independent draw that each failure descends from.
        single: share of the draws that may be alone.
    """
    pairs = np.unique(np.column_stack([region, draws]), axis=0)
    alone = int(np.sum(np.bincount(pairs[:, 0]) == 1))
    if alone <= single * len(pairs):
        return ""
    return f"{alone} of {len(pairs)} independent lines are alone in their region, and others may be missing"
