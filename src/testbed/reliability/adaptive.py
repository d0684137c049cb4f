"""Adaptive importance sampling with mixtures of normals that follow the failures: `adaptive`.

Subset simulation finds the failures. Points are then drawn in rounds from a mixture fitted to what has failed so far, which takes
the shape of the failures where a few design points cannot (population Monte Carlo, Cappe and others 2004, Journal of
Computational and Graphical Statistics 13:907; subset simulation before it, Helal and Elvira 2025, arXiv:2508.00210).
"""

from __future__ import annotations

import math

import numpy as np
from threadpoolctl import threadpool_limits

from testbed.common.statistics import CONFIDENCE
from testbed.reliability.importance import Rounds, effective_size, regions_missed
from testbed.reliability.limit_state import Asked
from testbed.reliability.mixture import Blend, Mixture, fitted
from testbed.reliability.results import FailureProbability
from testbed.reliability.subset import first_run, go_on, instead, log_normal, missing_evaluations
from testbed.reliability.subset_run import Run

ROUND = 500
LEAST = 3 * ROUND
"""Fewest points drawn: the first rounds look for regions."""
TARGET = 0.4
"""Coefficient of variation of the weights to be reached, as a share of that asked: what regions were missed comes on top."""
SPENT = 2 / 3
"""Share of what the subset simulation left of the budget that may be drawn; the rest is for going on without."""
MOST_DIMENSIONS = 200
"""In more dimensions the failures found are too few to fit where they differ from other points."""
LEVELS, EVERYWHERE = 0.6, 0.1
"""Shares of the first points that are drawn about the two levels above the failures, and from a broad normal."""
BROAD = 1.7
"""Standard deviations of the broad normal."""
KEPT = 0.4
"""Share of each further round that is drawn like the first."""
WIDER = 1.1
"""Factor on the covariances of what is fitted to the failures drawn."""
ALIKE = 60
"""Effective sample size to which the weights of the failures are flattened, before a mixture is fitted to them."""
CHAINED, COPIED = 3, 4
"""Correlated points that count as one independent point: points of a level, and failures of chains."""
HEAVY = 0.2
"""Share of the sum that a single weight may have."""
UNCOVERED = 0.05
"""Share of the failures found before that may be where a point drawn would have more than HEAVY of the sum."""
SINGLE = 0.5
"""Share of the independent draws that may be alone in their region."""
APART = 4.0
"""Standard deviations between the means of components of different regions."""


def adaptive(asked: Asked, random: np.random.Generator, cov: float) -> FailureProbability:
    """Find the failures by subset simulation, then draw in rounds from mixtures fitted to all that is known of them.

    Subset simulation goes on instead where it has little left to do, where the weights cannot be trusted, or where the failures
    seem to be in regions that it has not seen. The coefficient of variation has room for a region that none of the E
    independent draws led to that failures descend from: such a region has 1 / (E + 1) of the failures on average.
    """
    run = first_run(asked, random, cov)
    little = run.end == "reached" and missing_evaluations(run, cov) < LEAST
    if run.end != "reached" or little or asked.dimensions > MOST_DIMENSIONS:
        return go_on(asked, random, cov, [run])
    with threadpool_limits(1):  # the number of BLAS threads changes the last bits, and so the points
        rounds, last = _drawn(asked, run, random, cov)
        why = _doubt(rounds, last, run, asked)
    if why:
        return instead(asked, random, cov, run, why)
    whole = math.hypot(rounds.cov, 1 / (run.ancestors + 1))
    low, high = log_normal(rounds.probability, whole, rounds.effective - 1)
    ends = low, min(1.0, max(high, rounds.probability / (1 - CONFIDENCE) ** (1 / run.ancestors)))
    said = (
        f"{rounds.drawn} points in {len(rounds.points)} rounds about the failures, c.o.v. {rounds.cov:.2f}, "
        f"{whole:.2f} with what {run.ancestors} independent lines may have missed"
    )
    said += "." if whole <= cov else f"; {cov:g} was not reached."
    return asked.answer("adaptive", rounds.probability, whole, ends, run.levels, whole <= cov, said)


