"""Jam detection: a jammed or reversed actuator adds a force that no loss of effectiveness explains.

The test is a generalised likelihood ratio (GLR; Willsky and Jones, IEEE TAC 21 (1976) 108) on the mean of the residual e.
An actuator that is detected so is flagged as failed and as jammed. From then on its position is estimated in place of its
effectiveness: its column of `law.regressor` is the effect of one scaled unit.

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
    follows,
    force_of_offsets,
    position_behind,
    take_for_offset,
    time_to_stand_still,
)
from testbed.controllers.records import D_ALPHA, Q_DOT

RECENT_FLAG_S = 2.0
"""Detecting a jam takes about this long. A flag raised less than this before may be an effect of the jam, and is removed."""
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
"""An actuator that was taken for jammed is reversed if it moves this share of the way to minus its trim position, where a jammed
one would stay. The way must have so many scaled units, or gusts decide."""
OF_NO_USE = 0.25
"""Estimate below which a surface that stands at its stop may be jammed near its trim. A weak tail with half of its effect is better
used on (suite `open`, seed 777, draw 117)."""
REDESIGN_AFTER = 0.1
"""Scaled units by which a jammed actuator's estimated position may move before the regulator is designed again: the step to which
designs are rounded. Without an elevator a tenth of its unit changes the only level airspeed by a tenth."""


@compiled
def detect_jam(e, pressure_ratio, m, c, s):
    """Look for jammed actuators in the error e [4]; returns 1 when what is known of jams or offsets has changed.

    An actuator is taken for jammed

    * when it has been the `likeliest_jam` for `MEAN_S`, a motor or engine for `SLOW_S`. The timer runs down while it is
      not. A surface that `follows` its command has an offset instead; one that has `moved` is decided by `time_to_stand_still`;
    * when a surface has stood still under its commands for the `time_to_stand_still`;
    * when it looks jammed in another way for the `time_to_jam`.
    """
    follow_offsets(pressure_ratio, m, c, s)
    for row in range(4):
        new = e[row] - force_of_offsets(row, pressure_ratio, m, s)
        s.residual[row] += c.dt / MEAN_S * (new - s.residual[row])
    likeliest, offset = likeliest_jam(pressure_ratio, m, c, s)
    changed = 0
    for i in range(len(s.lambda_hat)):
        still = time_to_stand_still(i, pressure_ratio, m, c, s)
        time = still if still > 0.0 else time_to_jam(i, pressure_ratio, m, c, s)
        s.reversal_timer[i] = s.reversal_timer[i] + c.dt if time > 0.0 else 0.0
        s.jam_timer[i] = max(s.jam_timer[i] + (c.dt if i == likeliest else -c.dt), 0.0)
        explained = s.jam_timer[i] > (MEAN_S if m.servo[i] else SLOW_S)
        if explained and follows(i, m, c, s):
            take_for_offset(i, s.offset[i] + offset, s)
            changed = 1
        elif (explained and (s.moved[i] == 0.0 or not m.servo[i])) or (
            time > 0.0 and s.reversal_timer[i] > time + TIMER_ROUNDING
        ):
            position = s.lambda_hat[i] * s.filtered_position[1, i]
            if still > 0.0 or not m.servo[i]:
                position += position_behind(s.b, i, pressure_ratio, m, c, s)[0]
            elif i == likeliest:
                position += offset
            take_for_jammed(i, position, pressure_ratio, m, s)
        elif s.jammed[i]:
            follow_way_back(i, m, c, s)
            if turns_out_reversed(i, m, c, s):
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
    """How long an actuator that `acts_reversed`, `stands_at_a_stop` or `keeps_thrust` must do so until it is taken for jammed [s];
    0 where it does none of these. On an aircraft that is unstable in pitch `REVERSED_S` of the first is enough. The last takes a
    probed engine `ENGINE_S`."""
    if acts_reversed(i, m, c, s):
        return REVERSED_S if unstable(m) else c.persistence
    if stands_at_a_stop(i, m, c, s):
        return MEAN_S
    if keeps_thrust(i, pressure_ratio, m, c, s):
        return ENGINE_S if m.engine[i] and c.probes else MEAN_S
    return 0.0


@compiled
def stands_at_a_stop(i, m, c, s):
    """Whether a surface with less than `OF_NO_USE` of its effect is commanded to a stop, and the flight has departed all the same.
    There weak and jammed are the same force, and no other command comes to tell them apart: it is of no more use than a jammed
    one."""
    in_use = c.weighted and m.servo[i] and not (s.failed[i] or s.jammed[i] or s.reversed[i])
    at_stop = s.saturated and s.at_stop[i] != 0
    return s.departed and in_use and at_stop and s.lambda_hat[i] < OF_NO_USE


@compiled
def keeps_thrust(i, pressure_ratio, m, c, s):
    """Whether a motor or engine that was flagged gives thrust at its trim throttle, though less than one that works again: its
    thrust has not followed its command down."""
    if not c.weighted or m.servo[i] or not s.failed[i] or s.jammed[i] or s.lambda_hat[i] >= c.recovery:
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
    """Whether the estimate of an actuator that is not yet taken for jammed or reversed is below zero beyond doubt."""
    sigma = deviation(i, s)
    sure = sigma <= c.flag_std_max or (unstable(m) and s.lambda_hat[i] < -BEYOND_DOUBT * sigma)
    return s.lambda_hat[i] < -HALF_WAY and sure and not (s.jammed[i] or s.reversed[i])


@compiled
def unstable(m):
    """Whether the aircraft is statically unstable in pitch: what drives it away is doubled within a fraction of a second."""
    return m.A[Q_DOT, D_ALPHA] > 0.0


@compiled
def follow_way_back(i, m, c, s):
    """Advance the time since actuator i was taken for jammed, and the position it was jammed at as long as it is still on its way
    there: when a jam is flagged, the command of a reversed actuator may still move away from the trim position."""
    s.since_flag[i] += c.dt
    farther = abs(m.trim_position[i] + s.lambda_hat[i]) > abs(m.trim_position[i] + s.jammed_at[i])
    if s.since_flag[i] < REVERSAL_S and farther:
        s.jammed_at[i] = s.lambda_hat[i]


@compiled
def turns_out_reversed(i, m, c, s):
    """Whether the force of an actuator that was taken for jammed has gone where a reversed one's goes: to minus its trim position.

    At the moment of detection the two cannot be told apart. The command has run away from the aircraft's motion, and is often at a
    stop, so a reversed actuator stands as still as a jammed one. A motor cannot push the other way: it stays jammed."""
    if not c.weighted or not m.servo[i] or s.since_flag[i] >= REVERSAL_S:
        return False
    way = -m.trim_position[i] - s.jammed_at[i]
    gone = s.lambda_hat[i] - s.jammed_at[i]
    return abs(way) > REVERSAL_WAY_MIN and gone / way > REVERSAL_SHARE


@compiled
def take_for_reversed(i, pressure_ratio, m, s):
    """Use an actuator that is given up, as a reversed one: its effectiveness is estimated from -1 on, and `law.divisor` keeps that
    sign. It stays flagged."""
    s.jammed[i], s.reversed[i] = 0, 1
    s.lambda_hat[i] = -1.0
    reset_covariance(i, HEALTHY_VARIANCE, s)
    settle_regression(i, m.trim_position[i], pressure_ratio, m, s)


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
def likeliest_jam(pressure_ratio, m, c, s):
    """The actuator for which an offset of its position explains the residual best, and that offset.

    It is the `position_behind` the residual. Its variance is that of the fit, and that of the effectiveness times the position
    squared. The test value is (offset / its standard deviation)^2, twice the logarithm of the likelihood ratio.

    Returns:
        Index of the actuator with the largest test value, if that is above `JAM_SIGMA`^2, or -1; and its offset [scaled].
    """
    likeliest, largest, offset = -1, JAM_SIGMA * JAM_SIGMA, 0.0
    for i in range(len(s.lambda_hat)):
        change, sigma = position_behind(s.residual, i, pressure_ratio, m, c, s)
        position = s.filtered_position[1, i]
        # An error of the effectiveness, times the position, is an offset too.
        ratio = change * change / (sigma * sigma + position * position * s.P[i, i])
        if not s.jammed[i] and ratio > largest:
            likeliest, largest, offset = i, ratio, change
    return likeliest, offset


@compiled
def take_for_jammed(i, position, pressure_ratio, m, s):
    """Flag actuator i as jammed at about this position [scaled], which is estimated from now on.

    Until now its force has biased the estimates of the other actuators. So the estimates of those that are not flagged start
    again at 1, and flags raised less than `RECENT_FLAG_S` ago are removed.
    """
    s.jammed[i], s.failed[i], s.moved[i] = 1, 1, 0.0
    s.jam_timer[i], s.reversal_timer[i], s.offset[i], s.shift[i] = 0.0, 0.0, 0.0, 0.0
    for j in range(len(s.failed)):
        if not (s.jammed[j] or s.reversed[j]) and s.since_flag[j] < RECENT_FLAG_S:
            s.failed[j] = 0
        if not s.failed[j]:
            s.lambda_hat[j], s.lambda_slow[j] = 1.0, 1.0
            reset_covariance(j, HEALTHY_VARIANCE, s)
    s.lambda_hat[i] = min(max(position, m.low[i]), m.high[i])
    s.jammed_at[i], s.since_flag[i], s.reversed[i] = s.lambda_hat[i], 0.0, 0
    s.designed_position[i] = NOT_DESIGNED
    reset_covariance(i, JAM_VARIANCE, s)
    settle_regression(i, 1.0, pressure_ratio, m, s)  # its column of Phi is from now on the effect of one unit
    forget_model_error(s)
    for row in range(4):
        s.residual[row] = 0.0
