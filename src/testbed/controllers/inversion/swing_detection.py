"""Swing detection: an actuator that oscillates by itself while it follows its command, position = command + d(t), is not lost.

The literature calls it an oscillatory failure case (Lavigne, Zolghadri, Goupil and Simon 2011, doi:10.1007/s12555-011-0106-6). It
is at first taken for lost effectiveness, or for the force of a jam. But the command of an actuator
that is given up stands still at its trim position. Then a lost actuator has no force, the force of a jammed one stays, and that
of one that swings oscillates. Such an actuator is used again. From then on its swings are part of the model error b along its
column of B, so that its effectiveness is judged by what follows the command alone.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, forget_model_error, reset_covariance
from testbed.controllers.inversion.jam_detection import filtered_position, settle_regression
from testbed.controllers.inversion.law import effect_ratio, largest
from testbed.controllers.inversion.offset_detection import JAM_SIGMA

FORCE_TIME_S = 0.15
"""Time constant of the mean of a given-up actuator's force [s]: gusts at 25 ft/s leave 0.02 scaled units of a ruddervator."""
TURNS = 3
"""Turns of the force that make a swing. Coming to rest after a jam, a reversal or a runaway, it turns once or twice."""
SLOWEST_S = 5.0
"""Longest time between two turns of one swing [s]: an actuator that oscillates below 0.1 Hz stays given up."""


@compiled
def detect_swings(e, pressure_ratio, m, c, s):
    """Look for given-up actuators that swing, by the error e [4]; returns 1 when one is used again.

    The swings of one are seen in the force of each other whose column of B is not orthogonal to its own. So only the one whose
    swings are largest in their standard deviations is used again.
    """
    changed = 0
    for i in range(len(s.lambda_hat)):
        if not s.failed[i] or s.reversed[i] or s.own_noise[i] > 0.0:
            s.turns[i], s.since_turn[i], s.swing_sigmas[i] = -1, 0.0, 0.0
            continue
        sigma = follow_force(i, e, pressure_ratio, m, c, s)
        if not turned(i, sigma, m, c, s):
            continue
        count_turn(i, sigma, s)
        if s.turns[i] >= TURNS and s.swing_sigmas[i] == largest(s.swing_sigmas):
            use_again(i, pressure_ratio, m, s)
            changed = 1
    return changed


@compiled
def follow_force(i, e, pressure_ratio, m, c, s):
    """Update the mean force of a given-up actuator, and its extreme since the last turn; returns the mean's standard deviation
    [scaled]."""
    force, sigma = own_force(i, e, pressure_ratio, m, c, s)
    if s.turns[i] < 0:  # it has just been given up
        estimated = s.lambda_hat[i] * filtered_position(i, pressure_ratio, m, c, s)
        s.own_force[i], s.extreme[i], s.last_extreme[i] = estimated, estimated, estimated
        s.rising[i], s.turns[i] = 1, 0
    s.own_force[i] += c.dt / FORCE_TIME_S * (force - s.own_force[i])
    s.since_turn[i] += c.dt
    if way_back(i, s) < 0.0:
        s.extreme[i] = s.own_force[i]
    return sigma


@compiled
def own_force(i, e, pressure_ratio, m, c, s):
    """Force of actuator i as a position: that of its estimate, and what explains the innovation e - b beyond it, by weighted least
    squares. White noise of two-sided density S has the variance S / 2T after a lag of time constant T: so gusts count.

    Returns:
        The force [scaled], and the standard deviation of its mean over `FORCE_TIME_S` by gusts and what is unknown of b [scaled].
    """
    n = len(s.lambda_hat)
    projection, information = 0.0, 0.0
    for row in range(4):
        b = m.B[row, i] * effect_ratio(i, pressure_ratio, m)
        gusts = 0.5 * c.noise[row] * c.noise[row] / FORCE_TIME_S
        weight = 1.0 / (gusts + s.P[n + row, n + row])
        projection += b * weight * (e[row] - s.b[row])
        information += b * weight * b
    estimated = s.lambda_hat[i] * filtered_position(i, pressure_ratio, m, c, s)
    return estimated + projection / information, 1.0 / math.sqrt(information)


