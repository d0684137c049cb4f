"""Swing detection: an actuator that swings by itself while it follows its command, position = command + d(t), is not lost.

Its swings are at first taken for lost effectiveness, or for the force of a jam. But what is given up has a command that stands
still at its trim position. Then a lost actuator has no force, the force of a jammed one stays, and the force of one that swings
goes to and fro. Such an actuator is used again, and its swings are from then on part of the model error b along its column of B:
its effectiveness is judged by what follows the command alone.

Letters: m design model, c settings, s memory, e of the working memory; their fields, shapes and units are in `records`.
pressure_ratio is (V/V_0)^2.
"""

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, forget_model_error, reset_covariance
from testbed.controllers.inversion.jam_detection import filtered_position, settle_regression

FORCE_TIME_S = 0.15
"""Time constant of the mean of a given-up actuator's force: gusts at 25 ft/s leave .02 scaled units of a ruddervator."""
TURNS = 3
"""Turns of the force that make a swing. Coming to rest after a jam, a reversal or a runaway, it turns once or twice."""
SLOWEST_S = 5.0
"""Longest time between two turns of one swing."""


@compiled
def detect_swings(e, pressure_ratio, m, c, s):
    """Look for given-up actuators that swing, by the error e [4]; returns 1 when one is used again.

    The swings of one are seen in the force of each other whose column of B is not orthogonal to its own, so the surest is taken.
    """
    changed = 0
    for i in range(len(s.lambda_hat)):
        if not s.failed[i] or s.reversed[i] or s.own_noise[i] > 0.0:
            s.turns[i], s.since_turn[i], s.swing_sigmas[i] = -1, 0.0, 0.0
        elif (
            turned(i, e, pressure_ratio, m, c, s)
            and s.turns[i] >= TURNS
            and s.swing_sigmas[i] == s.swing_sigmas.max()
        ):
            use_again(i, pressure_ratio, m, s)
            changed = 1
    return changed


@compiled
def turned(i, e, pressure_ratio, m, c, s):
    """Whether the force of a given-up actuator has just come back from its last extreme, by more than gusts, the model error or
    its own effectiveness at the trim position explain. Counts the turns, from -1 before the first step."""
    force, sigma = own_force(i, e, pressure_ratio, m, c, s)
    if s.turns[i] < 0:
        s.own_force[i] = s.extreme[i] = s.last_extreme[i] = s.lambda_hat[i] * filtered_position(
            i, pressure_ratio, m, c, s
        )
        s.rising[i], s.turns[i] = 1, 0
    s.own_force[i] += c.dt / FORCE_TIME_S * (force - s.own_force[i])
    s.since_turn[i] += c.dt
    back = s.extreme[i] - s.own_force[i] if s.rising[i] else s.own_force[i] - s.extreme[i]
    if back < 0.0:
        s.extreme[i] = s.own_force[i]
    if back <= max(2.0 * c.jam_sigma * sigma, c.lambda_max * abs(m.trim_position[i])):
        return False
    s.turns[i] = s.turns[i] + 1 if s.since_turn[i] < SLOWEST_S else 1
    s.swing[i], s.half_period[i] = 0.5 * abs(s.extreme[i] - s.last_extreme[i]), s.since_turn[i]
    s.swing_sigmas[i], s.last_extreme[i] = s.swing[i] / sigma, s.extreme[i]
    s.extreme[i], s.rising[i], s.since_turn[i] = s.own_force[i], 1 - s.rising[i], 0.0
    return True


@compiled
def own_force(i, e, pressure_ratio, m, c, s):
    """Force of actuator i as a position [scaled]: that of its estimate, and what explains the innovation e - b beyond it.

    Returns:
        The force, and the standard deviation of its mean over `FORCE_TIME_S` by gusts and what is unknown of b.
    """
    projection, information = 0.0, 0.0
    for row in range(4):
        b = m.B[row, i] * (pressure_ratio if m.servo[i] else 1.0)
        gusts = 0.5 * c.noise[row] * c.noise[row] / FORCE_TIME_S
        weight = 1.0 / (gusts + s.P[len(s.lambda_hat) + row, len(s.lambda_hat) + row])
        projection += b * weight * (e[row] - s.b[row])
        information += b * weight * b
    estimated = s.lambda_hat[i] * filtered_position(i, pressure_ratio, m, c, s)
    return estimated + projection / information, 1.0 / math.sqrt(information)


@compiled
def use_again(i, pressure_ratio, m, s):
    """Take an actuator that swings for working: its flag is removed, and those set since, which its swings may have caused.

    The swings become process noise of the model error. A first-order process has the variance swing^2 / 2 and the corner pi /
    half_period at the density 2 (pi / half_period) swing^2 / 2. The mean that the swing was measured by is slower than it.
    """
    rate = math.pi / s.half_period[i]
    s.own_noise[i] = rate * s.swing[i] * s.swing[i] * (1.0 + (rate * FORCE_TIME_S) * (rate * FORCE_TIME_S))
    since = s.since_flag[i]
    s.failed[i], s.jammed[i], s.reversed[i], s.flag_timer[i], s.since_flag[i] = 0, 0, 0, 0.0, 0.0
    for j in range(len(s.failed)):
        if s.failed[j] and s.since_flag[j] < since:
            s.failed[j], s.jammed[j] = 0, 0
        if not s.failed[j]:
            start_again(j, pressure_ratio, m, s)
    forget_model_error(s)


@compiled
def start_again(j, pressure_ratio, m, s):
    """Begin the estimate of an actuator's effectiveness as for a healthy one, at its present position."""
    s.lambda_hat[j], s.flag_timer[j], s.jam_timer[j], s.reversal_timer[j] = 1.0, 0.0, 0.0, 0.0
    reset_covariance(j, HEALTHY_VARIANCE, s)
    settle_regression(j, s.position[j], pressure_ratio, m, s)


@compiled
def expect_swings(pressure_ratio, m, c, s):
    """Add the process noise of actuators that swing by themselves to the model error, along their columns of B."""
    n = len(s.lambda_hat)
    for i in range(n):
        if s.own_noise[i] > 0.0:
            pressure = pressure_ratio if m.servo[i] else 1.0
            noise = s.own_noise[i] * c.dt * pressure * pressure
            for row in range(4):
                for other in range(4):
                    s.P[n + row, n + other] += noise * m.B[row, i] * m.B[other, i]
