"""How fast and how quiet at once: the closed forms and their bound."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from paper import decoupling

DT = 0.001
TIME = (np.arange(30000) + 0.5) * DT
RESPONSES: dict[str, tuple[np.ndarray, float]] = {
    "paper": (2.0 * np.exp(-2.0 * TIME), decoupling.PAPER),
    "cascade, equal": (4.0 * TIME * np.exp(-2.0 * TIME), decoupling.cascade(2.0, 2.0)),
    "cascade, apart": (
        3.0 * (np.exp(-1.5 * TIME) - np.exp(-3.0 * TIME)),
        decoupling.cascade(1.5, 3.0),
    ),
    "boxcar": (np.where(TIME < 1.0, 1.0, 0.0), decoupling.BOXCAR),
    "second order": (
        1.0 / math.sqrt(1.0 - 0.49) * np.exp(-0.7 * TIME) * np.sin(math.sqrt(1.0 - 0.49) * TIME),
        decoupling.second_order(0.7),
    ),
}


@pytest.mark.parametrize("name", RESPONSES)
def test_a_closed_form_is_that_of_its_impulse_response(name: str) -> None:
    h, closed = RESPONSES[name]
    assert np.sum(h) * DT == pytest.approx(1.0, abs=2e-3)
    assert decoupling.of_response(h, DT) == pytest.approx(closed, rel=4e-3)


def test_the_numbers_are_those_that_are_quoted() -> None:
    known = (
        decoupling.PAPER,
        decoupling.cascade(1.0, 1.0),
        decoupling.second_order(0.7),
        decoupling.LINEAR_BOUND,
    )
    assert known == pytest.approx((1.50, 1.19, 1.04, 0.90), abs=5e-3)
    assert decoupling.cascade(1e4, 1.0) == pytest.approx(decoupling.PAPER, rel=1e-3)
    assert decoupling.cascade(1.0, 1.0 + 1e-7) == pytest.approx(decoupling.cascade(1.0, 1.001), rel=1e-3)


@settings(deadline=None, derandomize=True, max_examples=200)
@given(st.integers(0, 2**32 - 1))
def test_no_linear_estimator_is_below_the_bound(seed: int) -> None:
    """Random impulse responses, of either sign, that sum to one: int_0^T h >= 0.95 and Cauchy-Schwarz. One step of length dt is the
    resolution of T."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(5, 400))
    h = rng.uniform(-0.3, 1.0, n) * np.exp(-rng.uniform(0.0, 6.0) * np.arange(n) / n)
    if abs(h.sum()) < 0.05 * np.abs(h).sum():
        h = np.abs(h)
    found = decoupling.of_response(h / (h.sum() * DT), DT)
    assert found >= decoupling.LINEAR_BOUND * (1.0 - 1e-12)


def test_the_bound_is_reached_by_a_mean_that_ends_at_95_percent() -> None:
    """Negative control of the bound: it is attained, so nothing below it would have gone unnoticed."""
    h = np.where(TIME < 1.0, 0.95, 0.0)
    h[-1] = 0.05 / DT
    within = np.cumsum(h) * DT >= 0.95 - 1e-9
    reached = int(np.argmax(within)) + 1
    assert reached * DT * np.sum(h[:reached] ** 2) * DT == pytest.approx(decoupling.LINEAR_BOUND, rel=2e-3)
