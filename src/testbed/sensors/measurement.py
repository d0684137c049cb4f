"""One control step of all sensors: plain Python that numba compiles."""

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2

# Layers of the table [layers, steps, channels]: what was drawn before the flight, and what it fills.
ERROR, OFFSET, STATE_OF, SENSED, READING, LAYERS = 0, 1, 2, 3, 4, 5
# Rows of the parameters [6, channels]: the truth's column (-1: the specific force), lag, scale, delay, size
# of one digit, and 1 for an angle that goes from 0 to 2 pi.
SOURCE, LAG, SCALE, DELAY, DIGIT, CIRCULAR, PARAMETERS = 0, 1, 2, 3, 4, 5, 6
_TURN = 2.0 * math.pi


@compiled
def sense(k, truth, force, parameters, lagged, table):
    """Fill row k of what each channel senses and reads.

    Args:
        truth: [steps, ...] rows of `Plant.read`.
        force: specific force along body x [m/s2].
        parameters: [6, channels]; `lagged` [channels], `table` [5, steps, channels]: the sensors' memory.
    """
    for c in range(len(lagged)):
        source = int(parameters[SOURCE, c])
        x = truth[k, source] if source >= 0 else force
        if k == 0:
            lagged[c] = x
        change = x - lagged[c]
        if parameters[CIRCULAR, c] > 0.5:
            change = (change + math.pi) % _TURN - math.pi  # the short way round
        lag = parameters[LAG, c]
        lagged[c] = lagged[c] + lag * change if lag < 1.0 else x
        table[SENSED, k, c] = parameters[SCALE, c] * lagged[c] + table[ERROR, k, c]
        table[READING, k, c] = reading(k, c, parameters, table)


@compiled
def reading(k, c, parameters, table):
    """What channel c reads in step k: sensed some steps ago, with what is broken in it, in whole digits."""
    state = table[STATE_OF, k, c]
    if state == 1.0:
        return table[READING, k - 1, c] if k > 0 else table[SENSED, k, c]
    if state == 2.0:
        return table[OFFSET, k, c]
    x = table[SENSED, max(k - int(parameters[DELAY, c]), 0), c] + table[OFFSET, k, c]
    digit = parameters[DIGIT, c]
    if digit > 0.0:
        x = digit * np.floor(x / digit + 0.5)  # not math's, which makes an integer even of NaN
    return x % _TURN if parameters[CIRCULAR, c] > 0.5 else x


@compiled
def derive(k, rate, readings, measured):
    """Fill row k of the measured state from the readings alone (`channels.CHANNELS`, `signals.STATE`).

    Gyros are differentiated backwards, unfiltered: a filter belongs to who knows what else to filter alike.
    u_dot = a_x - g sin(pitch) - q w + r v, with v and w of the measured airspeed, alpha and beta.
    """
    y, x = readings[k], measured[k]
    p, q, r, a_x, roll, pitch, heading = y[0], y[1], y[2], y[3], y[4], y[5], y[6]
    airspeed, alpha, beta, altitude, climb_rate, north, east = y[7], y[8], y[9], y[10], y[11], y[12], y[13]
    x[0], x[1], x[2], x[3], x[4] = north, east, altitude, airspeed, climb_rate
    x[5], x[6], x[7], x[8], x[9] = roll, pitch, heading, alpha, beta
    x[10], x[11], x[12] = p, q, r
    for i in range(3):
        x[13 + i] = rate * (y[i] - readings[k - 1, i]) if k > 0 else 0.0
    v = airspeed * math.sin(beta)
    w = airspeed * math.sin(alpha) * math.cos(beta)
    x[16] = a_x - GRAVITY_M_S2 * math.sin(pitch) - q * w + r * v


@compiled
def measure(k, force, rate, parts):
    """One control step: sense, then derive; only `sense` sees the truth."""
    truth, measured, parameters, lagged, table = parts
    sense(k, truth, force, parameters, lagged, table)
    derive(k, rate, table[READING], measured)
