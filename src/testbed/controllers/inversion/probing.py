"""Probing: an actuator that is given up is moved a little to and fro, to find out whether it works again.

At its trim position a held actuator and one that works again cannot be told apart, and a surface that is lost hardly acts there.
So its command is trim + a sine; that of a surface just taken for jammed, which may be reversed, is first -trim
(`to_trim_if_reversed`). Its force follows its modelled position with a gain: 0 for one that is lost or held, 1 for one that
works. Whether 1 has taken the place of 0 is found by Page's test (CUSUM; Biometrika 41 (1954) 100): the logarithm of the likelihood
ratio is summed up, and begins again where it falls below 0. The actuator is used again when the sum is above `CERTAIN`. The noise
is what gusts and the model's error do to the rates, and the sine is as large as `CERTAIN` needs in it within `WITHIN_S`. An
engine's is slower, as the engine is.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, REVERSAL_S
from testbed.controllers.inversion.evidence import HALF_WAY, SLOW_S
from testbed.controllers.inversion.jam_detection import REVERSAL_WAY_MIN, settle_regression, take_for_working
from testbed.controllers.inversion.law import effect_ratio

CERTAIN = 7.0
"""Logarithm of a likelihood ratio that is believed [1]: 1100 to 1."""
WITHIN_S = 0.7
"""Time in which the sine is to show a gain [s]: what works again is to be used before something else fails."""
QUICK_SHARE = 0.25
"""Share of the variance of the model's error, beyond that at its trim, that varies as quickly as the sine [1]. With none of it
hardovers seemed to work in calm air. With all of it, propellers that worked again were found later than with a quarter."""
LARGEST, LARGEST_THRUST = 0.8, 1.6
"""Largest amplitude of the sine of a surface, and of thrust [scaled]. What is lost or held does not follow it: it moves an aircraft
only until it is used. Thrust moves it slowly, and with 0.8 an Aerosonde's propeller was used 2.9 s after it worked again."""
RAD_S, RAD_S_MORE = 4.0, 1.0
"""Angular frequency of the first actuator's sine, and how much faster the next ones are [rad/s]: fast against what the model leaves
out. One that acts 0.3 s late has a gain of -0.2 at 6 rad/s, and of -0.9 at 9 rad/s, where it seems reversed."""
ENGINE_SLOWER = 4.0
"""How many times slower the sine of an engine is, and how much longer it may take: it follows its throttle slowly [1]."""
AT_LEAST_RAD = 3.0 * math.pi
"""Phase of the sine before which nothing is decided [rad]: within the first turn and a half a drift looks like a gain."""
LARGEST_CHANGE = 5.0
"""Largest change of a rate that is taken in, over the root of its noise's density: a jam that ends, or another actuator that fails,
is a larger one, and the sine's own is about as large."""


@compiled
def probe(e, pressure_ratio, m, c, s):
    """Advance the probes of the actuators that are given up; returns 1 when one is used again."""
    changed = 0
    for i in range(len(s.probe)):
        position = s.filtered_position[1, i]  # as late as the regression
        if not s.failed[i] or s.reversed[i] or s.since_flag[i] < REVERSAL_S:
            s.probe[i] = to_trim_if_reversed(i, m, s) if s.failed[i] and s.jammed[i] else 0.0
            s.works[i], s.probe_mean[i] = 0.0, position
            for row in range(4):
                s.probe_rest[i, row] = unexplained(i, row, e, position, pressure_ratio, m, s)
            continue
        follow_probe(i, e, position, pressure_ratio, m, c, s)
        too_early = probe_rate(i, m) * (s.since_flag[i] - REVERSAL_S) < AT_LEAST_RAD
        if too_early or not has_room(i, m, s):
            s.works[i] = 0.0
            continue
        if s.works[i] > CERTAIN:
            use_again(i, pressure_ratio, m, s)
            changed = 1
    return changed


@compiled
def to_trim_if_reversed(i, m, s):
    """What is added to the trim position of a surface that may be reversed, so that a reversed one goes to its trim position. If it
    is nearly there already, nothing: the trim position itself shows more of it."""
    far = abs(s.jammed_at[i] - m.trim_position[i]) > REVERSAL_WAY_MIN
    return -2.0 * m.trim_position[i] if m.servo[i] and far else 0.0


@compiled
def has_room(i, m, s):
    """Whether an actuator is where its probe can move it: one that is held at its stop cannot show a gain, unless it is trimmed
    there."""
    low, high = m.low[i] + LARGEST, m.high[i] - LARGEST
    return not s.jammed[i] or low < s.lambda_hat[i] < high or not low < m.trim_position[i] < high


@compiled
def probe_rate(i, m):
    """Angular frequency of the sine of actuator i [rad/s]."""
    return (RAD_S + RAD_S_MORE * i) / slower(i, m)


@compiled
def slower(i, m):
    """How many times slower the probe of actuator i is than that of a surface or motor [1]."""
    return ENGINE_SLOWER if m.engine[i] else 1.0


@compiled
def follow_probe(i, e, position, pressure_ratio, m, c, s):
    """Add this step's logarithms of the likelihood ratios of actuator i, whose filtered position this is, to its sums, and move its
    sine on."""
    rate = probe_rate(i, m)
    s.probe_mean[i] += c.dt * (position - s.probe_mean[i])
    moved, product, information = position - s.probe_mean[i], 0.0, 0.0
    for row in range(4):
        varies = max(s.model_error_variance[row] - c.model_error_std[row] * c.model_error_std[row], 0.0)
        density = c.noise[row] * c.noise[row] + QUICK_SHARE * varies / rate
        column = m.B[row, i] * effect_ratio(i, pressure_ratio, m)
        change = unexplained(i, row, e, position, pressure_ratio, m, s) - s.probe_rest[i, row]
        s.probe_rest[i, row] += c.dt * change
        most = LARGEST_CHANGE * math.sqrt(density)
        product += column / density * min(max(change, -most), most)
        information += column * column / density
    half = HALF_WAY * moved * moved * information
    s.works[i] = max(s.works[i] + c.dt * (moved * product - half), 0.0)
    # The mean of the sum's rate is a quarter of the amplitude's square times the information.
    amplitude = math.sqrt(4.0 * CERTAIN / (information * WITHIN_S * slower(i, m)))
    s.probe[i] = min(amplitude, LARGEST if m.servo[i] else LARGEST_THRUST) * math.sin(
        rate * (s.since_flag[i] - REVERSAL_S)
    )


@compiled
def unexplained(i, row, e, position, pressure_ratio, m, s):
    """What the other actuators leave of a rate [x_c]: the error e, and what is ascribed to actuator i at this filtered position."""
    own = s.lambda_hat[i] * (1.0 if s.jammed[i] else position)
    return e[row] + m.B[row, i] * effect_ratio(i, pressure_ratio, m) * own


@compiled
def use_again(i, pressure_ratio, m, s):
    """Take an actuator for working: most likely all of its effect has come back. A surface that was held has an offset, by which
    its force is not that of its command: the model error takes it over, and commands make up for it (`offset_detection`)."""
    if s.jammed[i]:
        offset = effect_ratio(i, pressure_ratio, m) * (s.lambda_hat[i] - s.probe_mean[i])
        for row in range(4):
            s.b[row] += m.B[row, i] * offset
        # Its sine has shown that it follows.
        s.moved[i], s.offset_timer[i] = offset if m.servo[i] else 0.0, SLOW_S
    take_for_working(i, 1.0, 4.0 * HEALTHY_VARIANCE, s)
    settle_regression(i, s.position[i], pressure_ratio, m, s)
    s.probe[i], s.works[i] = 0.0, 0.0
