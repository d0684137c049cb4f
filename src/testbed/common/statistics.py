"""Probabilities and bounds from counts of flights, with their uncertainty. Each function cites its method.

Runs are assumed to be independent. Latin hypercubes and scrambled Sobol points cover the inputs more evenly than
independent draws; for these the intervals tend to be too wide, not too narrow.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np
from scipy import stats

CONFIDENCE = 0.95
_RESAMPLES = 4000
_MOST = 10**15  # runs that are looked for
Method = Literal["wilson", "exact"]


class _Known:
    """A result of which `plain` is what JSON can hold."""

    @property
    def plain(self) -> dict[str, Any]:
        return asdict(self)  # type: ignore[call-overload]


@dataclass(frozen=True)
class Proportion(_Known):
    """A probability estimated from counts, with its confidence interval `low` to `high`."""

    successes: int
    n: int
    estimate: float
    low: float
    high: float
    confidence: float
    method: str


def proportion(
    successes: int, n: int, confidence: float = CONFIDENCE, method: Method = "wilson"
) -> Proportion:
    """A probability with its interval, from `successes` of `n` runs; the interval is [0, 1] if there are no runs.

    Method `wilson` is the score interval (Wilson 1927), whose coverage is close to the confidence. `exact` (Clopper and
    Pearson 1934) never covers less than the confidence.
    """
    if n == 0:
        return Proportion(0, 0, math.nan, 0.0, 1.0, confidence, method)
    interval = stats.binomtest(int(successes), int(n)).proportion_ci(confidence, method=method)
    low, high = float(interval.low), float(interval.high)
    return Proportion(int(successes), int(n), successes / n, low, high, confidence, method)


@dataclass(frozen=True)
class Paired(_Known):
    """Two variants with the same draws: how often both, only one, or neither passed, and the difference first minus second."""

    both: int
    only_first: int
    only_second: int
    neither: int
    difference: float
    low: float
    high: float
    confidence: float
    p_value: float


def paired(first: Sequence[bool], second: Sequence[bool], confidence: float = CONFIDENCE) -> Paired:
    """Difference of two pass probabilities from the same runs.

    The test is the exact McNemar test. Its hypothesis is that in runs in which just one passed, each is equally likely to
    be that one (binomial with 1/2). The interval is Newcombe's (1998, Statistics in Medicine 17:2635, method 10).
    """
    a, b = np.asarray(first, dtype=bool), np.asarray(second, dtype=bool)
    both, only_a = int(np.sum(a & b)), int(np.sum(a & ~b))
    only_b, neither = int(np.sum(~a & b)), int(np.sum(~a & ~b))
    n, discordant = len(a), only_a + only_b
    p_value = float(stats.binomtest(only_a, discordant).pvalue) if discordant else 1.0
    difference = (only_a - only_b) / n if n else math.nan
    low, high = _newcombe(both, only_a, only_b, neither, confidence) if n else (-1.0, 1.0)
    return Paired(both, only_a, only_b, neither, difference, low, high, confidence, p_value)


@dataclass(frozen=True)
class Mean(_Known):
    """A mean with its confidence interval `low` to `high`."""

    estimate: float
    low: float
    high: float
    confidence: float


def rate(events: int, exposure: float, confidence: float = CONFIDENCE) -> Mean:
    """Events of a Poisson process per unit of exposure, with the exact interval (Garwood 1936); NaN where nothing was exposed."""
    if exposure <= 0.0:
        return Mean(math.nan, math.nan, math.nan, confidence)
    tail = 0.5 * (1.0 - confidence)
    low = stats.chi2.ppf(tail, 2 * events) if events else 0.0
    high = stats.chi2.isf(tail, 2 * events + 2)
    return Mean(events / exposure, float(low) / (2.0 * exposure), float(high) / (2.0 * exposure), confidence)


def mean(values: Sequence[float], confidence: float = CONFIDENCE) -> Mean:
    """The mean of independent values, or of differences by pairs, with the percentile interval of the bootstrap (Efron 1979).

    The resamples are the same whenever it is asked for the same number of values.
    """
    known = np.asarray(values, dtype=float)
    if not len(known):
        return Mean(math.nan, math.nan, math.nan, confidence)
    random = np.random.default_rng(len(known))
    means = [float(known[random.integers(len(known), size=len(known))].mean()) for _ in range(_RESAMPLES)]
    tail = 0.5 * (1.0 - confidence)
    low, high = np.quantile(means, [tail, 1.0 - tail])
    return Mean(float(known.mean()), float(low), float(high), confidence)


def _newcombe(both: int, only_a: int, only_b: int, neither: int, confidence: float) -> tuple[float, float]:
    """Newcombe's interval: Wilson intervals of the two proportions, combined with the correlation phi of the pairs."""
    n = both + only_a + only_b + neither
    one = proportion(both + only_a, n, confidence)
    two = proportion(both + only_b, n, confidence)
    margins = (both + only_a) * (only_b + neither) * (both + only_b) * (only_a + neither)
    cross = both * neither - only_a * only_b
    phi = 0.0
    if margins:
        corrected = max(cross - n / 2.0, 0.0) if cross > 0 else cross
        phi = corrected / math.sqrt(margins)
    d = one.estimate - two.estimate
    down, up = one.estimate - one.low, one.high - one.estimate
    down_two, up_two = two.estimate - two.low, two.high - two.estimate
    below = math.sqrt(max(0.0, down**2 - 2 * phi * down * up_two + up_two**2))
    above = math.sqrt(max(0.0, up**2 - 2 * phi * up * down_two + down_two**2))
    return max(-1.0, d - below), min(1.0, d + above)


