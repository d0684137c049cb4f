"""The GLR test for jams: which actuator, how sure, and what becomes of the estimates."""

from __future__ import annotations

import math

import numpy as np
import pytest
from vtail_setup import WEATHER, Records, records_of, vtail_setup

from testbed.controllers.inversion.estimator import (
    HEALTHY_VARIANCE,
    JAM_VARIANCE,
    REVERSAL_S,
)
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, MEAN_S, SLOW_S
from testbed.controllers.inversion.jam_detection import (
    RECENT_FLAG_S,
    REDESIGN_AFTER,
    REVERSED_S,
    detect_jam,
    likeliest_jam,
    take_for_jammed,
)
from testbed.controllers.inversion.offset_detection import JAM_SIGMA
from testbed.controllers.records import D_ALPHA, Q_DOT

SETUP = vtail_setup(WEATHER)
N = 4


def records() -> Records:
    made = records_of(SETUP)
    made.s.model_error_variance[:] = made.c.model_error_std**2
    made.s.filtered_position[:] = 0.0
    return made


@pytest.mark.parametrize("actuator", range(N))
@pytest.mark.parametrize("pressure_ratio", [0.8, 1.5])
def test_the_offset_of_each_actuator_is_found(actuator: int, pressure_ratio: float) -> None:
    """A residual along B_i is told from those along the others, with its size."""
    m, c, _, s, _ = records()
    factor = pressure_ratio if m.servo[actuator] else 1.0
    s.residual[:] = 3.0 * factor * m.B[:, actuator]
    found, offset = likeliest_jam(pressure_ratio, m, c, s)
    assert found == actuator
    assert offset == pytest.approx(3.0)


def test_the_ratio_is_that_of_weighted_least_squares() -> None:
    """(fit / its standard deviation)^2 of each actuator by numpy; the largest wins if it is beyond `JAM_SIGMA`^2. An error of the
    effectiveness is as good an explanation, as far as the position makes it one."""
    m, c, _, s, _ = records()
    s.residual[:] = residual_of_a_test = np.array([0.9, -2.0, 0.8, 0.5])
    variance = 0.5 * c.noise**2 / MEAN_S + s.model_error_variance
    s.P[range(N), range(N)] = [0.01, 0.04, 0.02, 0.03]
    s.filtered_position[1], ratios = [2.0, -1.0, 1.5, 3.0], []
    for i in range(N):
        root = np.sqrt(variance)
        column, residual = m.B[:, i] / root, s.residual / root
        fit, *_ = np.linalg.lstsq(column[:, None], residual, rcond=None)
        ratios.append(fit[0] ** 2 / (1.0 / (column @ column) + s.filtered_position[1, i] ** 2 * s.P[i, i]))
    best = int(np.argmax(ratios))
    for factor, expected in ((1.001, -1), (0.999, best)):
        s.residual[:] = residual_of_a_test * JAM_SIGMA / (math.sqrt(ratios[best]) * factor)
        assert likeliest_jam(1.0, m, c, s)[0] == expected


@pytest.mark.parametrize("i", [0, 2])
def test_a_jam_is_flagged_after_its_time_and_not_before(i: int) -> None:
    """Of a surface that may or may not follow its command, and of a motor, which waits for longer."""
    m, c, _, s, _ = records()
    s.P[i, i] = 1.0
    e = 6.0 * np.array(m.B)[:, i]
    time = MEAN_S if m.servo[i] else SLOW_S
    steps = 0
    while not detect_jam(e, 1.0, m, c, s):
        steps += 1
    assert time < steps * c.dt < time + 2.0 * MEAN_S
    assert np.flatnonzero(s.jammed).tolist() == [i] and np.flatnonzero(s.failed).tolist() == [i]


