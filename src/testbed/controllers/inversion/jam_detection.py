"""Jam detection: a jammed or reversed actuator has a force that does not follow its command.

The filter shows it: effectiveness 1 is out of question, and its force is in the model error b (`offset_detection`), or its
effectiveness is negative. One that is detected so is flagged as failed and as jammed. From then on its position is estimated in
place of its effectiveness: its column of `law.regressor` is the effect of one scaled unit.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import (
    HEALTHY_VARIANCE,
    JAM_VARIANCE,
    REVERSAL_S,
    forget_model_error,
    reset_covariance,
)
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, HALF_WAY, MEAN_S, SLOW_S
from testbed.controllers.inversion.law import TIMER_ROUNDING, effect_ratio
from testbed.controllers.inversion.offset_detection import (
    JAM_SIGMA,
    deviation,
    follow_offsets,
    goes_against,
    position_behind,
    time_to_stand_still,
)
from testbed.controllers.records import D_ALPHA, Q_DOT

REVERSED_S = 0.02
"""On an aircraft that is unstable in pitch, how long an estimate must be below zero beyond doubt [s]: it is beyond the stall before
the standard deviation is small."""
NOT_DESIGNED = 1e9
"""`designed_position` of a jam for which no regulator has been designed yet. That is done a step later: the first position is a
rough one, and the filter's next step corrects most of it."""
ENGINE_S = 8.0
"""How long a probed engine must keep its thrust until it is taken for jammed [s]: in about this time its probe says whether it
works again. Its estimate climbs slowly then."""
REVERSAL_SHARE, REVERSAL_WAY_MIN = 0.75, 1.0
"""An actuator that was taken for jammed is reversed if it moves this share of the way to where its command takes a reversed one: a
jammed one would stay. The way must have so many scaled units, or gusts decide."""
REDESIGN_AFTER = 0.1
"""Scaled units by which a jammed actuator's estimated position may move before the regulator is designed again: the step to which
designs are rounded. Without an elevator a tenth of its unit changes the only level airspeed by a tenth."""


@compiled
def detect_jam(pressure_ratio, m, c, s):
    """Look for actuators that do not follow their commands, by the estimates; returns 1 when what is known of jams or offsets has
    changed. An actuator is taken for jammed when it has looked so for the `time_to_jam`."""
    changed = follow_offsets(pressure_ratio, m, c, s)
    for i in range(len(s.lambda_hat)):
        time = time_to_jam(i, pressure_ratio, m, c, s)
        s.jam_timer[i] = s.jam_timer[i] + c.dt if time > 0.0 else 0.0
        if time > 0.0 and s.jam_timer[i] > time + TIMER_ROUNDING:
            # One that is given up and answers its sine the other way is not jammed.
            if s.failed[i] and m.servo[i] and acts_reversed(i, m, c, s):
                take_for_reversed(i, pressure_ratio, m, s)
                changed = 1
            else:
                take_for_jammed(i, pressure_ratio, m, c, s)
        elif s.jammed[i]:
            follow_way_back(i, m, c, s)
            if turns_out_reversed(i, m, s):
                take_for_reversed(i, pressure_ratio, m, s)
                changed = 1
            elif abs(s.lambda_hat[i] - s.designed_position[i]) > REDESIGN_AFTER:
                changed = 1
        elif s.reversed[i] and no_longer_reversed(i, s):
            take_for_working(i, 1.0, HEALTHY_VARIANCE, s)  # most likely all of its effect has come back
            changed = 1
    return changed


@compiled
def time_to_jam(i, pressure_ratio, m, c, s):
    """How long an actuator that stands still, `has_thrust_beside` its throttle, `acts_reversed` or `keeps_thrust` must do so until
    it is taken for jammed [s]; 0 where it does none of these. On an aircraft that is unstable in pitch `REVERSED_S` of the third is
    enough. The last takes a probed engine `ENGINE_S`."""
    time = time_to_stand_still(i, pressure_ratio, m, c, s)
    if time > 0.0:
        return time
    if has_thrust_beside(i, pressure_ratio, m, c, s):
        return SLOW_S
    if acts_reversed(i, m, c, s):
        return REVERSED_S if unstable(m) else c.persistence
    if keeps_thrust(i, pressure_ratio, m, c, s):
        return ENGINE_S if m.engine[i] and c.probes else MEAN_S
    return 0.0


@compiled
def has_thrust_beside(i, pressure_ratio, m, c, s):
    """Whether the model error b, less the force of surfaces that have moved, holds thrust of a motor or engine in use: what its
    throttle does not explain, beyond `JAM_SIGMA` standard deviations."""
    if m.servo[i] or s.failed[i]:
        return False
    thrust, sigma = position_behind(s.beside, i, pressure_ratio, m, c, s)
    return abs(thrust) > JAM_SIGMA * sigma


@compiled
def keeps_thrust(i, pressure_ratio, m, c, s):
    """Whether a motor or engine that was flagged gives thrust at its trim throttle, though less than one that works again: its
    thrust has not followed its command down."""
    if m.servo[i] or not s.failed[i] or s.jammed[i] or s.lambda_hat[i] >= c.recovery:
        return False
    # While its command stands still, the filter cannot tell its effectiveness from an offset.
    offset, sigma = position_behind(s.b, i, pressure_ratio, m, c, s)
    thrust = s.lambda_hat[i] * s.position[i] + offset
    return abs(thrust) > BEYOND_DOUBT * sigma


