"""Short flights of the v-tail with failures, and what the tests of failures and injections ask of them."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from testbed.aircraft.description import load_aircraft
from testbed.failures import TABLE
from testbed.flight.flight import Flight
from testbed.scenario.load import Scenario
from testbed.simulation import Assembly, assemble
from testbed.simulation.assembly import Lockstep
from testbed.simulation.conclude import conclude

AIRCRAFT = load_aircraft("vtail")
START_S, END_S = 0.5, 1.2
RATES = [(200, 200), (100, 400)]
"""Control and physics rate [Hz]; the second makes four physics steps in a control step."""


def cases() -> list[tuple[str, str]]:
    """(type, actuator) of each failure that an actuator can have."""
    return [
        (name, actuator)
        for name, kind in TABLE.items()
        for actuator, what in AIRCRAFT.actuators.items()
        if name != "property" and what.kind in kind.kinds
    ]


def example(name: str, actuator: str) -> dict[str, Any]:
    """The failure that the type shows itself with, from START_S to END_S."""
    kind = TABLE[name]
    fields = kind.examples[AIRCRAFT.actuators[actuator].kind]
    end = {"until_s": END_S} if kind.undone else {}
    return {"type": name, "actuator": actuator, "at_s": START_S, **end, **fields}


def without(failure: dict[str, Any], key: str) -> dict[str, Any]:
    """The same failure but for one field."""
    return {k: v for k, v in failure.items() if k != key}


def scenario(*failures: dict[str, Any], rates: tuple[int, int] = RATES[0], **changes: Any) -> Scenario:
    """Two seconds in which every actuator has something to do."""
    return Scenario.model_validate(
        {
            "name": "test",
            "aircraft": "vtail",
            "duration_s": 2.0,
            "rate_hz": rates[0],
            "physics_hz": rates[1],
            "initial": {"altitude_m": 300, "airspeed_m_s": 18, "heading_deg": 90},
            "commands": [{"at_s": 0.2, "heading_deg": 95, "altitude_m": 301}],
            "failures": list(failures),
            **changes,
        }
    )


class Flown(NamedTuple):
    """A flight, and the parts that flew it."""

    flight: Flight
    parts: Assembly

    def column(self, name: str) -> np.ndarray:
        return self.flight.data[:, self.flight.columns.index(name)]

    def event(self, active: bool = True, failure: int = 0) -> dict[str, Any]:
        """The receipt of this failure's start, or of its end."""
        (event,) = (
            e
            for e in self.flight.events
            if e["kind"] == "injection" and e["active"] == active and e["failure"] == failure
        )
        return dict(event)


def fly(*failures: dict[str, Any], **changes: Any) -> Flown:
    """Fly `scenario(*failures, **changes)`."""
    flown = Lockstep(assemble(scenario(*failures, **changes)))
    flown.advance(flown.parts.scenario.steps)
    assert flown.outcome is not None
    return Flown(conclude(flown.parts, flown.parts.scenario, flown.outcome, flown.recorded), flown.parts)


@cache
def healthy(rates: tuple[int, int] = RATES[0]) -> Flown:
    """The same flight with nothing broken; flown once for all tests of a process, which only read it."""
    return fly(rates=rates)


WINDOW = slice(round(START_S * RATES[0][0]), round(END_S * RATES[0][0]))
"""Rows of the log in which an example failure is active."""


def on_left_ruddervator(name: str, **fields: Any) -> tuple[Flown, np.ndarray]:
    """A type's example on the left ruddervator, with other fields: the flight, and the position [deg]."""
    flown = fly({**example(name, "left_ruddervator"), **fields})
    return flown, flown.column("left_ruddervator_position")
