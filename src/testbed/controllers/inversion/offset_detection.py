"""Offset detection: an actuator that has moved from its command, but still follows it, is used on.

A sudden force along a surface's column of B is either a jam or an offset: position = p, or position = command + d. At that moment
no test can tell them apart. The commands that follow do: the force of an offset surface changes with them, that of a jammed one
does not. So a change that no effectiveness explains goes to the model error b, and the effectiveness is judged by what follows.
An estimate of 0 then means a jam, and one of 1 an offset. Each is believed when the other is `BEYOND_DOUBT` away. A gust passes:
it is believed when an offset of the size seen at first is as far away. Until then, and after an offset is believed, commands make
up for it by its `shift`.

A motor or engine whose thrust turns the aircraft moves in the same way, but what it gives beside its throttle is a jam once that
has been sure for `SLOW_S`. Thrust that shows in u_dot alone looks like drag and gusts, and no sudden change of it is a move.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, HALF_WAY, MEAN_S
from testbed.controllers.inversion.law import effect_ratio

JAM_SIGMA = 4.0
"""Size of the fitted jam, in its standard deviations, beyond which an actuator counts as jammed. At 25 ft/s lost effectiveness
never goes beyond 1.1, and offsets of 5 deg go beyond 4 in half of 8 flights."""
NEAR_SIGMAS = 1.5
"""Standard deviations of the estimate above 0 up to which a surface with little force is jammed; above, it may be weak."""


@compiled
def is_of_position(i, estimate, c, s):
    """Whether actuator i is in use, and its change to this `estimate` is one of position: it cannot have this effectiveness, or it
    has moved already. One that acts late is excluded, because a wrong time explains such changes too."""
    in_use = c.tests_offsets and c.turns[i] and not (s.failed[i] or s.jammed[i])
    possible = (s.moved[i] == 0.0 or is_offset(i, s)) and c.lambda_min <= estimate <= c.lambda_max
    return in_use and not is_late(i, s) and not possible


@compiled
def is_late(i, s):
    """Whether actuator i acts later than its model says, beyond doubt."""
    return s.late[i] * s.late[i] > BEYOND_DOUBT * BEYOND_DOUBT * s.late_variance[i]


@compiled
def expect_offset(i, change, phi, m, s):
    """Give the model error b, along column i of Phi, the variance of a force of `change` times that column [4, n].

    What was learned of actuator i while its force was taken for effectiveness is doubted: the variance of its estimate becomes at
    least the square of its distance from 1. How far it has moved by the first such force is kept."""
    n = len(s.lambda_hat)
    if s.moved[i] == 0.0 or is_offset(i, s):
        lost = 1.0 - s.lambda_hat[i]
        s.P[i, i] = max(s.P[i, i], lost * lost)
    if s.moved[i] == 0.0:
        projection, square = 0.0, 1e-12
        for row in range(4):
            projection += m.B[row, i] * phi[row, i] * change
            square += m.B[row, i] * m.B[row, i]
        s.moved[i], s.offset_timer[i] = projection / square, 0.0
    for row in range(4):
        for other in range(4):
            s.P[n + row, n + other] += phi[row, i] * phi[other, i] * change * change


@compiled
def time_to_stand_still(i, pressure_ratio, m, c, s):
    """How long surface i must look jammed until it is taken for jammed [s]; 0 where it does not look jammed.

    Effectiveness 1 must be out of question, and one of these hold:

    * the force in the model error is beyond `JAM_SIGMA` standard deviations: `persistence` at that force, and less as one over the
      square of a larger one, since a hardover leaves no time;
    * with less force, it has `moved`: `persistence` if its effectiveness is negative beyond doubt, `MEAN_S` if it is about 0.
    """
    if not m.servo[i] or s.jammed[i] or s.reversed[i]:
        return 0.0
    doubt = deviation(i, s)
    if s.lambda_hat[i] >= min(HALF_WAY, 1.0 - BEYOND_DOUBT * doubt):
        return 0.0
    offset, sigma = position_behind(s.b, i, pressure_ratio, m, c, s)
    beyond = abs(offset) / (sigma * JAM_SIGMA)
    if beyond > 1.0:
        return c.persistence / (beyond * beyond)
    if s.moved[i] == 0.0 or s.lambda_hat[i] > NEAR_SIGMAS * doubt:
        return 0.0
    return c.persistence if s.lambda_hat[i] < -BEYOND_DOUBT * doubt else MEAN_S


@compiled
def follows(i, m, s):
    """Whether surface i moves with its commands: effectiveness 0 is out of question."""
    return m.servo[i] and s.lambda_hat[i] > max(HALF_WAY, BEYOND_DOUBT * deviation(i, s))


@compiled
def is_offset(i, s):
    """Whether actuator i follows its command with an offset: that was sure for `MEAN_S` longer than it was not."""
    return s.moved[i] != 0.0 and s.offset_timer[i] > MEAN_S


@compiled
def deviation(i, s):
    """Standard deviation of the effectiveness estimate of actuator i [1]."""
    return math.sqrt(max(s.P[i, i], 0.0))


@compiled
def goes_against(i, m, s):
    """Whether actuator i goes against its command: its effectiveness is below 0 beyond doubt, and nearer to that of a reversed one
    than to 0. That is -1, or less where a reversed one would be at its other stop, which may be much nearer."""
    a = s.position[i]
    there = min(max(-a, m.low[i]), m.high[i])
    half = HALF_WAY * there / a if m.servo[i] and a != 0.0 else -HALF_WAY
    return s.lambda_hat[i] < min(half, -BEYOND_DOUBT * deviation(i, s))


@compiled
def weight_of(row, c, s):
    """What a mean of this rate over `MEAN_S` weighs [x_c^-2]: one over its variance, S / 2T for gusts of two-sided density S, and
    that of the model error."""
    return 1.0 / (0.5 * c.noise[row] * c.noise[row] / MEAN_S + s.model_error_variance[row])


@compiled
def position_behind(rates, i, pressure_ratio, m, c, s):
    """The position of actuator i whose force explains these rates [4] best, by weighted least squares.

    Returns:
        The position, and its standard deviation if there is nothing but gusts and the model's error [scaled].
    """
    projection, information = 0.0, 0.0
    for row in range(4):
        column = m.B[row, i] * effect_ratio(i, pressure_ratio, m)  # of (2): the signature of this actuator
        weight = weight_of(row, c, s)
        projection += column * weight * rates[row]
        information += column * weight * column
    return projection / information, 1.0 / math.sqrt(information)


@compiled
def was_a_gust(i, offset, pressure_ratio, m, c, s):
    """Whether an actuator that has moved turns out not to have: an offset as large as the one that was seen at first is out of
    question. It is `BEYOND_DOUBT` of what is unknown of the `position_behind` the model error larger than that."""
    n, information, variance = len(s.lambda_hat), 0.0, 0.0
    for row in range(4):
        weight = m.B[row, i] * weight_of(row, c, s)
        information += weight * m.B[row, i]
        for other in range(4):
            variance += weight * s.P[n + row, n + other] * m.B[other, i] * weight_of(other, c, s)
    missing = abs(s.moved[i]) - effect_ratio(i, pressure_ratio, m) * offset * math.copysign(1.0, s.moved[i])
    return missing * information > BEYOND_DOUBT * math.sqrt(max(variance, 0.0))


@compiled
def keep_offsets(pressure_ratio, m, c, s):
    """Keep what actuators have moved in the model error b: along their columns of B it does not fade, and its standard deviation is
    that offset. Where b faded, effectiveness would slowly take its place. Until they are known to follow, it is no more than what
    was seen at first: with more, the offset of a jammed one would follow the commands, and it would seem to work."""
    n, rate = len(s.lambda_hat), c.model_error_rate * c.dt
    for i in range(n):
        if s.moved[i] != 0.0:
            force = effect_ratio(i, pressure_ratio, m) * position_behind(s.b, i, pressure_ratio, m, c, s)[0]
            size = abs(force) if is_offset(i, s) else min(abs(force), abs(s.moved[i]))
            for row in range(4):
                s.b[row] += rate * m.B[row, i] * force
                for other in range(4):
                    s.P[n + row, n + other] += 2.0 * rate * m.B[row, i] * m.B[other, i] * size * size


@compiled
def follow_offsets(pressure_ratio, m, c, s):
    """Update `shift`, by which commands make up for what has moved, by the model error b, and what is `beside` in b. Returns 1 when
    a surface `is_offset` from now on: that is sure while it `follows` and its force is beyond `JAM_SIGMA` standard deviations."""
    found = 0
    for row in range(4):
        s.beside[row] = s.b[row]
    for i in range(len(s.moved)):
        s.shift[i] = 0.0
        if s.moved[i] == 0.0:
            continue
        estimate, sigma = position_behind(s.b, i, pressure_ratio, m, c, s)
        s.shift[i] = 0.0 if c.uncompensated else estimate
        if m.servo[i]:
            for row in range(4):
                s.beside[row] -= m.B[row, i] * effect_ratio(i, pressure_ratio, m) * estimate
        if is_offset(i, s):
            continue
        sure = follows(i, m, s) and abs(estimate) > JAM_SIGMA * sigma
        s.offset_timer[i] = max(s.offset_timer[i] + (c.dt if sure else -c.dt), 0.0)
        if is_offset(i, s):
            found = 1
        elif was_a_gust(i, estimate, pressure_ratio, m, c, s):
            s.moved[i] = 0.0
    return found
