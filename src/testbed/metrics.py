"""Numbers that say how a controller coped, each one function of a finished flight's readings; truth is the judge.

Adding a metric is one function here and one line in TABLE; its name ends in its unit, its docstring is its definition.
A metric that has no value in a flight (the delay of a detection that never came) is NaN.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Readings:
    """What metrics are computed from: log columns by name, the events of the flight, the actuators' names."""

    log: Mapping[str, np.ndarray]
    events: Sequence[Mapping[str, Any]]
    actuators: Sequence[str]

    def error(self, signal: str, command: str) -> np.ndarray:
        """Signal minus its reference; headings the short way round."""
        error = self.log[signal] - self.log[command]
        return np.mod(error + 180.0, 360.0) - 180.0 if signal.startswith("heading") else error

    def of_kind(self, kind: str) -> list[Mapping[str, Any]]:
        """Events of one kind."""
        return [event for event in self.events if event["kind"] == kind]


def altitude_error_max_m(readings: Readings) -> float:
    """Largest distance of altitude from its reference, over the whole flight [m]."""
    return float(np.max(np.abs(readings.error("altitude_m", "altitude_command_m"))))


def heading_error_max_deg(readings: Readings) -> float:
    """Largest distance of heading from its reference, over the whole flight [deg]."""
    return float(np.max(np.abs(readings.error("heading_deg", "heading_command_deg"))))


def airspeed_error_max_m_s(readings: Readings) -> float:
    """Largest distance of airspeed from its reference, over the whole flight [m/s]."""
    return float(np.max(np.abs(readings.error("airspeed_m_s", "airspeed_command_m_s"))))


def detection_delay_s(readings: Readings) -> float:
    """Longest time from an actuator's loss to its being flagged, over all detections [s]; NaN without any."""
    delays = [event["delay_s"] for event in readings.of_kind("detection")]
    return max(delays, default=math.nan)


def false_alarms(readings: Readings) -> float:
    """How often an actuator was flagged that was not broken."""
    return float(len(readings.of_kind("false_alarm")))


Metric = Callable[[Readings], float]

TABLE: dict[str, Metric] = {
    function.__name__: function
    for function in (
        altitude_error_max_m,
        heading_error_max_deg,
        airspeed_error_max_m_s,
        detection_delay_s,
        false_alarms,
    )
}


def measure(readings: Readings) -> dict[str, float]:
    """Every metric of the table."""
    return {name: metric(readings) for name, metric in TABLE.items()}
