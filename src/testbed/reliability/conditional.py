"""Conditional sampling: Markov chains of standard normal points that stay at or below a threshold of the limit state.

A candidate is rho u + s z with z standard normal and rho^2 + s^2 = 1, which leaves the standard normal distribution as it
is; it is accepted if its limit state is at or below the threshold (Papaioannou, Betz, Zwirglmaier and Straub 2015,
Probabilistic Engineering Mechanics 41:89, section 3.2). The spread s follows the share of candidates that are accepted
(section 3.3), one spread for all coordinates: spreads of their own, from the seeds, were measured to be biased where few
chains share the failures.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from testbed.reliability.limit_state import Asked

ACCEPTED = 0.4
"""Acceptance rate to be reached; the optimum is flat, and near 0.44."""


@dataclass
class Spread:
    """The standard deviation s of the candidates, kept from level to level."""

    value: float = 0.6

    def follow(self, accepted: float, step: int) -> None:
        """Enlarge the spread if more than ACCEPTED of the candidates were accepted, by less with each step of a level."""
        self.value = min(1.0, self.value * math.exp((accepted - ACCEPTED) / math.sqrt(step)))


@dataclass(frozen=True)
class Chains:
    """Points [steps + 1, chains, d] of all chains with their values, the share of candidates accepted, and how many were NaN."""

    points: np.ndarray
    values: np.ndarray
    accepted: float
    unknown: int


def run_chains(
    asked: Asked,
    points: np.ndarray,
    values: np.ndarray,
    threshold: float,
    steps: int,
    spread: Spread,
    random: np.random.Generator,
) -> Chains:
    """Run a chain from each of `points` [n, d], all in parallel: one batch of n evaluations for each of the `steps`."""
    all_points, all_values = [points], [values]
    accepted, unknown = 0, 0
    for step in range(1, steps + 1):
        rho = math.sqrt(1 - spread.value**2)
        candidates = rho * points + spread.value * random.standard_normal(points.shape)
        found = asked(candidates)
        inside = found <= threshold  # False for NaN
        points = np.where(inside[:, None], candidates, points)
        values = np.where(inside, found, values)
        spread.follow(inside.mean(), step)
        accepted, unknown = accepted + int(inside.sum()), unknown + int(np.isnan(found).sum())
        all_points.append(points)
        all_values.append(values)
    return Chains(np.array(all_points), np.array(all_values), accepted / (steps * len(points)), unknown)
