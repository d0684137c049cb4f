"""One control step of the truth: logged in SI, measured ideally, and checked for the end of the flight.

Plain Python that numba compiles. A row of truth has `signals.STATE`, then the position and then the effectiveness of each
actuator (see `Plant.raw`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

from testbed.aircraft.description import Envelope
from testbed.common.jit import compiled
from testbed.common.signals import GROUND_M, STATE, as_records

GOES_ON, DIVERGED, ON_THE_GROUND, OUTSIDE_ENVELOPE = range(4)
"""Results of `observe`: the flight goes on, or why it ends."""

LIMITS = ("altitude_min", "airspeed_min", "airspeed_max", "alpha_max", "beta_max", "roll_max")
"""Limits of the flight envelope [m, m/s, rad]."""

CALM_M_S = 1e-9
"""Wind below which the air is calm: JSBSim's rounding leaves 1e-14 of a wind that nobody set [m/s]."""

_ALTITUDE, _AIRSPEED, _ROLL, _PITCH, _HEADING, _ALPHA, _BETA, _Q, _R, _U_DOT = map(
    STATE.index, ("altitude", "airspeed", "roll", "pitch", "heading", "alpha", "beta", "q", "r", "u_dot")
)


def limits_of(envelope: Envelope) -> np.ndarray:
    """[1] record of `LIMITS`; a limit that the aircraft does not have is one that is never passed."""

    def or_infinite(value: float | None) -> float:
        return math.inf if value is None else value

    limits = {
        "altitude_min": -math.inf if envelope.altitude_min_m is None else envelope.altitude_min_m,
        "airspeed_min": envelope.airspeed_min_m_s or 0.0,
        "airspeed_max": or_infinite(envelope.airspeed_max_m_s),
        "alpha_max": math.radians(or_infinite(envelope.alpha_max_deg)),
        "beta_max": math.radians(or_infinite(envelope.beta_max_deg)),
        "roll_max": math.radians(or_infinite(envelope.roll_max_deg)),
    }
    return as_records(np.array([[limits[name] for name in LIMITS]]), LIMITS)


@compiled
def observe(k, channels):
    """Fill row k of truth and of the measured state; return GOES_ON, or why the flight ends in this step.

    Args:
        k: the control step.
        channels: raw and factors [17 + 2 n] of the plant, wind [3] of the air, limits [1] (see `limits_of`), and two arrays to be
            filled: truth [steps, 17 + 2 n] and measured [steps, 17]. Sensors with errors later overwrite the row of `measured`.
    """
    raw, factors, wind, limits, truth, measured = channels
    row, finite = truth[k], True
    for i in range(len(raw)):
        row[i] = raw[i] * factors[i]
        finite = finite and math.isfinite(row[i])
    for i in range(measured.shape[1]):
        measured[k, i] = row[i]
    measured[k, _U_DOT] += turning_of(wind, row)
    if not finite:
        return DIVERGED
    if row[_ALTITUDE] < GROUND_M:
        return ON_THE_GROUND
    return GOES_ON if inside(row, limits[0]) else OUTSIDE_ENVELOPE


@compiled
def turning_of(wind, row):
    """What makes u_dot over the ground, of the truth, that through the air, of the measurement [m/s2]; 0 in calm air.

    The rate of u contains - q w + r v (Etkin and Reid, sec. 4.7), in which v and w are over the ground. A controller knows those
    through the air, from accelerometer and air data, and so does f_m. The difference is the wind's turning with the body axes.

    Args:
        wind: velocity of the air, north, east, down [m/s].
        row: of truth.
    """
    north, east, down = wind[0], wind[1], wind[2]
    if abs(north) + abs(east) + abs(down) < CALM_M_S:
        return 0.0
    roll, pitch, heading = row[_ROLL], row[_PITCH], row[_HEADING]
    ahead = north * math.cos(heading) + east * math.sin(heading)  # level, along the heading and to its right
    right = east * math.cos(heading) - north * math.sin(heading)
    below = down * math.cos(pitch) + ahead * math.sin(pitch)
    v = right * math.cos(roll) + below * math.sin(roll)
    w = below * math.cos(roll) - right * math.sin(roll)
    return row[_Q] * w - row[_R] * v


@compiled
def inside(row, limit):
    """Whether a row of truth is within the envelope."""
    return (
        row[_ALTITUDE] >= limit.altitude_min
        and limit.airspeed_min <= row[_AIRSPEED] <= limit.airspeed_max
        and abs(row[_ALPHA]) <= limit.alpha_max
        and abs(row[_BETA]) <= limit.beta_max
        and abs(row[_ROLL]) <= limit.roll_max
    )
