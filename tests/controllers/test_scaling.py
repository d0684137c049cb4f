"""The control design that suits an aircraft: the v-tail's, and how it changes with speed, authority, engines, gusts."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import vtail_setup

from testbed.aircraft.control_design import AllocationWeights, ControlDesign, Loops, StateDeviations
from testbed.aircraft.design_model import ROWS, DesignModel
from testbed.common.signals import RATES
from testbed.controllers.released_axes import authorities
from testbed.controllers.scaling import excess_u_dot, gust_density, model_error_std, scaled

SETUP = vtail_setup()
LIMITS = np.array([(a.low, a.high) for a in SETUP.actuators])
LAGS = [a.lag_rad_s for a in SETUP.actuators]
MODEL = SETUP.model


def design(model: DesignModel = MODEL, limits: np.ndarray = LIMITS, lags=LAGS, control=None) -> ControlDesign:
    return scaled(control or ControlDesign(), model, limits, lags)


def test_ample_authority_has_the_full_gains() -> None:
    """The v-tail's, as they were found in flight."""
    loops = design().loops
    assert (loops.altitude_kp, loops.pitch_kp) == (0.7, 3.0)
    assert (loops.heading_kp, loops.roll_kp, loops.r_kp) == (0.5, 1.5, 4.0)
    assert (loops.airspeed_kp, loops.altitude_ki, loops.climb_max) == (0.8, 0.01, 2.0)


def test_no_rate_is_controlled_more_slowly_than_it_is_damped() -> None:
    """The v-tail's damping of rolling and pitching is faster than 4 and 8 1/s, that of yawing slower than 4."""
    loops = design().loops
    roll, pitch, yaw = -np.diag(np.array(MODEL.derivatives)[:3, 2:])
    assert roll > 4.0 and pitch > 8.0 and yaw < 4.0
    assert (loops.p_kp, loops.q_kp, loops.r_kp) == (roll, pitch, 4.0)


def test_what_is_given_is_kept() -> None:
    control = ControlDesign(loops=Loops(q_kp=5.0, climb_max=9.0))
    found = design(control=control).loops
    assert (found.q_kp, found.climb_max, found.pitch_kp) == (5.0, 9.0, 3.0)


def test_it_is_computed_once_and_again_gives_itself() -> None:
    once = design()
    assert design() is once
    assert design(control=once) == once


def test_nothing_is_left_open() -> None:
    assert "null" not in design().model_dump_json()
    assert "null" in ControlDesign().model_dump_json()


def test_twice_as_fast_has_twice_the_lengths_and_speeds() -> None:
    one, two = design(), design(replace(MODEL, airspeed_m_s=2.0 * MODEL.airspeed_m_s))
    for name in ("climb_max", "altitude_error_max_m", "airspeed_error_max_m_s"):
        assert getattr(two.loops, name) == pytest.approx(2.0 * getattr(one.loops, name))
    assert two.loops.altitude_ki == pytest.approx(0.5 * one.loops.altitude_ki)
    assert two.regulator.states.altitude == pytest.approx(2.0 * one.regulator.states.altitude)
    assert two.regulator.states.pitch == one.regulator.states.pitch == StateDeviations().pitch


def test_in_units_of_authority_no_axis_weighs_more_than_a_more_important_one() -> None:
    """The v-tail has less authority in roll than in yaw, and in yaw than in pitch; most aircraft have the most in roll."""
    weights = design().allocation
    assert (weights.p_dot, weights.q_dot, weights.r_dot) == (1.0, 1.0, 1.0)
    rolls = np.array(MODEL.input_matrix)
    rolls[0] *= 40.0
    fast = replace(MODEL, input_matrix=tuple(map(tuple, rolls)))
    weights = design(fast).allocation
    each = {one.axis: one.authority for one in authorities(fast, LIMITS, RATES, range(4))}
    assert weights.p_dot * each["p_dot"] == pytest.approx(min(each["q_dot"], each["r_dot"]))
    assert (weights.q_dot, weights.r_dot) == (1.0, 1.0) and weights.p_dot < 0.2
    given = design(fast, control=ControlDesign(allocation=AllocationWeights(p_dot=2.0))).allocation
    assert (given.p_dot, given.r_dot) == (2.0, 1.0)
    first = design(fast, control=ControlDesign(priorities=("p_dot", "q_dot", "r_dot", "u_dot"))).allocation
    assert first.p_dot == 1.0
    still = np.array(MODEL.input_matrix)
    still[ROWS.index("r_dot")] = 0.0
    none = design(replace(fast, input_matrix=tuple(map(tuple, still)))).allocation
    assert (none.p_dot, none.q_dot, none.r_dot) == (1.0, 1.0, 1.0)


