"""One run of subset simulation: from independent draws down to the failures, level by level.

Au and Beck 2001, Probabilistic Engineering Mechanics 16:263. Each level is the tenth of the points with the lowest limit
state; Markov chains from these fill the level, until the failures are common enough to be counted.

A chain's candidate is rho u + s z with z standard normal and rho^2 + s^2 = 1, which leaves the standard normal distribution as
it is; it is accepted if its limit state is at or below the threshold (Papaioannou, Betz, Zwirglmaier and Straub 2015,
Probabilistic Engineering Mechanics 41:89, section 3.2). The spread s follows the share of candidates that are accepted
(section 3.3), one spread for all coordinates: spreads of their own, from the seeds, were measured to be biased where few
chains share the failures.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from testbed.common.statistics import proportion
from testbed.reliability.limit_state import Asked
from testbed.reliability.results import Level

LENGTH = 10
"""Points of each chain with its seed; 1 / LENGTH is the probability of each level given the one before."""
ENOUGH = 0.05
"""Share of failures in a level that is counted, without a further level."""
FLAT = 0.5
"""Share of a level with the same lowest value, from which on nothing shows the way down."""
FEWEST = 5
"""Fewest points below a flat part from which chains are run."""
ACCEPTED = 0.4
"""Acceptance rate to be reached; the optimum is flat, and near 0.44."""
STUCK = 0.1
"""Acceptance rate below which the points of a chain are mostly copies of each other."""


@dataclass
class Run:
    """Levels so far, and the failures [n, d] in the last one, each with the independent draw that it descends from.

    `populations` are the points of the last three levels, each inside the threshold of the level before it. `end` is
    reached, budget, flat or stuck. `unknown` are the upper ends of the share of points without a number. `spread` is the standard
    deviation s of the candidates, kept from level to level.
    """

    size: int
    spread: float = 0.6
    levels: list[Level] = field(default_factory=list)
    unknown: list[float] = field(default_factory=list)
    end: str = ""
    accepted: float = 1.0
    ancestors: int = 0
    shared: float = math.inf
    failures: np.ndarray = field(default_factory=lambda: np.empty((0, 0)))
    draws: np.ndarray = field(default_factory=lambda: np.empty(0, dtype=int))
    populations: list[np.ndarray] = field(default_factory=list)

    @property
    def probability(self) -> float:
        return math.prod(level.probability for level in self.levels)

    @property
    def above(self) -> float:
        """Probability of the last level but one, the lowest that is certain to hold every failure."""
        return math.prod(level.probability for level in self.levels[:-1])

    @property
    def variance(self) -> float:
        """Square of the coefficient of variation: the greater of two estimates.

        One is the sum over the levels, as if they were independent (Au and Beck 2001, equation 29). The other follows the
        failures back to the independent draws they come from: sum(n_i^2) / n^2, with n_i failures from draw i. So it has
        the correlation between the levels too (Lee and Whiteley 2018, Biometrika 105:609).
        """
        return max(sum(level.cov**2 for level in self.levels), self.shared)

    @property
    def evaluations(self) -> int:
        return sum(level.evaluations for level in self.levels)


@dataclass(frozen=True)
class Population:
    """The points of a level: their values, the chain and the independent draw that each comes from, and their cost."""

    points: np.ndarray
    values: np.ndarray
    chain: np.ndarray
    draw: np.ndarray
    evaluations: int


def run_levels(asked: Asked, size: int, random: np.random.Generator) -> Run:
    """Run subset simulation with `size` points a level, a multiple of LENGTH."""
    run = Run(size)
    population = _draw(asked, run, random)
    while not run.end:
        run.populations = [*run.populations[-2:], population.points]
        threshold = _threshold(population.values, size // LENGTH)
        inside = population.values <= threshold
        run.levels.append(_level(population, inside, threshold))
        run.end = _end(run, inside, asked)
        if not run.end:
            population = _next(asked, run, population, inside, random)
    failing = population.values <= 0
    run.failures, run.draws = population.points[failing], population.draw[failing]
    shares = np.bincount(run.draws) / max(failing.sum(), 1)
    run.ancestors = int(np.count_nonzero(shares))
    run.shared = float(np.sum(shares**2)) if run.ancestors else math.inf
    return run


def _draw(asked: Asked, run: Run, random: np.random.Generator) -> Population:
    """The first level: independent draws."""
    points = random.standard_normal((run.size, asked.dimensions))
    values = asked(points)
    run.unknown.append(_most_unknown(int(np.isnan(values).sum()), run.size))
    each = np.arange(run.size)
    return Population(points, np.where(np.isnan(values), np.inf, values), each, each, run.size)


def _threshold(values: np.ndarray, chains: int) -> float:
    """The value that a tenth is at or below; 0 once enough of the points fail.

    Where most of the points share that value, as where the limit state is saturated, the greatest below it.
    """
    if np.mean(values <= 0) >= ENOUGH:
        return 0.0
    lowest = float(np.partition(values, chains - 1)[chains - 1])
    below = values[values < lowest]
    if np.mean(values <= lowest) > FLAT and len(below) >= max(FEWEST, chains / 10):
        lowest = float(below.max())
    return max(lowest, 0.0)


def _level(population: Population, inside: np.ndarray, threshold: float) -> Level:
    """The level with its coefficient of variation, from the sums over its independent parts, the chains."""
    share = float(inside.mean())
    if share == 0:
        return Level(threshold, 0.0, math.inf, population.evaluations)
    sums = np.bincount(population.chain, weights=inside - share)
    return Level(threshold, share, float(np.sqrt(np.sum(sums**2)) / inside.sum()), population.evaluations)


def _end(run: Run, inside: np.ndarray, asked: Asked) -> str:
    """Why the run ends with this level, "" if it does not."""
    if run.accepted < STUCK:
        return "stuck"
    if run.levels[-1].threshold <= 0:
        return "reached"
    if inside.mean() > FLAT or not math.isfinite(run.levels[-1].threshold):
        return "flat"
    return "" if asked.left >= 2 * (run.size // LENGTH) else "budget"


def _next(
    asked: Asked, run: Run, population: Population, inside: np.ndarray, random: np.random.Generator
) -> Population:
    """The points of the next level, by chains from a tenth of the points that are inside it, all in parallel."""
    seeds = random.permutation(np.flatnonzero(inside))[: run.size // LENGTH]
    chains = len(seeds)
    steps = min(run.size // chains - 1, asked.left // chains)
    points, values = [population.points[seeds]], [population.values[seeds]]
    accepted, unknown = 0, 0
    for step in range(1, steps + 1):
        rho = math.sqrt(1 - run.spread**2)
        candidates = rho * points[-1] + run.spread * random.standard_normal(points[-1].shape)
        found = asked(candidates)
        taken = found <= run.levels[-1].threshold  # False for NaN
        points.append(np.where(taken[:, None], candidates, points[-1]))
        values.append(np.where(taken, found, values[-1]))
        run.spread = min(1.0, run.spread * math.exp((taken.mean() - ACCEPTED) / math.sqrt(step)))
        accepted, unknown = accepted + int(taken.sum()), unknown + int(np.isnan(found).sum())
    run.accepted = accepted / (steps * chains)
    run.unknown.append(run.probability * _most_unknown(unknown, steps * chains))
    return Population(
        points=np.concatenate(points),
        values=np.concatenate(values),
        chain=np.tile(np.arange(chains), steps + 1),
        draw=np.tile(population.draw[seeds], steps + 1),
        evaluations=steps * chains,
    )


def _most_unknown(unknown: int, n: int) -> float:
    """Upper end of the share of points without a number; 0 if there were none."""
    return proportion(unknown, n, method="exact").high if unknown else 0.0