def test_white_residuals_flag_nothing() -> None:
    """Negative control: gusts of the expected density, a minute of them."""
    m, c, _, s, _ = records()
    rng = np.random.default_rng(8)
    sigma = c.noise / math.sqrt(c.dt)
    assert not any(detect_jam(sigma * rng.normal(size=4), 1.0, m, c, s) for _ in range(12000))


def test_a_negative_estimate_that_is_certain_is_a_reversal() -> None:
    m, c, _, s, _ = records()
    s.lambda_hat[1] = -0.9
    s.filtered_position[1, 1] = 0.5
    steps = round(c.persistence / c.dt)
    assert not any(detect_jam(np.zeros(4), 1.0, m, c, s) for _ in range(steps))
    assert detect_jam(np.zeros(4), 1.0, m, c, s) == 0 and s.jammed[1] == 1
    assert detect_jam(np.zeros(4), 1.0, m, c, s) == 1, "the design is of the next step's position"
    assert s.jammed[1] == 1 and s.failed[1] == 1
    assert s.lambda_hat[1] == pytest.approx(-0.45), "from now on its position"


@pytest.mark.parametrize(
    ("departed", "at_stop", "estimate", "held"),
    [(1, -1, 0.16, True), (0, -1, 0.16, False), (1, 0, 0.16, False), (1, 1, 0.3, False)],
)
def test_a_weak_surface_that_stands_at_its_stop_is_held_once_the_flight_departs(
    departed: int, at_stop: int, estimate: float, held: bool
) -> None:
    """An Aerosonde's elevator stuck near its trim looked like one with 0.16 of its effect for 40 s, and 200 m were lost: at a stop
    the two are the same force."""
    m, c, _, s, _ = records()
    s.lambda_hat[1], s.saturated, s.at_stop[1], s.departed = estimate, 1, at_stop, departed
    s.filtered_position[1, 1] = -2.5
    steps = round(MEAN_S / c.dt)
    assert not any(detect_jam(np.zeros(4), 1.0, m, c, s) for _ in range(steps)) and not s.jammed.any()
    for _ in range(3):
        detect_jam(np.zeros(4), 1.0, m, c, s)
    assert bool(s.jammed[1]) == held
    assert s.lambda_hat[1] == pytest.approx(-2.5 * estimate if held else estimate)


def test_an_uncertain_negative_estimate_is_none() -> None:
    m, c, _, s, _ = records()
    s.lambda_hat[1], s.P[1, 1] = -0.9, 1.1 * c.flag_std_max**2
    assert not any(detect_jam(np.zeros(4), 1.0, m, c, s) for _ in range(400))


@pytest.mark.parametrize(("sigmas", "flagged"), [(1.05 * BEYOND_DOUBT, True), (0.95 * BEYOND_DOUBT, False)])
def test_an_aircraft_unstable_in_pitch_does_not_wait_for_a_small_deviation(
    sigmas: float, flagged: bool
) -> None:
    m, c, _, s, _ = records()
    m.A[Q_DOT, D_ALPHA] = 5.0
    s.lambda_hat[1], s.P[1, 1] = -0.9, (0.9 / sigmas) ** 2
    for _ in range(round(REVERSED_S / c.dt) + 1):
        detect_jam(np.zeros(4), 1.0, m, c, s)
    assert bool(s.jammed[1]) == flagged


def test_the_mode_is_designed_again_when_the_jammed_actuator_moves() -> None:
    m, c, _, s, _ = records()
    s.jammed[0], s.failed[0], s.lambda_hat[0], s.designed_position[0] = 1, 1, 1.0, 1.0
    assert detect_jam(np.zeros(4), 1.0, m, c, s) == 0
    s.lambda_hat[0] = 1.0 + 1.01 * REDESIGN_AFTER
    assert detect_jam(np.zeros(4), 1.0, m, c, s) == 1