def tolerance_bound(values: Sequence[float], coverage: float, confidence: float = CONFIDENCE) -> float | None:
    """Value below which, with this confidence, at least the share `coverage` of all flights stays.

    It is an order statistic, valid for any distribution (Wilks 1941): the smallest r-th value of n for which
    P(Binomial(n, coverage) <= r - 1) >= confidence. None if there are so few runs that even the largest value does not
    suffice. Enter lost flights as infinity; the bound is then infinite if it falls on one of them.
    """
    n = len(values)
    rank = int(stats.binom.ppf(confidence, n, coverage)) + 1 if n else 1
    while rank <= n and stats.binom.cdf(rank - 1, n, coverage) < confidence:
        rank += 1
    return float(np.sort(np.asarray(values, dtype=float))[rank - 1]) if rank <= n else None


def runs_for_tolerance(coverage: float, confidence: float = CONFIDENCE) -> int:
    """Least number of runs n for which the largest value is a tolerance bound: 1 - coverage^n >= confidence (Wilks 1941)."""
    return math.ceil(math.log1p(-confidence) / math.log(coverage) - 1e-12)


def runs_needed(claim: float, failures: int = 0, confidence: float = CONFIDENCE) -> int:
    """Least number of runs, `failures` of them failed, that shows P(pass) >= claim with this confidence.

    One-sided Clopper-Pearson: P(at most `failures` fail | P(pass) = claim) <= 1 - confidence. Without
    failures this is ln(1 - confidence) / ln(claim): 299 runs for 0.99, 2995 for 0.999.
    """
    return _least(failures + 1, lambda n: stats.binom.cdf(failures, n, 1.0 - claim) <= 1.0 - confidence)


def runs_for_half_width(estimate: float, half_width: float, confidence: float = CONFIDENCE) -> int:
    """Least number of runs after which a probability near `estimate` is known to +- half_width (Wilson)."""
    z = float(stats.norm.ppf(0.5 + confidence / 2.0))

    def narrow(n: int) -> bool:
        spread = estimate * (1.0 - estimate) / n + z * z / (4.0 * n * n)
        return z * math.sqrt(spread) / (1.0 + z * z / n) <= half_width

    return _least(1, narrow)


def _least(low: int, enough: Callable[[int], bool]) -> int:
    """The least number from `low` on that is enough, as all greater ones are."""
    return bisect_left(range(_MOST), True, low, key=enough)
