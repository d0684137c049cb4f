"""Whether the monitor flagged the actuators that were broken, and only those; and how long axes were given up."""

from __future__ import annotations

import math

import numpy as np

from testbed.flight.breakage import broken, lost
from testbed.flight.columns import stretches
from testbed.metrics.flight_view import Readings

NOTICEABLE_S = 2.0
"""An actuator that is lost for longer than this [s] has to be flagged."""
_RELEASED = "_released"


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
TABLE = (*OF_FLAGS, *OF_RELEASES)
