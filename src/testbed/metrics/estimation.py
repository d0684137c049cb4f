"""Accuracy of the effectiveness estimates, and their speed compared with the first-order lag of equations (21) and (22)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from testbed.flight.breakage import LOST
from testbed.flight.columns import stays_from
from testbed.metrics.flight_view import Readings

BAND = 0.05
"""An estimate has settled when its error is within this fraction of the step of the true effectiveness."""
_STEP = 0.05  # a larger change of true effectiveness from one row to the next is a step
_TIME_CONSTANTS = 3.0  # after ln 20 = 3.0 time constants a first-order lag is within 5 % of its end


def estimate_error_rms(readings: Readings) -> float:
    """Root mean square error of the effectiveness estimate, for the worst actuator [1 is healthy]."""
    return _worst(math.sqrt(float(np.square(error).mean())) for error in _errors(readings))


def estimate_error_end(readings: Readings) -> float:
    """Error of the effectiveness estimate in the log's last row, for the worst actuator [1 is healthy]."""
    return _worst(abs(float(error[-1])) for error in _errors(readings))


def estimate_settling_s(readings: Readings) -> float:
    """Longest time from a step of true effectiveness until the estimate stays within 5 % of it [s]; NaN if never.

    5 % means 5 % of the step. The estimate has to stay there until the next step or the end of the flight. NaN also if
    there was no step. Steps to 0.1 or less do not count: a lost actuator has to be flagged, which `detection_delay_s`
    measures, and its estimate does not matter.
    """
    return _worst(time for _, time in _settlings(readings))


def estimate_settling_ratio(readings: Readings) -> float:
    """Longest settling time divided by 3/gamma, which the paper's first-order lag (22) predicts [-]; 1 is as predicted.

    As `estimate_settling_s`, with the gamma of each actuator.
    """
    gamma = readings.gamma
    return _worst(time * gamma.get(name, math.nan) / _TIME_CONSTANTS for name, time in _settlings(readings))


def _errors(readings: Readings) -> Iterator[np.ndarray]:
    for name in readings.actuators:
        yield readings.log[f"{name}_effectiveness_estimate"] - readings.log[f"{name}_effectiveness"]


def _settlings(readings: Readings) -> Iterator[tuple[str, float]]:
    """(actuator, settling time [s]) of each step of true effectiveness; NaN if the estimate never settles."""
    for name, error in zip(readings.actuators, _errors(readings), strict=True):
        truth = readings.log[f"{name}_effectiveness"]
        change = np.abs(np.diff(truth))
        steps = np.flatnonzero(change > _STEP) + 1
        for start, end in pairwise([*steps, len(truth)]):
            if truth[start] > LOST:
                inside = np.abs(error) <= BAND * change[start - 1]
                row = stays_from(inside, start, end)
                yield name, math.nan if row is None else (row - start) * readings.step_s


def _worst(values: Iterator[float]) -> float:
    """The largest; NaN if any of them is NaN, or if there are none."""
    each = list(values)
    return max(each) if each and not any(map(math.isnan, each)) else math.nan


TABLE = (estimate_error_rms, estimate_error_end, estimate_settling_s, estimate_settling_ratio)
