"""Statistics against published numbers, closed forms, and simulated truth."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats

from testbed.common.statistics import (
    paired,
    proportion,
    rate,
    runs_for_half_width,
    runs_for_tolerance,
    runs_needed,
    tolerance_bound,
)


@pytest.mark.parametrize(
    ("successes", "n", "method", "low", "high"),
    [  # Newcombe (1998), Statistics in Medicine 17:857, table I, methods 3 (Wilson) and 5 (Clopper-Pearson)
        (81, 263, "wilson", 0.2553, 0.3662),
        (81, 263, "exact", 0.2527, 0.3676),
        (15, 148, "wilson", 0.0624, 0.1605),
        (15, 148, "exact", 0.0578, 0.1617),
        (0, 20, "wilson", 0.0, 0.1611),
        (0, 20, "exact", 0.0, 0.1684),
        (1, 29, "wilson", 0.0061, 0.1718),
        (1, 29, "exact", 0.0009, 0.1776),
    ],
)
def test_intervals_of_a_proportion(successes: int, n: int, method: str, low: float, high: float) -> None:
    known = proportion(successes, n, method=method)  # type: ignore[arg-type]
    assert (round(known.low, 4), round(known.high, 4)) == (low, high)


def test_no_runs_say_nothing() -> None:
    known = proportion(0, 0)
    assert math.isnan(known.estimate) and (known.low, known.high) == (0.0, 1.0)


def test_the_exact_test_of_pairs() -> None:
    """McNemar's exact p is twice the binomial's tail of the discordant pairs."""
    first = [True] * 59 + [True] * 6 + [False] * 16 + [False] * 80
    second = [True] * 59 + [False] * 6 + [True] * 16 + [False] * 80
    found = paired(first, second)
    assert (found.both, found.only_first, found.only_second, found.neither) == (59, 6, 16, 80)
    tail = sum(math.comb(22, k) for k in range(7)) / 2**22
    assert found.p_value == pytest.approx(2 * tail)
    assert found.difference == pytest.approx(-10 / 161)
    assert found.low < found.difference < found.high < 0.01
    assert paired(first, first).p_value == 1.0


@pytest.mark.nightly
def test_the_interval_of_pairs_holds_the_truth() -> None:
    """95 % of intervals hold the true difference, within what 2000 simulated sweeps can tell."""
    rng = np.random.default_rng(8)
    u = rng.random((2000, 120))
    first, second = u < 0.8, (u < 0.65) ^ (rng.random(u.shape) < 0.05)
    truth = 0.8 - (0.65 * 0.95 + 0.35 * 0.05)
    held = sum(r.low <= truth <= r.high for r in (paired(a, b) for a, b in zip(first, second, strict=True)))
    assert 0.93 < held / 2000 < 0.985


def test_tolerance_bounds_are_order_statistics() -> None:
    """Wilks: 59 runs for 95/95 by the largest, 93 by the second largest, 124 by the third; 299 for 95/99."""
    assert (runs_for_tolerance(0.95), runs_for_tolerance(0.99), runs_for_tolerance(0.9)) == (59, 299, 29)
    for n, rank in ((59, 1), (92, 1), (93, 2), (123, 2), (124, 3)):
        assert tolerance_bound(list(range(n)), 0.95) == n - rank
    assert tolerance_bound(list(range(58)), 0.95) is None
    assert tolerance_bound([], 0.95) is None
    assert tolerance_bound([*range(92), math.inf], 0.95) == 91.0  # one lost flight of 93 is allowed for
    assert tolerance_bound([*range(58), math.inf], 0.95) == math.inf


def test_a_tolerance_bound_keeps_its_promise() -> None:
    """In at least 95 % of simulated sweeps the bound is above the true 90 % quantile."""
    rng = np.random.default_rng(9)
    quantile = stats.norm.ppf(0.9)
    bounds = [tolerance_bound(rng.standard_normal(150).tolist(), 0.9) for _ in range(2000)]
    above = [bound is not None and bound >= quantile for bound in bounds]
    assert 0.945 < np.mean(above) < 0.99


def test_runs_that_a_claim_needs() -> None:
    assert [runs_needed(claim) for claim in (0.9, 0.95, 0.99, 0.999)] == [29, 59, 299, 2995]
    assert [runs_needed(0.95, failures) for failures in (0, 1, 2)] == [59, 93, 124]
    for failures in (0, 3, 17):
        n = runs_needed(0.97, failures)
        low, fewer = (stats.binomtest(m - failures, m).proportion_ci(0.9, "exact").low for m in (n, n - 1))
        assert low >= 0.97 > fewer  # 90 % two-sided is 95 % one-sided


def test_runs_for_a_half_width() -> None:
    for estimate, half_width in ((0.5, 0.01), (0.93, 0.02), (1.0, 0.005)):
        n = runs_for_half_width(estimate, half_width)
        z = stats.norm.ppf(0.975)
        widths = [
            z * math.sqrt(estimate * (1 - estimate) / m + z * z / (4 * m * m)) / (1 + z * z / m)
            for m in (n, n - 1)
        ]
        assert widths[0] <= half_width < widths[1]
    assert abs(runs_for_half_width(0.5, 0.01) - 9604) < 10


def test_a_rate_has_garwoods_interval() -> None:
    """Chi-square limits of a Poisson mean, as tabled by Garwood (1936): 0 and 10 events."""
    assert (rate(0, 2.0).low, rate(0, 2.0).high) == (0.0, pytest.approx(3.689 / 2.0, abs=5e-4))
    ten = rate(10, 4.0)
    assert (ten.estimate, ten.low, ten.high) == (
        2.5,
        pytest.approx(4.795 / 4.0, abs=5e-4),
        pytest.approx(18.39 / 4.0, abs=2e-3),
    )
    assert math.isnan(rate(0, 0.0).estimate)
