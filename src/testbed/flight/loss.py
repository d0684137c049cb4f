"""Why a flight ended early: which limit was passed, and which actuators were asked for all they have just before."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from testbed.aircraft.description import Envelope
from testbed.flight.columns import row_at
from testbed.flight.flight import Outcome

BEFORE_S = 1.0
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


def loss_event(
    log: Mapping[str, np.ndarray],
    outcome: Outcome,
    envelope: Envelope,
    actuators: Mapping[str, Mapping[str, Any]],
) -> dict[str, Any]:
    """The event of a flight that ended early.

    Args:
        log: columns by name, each [rows]; the flight ended in the last row.
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


def _passed(log: Mapping[str, np.ndarray], envelope: Envelope) -> Iterator[dict[str, Any]]:
    for name, (_, column, side, unit) in LIMITS.items():
        allowed, value = getattr(envelope, name), float(log[column][-1])
        if allowed is not None and ((side * value if side else abs(value)) > (side or 1) * allowed):
            yield {"limit": name, "value": value, "allowed": allowed, "unit": unit}


def _at_stops(
    log: Mapping[str, np.ndarray], actuators: Mapping[str, Mapping[str, Any]]
) -> Iterator[dict[str, Any]]:
    time = log["time_s"]
    last = slice(row_at(time, float(time[-1]) - BEFORE_S), len(time))
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
