"""What the controller did in a flight, read from its log: detections, false alarms, released axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from testbed.common.signals import RATES
from testbed.flight.breakage import broken_since
from testbed.flight.columns import stretches


def controller_events(
    log: Mapping[str, np.ndarray], actuators: Sequence[str], injections: Sequence[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """Detections with their delay, false alarms and releases, in order of time.

    When an actuator is flagged, this is a detection if the actuator is broken in that row (see `breakage`), and a false
    alarm if it is not. A detection's `delay_s` is the time since the actuator broke.

    Args:
        log: columns by name, each [rows].
        injections: the events of kind `injection`, in order of time.
    """
    events = [event for actuator in actuators for event in _flags(log, actuator, injections)]
    events += [
        {"time_s": float(log["time_s"][row]), "kind": "release", "axis": axis}
        for axis in RATES
        for row in _rises(log[f"{axis}_released"])
    ]
    return sorted(events, key=lambda event: (event["time_s"], event["kind"]))


def _flags(
    log: Mapping[str, np.ndarray], actuator: str, injections: Sequence[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """A detection or a false alarm for each time that this actuator was flagged."""
    events: list[dict[str, Any]] = []
    rows = _rises(log[f"{actuator}_failed"])
    since_s = broken_since(log, actuator, injections) if rows else np.zeros(0)
    for row in rows:
        time_s = float(log["time_s"][row])
        if np.isnan(since_s[row]):
            events.append({"time_s": time_s, "kind": "false_alarm", "actuator": actuator})
        else:
            delay_s = time_s - float(since_s[row])
            events.append({"time_s": time_s, "kind": "detection", "actuator": actuator, "delay_s": delay_s})
    return events


def _rises(flag: np.ndarray) -> list[int]:
    """Rows in which a flag changes from 0 to 1. One that is 1 in the first row comes from a setting, and is no event."""
    return [first for first, _ in stretches(flag > 0.0) if first > 0]
