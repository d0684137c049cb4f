"""Jams and reversals: which estimates show them, for how long, and what becomes of the estimates then."""

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
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, MEAN_S
from testbed.controllers.inversion.jam_detection import (
    REDESIGN_AFTER,
    REVERSED_S,
    detect_jam,
    take_for_jammed,
)
from testbed.controllers.inversion.loss_detection import monitor
from testbed.controllers.records import D_ALPHA, Q_DOT

SETUP = vtail_setup(WEATHER)
N = 4


def records() -> Records:
    made = records_of(SETUP)
    made.s.model_error_variance[:] = made.c.model_error_std**2
    made.s.filtered_position[:] = 0.0
    return made


def test_a_negative_estimate_that_is_certain_is_a_reversal() -> None:
    m, c, _, s, _ = records()
    s.lambda_hat[1] = -0.9
    s.filtered_position[1, 1] = 0.5
    steps = round(c.persistence / c.dt)
    assert not any(detect_jam(1.0, m, c, s) for _ in range(steps))
    assert detect_jam(1.0, m, c, s) == 0 and s.jammed[1] == 1
    assert detect_jam(1.0, m, c, s) == 1, "the design is of the next step's position"
    assert s.jammed[1] == 1 and s.failed[1] == 1
    assert s.lambda_hat[1] == pytest.approx(-0.45), "from now on its position"


def test_an_uncertain_negative_estimate_is_none() -> None:
    m, c, _, s, _ = records()
    s.lambda_hat[1], s.P[1, 1] = -0.9, 1.1 * c.flag_std_max**2
    assert not any(detect_jam(1.0, m, c, s) for _ in range(400))


def test_one_that_seems_lost_and_answers_its_sine_the_other_way_is_reversed_and_not_jammed() -> None:
    m, c, _, s, _ = records()
    s.failed[1], s.lambda_hat[1] = 1, -0.9
    changed = [detect_jam(1.0, m, c, s) for _ in range(round(c.persistence / c.dt) + 1)]
    assert changed[-1] == 1 and sum(changed) == 1
    assert (s.failed[1], s.jammed[1], s.reversed[1], s.lambda_hat[1]) == (1, 0, 1, -1.0)


@pytest.mark.parametrize(("other_stop", "flagged"), [(0.4, True), (1.0, False)])
def test_a_reversed_one_at_its_nearer_stop_seems_less_effective(other_stop: float, flagged: bool) -> None:
    """A command of -1 takes it to 0.4, or to 1 where it can go as far: then -0.3 is nearer to lost than to reversed."""
    m, c, _, s, _ = records()
    m.low[1], m.high[1], s.position[1], s.lambda_hat[1] = -1.0, other_stop, -1.0, -0.3
    s.P[1, 1] = 0.05**2
    for _ in range(round(c.persistence / c.dt) + 1):
        monitor(m, c, s)
        detect_jam(1.0, m, c, s)
    assert bool(s.jammed[1]) == flagged and s.failed[1] == 1


@pytest.mark.parametrize(("sigmas", "flagged"), [(1.05 * BEYOND_DOUBT, True), (0.95 * BEYOND_DOUBT, False)])
def test_an_aircraft_unstable_in_pitch_does_not_wait_for_a_small_deviation(
    sigmas: float, flagged: bool
) -> None:
    m, c, _, s, _ = records()
    m.A[Q_DOT, D_ALPHA] = 5.0
    s.lambda_hat[1], s.P[1, 1] = -0.9, (0.9 / sigmas) ** 2
    for _ in range(round(REVERSED_S / c.dt) + 1):
        detect_jam(1.0, m, c, s)
    assert bool(s.jammed[1]) == flagged


def test_the_mode_is_designed_again_when_the_jammed_actuator_moves() -> None:
    m, c, _, s, _ = records()
    s.jammed[0], s.failed[0], s.lambda_hat[0], s.designed_position[0] = 1, 1, 1.0, 1.0
    assert detect_jam(1.0, m, c, s) == 0
    s.lambda_hat[0] = 1.0 + 1.01 * REDESIGN_AFTER
    assert detect_jam(1.0, m, c, s) == 1


def test_a_jam_starts_the_estimates_of_the_others_again() -> None:
    """Its position is where its effectiveness and the model's error put it. Another failure stays one."""
    m, c, _, s, _ = records()
    s.lambda_hat[:] = [0.1, 0.4, 0.02, 0.9]
    s.failed[2], s.filtered_position[1, 3] = 1, 1.0
    column = np.array(m.B)[:, 3]
    s.b[:] = 1.6 * column
    take_for_jammed(3, 1.0, m, c, s)
    assert s.failed.tolist() == [0, 0, 1, 1] and s.jammed.tolist() == [0, 0, 0, 1]
    assert s.lambda_hat == pytest.approx([1.0, 1.0, 0.02, 2.5])
    assert np.array(s.filtered_phi)[:, :, 3] == pytest.approx(np.array([column, column]))
    assert not s.b.any()
    assert np.allclose(np.diag(s.P)[N:], s.model_error_variance)
    assert np.diag(s.P)[[0, 1, 3]].tolist() == [HEALTHY_VARIANCE, HEALTHY_VARIANCE, JAM_VARIANCE]


