"""How true the effectiveness estimates were, and how fast against the first-order lag of (21) and (22)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from testbed.flight.breakage import LOST
from testbed.metrics.flight_view import Readings, settled_after

BAND = 0.05
"""An estimate has settled within this fraction of the step that the truth made."""
_STEP = 0.05  # a change of effectiveness from one row to the next is a step if it is larger
_TIME_CONSTANTS = 3.0  # a first-order lag is within 5 % after ln 20 = 3.0 of them


def estimate_error_rms(readings: Readings) -> float:
    """Root mean square error of the effectiveness estimate, of the worst actuator [1 is healthy]."""
    return _worst(math.sqrt(float(np.square(error).mean())) for error in _errors(readings))


def estimate_error_end(readings: Readings) -> float:
    """Error of the effectiveness estimate in the log's last row, of the worst actuator [1 is healthy]."""
    return _worst(abs(float(error[-1])) for error in _errors(readings))


def estimate_settling_s(readings: Readings) -> float:
    """Longest from a step of effectiveness until the estimate stays within 5 % of the step [s]; NaN if never.

    Until the next step or the end of the flight; NaN also without a step. Steps to 0.1 or less are not
    counted: of an actuator that is lost the monitor is asked, not the estimate (`detection_delay_s`).
    """
    return _worst(time for _, time in _settlings(readings))


def estimate_settling_ratio(readings: Readings) -> float:
    """`estimate_settling_s` over the 3/gamma of the paper's first-order lag (22) [-]; 1 is as predicted."""
    gamma = readings.gamma
    return _worst(time * gamma.get(name, math.nan) / _TIME_CONSTANTS for name, time in _settlings(readings))


def _errors(readings: Readings) -> Iterator[np.ndarray]:
    for name in readings.actuators:
        yield readings.log[f"{name}_effectiveness_estimate"] - readings.log[f"{name}_effectiveness"]


def _settlings(readings: Readings) -> Iterator[tuple[str, float]]:
    """(actuator, settling time [s]) of each step of the truth; NaN if it never settles."""
    for name, error in zip(readings.actuators, _errors(readings), strict=True):
        truth = readings.log[f"{name}_effectiveness"]
        change = np.abs(np.diff(truth))
        steps = np.flatnonzero(change > _STEP) + 1
        for start, end in pairwise([*steps, len(truth)]):
            if truth[start] > LOST:
                outside = ~(np.abs(error[start:end]) <= BAND * change[start - 1])
                row = settled_after(outside, 0)
                yield name, math.nan if row is None else row * readings.step_s


def _worst(values: Iterator[float]) -> float:
    """The largest; NaN if any is, or if there is none."""
    found = list(values)
    return max(found) if found and not any(map(math.isnan, found)) else math.nan


TABLE = (estimate_error_rms, estimate_error_end, estimate_settling_s, estimate_settling_ratio)
