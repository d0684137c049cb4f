"""The nearest root: closed forms with fewer, as many and more unknowns than equations, and with bounds. Roots in a bracket are
those of scipy's `brentq`, to the last bit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from testbed.common.roots import NearestRoot, bracketed_root

FAR = 10.0


def root_of(function, n: int, weight=1.0, low=-FAR, high=FAR, preferred=0.0, guess=0.5) -> np.ndarray:
    problem = NearestRoot(
        lambda x: np.atleast_1d(np.asarray(function(x), float)),
        np.full(n, low),
        np.full(n, high),
        np.broadcast_to(np.asarray(weight, float), (n,)).copy(),
        lambda x: np.broadcast_to(np.asarray(preferred, float), (n,)).copy(),
    )
    return problem.find(np.broadcast_to(np.asarray(guess, float), (n,)).copy(), 1e-9)


def test_the_point_of_a_circle_nearest_to_another_point() -> None:
    """Of x^2 + y^2 = 4, nearest to (3, 4): (1.2, 1.6). A root to rounding, nearest as well as the updated Jacobian is known."""
    found = root_of(lambda x: x @ x - 4.0, 2, preferred=(3.0, 4.0), guess=(1.0, 1.0))
    assert found == pytest.approx([1.2, 1.6], abs=1e-4)
    assert found @ found == pytest.approx(4.0, abs=1e-10)


def test_weights_say_which_unknown_is_used() -> None:
    """x + y = 1 with y ten times as unwanted: x = 100/101."""
    found = root_of(lambda x: x.sum() - 1.0, 2, weight=(1.0, 10.0))
    assert found == pytest.approx([100 / 101, 1 / 101], abs=1e-9)


def test_an_unknown_at_its_bound_is_left_there() -> None:
    """x + y = 3 within [-2, 2], x preferred at 5: x = 2, and y makes up for the rest."""
    found = root_of(lambda x: x.sum() - 3.0, 2, low=-2.0, high=2.0, preferred=(5.0, -5.0))
    assert found == pytest.approx([2.0, 1.0], abs=1e-9)


def test_square_systems_have_their_root_to_rounding() -> None:
    """Rosenbrock's system: 10 (y - x^2) = 0 and 1 - x = 0."""
    found = root_of(lambda x: [10.0 * (x[1] - x[0] ** 2), 1.0 - x[0]], 2, guess=(-1.2, 1.0))
    assert found == pytest.approx([1.0, 1.0], abs=1e-10)


def test_where_there_is_none_the_function_is_not_small() -> None:
    """x^2 + 1 has no root; and x = 3 is beyond the bounds."""
    assert root_of(lambda x: x @ x + 1.0, 1) @ np.ones(1) == pytest.approx(0.0, abs=0.1)
    assert root_of(lambda x: x - 3.0, 1, high=2.0) == pytest.approx([2.0], abs=1e-5)


@pytest.mark.parametrize("beyond", [math.nan, math.inf])
def test_a_search_ends_where_the_function_is_not_finite(beyond: float) -> None:
    """The function is not finite at the guess and below it, so no step from there is known to lead to a root."""
    found = root_of(lambda x: [x[0] + 1.0 if x[0] > 0.5 else beyond], 1)
    assert found == pytest.approx([0.5])


def test_most_of_a_search_is_made_with_the_coarse_function() -> None:
    """Rosenbrock's system, with a coarse function that is 1e-4 wrong: the root is the exact one, for a few exact evaluations."""
    exact_at: list[np.ndarray] = []

    def rosenbrock(x: np.ndarray) -> np.ndarray:
        return np.array([10.0 * (x[1] - x[0] ** 2), 1.0 - x[0]])

    def exact(x: np.ndarray) -> np.ndarray:
        exact_at.append(x)
        return rosenbrock(x)

    def coarse(x: np.ndarray) -> np.ndarray:
        return rosenbrock(x) + 1e-4 * np.sin(1e4 * x)

    bounds = np.full(2, -FAR), np.full(2, FAR), np.ones(2), np.zeros_like
    near = NearestRoot(coarse, *bounds, enough=1e-3, noise=1e-4)
    guess = np.array([-1.2, 1.0])
    found = NearestRoot(exact, *bounds, coarse=(near, 1e-3)).find(guess, 1e-9)
    with_coarse = len(exact_at)
    NearestRoot(exact, *bounds).find(guess, 1e-9)
    assert found == pytest.approx([1.0, 1.0], abs=1e-10)
    assert 5 * with_coarse < len(exact_at) - with_coarse


def test_a_way_that_leaves_the_roots_for_good_ends_at_the_last_one() -> None:
    """y^2 + (x - 1) / 20 beyond x = 1 has no root there, but is small on the way to the preferred (8, 0)."""
    problem = NearestRoot(
        lambda x: np.array([x[1] ** 2 + 0.05 * max(x[0] - 1.0, 0.0)]),
        np.full(2, -FAR),
        np.full(2, FAR),
        np.ones(2),
        lambda x: np.array([8.0, 0.0]),
    )
    found = problem.find(np.zeros(2), 1e-9, thorough=False)
    assert abs(problem.function(found)[0]) < 1e-9 and found[0] <= 1.0 + 1e-6


@settings(deadline=None, max_examples=300)
@given(st.floats(-3, 3), st.floats(0.01, 50), st.lists(st.floats(-5, 5), min_size=3, max_size=12))
def test_is_that_of_scipy(root: float, scale: float, slopes: list[float]) -> None:
    """Of a table with corners, rising or not, and of a smooth function."""
    values = np.cumsum(np.abs(slopes) + 0.1)
    grid = np.linspace(-3.1, 3.1, len(values))
    at_root = float(np.interp(root, grid, values))
    for function in (
        lambda x: scale * (float(np.interp(x, grid, values)) - at_root) * (1.0 + x * x),
        lambda x: scale * (math.exp(x) - math.exp(root)),
    ):
        if function(-3.1) * function(3.1) < 0.0:
            assert bracketed_root(function, -3.1, 3.1) == brentq(function, -3.1, 3.1)


@pytest.mark.parametrize(("low", "high"), [(0.0, 1.0), (-1.0, 0.0)])
def test_a_root_at_an_end(low: float, high: float) -> None:
    assert bracketed_root(lambda x: x, low, high) == 0.0 == brentq(lambda x: x, low, high)
