"""Importance sampling about the design points of every failure region: `importance` (Schueller and Stix 1987, Structural Safety
4:293; Melchers 1989, Structural Safety 6:3). `Rounds`, what is drawn with its estimate and the doubts about it, also serves
`adaptive`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from scipy import stats
from threadpoolctl import threadpool_limits

from testbed.common.statistics import CONFIDENCE
from testbed.reliability.limit_state import Asked
from testbed.reliability.mixture import AboutPoints, Blend, Density
from testbed.reliability.results import FailureProbability
from testbed.reliability.smallest import search_from
from testbed.reliability.subset import first_run, go_on, instead, log_normal, missing_evaluations
from testbed.reliability.subset_run import Run
from testbed.reliability.surface import Search

FEWEST = 10
"""Number of failures from which on the scatter of their weights is an estimate of its own error."""
DIFFERS = 3.3
"""Standard deviations by which subset simulation and importance sampling may differ: one in a thousand."""
BATCH = 200
MOST_REGIONS = 8
COVERED = 0.8
"""A failure u belongs to the region of design point c if u.c is at least this share of c.c: it then weighs little."""
MISSED = 0.02
"""Share of the failures found beforehand that may belong to no region."""
SINGLE = 0.15
"""Largest share of the independent draws that may be alone in their region. It estimates the share of the failures in regions
that were not found."""
HEAVY = 0.1
"""Share of the sum that a single weight may have."""


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


def importance(asked: Asked, random: np.random.Generator, cov: float) -> FailureProbability:
    """Find the failure regions by a short subset simulation, their design points by search, and draw about these.

    Where that cannot be trusted, subset simulation goes on instead: many regions, failures all around, single heavy
    weights, or a result that differs from that of subset simulation. It also goes on where it has little left to do.
    The interval's upper end has room for a region that none of the independent draws led to: with E draws that failures
    descend from, one with a share q of all failures is missed with probability (1 - q)^E.
    """
    run = first_run(asked, random, cov)
    if run.end != "reached" or missing_evaluations(run, cov) < _search_evaluations(asked) + 2 * BATCH:
        return go_on(asked, random, cov, [run])
    with threadpool_limits(1):  # the number of BLAS threads changes the last bits, and so the points
        mixture = _mixture(asked, run, random)
        if mixture is None:
            return instead(asked, random, cov, run, "the failures are not in a few regions")
        drawn = _draw(asked, mixture, random, cov)
    why = drawn.doubt(run, asked, "the design points", HEAVY)
    why = why or regions_missed(mixture.likeliest(run.failures), run.draws, SINGLE)
    if why:
        return instead(asked, random, cov, run, why)
    regions, reached = len(mixture.shares), drawn.cov <= cov
    said = f"{drawn.drawn} points about {regions} design point{'s' * (regions > 1)}, c.o.v. {drawn.cov:.2f}"
    said += "." if reached else f"; the budget was spent before {cov:g} was reached."
    low, high = log_normal(drawn.probability, drawn.cov, drawn.effective - 1)
    ends = low, min(1.0, high / (1 - CONFIDENCE) ** (1 / run.ancestors))
    return asked.answer("importance", drawn.probability, drawn.cov, ends, run.levels, reached, said)


def _mixture(asked: Asked, run: Run, random: np.random.Generator) -> AboutPoints | None:
    """Design points one after another, each from the nearest failure that belongs to none yet; None with too many."""
    failures = run.failures[np.argsort(np.linalg.norm(run.failures, axis=1), kind="stable")]
    search, centres = Search(asked), np.empty((0, asked.dimensions))
    while len(left := failures[~_covered(failures, centres)]) > (
        MISSED * len(failures) if len(centres) else 0
    ):
        share = min(_search_evaluations(asked), asked.left // 6)
        if len(centres) == MOST_REGIONS or share < 30:
            return None
        search_from(search, left[0], share, random)
        if search.best is None:
            return None
        if not _covered(left[:1], search.best[None])[0]:  # the search left for another region
            search.best = left[0]
        centres = np.vstack([centres, search.best])
        if np.mean(_covered(failures, centres)) < len(centres) / MOST_REGIONS / 2:
            return None
    alone = stats.norm.sf(np.linalg.norm(centres, axis=1))
    return AboutPoints(centres, (alone / alone.sum() + 1 / len(centres)) / 2)


def _search_evaluations(asked: Asked) -> int:
    """Evaluations of the search for one design point."""
    return 60 + 15 * asked.dimensions


def _covered(failures: np.ndarray, centres: np.ndarray) -> np.ndarray:
    """Which of the failures [n] belong to the region of any centre."""
    return np.any(failures @ centres.T >= COVERED * np.sum(centres**2, axis=1), axis=1)


def _draw(asked: Asked, mixture: AboutPoints, random: np.random.Generator, cov: float) -> Rounds:
    """Draw batches until the precision is reached, the weights turn out useless, or the budget is spent."""
    drawn = Rounds()
    while asked.left and (
        drawn.drawn < 2 * BATCH or (drawn.enough and drawn.cov > cov and drawn.heaviest <= HEAVY)
    ):
        drawn.draw(asked, mixture, min(BATCH, asked.left), random)
    return drawn
