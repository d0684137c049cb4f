"""What happened in a flight, read from its log: detections, false alarms, released axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from testbed.common.signals import RATES

_TRULY_FAILED = (
    0.1  # an actuator with this much effectiveness or less is lost, whatever a controller's threshold
)


def controller_events(
    log: Mapping[str, np.ndarray], actuators: Sequence[str], injections: Sequence[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """Detections (with their delay), false alarms and releases, in order of time.

    A flag is a detection while the actuator it blames is broken: lost by its effectiveness, or in a failure of any
    other kind that has started. Its delay is counted from when that began.
    """
    time = log["time_s"]
    events = []
    for actuator in actuators:
        for row in _rises(log[f"{actuator}_failed"]):
            since = _broken_since(log, actuator, row, injections)
            event = {"time_s": float(time[row]), "actuator": actuator}
            if since is None:
                events.append({**event, "kind": "false_alarm"})
            else:
                events.append({**event, "kind": "detection", "delay_s": float(time[row]) - since})
    for axis in RATES:
        events += [
            {"time_s": float(time[row]), "kind": "release", "axis": axis}
            for row in _rises(log[f"{axis}_released"])
        ]
    return sorted(events, key=lambda event: (event["time_s"], event["kind"]))


def _rises(flag: np.ndarray) -> list[int]:
    """Rows at which a flag goes up; one that is up from the first row on is a setting, not an event."""
    return [int(row) for row in np.flatnonzero(np.diff(flag) > 0.5) + 1]


def _broken_since(
    log: Mapping[str, np.ndarray], actuator: str, row: int, injections: Sequence[Mapping[str, Any]]
) -> float | None:
    """When the actuator that is broken at this row became so, or None if it is not."""
    lost = log[f"{actuator}_effectiveness"][: row + 1] <= _TRULY_FAILED
    if lost[row]:
        return float(log["time_s"][row + 1 - np.argmin(lost[::-1]) if not lost.all() else 0])
    since = None
    for event in injections:
        if (
            event["actuator"] == actuator
            and event["type"] != "effectiveness"
            and event["time_s"] <= log["time_s"][row]
        ):
            since = event["time_s"] if event["active"] else None
    return since
