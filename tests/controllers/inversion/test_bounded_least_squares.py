"""Weighted least squares within bounds, against scipy's solver."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import lsq_linear

from testbed.controllers.inversion.allocation import MOST_ITERATIONS, bounded_least_squares

PROBLEMS = 10_000
DEVIATION = 1e-3


def problem(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """A, b, low, high of a random allocation: any number of rows and actuators, some of them failed or stuck."""
    n, rows = rng.integers(1, 13), rng.integers(1, 5)
    effects = rng.normal(size=(rows, n)) * 10 ** rng.uniform(-1, 1, size=n)
    weights = 10 ** rng.uniform(-1, 0, size=rows)
    low = 10 ** rng.uniform(-2, 1, size=n) * rng.uniform(-1.0, 0.2, size=n)
    high = low + 10 ** rng.uniform(-2, 1, size=n)
    failed = rng.random(n) < 0.15
    low[failed] = high[failed] = 0.0
    wanted = weights * rng.normal(size=rows) * 10 ** rng.uniform(-1, 2)
    A = np.vstack([weights[:, None] * effects, DEVIATION * np.eye(n)])
    return A, np.concatenate([wanted, np.zeros(n)]), low, high


def solve(
    A: np.ndarray, b: np.ndarray, low: np.ndarray, high: np.ndarray, d: np.ndarray, at_bound: np.ndarray
) -> np.ndarray:
    n = len(low)
    bounded_least_squares(A.T @ A, A.T @ b, low, high, d, at_bound, np.zeros((n, n)), np.zeros(n))
    return d


def by_scipy(A: np.ndarray, b: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    x, free = low.copy(), low < high
    if free.any():
        left = b - A @ np.where(free, 0.0, low)
        found = lsq_linear(A[:, free], left, (low[free], high[free]), method="bvls", tol=1e-14, max_iter=500)
        x[free] = found.x
    return x


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in (1, 2, 3))])
def test_random_problems_end_at_scipys_minimum_from_any_start(seed: int) -> None:
    rng = np.random.default_rng(seed)
    for _ in range(PROBLEMS // 4):
        A, b, low, high = problem(rng)
        n = len(low)
        at_bound = rng.integers(-1, 2, size=n).astype(np.int8)
        d = solve(A, b, low, high, rng.normal(size=n), at_bound)
        assert np.all(d >= low) and np.all(d <= high)
        reference = np.sum((A @ by_scipy(A, b, low, high) - b) ** 2)
        assert np.sum((A @ d - b) ** 2) <= reference * (1.0 + 1e-9) + 1e-15


def test_started_at_the_result_it_stays_there() -> None:
    rng = np.random.default_rng(5)
    for _ in range(200):
        A, b, low, high = problem(rng)
        at_bound = np.zeros(len(low), np.int8)
        first = solve(A, b, low, high, np.zeros(len(low)), at_bound).copy()
        active = at_bound.copy()
        assert solve(A, b, low, high, first.copy(), at_bound) == pytest.approx(first, rel=1e-6, abs=1e-9)
        assert np.array_equal(at_bound, active)


def test_the_active_set_says_what_stands_at_a_bound() -> None:
    A, b = np.eye(3), np.array([2.0, 0.1, -3.0])
    at_bound = np.zeros(3, np.int8)
    d = solve(A, b, -np.ones(3), np.ones(3), np.zeros(3), at_bound)
    assert d.tolist() == pytest.approx([1.0, 0.1, -1.0])
    assert at_bound.tolist() == [1, 0, -1]


def test_a_bound_that_was_active_is_left_when_it_costs() -> None:
    at_bound = np.array([1, -1], np.int8)
    d = solve(np.eye(2), np.array([0.2, 0.3]), -np.ones(2), np.ones(2), np.zeros(2), at_bound)
    assert d.tolist() == pytest.approx([0.2, 0.3]) and not at_bound.any()
    assert MOST_ITERATIONS >= 100