def test_little_authority_slows_the_whole_cascade() -> None:
    """Surfaces with a fortieth of their effect: the gains of pitch are those of a longer unit of time, the integral's squared. That
    of the rate, which is the damping's, stays."""
    weak = np.array(MODEL.input_matrix)
    weak[:, :2] /= 40.0
    slow, full = design(replace(MODEL, input_matrix=tuple(map(tuple, weak)))).loops, design().loops
    pace = slow.pitch_kp / full.pitch_kp
    assert 0.2 < pace < 0.9
    assert slow.altitude_kp / full.altitude_kp == pytest.approx(pace)
    assert slow.altitude_ki / full.altitude_ki == pytest.approx(pace**2)
    assert slow.q_kp == full.q_kp


def test_slow_engines_slow_the_airspeed_loop() -> None:
    loops = design(lags=[30.0, 30.0, 0.6, 1.5]).loops
    assert loops.airspeed_kp == pytest.approx(0.2)
    assert loops.airspeed_ki == pytest.approx(0.1 / 16.0)


def test_a_climb_uses_half_of_the_excess_thrust() -> None:
    """6 N are left of each propeller's, of 0.2 m/s2 each: 2.4 m/s2, so that tan gamma is 0.12 at the most."""
    limits = LIMITS.copy()
    limits[2:, 1] = np.array(MODEL.trim)[2:] + 1.5
    excess = excess_u_dot(MODEL, limits)
    assert excess == pytest.approx(1.5 * sum(MODEL.input_matrix[3][2:]))
    assert design(limits=limits).loops.climb_max == pytest.approx(0.5 * excess / 9.80665 * 18.0, rel=1e-3)


def test_gusts_act_by_angles_and_along_the_span() -> None:
    """Twice the airspeed halves the change of angle, and doubles the power of gusts at a frequency. The air rolls about a span of
    three metres two thirds as much."""
    found, point = gust_density(MODEL), replace(MODEL, span_m=None)
    assert 1.5 * 0.32 < found[1] < 2.0 * 0.32, "of the v-tail: 1.5 to 2 times what was measured in flight"
    assert 1.5 * 1.3 < found[0] < 2.0 * 1.3, "likewise"
    fast = gust_density(replace(point, airspeed_m_s=36.0))
    assert fast[1] == pytest.approx(0.5 * math.sqrt(2.0) * gust_density(point)[1])
    rolling = np.zeros((6, 5))
    rolling[0, 2] = MODEL.derivatives[0][2]
    only = replace(MODEL, derivatives=tuple(map(tuple, rolling)))
    assert gust_density(replace(only, span_m=3.0))[0] == pytest.approx(2.0 / 3.0 * gust_density(only)[0])
    assert gust_density(point)[0] < 0.3


def test_the_air_rolls_no_less_about_wide_slow_wings_than_their_estimation_sees() -> None:
    """A glider of 18 m/s and 14 m has the corner of its rolling gusts at 1 rad/s, where effectiveness is estimated: the density
    there is that above a corner of 4 rad/s, 2.8 times that above its own."""
    rolling = np.zeros((6, 5))
    rolling[0, 2] = MODEL.derivatives[0][2]
    only = replace(MODEL, derivatives=tuple(map(tuple, rolling)))
    span = math.pi * 18.0 / 4.0
    wide = gust_density(replace(only, span_m=span))[0]
    assert wide == pytest.approx(4.0 / math.sqrt(2.0) * 2.0 / span * gust_density(only)[0], rel=1e-3)


def test_gusts_enter_forward_acceleration_by_the_aircrafts_turning() -> None:
    """By hand: 0.3 rad/s times 0.0933 m/s per sqrt(Hz), also of an aircraft whose drag does not change with its angles."""
    still = replace(MODEL, derivatives=tuple(map(tuple, np.zeros((6, 5)))))
    assert gust_density(still)[3] == pytest.approx(0.028, rel=0.01)
    assert gust_density(replace(still, airspeed_m_s=72.0))[3] == pytest.approx(0.056, rel=0.01)


def test_the_models_error_is_that_of_an_angle() -> None:
    slopes = np.array(MODEL.derivatives)
    assert model_error_std(MODEL)[1] == pytest.approx(0.005 * math.hypot(*slopes[1, :2]))
    assert model_error_std(MODEL)[3] == 0.1
