"""Angles round a full turn, the short way: an error of heading is at most half a turn."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


def wrap(angle: Any) -> Any:
    """The same angle from -pi to below pi [rad]; a number or an array. The control law compiles this function."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def wrap_deg(angle_deg: np.ndarray) -> np.ndarray:
    """The same angles from -180 to 180 [deg], by whole turns: an angle that is within them already keeps every bit."""
    return angle_deg - 360.0 * np.rint(angle_deg / 360.0)
