"""One control step of all sensors, and an error that wanders: plain Python that numba compiles.

A reading is made of the truth in this order: low-pass, scale and drawn errors (what is *sensed*), then delay, faults and
resolution (what is *read*). What the controller is told is computed from the readings alone.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

from testbed.common.angles import wrap
from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2
from testbed.sensors.faults import HOLDS, REPLACED

ERROR, OFFSET, FAULT, SENSED, READING, LAYERS = 0, 1, 2, 3, 4, 5
"""Layers of the table [layers, steps, channels], in SI. ERROR, OFFSET and FAULT are drawn before the flight; SENSED and READING
are filled during it."""

_FIELDS = np.dtype(
    [
        ("source", np.int64),  # column of the truth, -1 for the specific force
        ("lag", np.float64),  # fraction of a change that passes the low-pass within one step; 1 is no lag
        ("scale", np.float64),
        ("delay", np.int64),  # control steps
        ("digit", np.float64),  # size of one digit [SI]; 0 is infinitely fine
        ("circular", np.bool_),  # an angle that goes from 0 to 2 pi
    ],
    align=True,
)
PARAMETERS = np.dtype((np.record, _FIELDS))
"""The constants of one channel, as a record."""

_TURN = 2.0 * math.pi
_wrap = compiled(wrap)


@compiled
def measure(k, force, rate, parts):
    """One control step: sense, then derive; only `sense` sees the truth.

    Args:
        k: the control step.
        force: specific force along body x [m/s2].
        rate: control rate [Hz].
        parts: truth [steps, ...] (see `Plant.read`), channels [channels] of `PARAMETERS`, lagged [channels] outputs of the
            low-passes, table [5, steps, channels]. Then two arrays [steps] of records: the table's readings by channel, and the
            measured state by `signals.STATE`, which is filled.
    """
    truth, channels, lagged, table, readings, measured = parts
    sense(k, truth, force, channels, lagged, table)
    derive(k, rate, readings, measured)


@compiled
def sense(k, truth, force, channels, lagged, table):
    """Fill row k of what each channel senses and reads; arguments as in `measure`."""
    for c in range(len(lagged)):
        channel = channels[c]
        x = truth[k, channel.source] if channel.source >= 0 else force
        if k == 0:
            lagged[c] = x
        change = x - lagged[c]
        if channel.circular:
            change = _wrap(change)
        lagged[c] = lagged[c] + channel.lag * change if channel.lag < 1.0 else x
        table[SENSED, k, c] = channel.scale * lagged[c] + table[ERROR, k, c]
        table[READING, k, c] = reading(k, c, channel, table)


@compiled
def reading(k, c, channel, table):
    """What channel c reads in step k: what it sensed `delay` steps ago, with its faults, rounded to whole digits."""
    fault = table[FAULT, k, c]
    if fault == HOLDS:
        return table[READING, k - 1, c] if k > 0 else table[SENSED, k, c]
    if fault == REPLACED:
        return table[OFFSET, k, c]
    x = table[SENSED, max(k - channel.delay, 0), c] + table[OFFSET, k, c]
    if channel.digit > 0.0:
        x = channel.digit * np.floor(x / channel.digit + 0.5)  # math.floor would turn NaN into an integer
    return x % _TURN if channel.circular else x


@compiled
def derive(k, rate, readings, measured):
    """Fill row k of the measured state from the readings alone (`channels.CHANNELS`, `signals.STATE`).

    Angular accelerations are backward differences of the gyros. They are not filtered here: the controller filters them, with
    the same filter as its other signals. u_dot = a_x - g sin(pitch) - q w + r v, with v and w of the measured airspeed, alpha
    and beta.
    """
    y, x = readings[k], measured[k]
    x.north, x.east, x.altitude = y.position_north, y.position_east, y.altitude
    x.airspeed, x.climb_rate = y.airspeed, y.climb_rate
    x.roll, x.pitch, x.heading = y.roll, y.pitch, y.heading
    x.alpha, x.beta = y.alpha, y.beta
    x.p, x.q, x.r = y.gyro_p, y.gyro_q, y.gyro_r
    before = readings[max(k - 1, 0)]  # in the first step nothing has changed yet
    x.p_dot = rate * (y.gyro_p - before.gyro_p)
    x.q_dot = rate * (y.gyro_q - before.gyro_q)
    x.r_dot = rate * (y.gyro_r - before.gyro_r)
    v = y.airspeed * math.sin(y.beta)
    w = y.airspeed * math.sin(y.alpha) * math.cos(y.beta)
    x.u_dot = y.accelerometer_x - GRAVITY_M_S2 * math.sin(y.pitch) - y.gyro_q * w + y.gyro_r * v


@compiled
def correlate(x, correlation):
    """Turn white noise, in place, into a first-order Gauss-Markov sequence of variance one:
    x[k] = c x[k-1] + sqrt(1 - c^2) noise[k], x[0] = noise[0].

    Args:
        x: [steps] standard normal noise, and result.
        correlation: c, the correlation of neighbouring steps, exp(-dt / correlation time).
    """
    fresh = math.sqrt(1.0 - correlation * correlation)
    for k in range(1, len(x)):
        x[k] = correlation * x[k - 1] + fresh * x[k]