def _drawn(asked: Asked, run: Run, random: np.random.Generator, cov: float) -> tuple[Rounds, Mixture]:
    """Draw rounds until the precision is reached, or SPENT of the budget; with the last mixture fitted."""
    rounds, (last, first) = Rounds(), _first(run, random)
    density, most = first, int(SPENT * asked.left)
    while rounds.drawn < most and (
        rounds.drawn < LEAST or rounds.cov > TARGET * cov or rounds.heaviest > HEAVY
    ):
        rounds.draw(asked, density, min(ROUND, most - rounds.drawn), random)
        if rounds.enough:
            last = _fitted(rounds, run, random)
            density = Blend([last.wider(WIDER), *first.parts], np.array([1 - KEPT, *(KEPT * first.shares)]))
    return rounds, last


def _first(run: Run, random: np.random.Generator) -> tuple[Mixture, Blend]:
    """The mixture fitted to the failures of the subset simulation; and its blend with those of the two levels above them, in which
    rarer regions are more often seen."""
    about = fitted(run.failures, _equal(run.failures), _known(run), random)
    levels = [
        fitted(points, _equal(points), len(points) / CHAINED, random).wider(1.0)
        for points in reversed(run.populations[:-1])
    ]
    broad = levels[-1] if levels else about
    each = [LEVELS / len(levels)] * len(levels) if levels else []
    shares = np.array([1 - EVERYWHERE - sum(each), EVERYWHERE, *each])
    return about, Blend([about, broad.broad(BROAD), *levels], shares)


def _equal(points: np.ndarray) -> np.ndarray:
    return np.full(len(points), 1 / len(points))


def _known(run: Run) -> float:
    """Number of independent failures that those of the subset simulation count as."""
    return float(max(len(np.unique(run.failures, axis=0)) / COPIED, run.ancestors))


def _fitted(rounds: Rounds, run: Run, random: np.random.Generator) -> Mixture:
    """The mixture fitted to the failures drawn, and to those of the subset simulation, which count a quarter."""
    points, weights = rounds.failures()
    weights, effective = _flattened(weights)
    before = _known(run) / 4
    share = effective / (effective + before)
    return fitted(
        np.vstack([points, run.failures]),
        np.concatenate([share * weights, (1 - share) * _equal(run.failures)]),
        effective + before,
        random,
    )


def _flattened(weights: np.ndarray) -> tuple[np.ndarray, float]:
    """The weights to a power of at most 1, with which their effective sample size is ALIKE, and that size; their sum is 1."""
    wanted, low, high = min(ALIKE, len(weights)), 0.0, 1.0
    if effective_size(weights) < wanted:
        for _ in range(30):
            middle = (low + high) / 2
            low, high = (middle, high) if effective_size(weights**middle) >= wanted else (low, middle)
        weights = weights**low
    return weights / weights.sum(), effective_size(weights)


def _doubt(rounds: Rounds, last: Mixture, run: Run, asked: Asked) -> str:
    """Why the weights are not to be trusted; "" if nothing speaks against them."""
    if why := rounds.doubt(run, asked, "the failures", HEAVY):
        return why
    uncovered = float(np.mean(rounds.weights_of(run.failures) > HEAVY * rounds.drawn * rounds.probability))
    if uncovered > UNCOVERED:
        return f"{uncovered:.0%} of the failures found before are where hardly any point was drawn"
    along = run.failures @ last.basis
    parts = last.mean_log(along, _equal(along))[1]
    return regions_missed(_regions(last)[np.argmax(parts, axis=0)], run.draws, SINGLE)


def _regions(mixture: Mixture) -> np.ndarray:
    """Region [k] of each component: those less than APART from each other, or from a third, share one."""
    region = np.arange(len(mixture.shares))
    for i in range(len(region)):
        for j in range(i):
            between = mixture.means[i] - mixture.means[j]
            covariance = (mixture.covariances[i] + mixture.covariances[j]) / 2
            if between @ np.linalg.solve(covariance, between) < APART**2:
                region[region == region[i]] = region[j]
    return region
