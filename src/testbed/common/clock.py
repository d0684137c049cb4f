"""One clock for every part of a flight: control step k is at t = k / rate."""

from __future__ import annotations

import math

_ROUNDING = 1e-9  # of a step: 0.3 s at 200 Hz is 60.00000000000001 steps, and means step 60


def first_step_at(time_s: float, rate_hz: float) -> int:
    """The first control step at or after a time [s]."""
    return math.ceil(time_s * rate_hz - _ROUNDING)
