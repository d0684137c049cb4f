"""What happened in a flight, read from its log: detections, false alarms, released axes; and, of one that ended early, why: which
limit was passed, and which actuators were asked for all they have just before."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from testbed.aircraft.description import Envelope
from testbed.common.signals import RATES
from testbed.flight.breakage import broken_since
from testbed.flight.columns import Events, Log, row_at, stretches
from testbed.flight.flight import Outcome

_BEFORE_S = 1.0
"""How long before the end of the flight commands are looked at [s]."""
_AT_STOP = 1e-3  # a command counts as at its stop within this fraction of the travel
LIMITS = {
    "alpha_max_deg": ("angle of attack", "alpha_deg", 0, "deg"),
    "beta_max_deg": ("sideslip", "beta_deg", 0, "deg"),
    "roll_max_deg": ("bank", "roll_deg", 0, "deg"),
    "airspeed_min_m_s": ("airspeed", "airspeed_m_s", -1, "m/s"),
    "airspeed_max_m_s": ("airspeed", "airspeed_m_s", 1, "m/s"),
    "altitude_min_m": ("altitude", "altitude_m", -1, "m"),
}
"""Limit of the envelope: (what it limits, column of the log, sign of the side on which it is passed, unit)."""


def controller_events(log: Log, actuators: Sequence[str], injections: Events) -> list[dict[str, Any]]:
    """Detections with their delay, false alarms and releases, in order of time.

    When an actuator is flagged, this is a detection if the actuator is broken in that row (see `breakage`), and a false
    alarm if it is not. A detection's `delay_s` is the time since the actuator broke. `injections` are the events of that kind.
    """
    events = [event for actuator in actuators for event in _flags(log, actuator, injections)]
    events += [
        {"time_s": float(log["time_s"][row]), "kind": "release", "axis": axis}
        for axis in RATES
        for row in _rises(log[f"{axis}_released"])
    ]
    return sorted(events, key=lambda event: (event["time_s"], event["kind"]))


def _flags(log: Log, actuator: str, injections: Events) -> Iterator[dict[str, Any]]:
    """A detection or a false alarm for each time that this actuator was flagged."""
    rows = _rises(log[f"{actuator}_failed"])
    since_s = broken_since(log, actuator, injections) if rows else np.zeros(0)
    for row in rows:
        flag: dict[str, Any] = {
            "time_s": float(log["time_s"][row]),
            "kind": "false_alarm",
            "actuator": actuator,
        }
        if not np.isnan(since_s[row]):
            flag |= {"kind": "detection", "delay_s": flag["time_s"] - float(since_s[row])}
        yield flag


def _rises(flag: np.ndarray) -> list[int]:
    """Rows in which a flag changes from 0 to 1. One that is 1 in the first row comes from a setting, and is no event."""
    return [first for first, _ in stretches(flag > 0.0) if first > 0]


def loss_event(
    log: Log, outcome: Outcome, envelope: Envelope, actuators: Mapping[str, Mapping[str, Any]]
) -> dict[str, Any]:
    """The event of a flight that ended early.

    Args:
        log: the flight ended in the last row.
        actuators: {limits, ...} of each by name.

    Returns:
        {time_s, kind: "lost", outcome, limits, at_stop}: `limits` has {limit, value, allowed, unit} of each limit of the envelope
        that was passed, and `at_stop` {actuator, stop, share} of each actuator whose command was at a stop for more than half
        of the last second: `stop` is "low" or "high", and `share` how much of that second.
    """
    return {
        "time_s": float(log["time_s"][-1]),
        "kind": "lost",
        "outcome": str(outcome),
        "limits": list(_passed(log, envelope)) if outcome is Outcome.envelope_exceeded else [],
        "at_stop": list(_at_stops(log, actuators)),
    }


def _passed(log: Log, envelope: Envelope) -> Iterator[dict[str, Any]]:
    for name, (_, column, side, unit) in LIMITS.items():
        allowed, value = getattr(envelope, name), float(log[column][-1])
        if allowed is not None and ((side * value if side else abs(value)) > (side or 1) * allowed):
            yield {"limit": name, "value": value, "allowed": allowed, "unit": unit}


def _at_stops(log: Log, actuators: Mapping[str, Mapping[str, Any]]) -> Iterator[dict[str, Any]]:
    time = log["time_s"]
    last = slice(row_at(time, float(time[-1]) - _BEFORE_S), len(time))
    for name, facts in actuators.items():
        if "limits" not in facts:
            continue
        command = log[f"{name}_command"][last]
        for stop, at in zip(("low", "high"), at_stops(command, *facts["limits"]), strict=True):
            share = float(np.mean(at))
            if share > 0.5:
                yield {"actuator": name, "stop": stop, "share": share}


def at_stops(command: np.ndarray, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """[rows] whether a command is at its low stop, and at its high one."""
    margin = _AT_STOP * (high - low)
    return command <= low + margin, command >= high - margin
