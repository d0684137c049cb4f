"""Offset detection: a surface that has moved from its command, but still follows it, is used on.

A sudden force along a surface's column of B is either a jam or an offset: position = p, or position = command + d. At that moment
no test can tell them apart. The commands that follow do: the force of an offset surface changes with them, that of a jammed one
does not. So a change that no effectiveness explains goes to the model error b, and the effectiveness is judged by what follows.
An estimate of 0 then means a jam, and one of 1 an offset. Each is believed when the other is `BEYOND_SIGMAS` away. Until then, and
after an offset is believed, commands make up for it by its `shift`.

Motors and engines are left out: what they give beside their throttle is a jam.

Letters: m design model, c settings, s memory, phi of the working memory; their fields, shapes and units are in `records`.
pressure_ratio is (V/V_0)^2.
"""

from __future__ import annotations

import math

from testbed.common.jit import compiled

BETWEEN = 0.5
"""Effectiveness as far from that of a jammed surface, 0, as from that of one that follows, 1."""
BEYOND_SIGMAS = 3.0
"""Standard deviations of the estimate at which a hypothesis is given up."""


@compiled
def no_effectiveness(i, estimate, m, c, s):
    """Whether surface i is in use, and cannot have this effectiveness: its change is one of position. One that is known to be late
    is left out, because a wrong time explains such changes too."""
    in_use = m.servo[i] and not (s.failed[i] or s.jammed[i])
    in_time = s.late[i] * s.late[i] <= BEYOND_SIGMAS * BEYOND_SIGMAS * s.late_variance[i]
    return in_use and in_time and not c.lambda_min <= estimate <= c.lambda_max


@compiled
def expect_offset(i, change, phi, s):
    """Give the model error b, along column i of Phi, the variance of a force of `change` times that column [4, n].

    What was learned of surface i while its force was taken for effectiveness is doubted: the variance of its estimate becomes at
    least the square of its distance from 1."""
    n = len(s.lambda_hat)
    if not s.moved[i]:
        lost = 1.0 - s.lambda_hat[i]
        s.P[i, i], s.moved[i] = max(s.P[i, i], lost * lost), 1
    for row in range(4):
        for other in range(4):
            s.P[n + row, n + other] += phi[row, i] * phi[other, i] * change * change


@compiled
def time_to_stand_still(i, pressure_ratio, m, c, s):
    """How long surface i must look jammed until it is taken for jammed [s]; 0 where it does not look jammed.

    Effectiveness 1 must be out of question, and one of these hold:

    * the force in the model error is beyond `jam_sigma` standard deviations: `persistence` at that force, and less as one over the
      square of a larger one, since a hardover leaves no time;
    * with less force, it has `moved`: `persistence` if its effectiveness is negative beyond doubt, `jam_time` if it may be 0.
    """
    if not c.weighted or not m.servo[i] or s.jammed[i] or s.reversed[i]:
        return 0.0
    if s.lambda_hat[i] >= min(BETWEEN, 1.0 - BEYOND_SIGMAS * deviation(i, s)):
        return 0.0
    ratio = offset_in_model_error(i, pressure_ratio, m, s)[1] / (c.jam_sigma * c.jam_sigma)
    if ratio > 1.0:
        return c.persistence / ratio
    sure = BEYOND_SIGMAS * deviation(i, s)
    if not s.moved[i] or s.lambda_hat[i] > sure:
        return 0.0
    return c.persistence if s.lambda_hat[i] < -sure else c.jam_time


@compiled
def follows(i, m, c, s):
    """Whether surface i moves with its commands: effectiveness 0 is out of question."""
    sure = s.lambda_hat[i] > max(BETWEEN, BEYOND_SIGMAS * deviation(i, s))
    return c.weighted and m.servo[i] and sure and not s.failed[i]


@compiled
def deviation(i, s):
    """Standard deviation of the effectiveness estimate of actuator i [1]."""
    return math.sqrt(max(s.P[i, i], 0.0))


@compiled
def offset_in_model_error(i, pressure_ratio, m, s):
    """The offset of actuator i that explains the estimated model error b best, by least squares weighted with its variance.

    Returns:
        The offset [scaled], and the square of the offset over its standard deviation [1].
    """
    projection, information = 0.0, 0.0
    for row in range(4):
        column = m.B[row, i] * (pressure_ratio if m.servo[i] else 1.0)
        weight = 1.0 / s.model_error_variance[row]
        projection += column * weight * s.b[row]
        information += column * weight * column
    return projection / information, projection * projection / information


@compiled
def take_for_offset(i, offset, s):
    """Use surface i with this offset [scaled]."""
    s.offset[i], s.jam_timer[i], s.moved[i] = offset, 0.0, 0
    for row in range(4):
        s.residual[row] = 0.0


@compiled
def keep_offsets(pressure_ratio, m, c, s):
    """Keep the offsets of surfaces in the model error b: along their columns of B it does not fade, and its standard deviation is
    the offset. Where b faded, effectiveness would slowly take its place."""
    n = len(s.lambda_hat)
    for i in range(n):
        if s.moved[i] or s.offset[i] != 0.0:
            offset = offset_in_model_error(i, pressure_ratio, m, s)[0]
            rate = c.model_error_rate * c.dt
            for row in range(4):
                force = pressure_ratio * m.B[row, i] * offset
                s.b[row] += rate * force
                for other in range(4):
                    s.P[n + row, n + other] += 2.0 * rate * force * pressure_ratio * m.B[other, i] * offset


@compiled
def follow_offsets(pressure_ratio, m, c, s):
    """Update the offsets by the model error b, and `shift`, by which commands make up for them. A surface that works, and whose
    offset is within one standard deviation of the model error, has not moved: gusts look like it for a moment."""
    for i in range(len(s.offset)):
        s.shift[i] = 0.0
        if s.offset[i] != 0.0 or s.moved[i]:
            found, ratio = offset_in_model_error(i, pressure_ratio, m, s)
            if ratio < 1.0 and s.lambda_hat[i] > BETWEEN:
                s.moved[i] = 0
            s.shift[i] = 0.0 if c.uncompensated else found
            s.offset[i] = found if s.offset[i] != 0.0 else 0.0


@compiled
def force_of_offsets(row, pressure_ratio, m, s):
    """What the known offsets of surfaces add to one rate [rad/s2; u_dot m/s2]."""
    force = 0.0
    for i in range(len(s.offset)):
        if s.offset[i] != 0.0:
            force += m.B[row, i] * pressure_ratio * s.offset[i]
    return force
