"""What metrics are computed from: a flight's log, events and actuators, and what many metrics ask of them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import Scenario

TRULY_LOST = 0.1
"""An actuator with this much effectiveness or less is lost, whatever a controller's threshold."""
_TRACKED = {"altitude": "m", "airspeed": "m_s", "heading": "deg"}


@dataclass(frozen=True, eq=False)
class Readings:
    """Log columns by name, events, and for each actuator what `Flight.actuators` says of it.

    `gamma` [1/s] is the adaptation rate of each actuator, empty if the controller has none; `survived`
    means flown to the end.
    """

    log: Mapping[str, np.ndarray]
    events: Sequence[Mapping[str, Any]]
    actuators: Mapping[str, Mapping[str, Any]]
    gamma: Mapping[str, float] = field(default_factory=dict)
    survived: bool = True

    @property
    def time_s(self) -> np.ndarray:
        return self.log["time_s"]

    @property
    def step_s(self) -> float:
        """Time between rows [s]."""
        return float(self.time_s[1] - self.time_s[0]) if len(self.time_s) > 1 else 0.0

    def error(self, quantity: str) -> np.ndarray:
        """Altitude, airspeed or heading minus its reference [m, m/s, deg]; headings the short way round."""
        unit = _TRACKED[quantity]
        error = self.log[f"{quantity}_{unit}"] - self.log[f"{quantity}_command_{unit}"]
        if quantity != "heading":
            return error
        error = np.where(error > 180.0, error - 360.0, error)
        return np.where(error < -180.0, error + 360.0, error)

    def of_kind(self, kind: str) -> list[Mapping[str, Any]]:
        """Events of one kind."""
        return [event for event in self.events if event["kind"] == kind]

    def failure_times_s(self) -> list[float]:
        """When failures began, in order."""
        return sorted(event["time_s"] for event in self.of_kind("injection") if event.get("active", True))

    def first_failed_row(self) -> int:
        """First row with anything broken; the number of rows if nothing ever was."""
        times = self.failure_times_s()
        return self.row_at(times[0]) if times else len(self.time_s)

    def row_at(self, time_s: float) -> int:
        """First row at or after a time."""
        return int(np.searchsorted(self.time_s, time_s - 1e-9))

    def losses(self, actuator: str) -> Iterator[tuple[int, int]]:
        """[first row, row after the last) of each stretch in which an actuator is truly lost."""
        yield from runs(self.log[f"{actuator}_effectiveness"] <= TRULY_LOST)


def readings(flight: Flight) -> Readings:
    """Of a finished flight, as logged: with fewer rows than steps (`log_hz`) the numbers are coarser."""
    return Readings(
        log=dict(zip(flight.columns, np.ascontiguousarray(flight.data.T), strict=True)),
        events=flight.events,
        actuators=flight.actuators,
        gamma={} if flight.flown_by else adaptation_rates(flight.scenario, flight.actuators),
        survived=flight.outcome is Outcome.completed,
    )


def adaptation_rates(scenario: Scenario, actuators: Mapping[str, Mapping[str, Any]]) -> dict[str, float]:
    """gamma of (13) for each actuator [1/s]: one for all, or one for each kind; empty if there is none."""
    gamma = scenario.controller.model_dump().get("gamma")
    if gamma is None:
        return {}
    if not isinstance(gamma, Mapping):
        return dict.fromkeys(actuators, float(gamma))
    return {name: float(gamma.get(facts["kind"], math.nan)) for name, facts in actuators.items()}


def runs(flag: np.ndarray) -> list[tuple[int, int]]:
    """[start, end) of each stretch in which a flag is up."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], flag, [False])).astype(np.int8)))
    return [(int(start), int(end)) for start, end in edges.reshape(-1, 2)]


def settled_after(outside: np.ndarray, start: int) -> int | None:
    """First row from `start` on from which a flag stays down to the end; None if it is up at the end."""
    rows = np.flatnonzero(outside[start:])
    if not len(rows):
        return start
    settled = start + int(rows[-1]) + 1
    return settled if settled < len(outside) else None