def taken_at(position: float) -> Records:
    """The right ruddervator has been taken for jammed at this scaled position."""
    made = records()
    made.s.position[:] = made.m.trim_position
    made.s.lambda_hat[1], made.s.filtered_position[1, 1] = 1.0, position
    take_for_jammed(1, 1.0, made.m, made.c, made.s)
    made.s.designed_position[1] = position
    return made


def test_an_actuator_whose_force_goes_to_minus_its_trim_position_is_reversed() -> None:
    """It is not jammed from then on, and its effectiveness is estimated from -1 on."""
    m, c, _, s, _ = taken_at(-2.0)
    s.lambda_hat[1], s.since_flag[1] = -1.0, 0.05
    for short_of, changed in ((0.3, 0), (0.2, 1)):  # three quarters of the way to minus its trim position
        s.lambda_hat[1] = -2.0 + (2.0 - m.trim_position[1]) * (1.0 - short_of)
        s.designed_position[1] = s.lambda_hat[1]
        assert detect_jam(1.0, m, c, s) == changed
    assert (s.jammed[1], s.failed[1], s.reversed[1], s.lambda_hat[1]) == (0, 1, 1, -1.0)
    assert s.P[1, 1] == HEALTHY_VARIANCE
    s.P[1, 1] = 1.0
    s.lambda_hat[1] = c.lambda_min
    for _ in range(2 * round(c.persistence / c.dt)):
        assert detect_jam(1.0, m, c, s) == 0
    assert not s.jammed[1], "gusts drive the estimate of a surface at its trim position to its limits"


def test_what_no_longer_acts_reversed_works() -> None:
    """Once that is sure, by three standard deviations."""
    m, c, _, s, _ = records()
    s.failed[1], s.reversed[1], s.lambda_hat[1] = 1, 1, 0.1
    for sigma, changed in ((0.21, 0), (0.19, 1)):
        s.P[1, 1] = sigma**2
        assert detect_jam(1.0, m, c, s) == changed
        assert (s.failed[1], s.reversed[1], s.jammed[1]) == (1 - changed, 1 - changed, 0)
    assert s.lambda_hat[1] == 1.0


def test_a_jam_leaves_the_flag_of_a_reversed_actuator() -> None:
    m, c, _, s, _ = records()
    s.failed[1], s.reversed[1], s.lambda_hat[1] = 1, 1, -0.9
    take_for_jammed(3, 1.0, m, c, s)
    assert s.failed.tolist() == [0, 1, 0, 1] and s.lambda_hat[1] == -0.9


def test_a_motor_that_is_stuck_is_never_reversed() -> None:
    m, c, _, s, _ = records()
    take_for_jammed(2, 1.0, m, c, s)
    s.jammed_at[2] = 5.0
    s.designed_position[2], s.lambda_hat[2] = 5.0, -m.trim_position[2]
    detect_jam(1.0, m, c, s)
    assert s.jammed[2] and not s.reversed[2]


def test_a_reversed_actuator_flagged_on_its_way_is_judged_from_the_farthest() -> None:
    """It is flagged before its command is at the stop: the force goes on for a moment, and then comes back."""
    m, c, _, s, _ = taken_at(-1.05)
    s.since_flag[1] = 0.05
    for estimate, changed in ((-1.1, 0), (-1.5, 1), (-0.2, 1)):
        s.lambda_hat[1] = estimate
        assert detect_jam(1.0, m, c, s) == changed
    assert s.reversed[1] and not s.jammed[1]


@pytest.mark.parametrize(("position", "estimate"), [(-2.0, -1.5), (-2.0, -2.2), (-0.9, -0.5), (2.0, 1.3)])
def test_an_actuator_whose_force_stays_is_jammed(position: float, estimate: float) -> None:
    """Or comes from so near that gusts may have moved the estimate."""
    m, c, _, s, _ = taken_at(position)
    s.lambda_hat[1] = estimate
    detect_jam(1.0, m, c, s)
    assert s.jammed[1] and not s.reversed[1]


def test_an_estimate_that_moves_later_is_no_reversal() -> None:
    m, c, _, s, _ = taken_at(-2.0)
    for _ in range(round(REVERSAL_S / c.dt)):
        detect_jam(1.0, m, c, s)
    s.lambda_hat[1] = -0.5
    assert detect_jam(1.0, m, c, s) == 1, "but the mode is designed again"
    assert s.jammed[1] and not s.reversed[1]


def test_a_jammed_position_is_within_the_stops() -> None:
    m, c, _, s, _ = records()
    s.filtered_position[1, 0] = 99.0
    take_for_jammed(0, 1.0, m, c, s)
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
    assert not any(detect_jam(1.0, m, c, s) for _ in range(steps - 2)) and not s.jammed.any()
    for _ in range(4):
        detect_jam(1.0, m, c, s)
    assert s.jammed[actuator] == jammed
    if jammed:
        assert s.lambda_hat[actuator] == pytest.approx(
            np.clip(2.0 * (share + in_error), m.low[actuator], m.high[actuator])
        )
