"""The paper's law, function by function, against the design model, scipy, and numbers by hand.

The equations on the paper's ideal plant are in tests/paper/test_equations.py.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import lfilter
from vtail_setup import WEATHER, records_of, trim_state, vtail_setup

from testbed.controllers.inversion.law import (
    adapt,
    beyond_tangent,
    compensate,
    invert,
    lag_gain,
    low_pass,
    measured_error,
    modified_inverse,
    pressure_ratio_of,
    regressor,
    state_function,
)

SETUP = vtail_setup()
MODEL = SETUP.model
RNG = np.random.default_rng(11)
_FIRST_DRAW = RNG.bit_generator.state


@pytest.fixture(autouse=True)
def the_same_draws_in_any_order() -> None:
    RNG.bit_generator.state = _FIRST_DRAW


def test_pressure_ratio() -> None:
    assert pressure_ratio_of(trim_state(MODEL, airspeed=36.0), records_of(SETUP).m) == pytest.approx(4.0)


@pytest.mark.parametrize("seed", range(5))
def test_f_and_phi_are_the_design_models_rates(seed: int) -> None:
    """f_m of (2) with whole propellers, less their share, plus Phi lambda, is `DesignModel.rates` with rotors steady."""
    rng = np.random.default_rng(seed)
    m, _, _, s, w = records_of(SETUP)
    names = ("alpha", "beta", "p", "q", "r", "roll", "pitch")
    y = trim_state(
        MODEL, airspeed=rng.uniform(14.0, 22.0), **dict(zip(names, 0.2 * rng.normal(size=7), strict=True))
    )
    s.position[:] = rng.normal(size=4)
    s.torque[:] = m.torque_slope * s.position  # steady rotors: no transient
    effectiveness = rng.uniform(0.0, 1.0, 4)
    state_function(y, m, w.f)
    regressor(pressure_ratio_of(y, m), m, s, w.phi)
    x = {name: float(y[name]) for name in ("airspeed", *names)}
    wanted = MODEL.rates(x, s.position * SETUP.scale, effectiveness)[:4]
    # The law has the offset of whole propellers in f_m, scaled by dynamic pressure; the model has each one's, unscaled.
    offsets = np.array(MODEL.offset_matrix)[:4]
    share = pressure_ratio_of(y, m) * offsets.sum(axis=1) - offsets @ effectiveness
    assert w.f + w.phi @ effectiveness - share == pytest.approx(wanted, rel=1e-9, abs=1e-9)


def test_f_has_the_effect_of_the_size_of_sideslip() -> None:
    """c |beta| times the ratio of dynamic pressures, for sideslip to either side."""
    sideslip = (1.0, -2.0, 3.0, -40.0, 0.0, 0.0)
    with_it = replace(SETUP, model=replace(MODEL, sideslip=sideslip))
    for beta in (-0.1, 0.1):
        found = []
        for setup in (SETUP, with_it):
            y, (m, *_, w) = trim_state(MODEL, airspeed=36.0, beta=beta), records_of(setup)
            state_function(y, m, w.f)
            found.append(w.f.copy())
        assert found[1] - found[0] == pytest.approx(np.multiply(0.4, sideslip[:4]))


def test_forward_force_curves_with_lift_up_to_the_stall() -> None:
    m = records_of(vtail_setup(WEATHER)).m
    assert m.forward_curvature > 0.0
    for alpha, counts in ((m.stall_alpha - 0.05, m.stall_alpha - 0.05), (m.stall_alpha + 0.1, m.stall_alpha)):
        found = beyond_tangent(trim_state(MODEL, alpha=alpha), m)
        assert found == pytest.approx(m.forward_curvature * (counts - m.alpha) ** 2)


def test_a_jammed_actuator_has_the_column_of_one_unit() -> None:
    m, _, _, s, w = records_of(SETUP)
    s.position[:], s.jammed[1] = 0.7, 1
    regressor(1.2, m, s, w.phi)
    assert w.phi[:, 1] == pytest.approx(1.2 * m.B[:, 1])
    assert w.phi[:, 0] == pytest.approx(1.2 * 0.7 * m.B[:, 0])


def test_motor_torque_beyond_the_steady_is_felt_at_once() -> None:
    m, _, _, s, w = records_of(SETUP)
    s.position[2], s.torque[2] = 1.5, m.torque_slope[2] * 1.5 + 0.1
    regressor(1.0, m, s, w.phi)
    assert w.phi[:, 2] == pytest.approx(1.5 * m.B[:, 2] + 0.1 * m.B_torque[:, 2])


def test_modified_inverse_by_hand() -> None:
    assert [modified_inverse(a, 0.1) for a in (0.5, -0.2, 0.05, 0.0)] == pytest.approx([2.0, -5.0, 5.0, 0.0])


def test_the_filter_is_two_equal_lags() -> None:
    x, a = RNG.normal(size=300), 20.0 * 0.005
    lags, out = np.zeros((2, 1)), []
    for value in x:
        signal = np.array([value])
        low_pass(signal, lags, lag_gain(a))
        out.append(signal[0])
    gain = 1.0 - math.exp(-a)
    once = lfilter([gain], [1.0, gain - 1.0], x)
    assert out == pytest.approx(lfilter([gain], [1.0, gain - 1.0], once), abs=1e-12)
    signal = np.array([3.0])
    low_pass(signal, lags, lag_gain(0.0))
    assert signal[0] == 3.0, "a of 0 is no filter"


def test_measured_error_is_what_the_estimates_do_not_explain() -> None:
    _, _, _, s, w = records_of(SETUP)
    w.z[:], w.phi[:], s.lambda_hat[:] = RNG.normal(size=4), RNG.normal(size=(4, 4)), RNG.uniform(size=4)
    measured_error(w.z, w.phi, s, w.e)
    assert w.e == pytest.approx(w.z - w.phi @ s.lambda_hat)


def test_estimates_are_kept_between_their_bounds() -> None:
    m, c, _, s, _ = records_of(SETUP)
    s.position[:] = 1.0
    for sign, bound in ((1.0, c.lambda_max), (-1.0, c.lambda_min)):
        for _ in range(2000):
            adapt(sign * (np.array(m.B) @ np.ones(4)), 1.0, m, c, s)
        assert s.lambda_hat == pytest.approx(np.full(4, bound))


def test_inversion_gives_the_rates_back() -> None:
    """(29) with the first mode is (6): B_m diag(pressure) r is nu, at any airspeed."""
    m, _, k, s, _ = records_of(SETUP)
    nu, pressure_ratio = RNG.normal(size=4), 1.3
    invert(nu, pressure_ratio, m, k, s)
    factors = np.where(m.servo == 1, pressure_ratio, 1.0)
    assert np.array(m.B) @ (factors * s.r) == pytest.approx(nu)


@pytest.mark.parametrize(("uncompensated", "effect"), [(0, -0.8), (1, -1.0)])
def test_a_reversed_actuator_is_sent_the_other_way(uncompensated: int, effect: float) -> None:
    """Its estimate divides, at most -`divisor_min`, so its force is the reference; without estimates it is taken for -1."""
    m, c, k, s, _ = records_of(SETUP)
    c.uncompensated, s.reversed[:2], s.lambda_hat[:2], s.r[:2] = uncompensated, 1, [-0.8, 0.3], [0.4, 0.01]
    compensate(m, c, k, s)
    weakest = -1.0 if uncompensated else -c.divisor_min
    assert s.u[:2] == pytest.approx([0.4 / effect, 0.01 / weakest])


def test_compensation_divides_by_the_estimate_within_the_stops() -> None:
    m, c, k, s, _ = records_of(SETUP)
    s.r[:], s.lambda_hat[:] = [0.4, 0.4, 2.0, 30.0], [0.5, 0.001, 1.0, 1.0]
    k.available[2] = 0
    compensate(m, c, k, s)
    limited = min(0.4 / c.divisor_min, m.high[1])
    assert s.u == pytest.approx([0.8, limited, m.trim_position[2], m.high[3]])
