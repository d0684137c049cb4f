"""Smallest failures of limit states whose nearest failure is known, and of some that have none."""

from __future__ import annotations

import math
import zlib

import limit_states
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from testbed.inputs.problems import BadInput
from testbed.reliability import smallest_failure

Case = limit_states.Case

KNOWN = {
    "one dimension": Case(lambda u: 3.0 - u[:, 0], 1, math.nan, 3.0),
    "linear, 2 dimensions": limit_states.linear(2, 1e-5),
    "linear, 60 dimensions": limit_states.linear(60, 1e-7),
    "four branches": limit_states.four_branch(20),
    "two regions": limit_states.two_sided(10, 4.0, 5.0),
    "in series": limit_states.series(20, 10, 4.5),
    "in parallel": limit_states.parallel(10, 2, 2.7),
    "curved": limit_states.quadratic(20, 4.0, 0.3),
    "sphere": limit_states.sphere(20, 7.6),
    "sum of moduli": Case(lambda u: 6 - abs(u[:, :2]).sum(axis=1), 10, math.nan, 6 / math.sqrt(2)),
    "stairs": Case(lambda u: np.ceil(2 * (4.25 - u[:, 0])), 10, math.nan, 4.25),
    "jumps below 0": Case(lambda u: np.where(u[:, 0] > 4, -3.0, 8 - u[:, 0]), 10, math.nan, 4.0),
    "cubed and scaled": Case(lambda u: 1000 * (4 - u[:, 0]) ** 3, 10, math.nan, 4.0),
    "saturated": Case(lambda u: np.tanh(4 - u[:, 0]), 10, math.nan, 4.0),
}


@pytest.mark.parametrize("name", KNOWN)
def test_it_is_within_a_twentieth_of_the_nearest(name: str) -> None:
    case = KNOWN[name]
    for seed in range(2):
        found = smallest_failure(case.limit_state, case.dimensions, seed=seed)
        assert found.found and found.evaluations <= 2000
        assert case.distance * (1 - 1e-9) <= found.distance <= 1.05 * case.distance
        assert found.design_point is not None
        assert np.linalg.norm(found.design_point) == found.distance
        assert case.limit_state(found.design_point[None])[0] == found.limit_state <= 0


NARROW = {
    "one dimension, two sides": limit_states.two_sided(1, 2.0, 2.2),
    "two sides": limit_states.two_sided(3, 2.35, 2.5),
    "four branches": limit_states.four_branch(2),
    "a jump off the gradient": Case(
        lambda u: np.where(u @ [0.6, -0.64, 0.48] > 2.4, -0.2, 0.8 - 0.1 * u[:, 0]), 3, math.nan, 2.4
    ),
    "a nearer region that is a jump": Case(
        lambda u: np.where(u[:, 1] - u[:, 2] > 1.5 * math.sqrt(2), -0.1, 2 - u[:, 0]), 3, math.nan, 1.5
    ),
    "in parallel": limit_states.parallel(3, 2, 1.6),
}


@pytest.mark.parametrize("name", NARROW)
def test_300_evaluations_are_enough_in_few_dimensions(name: str) -> None:
    case = NARROW[name]
    for seed in range(3):
        found = smallest_failure(case.limit_state, case.dimensions, seed=seed, budget=300, starts=2)
        assert case.distance * (1 - 1e-9) <= found.distance <= 1.05 * case.distance


def test_of_mirrored_coordinates_one_side_is_asked() -> None:
    asked: list[np.ndarray] = []

    def limit_state(u: np.ndarray) -> np.ndarray:
        asked.append(u)
        return 3.0 - np.abs(u) @ [0.6, 0.8]

    found = smallest_failure(limit_state, 2, budget=200, starts=2, mirrored=[1])
    points = np.concatenate(asked)
    assert (points[:, 1] >= 0).all() and (points[:, 0] < 0).any()
    assert found.distance == pytest.approx(3.0, rel=0.01)
    assert found.design_point is not None and found.design_point[1] == pytest.approx(2.4, rel=0.05)


