"""Whether the monitor flagged the actuators that were broken, and only those; how long axes were given up; how true estimates were.

The speed of the effectiveness estimates is compared with the first-order lag of equations (21) and (22).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from testbed.flight.breakage import LOST, broken, lost
from testbed.flight.columns import stays_from, stretches
from testbed.metrics.flight_view import Readings

NOTICEABLE_S = 2.0
"""An actuator that is lost for longer than this [s] has to be flagged."""
_RELEASED = "_released"
BAND = 0.05
"""An estimate has settled when its error is within this fraction of the step of the true effectiveness."""
_STEP = 0.05  # a larger change of true effectiveness from one row to the next is a step
_TIME_CONSTANTS = 3.0  # after ln 20 = 3.0 time constants a first-order lag is within 5 % of its end


def detection_delay_s(readings: Readings) -> float:
    """Longest time from when an actuator broke until it was first flagged [s]; NaN without a detection."""
    first: dict[tuple[str, int], float] = {}
    for event in readings.of_kind("detection"):  # a second flag for the same breakage is not a new detection
        breakage = (event["actuator"], round((event["time_s"] - event["delay_s"]) * 1e3))
        first[breakage] = min(first.get(breakage, math.inf), event["delay_s"])
    return max(first.values(), default=math.nan)


def missed_detections(readings: Readings) -> float:
    """Losses of an actuator (effectiveness 0.1 or less for over 2 s) during which it was never flagged [count]."""
    return float(
        sum(
            not readings.log[f"{actuator}_failed"][start:end].any()
            for actuator in readings.actuators
            for start, end in stretches(lost(readings.log, actuator))
            if (end - start) * readings.step_s > NOTICEABLE_S
        )
    )


def false_alarms(readings: Readings) -> float:
    """Flags of actuators that were not broken when they were flagged [count]."""
    return float(len(readings.of_kind("false_alarm")))


def wrong_blames(readings: Readings) -> float:
    """False alarms while another actuator was broken: the failure was attributed to the wrong actuator [count]."""
    alarms = readings.of_kind("false_alarm")
    return float(sum(_another_broken(readings, alarm["actuator"], alarm["time_s"]) for alarm in alarms))


def isolation_fraction(readings: Readings) -> float:
    """Share of all flags that were raised for a broken actuator [0 to 1]; NaN without a flag."""
    right, wrong = len(readings.of_kind("detection")), len(readings.of_kind("false_alarm"))
    return right / (right + wrong) if right + wrong else math.nan


def goal_switches(readings: Readings) -> float:
    """Number of times that an axis was given up or taken back [count]; one or two for a lost actuator, more is chatter."""
    return float(sum(np.count_nonzero(np.diff(flag)) for flag in _released(readings)))


def released_time_s(readings: Readings) -> float:
    """Time with at least one axis given up [s]."""
    flags = _released(readings)
    return float(np.count_nonzero(sum(flags[1:], flags[0])) * readings.step_s) if flags else 0.0


def _released(readings: Readings) -> list[np.ndarray]:
    return [column for name, column in readings.log.items() if name.endswith(_RELEASED)]


def _another_broken(readings: Readings, blamed: str, time_s: float) -> bool:
    """Whether any actuator other than the one flagged is broken at this time [s]."""
    # With `log_hz` the last row may be before the event.
    row = min(readings.row_at(time_s), len(readings.time_s) - 1)
    injections = readings.of_kind("injection")
    others = (actuator for actuator in readings.actuators if actuator != blamed)
    return any(broken(readings.log, actuator, injections)[row] for actuator in others)


OF_FLAGS = (detection_delay_s, missed_detections, false_alarms, wrong_blames, isolation_fraction)
OF_RELEASES = (goal_switches, released_time_s)


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


OF_ESTIMATES = (estimate_error_rms, estimate_error_end, estimate_settling_s, estimate_settling_ratio)
