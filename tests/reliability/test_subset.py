"""Subset simulation on limit states whose probability is known, and on some that mislead it."""

from __future__ import annotations

import itertools
import math
import zlib

import limit_states
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from testbed.reliability import failure_probability
from testbed.reliability.results import FailureProbability

METHODS = ["subset", "importance", "adaptive"]
KNOWN = {
    "linear, 20 dimensions": limit_states.linear(20, 1e-5),
    "four branches": limit_states.four_branch(),
    "two regions": limit_states.two_sided(10, 3.0, 3.2),
    "in series": limit_states.series(20, 10, 4.0),
    "in parallel": limit_states.parallel(10, 2, 2.0),
    "sphere": limit_states.sphere(100, 13.0),
    "curved": limit_states.quadratic(5, 3.0, 0.3),
}


def results(case: limit_states.Case, seeds: int, **given: object) -> list[FailureProbability]:
    given = {"method": "subset", **given}
    return [
        failure_probability(case.limit_state, case.dimensions, seed=seed, **given) for seed in range(seeds)
    ]


@pytest.mark.nightly
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", KNOWN)
def test_the_interval_covers_and_the_estimate_is_near(name: str, method: str) -> None:
    case, seeds = KNOWN[name], 20
    found = results(case, seeds, method=method)
    assert sum(one.interval[0] <= case.probability <= one.interval[1] for one in found) >= 17
    assert sum(0.5 < one.probability / case.probability < 2 for one in found) >= 15
    assert max(one.evaluations for one in found) <= 4000


def test_two_regions_are_both_counted() -> None:
    one = limit_states.two_sided(10, 3.0, 9.0).probability
    both = limit_states.two_sided(10, 3.0, 3.0)
    middle = np.median([found.probability for found in results(both, 15)])
    assert middle == pytest.approx(2 * one, rel=0.25)


def test_the_asked_precision_is_reached_and_the_budget_kept() -> None:
    case = limit_states.linear(5, 1e-3)
    found = failure_probability(case.limit_state, 5, cov=0.1, budget=60_000)
    assert found.converged and found.cov <= 0.1 and found.evaluations <= 60_000
    assert case.probability == pytest.approx(found.probability, rel=0.4)
    assert [level.threshold for level in found.levels] == sorted(
        (level.threshold for level in found.levels), reverse=True
    )
    assert found.levels[-1].threshold == 0


@given(budget=st.integers(10, 3000), dimensions=st.integers(1, 30), seed=st.integers(0, 9))
@settings(max_examples=40, deadline=None)
def test_never_more_than_the_budget_and_always_an_interval(budget: int, dimensions: int, seed: int) -> None:
    asked = 0

    def limit_state(u: np.ndarray) -> np.ndarray:
        nonlocal asked
        asked += len(u)
        return 3.0 - u[:, 0]

    found = failure_probability(limit_state, dimensions, seed=seed, budget=budget)
    assert found.evaluations == asked <= budget
    low, high = found.interval
    assert 0 <= low <= high <= 1
    assert math.isnan(found.probability) or low <= found.probability <= high


def test_the_same_seed_asks_the_same_points() -> None:
    def asked(seed: int) -> list[int]:
        batches: list[int] = []

        def limit_state(u: np.ndarray) -> np.ndarray:
            batches.append(zlib.crc32(u.tobytes()))
            u[:] = 0  # what is given may be written over
            return np.full(len(u), np.nan) if len(batches) == 3 else 2.5 - 0 * u[:, 0] - batches[-1] % 7

        failure_probability(limit_state, 4, seed=seed, budget=600)
        return batches

    assert asked(1) == asked(1) != asked(2)


def test_rotations_change_nothing() -> None:
    """The law of the estimate is that of the rotated limit state: medians of 15 seeds agree."""
    rotation = np.linalg.qr(np.random.default_rng(3).standard_normal((6, 6)))[0]
    straight = [failure_probability(lambda u: 3.5 - u[:, 0], 6, seed=seed).probability for seed in range(15)]
    turned = [
        failure_probability(lambda u: 3.5 - (u @ rotation)[:, 0], 6, seed=seed).probability
        for seed in range(15)
    ]
    assert np.median(turned) == pytest.approx(np.median(straight), rel=0.4)