def test_a_jam_takes_back_recent_flags_and_starts_the_estimates_again() -> None:
    """Flags that the jam may have caused are taken back; an older failure stays one."""
    m, _, _, s, _ = records()
    s.lambda_hat[:] = [0.1, 0.4, 0.02, 0.9]
    s.failed[:] = [1, 0, 1, 0]
    s.since_flag[:] = [0.9 * RECENT_FLAG_S, math.inf, 1.1 * RECENT_FLAG_S, math.inf]
    s.b[:], s.residual[:] = 1.0, 1.0
    take_for_jammed(3, 2.5, 1.0, m, s)
    assert s.failed.tolist() == [0, 0, 1, 1] and s.jammed.tolist() == [0, 0, 0, 1]
    assert s.lambda_hat.tolist() == [1.0, 1.0, 0.02, 2.5]
    column = np.array(m.B)[:, 3]
    assert np.array(s.filtered_phi)[:, :, 3] == pytest.approx(np.array([column, column]))
    assert not s.b.any() and not s.residual.any()
    assert np.allclose(np.diag(s.P)[N:], s.model_error_variance)
    assert np.diag(s.P)[[0, 1, 3]].tolist() == [HEALTHY_VARIANCE, HEALTHY_VARIANCE, JAM_VARIANCE]


def taken_at(position: float) -> Records:
    """The right ruddervator has been taken for jammed at this scaled position."""
    made = records()
    made.s.position[:] = made.m.trim_position
    take_for_jammed(1, position, 1.0, made.m, made.s)
    made.s.designed_position[1] = position
    return made


def test_an_actuator_whose_force_goes_to_minus_its_trim_position_is_reversed() -> None:
    """It is not jammed from then on, and its effectiveness is estimated from -1 on."""
    m, c, _, s, _ = taken_at(-2.0)
    s.lambda_hat[1], s.since_flag[1] = -1.0, 0.05
    for short_of, changed in ((0.3, 0), (0.2, 1)):  # three quarters of the way to minus its trim position
        s.lambda_hat[1] = -2.0 + (2.0 - m.trim_position[1]) * (1.0 - short_of)
        s.designed_position[1] = s.lambda_hat[1]
        assert detect_jam(np.zeros(4), 1.0, m, c, s) == changed
    assert (s.jammed[1], s.failed[1], s.reversed[1], s.lambda_hat[1]) == (0, 1, 1, -1.0)
    assert s.P[1, 1] == HEALTHY_VARIANCE
    s.P[1, 1] = 1.0
    s.lambda_hat[1] = c.lambda_min
    for _ in range(2 * round(c.persistence / c.dt)):
        assert detect_jam(np.zeros(4), 1.0, m, c, s) == 0
    assert not s.jammed[1], "gusts drive the estimate of a surface at its trim position to its limits"


def test_what_no_longer_acts_reversed_works() -> None:
    """Once that is sure, by three standard deviations."""
    m, c, _, s, _ = records()
    s.failed[1], s.reversed[1], s.lambda_hat[1] = 1, 1, 0.1
    for sigma, changed in ((0.21, 0), (0.19, 1)):
        s.P[1, 1] = sigma**2
        assert detect_jam(np.zeros(4), 1.0, m, c, s) == changed
        assert (s.failed[1], s.reversed[1], s.jammed[1]) == (1 - changed, 1 - changed, 0)
    assert s.lambda_hat[1] == 1.0


def test_a_jam_leaves_the_flag_of_a_reversed_actuator() -> None:
    m, _, _, s, _ = records()
    s.failed[:2], s.reversed[1], s.lambda_hat[1], s.since_flag[:] = 1, 1, -0.9, 0.5 * RECENT_FLAG_S
    take_for_jammed(3, 1.0, 1.0, m, s)
    assert s.failed.tolist() == [0, 1, 0, 1] and s.lambda_hat[1] == -0.9