@compiled
def settle_regression(i, position, pressure_ratio, m, s):
    """Set the filtered column of Phi of an actuator to what it is after a long time at this position [scaled]."""
    for row in range(4):
        column = m.B[row, i] * effect_ratio(i, pressure_ratio, m) * position
        s.filtered_phi[0, row, i], s.filtered_phi[1, row, i] = column, column
        s.late_rate[i, 0, row], s.late_rate[i, 1, row] = 0.0, 0.0


@compiled
def acts_reversed(i, m, c, s):
    """Whether actuator i, not yet taken for jammed or reversed, `goes_against` its command for sure."""
    sure = deviation(i, s) <= c.flag_std_max or unstable(m)
    return sure and goes_against(i, m, s) and not (s.jammed[i] or s.reversed[i])


@compiled
def unstable(m):
    """Whether the aircraft is statically unstable in pitch: what drives it away is doubled within a fraction of a second."""
    return m.A[Q_DOT, D_ALPHA] > 0.0


@compiled
def follow_way_back(i, m, c, s):
    """Advance the time since actuator i was taken for jammed, and the position it was jammed at as long as it is still on its way
    there: when a jam is flagged, a reversed actuator may still move away from where its new command takes it."""
    s.since_flag[i] += c.dt
    farther = abs(s.lambda_hat[i] - if_reversed(i, m, s)) > abs(s.jammed_at[i] - if_reversed(i, m, s))
    if s.since_flag[i] < REVERSAL_S and farther:
        s.jammed_at[i] = s.lambda_hat[i]


@compiled
def if_reversed(i, m, s):
    """Where the command of an actuator that is given up takes a reversed one [scaled]."""
    return -(m.trim_position[i] + s.probe[i])


@compiled
def turns_out_reversed(i, m, s):
    """Whether the force of an actuator that was taken for jammed has gone where a reversed one's goes, `if_reversed`.

    At the moment of detection the two cannot be told apart. The command has run away from the aircraft's motion, and is often at a
    stop, so a reversed actuator stands as still as a jammed one. A motor cannot push the other way: it stays jammed."""
    if not m.servo[i] or s.since_flag[i] >= REVERSAL_S:
        return False
    way = if_reversed(i, m, s) - s.jammed_at[i]
    gone = s.lambda_hat[i] - s.jammed_at[i]
    return abs(way) > REVERSAL_WAY_MIN and gone / way > REVERSAL_SHARE


@compiled
def take_for_reversed(i, pressure_ratio, m, s):
    """Use an actuator that is given up, as a reversed one: its effectiveness is estimated from -1 on, and `law.divisor` keeps that
    sign. It stays flagged."""
    s.jammed[i], s.reversed[i] = 0, 1
    s.lambda_hat[i] = -1.0
    reset_covariance(i, HEALTHY_VARIANCE, s)
    settle_regression(i, s.position[i], pressure_ratio, m, s)


@compiled
def no_longer_reversed(i, s):
    """Whether the estimate of an actuator that is used with the opposite sign is above `-HALF_WAY` beyond doubt."""
    return s.lambda_hat[i] - BEYOND_DOUBT * deviation(i, s) > -HALF_WAY


@compiled
def take_for_working(i, effectiveness, variance, s):
    """Use an actuator as one that works, with this effectiveness [1] and its variance. Should it be lost, `monitor` says so."""
    s.failed[i], s.jammed[i], s.reversed[i], s.early[i] = 0, 0, 0, 0
    s.flag_timer[i], s.since_flag[i] = 0.0, 0.0
    s.lambda_hat[i], s.lambda_slow[i] = effectiveness, effectiveness
    reset_covariance(i, variance, s)


@compiled
def take_for_jammed(i, pressure_ratio, m, c, s):
    """Flag actuator i as jammed at the position that the filter's force of it shows, which is estimated from now on.

    Until now its force has biased the estimates of the other actuators. So those of the ones that are not flagged start again at 1.
    """
    position = s.lambda_hat[i] * s.filtered_position[1, i]
    position += position_behind(s.b, i, pressure_ratio, m, c, s)[0]
    s.jammed[i], s.failed[i], s.moved[i], s.shift[i], s.jam_timer[i] = 1, 1, 0.0, 0.0, 0.0
    for j in range(len(s.failed)):
        if not s.failed[j]:
            s.lambda_hat[j], s.lambda_slow[j] = 1.0, 1.0
            reset_covariance(j, HEALTHY_VARIANCE, s)
    s.lambda_hat[i] = min(max(position, m.low[i]), m.high[i])
    s.jammed_at[i], s.since_flag[i], s.reversed[i] = s.lambda_hat[i], 0.0, 0
    s.designed_position[i] = NOT_DESIGNED
    reset_covariance(i, JAM_VARIANCE, s)
    settle_regression(i, 1.0, pressure_ratio, m, s)  # its column of Phi is from now on the effect of one unit
    forget_model_error(s)