# --- limit states that mislead: the result says that it does not know


def noise(u: np.ndarray) -> np.ndarray:
    """A normal deviate of each point's own, unrelated to its neighbours'."""
    return 4.0 + np.array([np.random.default_rng(zlib.crc32(row.tobytes())).standard_normal() for row in u])


@pytest.mark.parametrize("method", METHODS)
def test_a_flat_limit_state_is_sampled_plainly(method: str) -> None:
    found = failure_probability(lambda u: np.where(u[:, 0] > 3.0, -1.0, 1.0), 3, method=method)
    assert found.interval[0] < 0.00135 < found.interval[1] and "flat" in found.reason
    never = failure_probability(lambda u: np.ones(len(u)), 3, method=method)
    assert never.probability == 0 and not never.converged and math.isinf(never.cov)
    assert never.interval == (0.0, pytest.approx(3.7 / 4000, rel=0.01))
    assert never.design_point is None and math.isinf(never.distance)


@pytest.mark.parametrize("method", METHODS)
def test_a_saturated_limit_state_is_followed_below_its_flat_part(method: str) -> None:
    found = failure_probability(lambda u: np.minimum(3.5 - u[:, 0], 1.6), 3, method=method)
    assert len(found.levels) > 1 and found.levels[0].threshold < 1.6
    assert found.interval[0] < 2.33e-4 < found.interval[1]


@pytest.mark.parametrize("method", METHODS)
def test_a_plateau_above_the_failures_gives_an_upper_end_only(method: str) -> None:
    found = failure_probability(lambda u: np.maximum(2.0 - u[:, 0], 0.5), 3, method=method)
    assert "flat" in found.reason and not found.converged
    assert found.interval[0] == 0 and 0.0668 <= found.interval[1] < 0.3  # P(u > 1.5) = .0668


@pytest.mark.parametrize("method", METHODS)
def test_a_limit_state_that_is_noise_is_not_followed(method: str) -> None:
    found = failure_probability(noise, 3, method=method)
    assert "hardly move" in found.reason and not found.converged
    assert found.interval[0] == 0 and found.interval[1] > 3.2e-5 and math.isinf(found.cov)


@pytest.mark.parametrize("method", METHODS)
def test_a_slope_that_ends_before_the_failures_gives_an_upper_end_only(method: str) -> None:
    found = failure_probability(lambda u: np.exp(-u[:, 0]), 2, budget=2000, method=method)
    assert found.interval[0] == 0 and not found.converged and "budget" in found.reason
    assert found.interval[1] < 0.01


@pytest.mark.parametrize("method", METHODS)
def test_what_is_not_a_number_widens_the_interval(method: str) -> None:
    def limit_state(u: np.ndarray) -> np.ndarray:
        return np.where(u[:, 1] > 2.5, np.nan, 3.5 - u[:, 0])

    found = failure_probability(limit_state, 4, method=method)
    assert "not a number" in found.reason and not found.converged
    assert found.interval[0] < 2.3e-4 and found.interval[1] > 0.0062  # P(u > 2.5) = .0062
    nothing = failure_probability(lambda u: np.full(len(u), np.nan), 4, method=method)
    assert not nothing.converged and nothing.interval[1] > 0.99


@pytest.mark.parametrize("method", METHODS)
def test_failing_more_often_than_not(method: str) -> None:
    found = failure_probability(lambda u: u[:, 0] - 0.5, 3, method=method)
    assert found.converged and found.interval[0] < 0.6915 < found.interval[1]


def test_every_way_to_end_has_a_sentence() -> None:
    said = [
        failure_probability(limit_state, 2, budget=budget).reason
        for limit_state, budget in itertools.product((noise, lambda u: 9.0 - u[:, 0]), (50, 1000))
    ]
    assert all(reason.endswith(".") for reason in said)
