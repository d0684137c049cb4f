"""What metrics are computed from: a flight's log, events and actuators, with functions that several metrics use."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from testbed.flight.breakage import failure_times_s, tracking_error
from testbed.flight.columns import row_at, row_spacing_s
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import Scenario


@dataclass(frozen=True, eq=False)
class Readings:
    """What metrics read of one flight.

    Attributes:
        log: columns by name, each [rows], in the log's units.
        events: as in `Flight.events`.
        actuators: as in `Flight.actuators`.
        gamma: adaptation rate of each actuator by name [1/s], equation (13); empty if the controller has none.
        survived: whether the aircraft was flown to the end.
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
        return row_spacing_s(self.time_s)

    def error(self, quantity: str) -> np.ndarray:
        """[rows] altitude, airspeed or heading minus its reference [m, m/s, deg]; headings the short way round."""
        return tracking_error(self.log, quantity)

    def of_kind(self, kind: str) -> list[Mapping[str, Any]]:
        """Events of one kind."""
        return [event for event in self.events if event["kind"] == kind]

    def failure_times_s(self) -> list[float]:
        """Times at which failures began, each once, in order [s]."""
        return failure_times_s(self.events)

    def first_failed_row(self) -> int:
        """First row from the start of the first failure on; the number of rows if there was no failure."""
        times = self.failure_times_s()
        return self.row_at(times[0]) if times else len(self.time_s)

    def row_at(self, time_s: float) -> int:
        """First row at or after a time [s]; the number of rows if the log ends before it."""
        return row_at(self.time_s, time_s)


def readings(flight: Flight) -> Readings:
    """Readings of a finished flight, from the rows that were logged.

    If fewer rows were logged than control steps were flown (`log_hz`), metrics from these readings are less exact than the
    flight's own, which were computed from every step.
    """
    return Readings(
        log=flight.signals,
        events=flight.events,
        actuators=flight.actuators,
        gamma={} if flight.flown_by else adaptation_rates(flight.scenario, flight.actuators),
        survived=flight.outcome is Outcome.completed,
    )


def adaptation_rates(scenario: Scenario, actuators: Mapping[str, Mapping[str, Any]]) -> dict[str, float]:
    """gamma of equation (13) for each actuator [1/s]; empty if the controller has none.

    The setting is one number for all actuators, or one for each kind of actuator.
    """
    gamma = scenario.controller.model_dump().get("gamma")
    if gamma is None:
        return {}
    if not isinstance(gamma, Mapping):
        return dict.fromkeys(actuators, float(gamma))
    return {name: float(gamma.get(facts["kind"], math.nan)) for name, facts in actuators.items()}