@pytest.mark.parametrize("mirrored", [[2], [-1], [0.5], ["a"]])
def test_mirrored_coordinates_must_be_there(mirrored: list[int]) -> None:
    with pytest.raises(BadInput, match="coordinates from 0 to 1"):
        smallest_failure(lambda u: 3.0 - u[:, 0], 2, mirrored=mirrored)


def test_a_small_ball_far_before_a_half_space_is_mostly_found() -> None:
    def limit_state(u: np.ndarray) -> np.ndarray:
        ball = 0.4 * np.linalg.norm(u - [1.9, 0.8, -0.6], axis=1) - 0.1
        return np.minimum(ball, 0.96 - u @ [0, 0.18, 0.24])

    found = [smallest_failure(limit_state, 3, seed=s, budget=300, starts=2).distance for s in range(6)]
    nearest = math.sqrt(4.61) - 0.25
    assert min(found) >= nearest
    assert sum(each <= 1.05 * nearest for each in found) >= 5


def test_every_step_of_the_path_fails_and_is_nearer() -> None:
    case = KNOWN["curved"]
    path = smallest_failure(case.limit_state, case.dimensions, budget=800).path
    distances = [step.distance for step in path]
    assert distances == sorted(distances, reverse=True) and len(set(distances)) == len(path) > 3
    assert [step.evaluations for step in path] == sorted(step.evaluations for step in path)
    assert all(case.limit_state(step.point[None])[0] <= 0 for step in path)


def test_what_cannot_be_broken_is_not_found_and_bounded() -> None:
    found = smallest_failure(lambda u: 1.0 + np.sum(u**2, axis=1), 8, budget=1000)
    assert not found.found and found.design_point is None and math.isinf(found.distance)
    assert found.path == () and found.evaluations == 1000
    assert found.independent >= 250
    assert found.upper_bound == pytest.approx(1 - 0.05 ** (1 / found.independent))
    assert f"Not found in 1000 evaluations. As {found.independent} of them" in found.reason


@pytest.mark.nightly
def test_a_flat_limit_state_is_found_by_its_draws() -> None:
    found = smallest_failure(lambda u: np.where(u[:, 0] > 2.0, -1.0, 1.0), 4, seed=1)
    assert 2.0 < found.distance < 2.1


@pytest.mark.parametrize(("value", "said"), [(0.0, "fails at the origin"), (math.nan, "not a number")])
def test_the_origin_must_pass(value: float, said: str) -> None:
    with pytest.raises(BadInput, match=said):
        smallest_failure(lambda u: np.full(len(u), value), 3)


@pytest.mark.nightly
@given(budget=st.integers(10, 400), dimensions=st.integers(1, 12), starts=st.integers(1, 5))
@settings(max_examples=30, deadline=None)
def test_never_more_than_the_budget(budget: int, dimensions: int, starts: int) -> None:
    asked: list[int] = []

    def limit_state(u: np.ndarray) -> np.ndarray:
        asked.append(zlib.crc32(u.tobytes()))
        counted.append(len(u))
        return np.where(u[:, 0] < -1, np.nan, 2.0 - u[:, 0])

    counted: list[int] = []
    first = smallest_failure(limit_state, dimensions, budget=budget, starts=starts)
    assert first.evaluations == sum(counted) <= budget
    half, asked = asked, []
    again = smallest_failure(limit_state, dimensions, budget=budget, starts=starts)
    assert asked == half and again.distance == first.distance
    assert counted[0] == 1  # the origin, alone


@pytest.mark.nightly
def test_what_is_not_a_number_is_no_failure() -> None:
    found = smallest_failure(lambda u: np.where(u[:, 0] > 2, np.nan, 4.0 - u[:, 1]), 5)
    assert found.distance == pytest.approx(4.0, rel=0.02)
    hidden = smallest_failure(lambda u: np.where(u[:, 0] > 2, np.nan, 4.0 - u[:, 0]), 5, budget=600)
    assert not hidden.found


def test_the_global_random_numbers_are_left_alone() -> None:
    np.random.seed(1)  # noqa: NPY002
    smallest_failure(lambda u: 2.0 - u[:, 0], 3, budget=100)
    left = np.random.random()  # noqa: NPY002
    np.random.seed(1)  # noqa: NPY002
    assert left == np.random.random()  # noqa: NPY002
