"""The unit of each column of a flight's log."""

from __future__ import annotations

from testbed.common.units import unit
from testbed.flight.flight import Flight

_IN_THE_ACTUATORS_UNIT = ("reference", "command", "position", "believed_position")


def units_of(flight: Flight) -> dict[str, str]:
    """{column: unit}; "1" for what has none, such as an effectiveness or a flag."""
    known = {
        f"{name}_{of}": str(facts.get("unit", ""))
        for name, facts in flight.actuators.items()
        for of in _IN_THE_ACTUATORS_UNIT
    }
    return {column: known.get(column) or unit(column) or "1" for column in flight.columns}