def test_a_motor_that_is_stuck_is_never_reversed() -> None:
    m, c, _, s, _ = records()
    take_for_jammed(2, 5.0, 1.0, m, s)
    s.designed_position[2], s.lambda_hat[2] = 5.0, -m.trim_position[2]
    detect_jam(np.zeros(4), 1.0, m, c, s)
    assert s.jammed[2] and not s.reversed[2]


def test_a_reversed_actuator_flagged_on_its_way_is_judged_from_the_farthest() -> None:
    """It is flagged before its command is at the stop: the force goes on for a moment, and then comes back."""
    m, c, _, s, _ = taken_at(-1.05)
    s.since_flag[1] = 0.05
    for estimate, changed in ((-1.1, 0), (-1.5, 1), (-0.2, 1)):
        s.lambda_hat[1] = estimate
        assert detect_jam(np.zeros(4), 1.0, m, c, s) == changed
    assert s.reversed[1] and not s.jammed[1]


@pytest.mark.parametrize(("position", "estimate"), [(-2.0, -1.5), (-2.0, -2.2), (-0.9, -0.5), (2.0, 1.3)])
def test_an_actuator_whose_force_stays_is_jammed(position: float, estimate: float) -> None:
    """Or comes from so near that gusts may have moved the estimate."""
    m, c, _, s, _ = taken_at(position)
    s.lambda_hat[1] = estimate
    detect_jam(np.zeros(4), 1.0, m, c, s)
    assert s.jammed[1] and not s.reversed[1]


def test_an_estimate_that_moves_later_is_no_reversal() -> None:
    m, c, _, s, _ = taken_at(-2.0)
    for _ in range(round(REVERSAL_S / c.dt)):
        detect_jam(np.zeros(4), 1.0, m, c, s)
    s.lambda_hat[1] = -0.5
    assert detect_jam(np.zeros(4), 1.0, m, c, s) == 1, "but the mode is designed again"
    assert s.jammed[1] and not s.reversed[1]


def test_a_jammed_position_is_within_the_stops() -> None:
    m, _, _, s, _ = records()
    take_for_jammed(0, 99.0, 1.0, m, s)
    assert s.lambda_hat[0] == m.high[0]


@pytest.mark.parametrize(
    ("actuator", "share", "in_error", "sigma", "jammed"),
    [
        (2, 0.5, 0.0, 0.1, 1),
        (2, 0.1, 0.4, 0.1, 1),
        (2, -0.5, 0.0, 0.1, 1),
        (2, 0.2, 0.0, 0.1, 0),
        (2, 0.5, -0.4, 0.1, 0),
        (2, 0.5, 0.0, 0.3, 0),
        (2, 0.9, 0.0, 0.1, 0),
        (0, 0.5, 0.0, 0.1, 0),
    ],
)
def test_a_flagged_motor_that_keeps_its_thrust_is_jammed(
    actuator: int, share: float, in_error: float, sigma: float, jammed: int
) -> None:
    """Not one whose thrust may be nothing, one that works again, or a surface. Of two units of thrust the estimate says a share,
    and the model's error holds another, with a standard deviation."""
    m, c, _, s, _ = records()
    s.failed[actuator], s.lambda_hat[actuator] = 1, share
    s.filtered_position[1, actuator] = 2.0
    s.b[:] = 2.0 * in_error * np.array(m.B)[:, actuator]
    c.noise[:] = 0.0
    s.model_error_variance[:] = 4.0 * (2.0 * sigma * np.array(m.B)[:, actuator]) ** 2
    steps = math.ceil(MEAN_S / c.dt)
    assert not any(detect_jam(np.zeros(4), 1.0, m, c, s) for _ in range(steps - 2)) and not s.jammed.any()
    for _ in range(4):
        detect_jam(np.zeros(4), 1.0, m, c, s)
    assert s.jammed[actuator] == jammed
    if jammed:
        assert s.lambda_hat[actuator] == pytest.approx(
            np.clip(2.0 * (share + in_error), m.low[actuator], m.high[actuator])
        )
