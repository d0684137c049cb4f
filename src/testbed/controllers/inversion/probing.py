"""Probing: an actuator that is given up is moved a little to and fro, to find out whether it works again.

At its trim position a held actuator and one that works again cannot be told apart, and a surface that is lost hardly acts there.
So its command is trim + a sine. The gain g from its modelled position to its force is found by least squares over the last
`MEMORY_S`: 0 for one that is lost or held, 1 for one that works, -1 for one that is reversed. What it is taken for changes
when 0 is `BEYOND_DOUBT` standard deviations away. The sine is as large as that needs within `MEMORY_S`, given what gusts do to the
rates. An engine's is slower, as the engine is.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, REVERSAL_S
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, HALF_WAY
from testbed.controllers.inversion.jam_detection import (
    settle_regression,
    take_for_reversed,
    take_for_working,
)
from testbed.controllers.inversion.law import effect_ratio, lag_gain
from testbed.controllers.inversion.offset_detection import deviation

MEMORY_S = 2.0
"""Time constant of the least squares [s]: what works again is to be used within a few seconds, before something else fails."""
DEVIATION = 0.2
"""Standard deviation of g that the sine is made for [1]."""
LARGEST = 0.4
"""Largest amplitude of the sine [scaled]."""
RAD_S, RAD_S_MORE = 4.0, 1.0
"""Angular frequency of the first actuator's sine, and how much faster the next ones are [rad/s]: fast against what the model leaves
out. One that acts 0.3 s late has a gain of -0.2 at 6 rad/s, and of -0.9 at 9 rad/s, where it seems reversed."""
ENGINE_SLOWER = 4.0
"""How many times slower the sine of an engine is, and how many times longer its memory: it follows its throttle slowly [1]."""
AT_LEAST_RAD = 3.0 * math.pi
"""Phase of the sine before which nothing is decided [rad]: within the first turn and a half a drift looks like a gain."""
LARGEST_CHANGE = 10.0
"""Largest change of a rate that is taken in, over the root of its noise's density: a jam that ends, or another actuator that fails,
is a larger one."""
OPPOSITE_WITHIN = 2.0
"""How far from the opposite of its command the force of a reversed surface may seem [scaled]: far from the trim the model is wrong
by as much. The motions of an aircraft with a hardover have a gain, too."""


@compiled
def probe(e, pressure_ratio, m, c, s):
    """Advance the probes of the actuators that are given up; returns 1 when one is used again."""
    changed = 0
    for i in range(len(s.probe)):
        if not s.failed[i] or s.reversed[i] or s.since_flag[i] < REVERSAL_S:
            s.probe[i], s.probe_product[i], s.probe_square[i] = 0.0, 0.0, 0.0
            s.probe_mean[i] = s.probe_lags[i, 0] = s.probe_lags[i, 1] = s.position[i]
            for row in range(4):
                s.probe_rest[i, row] = unexplained(i, row, e, s.position[i], pressure_ratio, m, c, s)
            continue
        follow_probe(i, e, pressure_ratio, m, c, s)
        too_early = probe_rate(i, m) * (s.since_flag[i] - REVERSAL_S) < AT_LEAST_RAD
        if too_early or s.probe_square[i] <= 0.0 or not has_room(i, m, s):
            continue
        gain, sigma = s.probe_product[i] / s.probe_square[i], 1.0 / math.sqrt(s.probe_square[i])
        if gain - BEYOND_DOUBT * sigma > 0.0 and gain > HALF_WAY:
            use_again(i, gain, pressure_ratio, m, s)
            changed = 1
        elif gain + BEYOND_DOUBT * sigma < 0.0 and gain < -HALF_WAY and may_be_reversed(i, m, s):
            take_for_reversed(i, pressure_ratio, m, s)
            changed = 1
    return changed


@compiled
def has_room(i, m, s):
    """Whether an actuator is where its probe can move it: one that is held at its stop cannot show a gain, unless it is trimmed
    there."""
    low, high = m.low[i] + LARGEST, m.high[i] - LARGEST
    return not s.jammed[i] or low < s.lambda_hat[i] < high or not low < m.trim_position[i] < high


@compiled
def may_be_reversed(i, m, s):
    """Whether the force of a surface at its trim position may be that of a reversed one, and is needed: the flight has departed,
    and the surface is held near the opposite of its command, or lost and its estimate is below zero beyond doubt. One that has just
    begun to work again has a gain of any sign; so has one that moves slowly, or swings at about the sine's frequency, and a flight
    that goes on without it loses by the mistake."""
    opposite = abs(s.lambda_hat[i] + m.trim_position[i]) < OPPOSITE_WITHIN
    wrong_way = s.lambda_hat[i] + BEYOND_DOUBT * deviation(i, s) < 0.0
    return s.departed and m.servo[i] and (opposite if s.jammed[i] else wrong_way)


@compiled
def probe_rate(i, m):
    """Angular frequency of the sine of actuator i [rad/s]."""
    return (RAD_S + RAD_S_MORE * i) / slower(i, m)


@compiled
def slower(i, m):
    """How many times slower the probe of actuator i is than that of a surface or motor [1]."""
    return ENGINE_SLOWER if m.engine[i] else 1.0


@compiled
def follow_probe(i, e, pressure_ratio, m, c, s):
    """Move the sine of actuator i on, and take this step's innovation into its least squares."""
    information, memory = 0.0, MEMORY_S * slower(i, m)
    for row in range(4):
        column = m.B[row, i] * effect_ratio(i, pressure_ratio, m) / c.noise[row]
        information += column * column
    amplitude = math.sqrt(2.0 / (information * memory)) / DEVIATION
    s.probe[i] = min(amplitude, LARGEST) * math.sin(probe_rate(i, m) * (s.since_flag[i] - REVERSAL_S))
    position = filtered_position_of(i, c, s)
    s.probe_mean[i] += c.dt * (position - s.probe_mean[i])
    moved, fade = position - s.probe_mean[i], c.dt / memory
    product = 0.0
    for row in range(4):
        column = m.B[row, i] * effect_ratio(i, pressure_ratio, m) / c.noise[row]
        change = unexplained(i, row, e, position, pressure_ratio, m, c, s) - s.probe_rest[i, row]
        s.probe_rest[i, row] += c.dt * change
        product += column * min(max(change, -LARGEST_CHANGE), LARGEST_CHANGE)
    s.probe_product[i] += c.dt * moved * product - fade * s.probe_product[i]
    s.probe_square[i] += c.dt * moved * moved * information - fade * s.probe_square[i]


