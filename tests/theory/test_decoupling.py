"""How fast and how quiet at once: the closed forms, their bound, and the flying laws on noise."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from testbed.controllers.l1 import adapt_fast, low_pass_channel
from testbed.controllers.records import memory_dtype, mode_dtype, model_dtype, settings_dtype
from testbed.theory import decoupling
from testbed.theory.ideal import IdealLoop, IdealPlant, Tuning

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


# --- the flying laws ---------------------------------------------------------------------------------------------------------


def l1_effects(gamma: float, k: float, truth: np.ndarray, noise: np.ndarray, dt: float) -> np.ndarray:
    """[steps, 4] effects lambda u of four like actuators under `l1`, r = 1, measured with noise [steps, 4]."""
    m, c, mode, s = (
        np.zeros(1, of(4)).view(np.recarray)[0]
        for of in (model_dtype, settings_dtype, mode_dtype, memory_dtype)
    )
    m.servo[:], m.low[:], m.high[:] = 1, -1e6, 1e6
    c.dt, c.gamma[:], c.channel_rate, c.epsilon[:], c.lambda_min, c.lambda_max = dt, gamma, k, 1e-9, 1e-3, 1e3
    mode.available[:], mode.B_hat_inv[:] = 1, np.eye(4)
    s.lambda_hat[:], s.r[:], s.u[:] = truth[0], 1.0, 1.0 / truth[0]
    s.correction[:] = s.u - 1.0
    effects = np.empty((len(truth), 4))
    for step in range(len(truth)):
        low_pass_channel(m, c, mode, s)
        s.position[:] = s.u
        effects[step] = truth[step] * s.u
        e = truth[step] * s.u + noise[step] - s.lambda_hat * s.u
        adapt_fast(e, 1.0, m, c, mode, s)
    return effects


def paper_effects(gamma: float, _: float, truth: np.ndarray, noise: np.ndarray, dt: float) -> np.ndarray:
    """The same of the paper's law on the ideal plant."""
    steps = len(truth)
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-9, dt), truth[0])
    estimate = loop.fly(np.ones((steps, 4)), np.tile(truth[:, None], (1, 4)), noise).lambda_hat[:-1]
    return truth[:, None] / estimate


@pytest.mark.slow
@pytest.mark.parametrize(
    ("effects", "gamma", "k", "measure"),
    [
        (paper_effects, 2.0, 0.0, decoupling.PAPER),
        (l1_effects, 2.0, 2.0, decoupling.cascade(2.0, 2.0)),
        (l1_effects, 20.0, 2.0, decoupling.cascade(20.0, 2.0)),
    ],
)
def test_the_flying_laws_have_the_measure_of_their_poles(
    effects: Callable[..., np.ndarray], gamma: float, k: float, measure: float
) -> None:
    """T_5% after a loss of 1 %, and the variance of the effect under white noise, small for the law to be linear.

    The variance comes from 4 x 240 s with a correlation time of about half a second: 4 standard errors are 4 sqrt(2 / 960).
    """
    dt, loss = 0.005, 0.01
    truth = np.where(np.arange(4000) < 10, 1.0, 1.0 - loss)
    missing = np.abs(effects(gamma, k, truth, np.zeros((4000, 4)), dt)[10:, 0] - 1.0) / loss
    time = (np.flatnonzero(missing > 1.0 - decoupling.REACHED)[-1] + 1) * dt
    s = 1e-5
    noise = np.random.default_rng(7).normal(0.0, math.sqrt(s / dt), (48000, 4))
    flown = effects(gamma, k, np.ones(48000), noise, dt)[1000:]
    assert time * flown.var() / s == pytest.approx(measure, rel=4.0 * math.sqrt(2.0 / 960.0))
