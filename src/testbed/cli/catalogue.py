"""What there is: each table that a scenario can name something of, with the first line of each docstring."""

from __future__ import annotations

from collections.abc import Mapping


def _aircraft() -> list[tuple[str, str]]:
    from testbed.aircraft.description import load_aircraft
    from testbed.aircraft.shipped import aircraft_names

    return [(name, load_aircraft(name).description) for name in aircraft_names()]


def _controllers() -> list[tuple[str, str]]:
    from testbed.controllers.config import TABLE

    return _described(TABLE)


def _failures() -> list[tuple[str, str]]:
    from testbed.failures import TABLE

    return _described(TABLE)


def _metrics() -> list[tuple[str, str]]:
    from testbed.metrics import TABLE

    return _described(TABLE)


def _described(table: Mapping[str, object]) -> list[tuple[str, str]]:
    """Names, each with the first line of its docstring."""
    return [(name, (entry.__doc__ or "").strip().partition("\n")[0]) for name, entry in table.items()]


LISTS = {"aircraft": _aircraft, "controllers": _controllers, "failures": _failures, "metrics": _metrics}