@compiled
def unexplained(i, row, e, position, pressure_ratio, m, c, s):
    """What the other actuators leave of a rate, over the root of its noise's density: the error e, and what is ascribed to
    actuator i at this filtered position."""
    own = s.lambda_hat[i] * (1.0 if s.jammed[i] else position)
    return (e[row] + m.B[row, i] * effect_ratio(i, pressure_ratio, m) * own) / c.noise[row]


@compiled
def filtered_position_of(i, c, s):
    """Modelled position of an actuator that is given up [scaled], through the two lags of the regression."""
    gain = lag_gain(c.filter_rate * c.dt)
    s.probe_lags[i, 0] += gain * (s.position[i] - s.probe_lags[i, 0])
    s.probe_lags[i, 1] += gain * (s.probe_lags[i, 0] - s.probe_lags[i, 1])
    return s.probe_lags[i, 1]


@compiled
def use_again(i, gain, pressure_ratio, m, s):
    """Take an actuator for working, with this effectiveness [1]. A surface that was held has an offset, by which its force is not
    that of its command: the model error takes it over, and commands make up for it (`offset_detection`)."""
    if s.jammed[i]:
        offset = s.lambda_hat[i] - s.probe_lags[i, 1]
        for row in range(4):
            s.b[row] += m.B[row, i] * effect_ratio(i, pressure_ratio, m) * offset
        s.offset[i] = offset if m.servo[i] else 0.0
    take_for_working(i, min(gain, 1.0), 4.0 * HEALTHY_VARIANCE, s)
    settle_regression(i, s.position[i], pressure_ratio, m, s)
    s.probe[i], s.probe_product[i], s.probe_square[i] = 0.0, 0.0, 0.0