@compiled
def way_back(i, s):
    """How far the mean force has come back from its extreme since the last turn [scaled]; negative beyond that extreme."""
    return s.extreme[i] - s.own_force[i] if s.rising[i] else s.own_force[i] - s.extreme[i]


@compiled
def turned(i, sigma, m, c, s):
    """Whether the mean force of a given-up actuator has turned: it has come back by more than gusts, the model error or its own
    effectiveness at the trim position explain. The amplitude, half of the way, must be `JAM_SIGMA` standard deviations."""
    return way_back(i, s) > max(2.0 * JAM_SIGMA * sigma, c.lambda_max * abs(m.trim_position[i]))


@compiled
def count_turn(i, sigma, s):
    """Count a turn, and keep the amplitude and the half period of the swing that it ends. After a pause the count begins again."""
    s.turns[i] = s.turns[i] + 1 if s.since_turn[i] < SLOWEST_S else 1
    s.swing[i], s.half_period[i] = 0.5 * abs(s.extreme[i] - s.last_extreme[i]), s.since_turn[i]
    s.swing_sigmas[i], s.last_extreme[i] = s.swing[i] / sigma, s.extreme[i]
    s.extreme[i], s.rising[i], s.since_turn[i] = s.own_force[i], 1 - s.rising[i], 0.0


@compiled
def use_again(i, pressure_ratio, m, s):
    """Take an actuator that swings for working: its flag is removed, and those set since, which its swings may have caused."""
    s.own_noise[i], since = swing_noise(i, s), s.since_flag[i]
    s.failed[i], s.jammed[i], s.reversed[i], s.flag_timer[i], s.since_flag[i] = 0, 0, 0, 0.0, 0.0
    for j in range(len(s.failed)):
        if s.failed[j] and not s.reversed[j] and s.since_flag[j] < since:
            s.failed[j], s.jammed[j] = 0, 0
        if not s.failed[j]:
            reset_estimate(j, pressure_ratio, m, s)
    forget_model_error(s)


@compiled
def swing_noise(i, s):
    """Process noise of the model error that stands for the swings of actuator i [scaled^2/s].

    A sine of amplitude A and angular frequency w has the variance A^2 / 2. So has the first-order process with the corner w that is
    driven by noise of density 2 w A^2 / 2. The amplitude was measured through a lag of time constant T = `FORCE_TIME_S`, which
    leaves 1 / sqrt(1 + (w T)^2) of it.
    """
    rate = math.pi / s.half_period[i]
    return rate * s.swing[i] * s.swing[i] * (1.0 + (rate * FORCE_TIME_S) * (rate * FORCE_TIME_S))


@compiled
def reset_estimate(j, pressure_ratio, m, s):
    """Begin the estimate of an actuator's effectiveness as for a healthy one, at its present position."""
    s.lambda_hat[j], s.lambda_slow[j] = 1.0, 1.0
    s.flag_timer[j], s.jam_timer[j], s.reversal_timer[j] = 0.0, 0.0, 0.0
    reset_covariance(j, HEALTHY_VARIANCE, s)
    settle_regression(j, s.position[j], pressure_ratio, m, s)


@compiled
def expect_swings(pressure_ratio, m, c, s):
    """Add the process noise of actuators that swing by themselves to the model error, along their columns of B."""
    n = len(s.lambda_hat)
    for i in range(n):
        if s.own_noise[i] > 0.0:
            ratio = effect_ratio(i, pressure_ratio, m)
            noise = s.own_noise[i] * c.dt * ratio * ratio
            for row in range(4):
                for other in range(4):
                    s.P[n + row, n + other] += noise * m.B[row, i] * m.B[other, i]
