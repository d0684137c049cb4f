"""Importance sampling about the design points of every failure region: `importance`.

Schueller and Stix 1987, Structural Safety 4:293; Melchers 1989, Structural Safety 6:3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from scipy import stats
from scipy.special import logsumexp
from threadpoolctl import threadpool_limits

from testbed.common.statistics import CONFIDENCE
from testbed.reliability.doubt import doubt, regions_missed
from testbed.reliability.limit_state import Asked
from testbed.reliability.results import FailureProbability
from testbed.reliability.smallest import search_from
from testbed.reliability.subset import first_run, go_on, instead, log_normal, missing_evaluations
from testbed.reliability.subset_run import Run
from testbed.reliability.surface import Search

EXPLORED = 1 / 8
"""Points a level of the subset simulation that looks for regions, as a share of the budget."""
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
class Mixture:
    """Standard normals about the design points `centres` [k, d], drawn with the probabilities `shares` [k]."""

    centres: np.ndarray
    shares: np.ndarray

    def draw(self, n: int, random: np.random.Generator) -> np.ndarray:
        """Draw n points [n, d]."""
        centre = self.centres[random.choice(len(self.shares), n, p=self.shares)]
        return centre + random.standard_normal(centre.shape)

    def weights(self, points: np.ndarray) -> np.ndarray:
        """Standard normal density over that of the mixture, at points [n, d]."""
        exponents = points @ self.centres.T - np.sum(self.centres**2, axis=1) / 2
        return np.exp(-logsumexp(exponents, axis=1, b=self.shares))


@dataclass
class Weighed:
    """Weights of the drawn points, 0 for those that do not fail."""

    weights: np.ndarray = field(default_factory=lambda: np.empty(0))

    @property
    def probability(self) -> float:
        return float(self.weights.mean())

    @property
    def cov(self) -> float:
        """Coefficient of variation of the mean; infinite before there are 10 failures."""
        if np.count_nonzero(self.weights) < 10:
            return math.inf
        return float(self.weights.std() / self.weights.mean() / math.sqrt(len(self.weights)))

    @property
    def heaviest(self) -> float:
        """The greatest weight, as a share of the sum."""
        return float(self.weights.max() / self.weights.sum())

    @property
    def useless(self) -> bool:
        """Whether fewer than 10 points failed, or one weight is more than HEAVY of the sum."""
        return not math.isfinite(self.cov) or self.heaviest > HEAVY

    @property
    def effective(self) -> int:
        """Effective sample size (Kish 1965): the number of equal weights that have the same coefficient of variation."""
        return int(self.weights.sum() ** 2 / np.sum(self.weights**2))


def importance(asked: Asked, random: np.random.Generator, cov: float) -> FailureProbability:
    """Find the failure regions by a short subset simulation, their design points by search, and draw about these.

    Where that cannot be trusted, subset simulation goes on instead: many regions, failures all around, single heavy
    weights, or a result that differs from that of subset simulation. It also goes on where it has little left to do.
    The interval's upper end has room for a region that none of the independent draws led to: with E draws that failures
    descend from, one with a share q of all failures is missed with probability (1 - q)^E.
    """
    run = first_run(asked, random, cov, share=EXPLORED)
    if run.end != "reached" or missing_evaluations(run, cov) < _search_evaluations(asked) + 2 * BATCH:
        return go_on(asked, random, cov, [run])
    with threadpool_limits(1):  # the number of BLAS threads changes the last bits, and so the points
        mixture = _mixture(asked, run, random)
        if mixture is None:
            return instead(asked, random, cov, run, "the failures are not in a few regions")
        drawn = _draw(asked, mixture, random, cov)
    why = doubt(drawn, run, asked, "the design points", HEAVY)
    why = why or regions_missed(_regions(mixture, run.failures), run.draws, SINGLE)
    if why:
        return instead(asked, random, cov, run, why)
    return _result(asked, run, drawn, cov, len(mixture.shares))


def _mixture(asked: Asked, run: Run, random: np.random.Generator) -> Mixture | None:
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
    return Mixture(centres, (alone / alone.sum() + 1 / len(centres)) / 2)


def _search_evaluations(asked: Asked) -> int:
    """Evaluations of the search for one design point."""
    return 60 + 15 * asked.dimensions


def _covered(failures: np.ndarray, centres: np.ndarray) -> np.ndarray:
    """Which of the failures [n] belong to the region of any centre."""
    return np.any(failures @ centres.T >= COVERED * np.sum(centres**2, axis=1), axis=1)


def _draw(asked: Asked, mixture: Mixture, random: np.random.Generator, cov: float) -> Weighed:
    """Draw batches until the precision is reached, the weights turn out useless, or the budget is spent."""
    drawn = Weighed()
    while asked.left and (len(drawn.weights) < 2 * BATCH or (drawn.cov > cov and not drawn.useless)):
        points = mixture.draw(min(BATCH, asked.left), random)
        failing = asked(points) <= 0
        drawn.weights = np.append(drawn.weights, np.where(failing, mixture.weights(points), 0.0))
    return drawn


def _regions(mixture: Mixture, failures: np.ndarray) -> np.ndarray:
    """The design point [n] about which each of the failures [n, d] is likeliest to have been drawn."""
    likely = failures @ mixture.centres.T - np.sum(mixture.centres**2, axis=1) / 2
    return np.asarray(np.argmax(likely, axis=1))


def _result(asked: Asked, run: Run, drawn: Weighed, cov: float, regions: int) -> FailureProbability:
    said = f"{len(drawn.weights)} points about {regions} design point{'s' * (regions > 1)}, c.o.v. {drawn.cov:.2f}"
    reached = drawn.cov <= cov
    low, high = log_normal(drawn.probability, drawn.cov, drawn.effective - 1)
    high = min(1.0, high / (1 - CONFIDENCE) ** (1 / run.ancestors))
    return FailureProbability(
        probability=drawn.probability,
        cov=drawn.cov,
        interval=(low, high),
        evaluations=asked.evaluations,
        method="importance",
        levels=tuple(run.levels),
        design_point=asked.nearest,
        converged=reached,
        reason=f"{said}." if reached else f"{said}; the budget was spent before {cov:g} was reached.",
    )
