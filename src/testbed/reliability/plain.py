"""Plain Monte Carlo: independent standard normal draws, with the exact interval. The check of the other methods."""

from __future__ import annotations

import math

import numpy as np

from testbed.common.statistics import proportion
from testbed.reliability.limit_state import Asked
from testbed.reliability.results import FailureProbability, Level

BATCH = 1000


def plain(
    asked: Asked, random: np.random.Generator, cov: float, failures: int = 0, n: int = 0
) -> FailureProbability:
    """Draw batches, after `failures` in `n` draws, until the coefficient of variation is at most `cov` or the budget is spent.

    It is sqrt((1 - p) / (p n)). The interval is that of Clopper and Pearson (1934). Points without a number widen it: its
    upper end counts them as failures.
    """
    while asked.left > 0 and _cov(failures, n) > cov:
        values = asked(random.standard_normal((min(BATCH, asked.left), asked.dimensions)))
        failures += int((values <= 0).sum())
        n += len(values)
    known, found = proportion(failures, n, method="exact"), _cov(failures, n)
    high = proportion(failures + asked.unknown, n, method="exact").high
    level = Level(0.0, known.estimate, found, n)
    converged = found <= cov and not asked.unknown
    reason = _reason(asked, failures, n, converged)
    return asked.answer("plain", known.estimate, found, (known.low, high), [level], converged, reason)


def _cov(failures: int, n: int) -> float:
    return math.sqrt((n - failures) / (failures * n)) if failures else math.inf


def _reason(asked: Asked, failures: int, n: int, converged: bool) -> str:
    if asked.unknown:
        return f"{asked.unknown} of {n} values were not a number; the interval's upper end counts them as failures."
    said = f"{failures} failure{'s' * (failures != 1)} in {n} independent draws"
    return (
        f"{said}." if converged else f"{said}; the budget was spent before the asked precision was reached."
    )
