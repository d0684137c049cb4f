"""The signals that are exchanged in each control step (names, order, frames and signs), and the control step of a time.

Frames: body axes, x forward, y right, z down, origin at the centre of gravity; north-east-down for navigation.
Angles are in radians and right-handed: roll right, nose up and nose right are positive; heading is 0 to 2 pi from
north; sideslip beta is positive with the wind from the right; a control surface is positive trailing edge down.
Airspeed, alpha and beta are relative to the air (gusts included); p, q, r and attitude to the ground. `u_dot` is the rate of change
of the body-x velocity: of the truth over the ground; measured, through air that moves steadily, as an accelerometer and air data
give it.

A vector of signals is one row of float64, which the loop fills by index. Compiled functions read the same memory by name, as a
numpy record, without a copy.
"""

from __future__ import annotations

import math
from enum import IntEnum
from functools import cache
from typing import Self

import numpy as np

_ROUNDING = 1e-9  # of a step: 0.3 s at 200 Hz is 60.00000000000001 steps, and means step 60
_ROOM, _ROOM_STEPS = 32, 800_000
"""How many times as long a flight can become before its rows are copied again, up to an hour at 200 Hz: memory is limited."""

STATE = (
    "north", "east", "altitude", "airspeed", "climb_rate",
    "roll", "pitch", "heading", "alpha", "beta",
    "p", "q", "r", "p_dot", "q_dot", "r_dot", "u_dot",
)  # fmt: skip
"""The state that is measured each step [m, m/s, rad, rad/s, rad/s2, m/s2]."""

RATES = ("p_dot", "q_dot", "r_dot", "u_dot")
"""State rates that can be controlled directly, x_c of equation (3), in the order of the state vector."""

SETPOINT = ("altitude", "airspeed", "heading", "altitude_rate", "airspeed_rate", "heading_rate")
"""Rate-limited references and their rates [m, m/s, rad, m/s, m/s2, rad/s]."""

SENSED = (
    "time", "p", "q", "r", "force_x", "force_y", "force_z",
    "velocity_north", "velocity_east", "velocity_down", "north", "east", "altitude",
    "roll", "pitch", "heading", "airspeed", "alpha", "beta", "pressure", "temperature",
)  # fmt: skip
"""What an autopilot outside of the program is given each step, as the sensors read it: time [s], gyro [rad/s], specific force along
the body axes [m/s2], velocity over the ground [m/s], position from the start and altitude above sea level [m], attitude [rad],
airspeed [m/s], alpha and beta [rad], static pressure [Pa] and temperature of the air [K]."""

GROUND_M = 0.5
"""Altitude of the centre of gravity below which the aircraft counts as on the ground [m]; the terrain is at sea level."""

TELEMETRY = ("reference", "command", "effectiveness_estimate", "failed")
"""What a controller logs of each actuator: reference and command divided by the actuator's `scale`, the estimate of its
effectiveness (1 is healthy), and a flag that is 1 while the controller takes it for failed."""

BELIEFS = ("belief", "believed_position")
"""What a controller may log besides of each actuator: what it takes it for (a code of `Belief`), and the position at which it is
thought to be held, divided by `scale`."""

GUARDED = ("alpha", "beta", "airspeed", "p", "q", "r")
"""Readings that a controller may take for stuck. It may log a flag of each, which is 1 while it does."""


class Belief(IntEnum):
    """What a controller takes an actuator for. The log has the number; the name is the word for it. `meaning` is what the
    controller believes then, and what it does with the actuator."""

    works = 0, "it follows its command, with the effectiveness of its estimate"
    doubted = 1, "its force has changed, and what has failed is not decided yet; it is used on"
    lost = 2, "it has no force; it is given up"
    held = 3, "its force does not follow its command but stays; it is given up, and its force is balanced"
    reversed = 4, "its force goes against its command; it is used with the opposite sign"
    offset = 5, "it follows its command with an offset, which commands make up for"
    swings = 6, "it follows its command and swings by itself; it is used"
    late = 7, "it follows its command later than it is designed to; it is used"

    meaning: str

    def __new__(cls, code: int, meaning: str) -> Self:
        belief = int.__new__(cls, code)
        belief._value_, belief.meaning = code, meaning
        return belief


def telemetry_width(actuators: int) -> int:
    """Length of a row of telemetry: `TELEMETRY`, each for all actuators; desired rates and released flags of `RATES`; `BELIEFS`,
    each for all actuators; a flag for each of `GUARDED`."""
    return (len(TELEMETRY) + len(BELIEFS)) * actuators + 2 * len(RATES) + len(GUARDED)


def telemetry_rows(steps: int, actuators: int) -> np.ndarray:
    """[steps, `telemetry_width`] rows for a controller to fill; NaN is what it does not say."""
    return np.full((steps, telemetry_width(actuators)), math.nan)


@cache
def record_dtype(names: tuple[str, ...]) -> np.dtype:
    """Dtype of a record of float64 fields with these names, to view one row of a float64 array.

    Cached: numba recognises a dtype by its identity, and an equal but new one costs 4 us in each call.
    """
    return np.dtype((np.record, [(name, np.float64) for name in names]))


def as_records(rows: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
    """View contiguous float64 rows [N, len(names)] as N records: same memory, fields by name."""
    return rows.view(record_dtype(names)).reshape(len(rows))


def first_step_at(time_s: float, rate_hz: float) -> int:
    """The first control step at or after a time [s]; step k is at k / rate, for every part of a flight."""
    return math.ceil(time_s * rate_hz - _ROUNDING)


def begins_within(at_s: float | None, rate_hz: float, steps: float) -> bool:
    """Whether something that begins at a time [s], or at no stated one, may begin within the first `steps` control steps."""
    return at_s is None or first_step_at(at_s, rate_hz) < steps


def room_for(steps: int) -> int:
    """Rows to have room for where a flight has just become this long [control steps] and goes on."""
    return max(steps, min(_ROOM * steps, _ROOM_STEPS))


def longer(rows: np.ndarray, steps: int, rest: float = 0.0) -> np.ndarray:
    """Rows of signals [N, ...] for more control steps [steps, ...]: those so far, then `rest`.

    They may be the same memory. There is room in it for some more times, so that a flight that goes on is seldom copied; the
    system gives memory for what is written only.
    """
    room = rows.base  # of which these rows are the beginning, if they come from here
    if room is None or room.shape[1:] != rows.shape[1:] or len(room) < steps:
        room = np.zeros((room_for(steps), *rows.shape[1:]))
        room[: len(rows)] = rows
    if rest:
        room[len(rows) : steps] = rest
    return room[:steps]
