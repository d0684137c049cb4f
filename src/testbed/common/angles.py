"""Wrapping of angles to half a turn in either direction, as for a heading error; and rotations between the frames of `signals`:
north-east-down, body and wind axes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


def wrap(angle: Any) -> Any:
    """The same angle in [-pi, pi) [rad]; a number or an array. The control law also uses this function, compiled."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def wrap_deg(angle_deg: np.ndarray) -> np.ndarray:
    """The same angles from -180 to 180 [deg]. Whole turns are subtracted, so an angle that is in this range keeps every bit."""
    return angle_deg - 360.0 * np.rint(angle_deg / 360.0)


def unwrapped_deg(angles: np.ndarray) -> np.ndarray:
    """Angles [..., points] without jumps by whole turns in time [deg]; NaN, after a flight's end, stays."""
    known = np.where(np.isfinite(angles), angles, 0.0)
    return np.where(np.isfinite(angles), np.unwrap(known, period=360.0, axis=-1), np.nan)


def body_from_ned(roll: float, pitch: float, heading: float) -> np.ndarray:
    """[3, 3] matrix from north-east-down components to body components: rotations by heading, then pitch, then roll [rad]."""
    cr, sr, cp, sp = math.cos(roll), math.sin(roll), math.cos(pitch), math.sin(pitch)
    ch, sh = math.cos(heading), math.sin(heading)
    return np.array(
        [
            [cp * ch, cp * sh, -sp],
            [sr * sp * ch - cr * sh, sr * sp * sh + cr * ch, sr * cp],
            [cr * sp * ch + sr * sh, cr * sp * sh - sr * ch, cr * cp],
        ]
    )


def body_from_wind(alpha: float, beta: float) -> np.ndarray:
    """[3, 3] matrix from components in wind axes (x along the velocity through the air) to body components; angles in rad."""
    ca, sa, cb, sb = math.cos(alpha), math.sin(alpha), math.cos(beta), math.sin(beta)
    return np.array([[ca * cb, -ca * sb, -sa], [sb, cb, 0.0], [sa * cb, -sa * sb, ca]])


def level_pitch(alpha: float, beta: float, roll: float, path_angle: float = 0.0) -> float:
    """Pitch angle [rad] that gives the flight path angle at this alpha, beta and roll
    (Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., eq. 3.6-3)."""
    a = math.cos(alpha) * math.cos(beta)
    b = math.sin(roll) * math.sin(beta) + math.cos(roll) * math.sin(alpha) * math.cos(beta)
    s = math.sin(path_angle)
    return math.atan((a * b + s * math.sqrt(max(a * a - s * s + b * b, 0.0))) / (a * a - s * s))
