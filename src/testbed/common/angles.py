"""Wrapping of angles to half a turn in either direction, as for a heading error."""

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
