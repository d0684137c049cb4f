"""Fly a scenario: `check` it, put its parts together and step them (`assembly`, `session`), and `conclude`."""

from __future__ import annotations

TYPE_CHECKING = False  # as `typing` has it
if TYPE_CHECKING:
    from typing import Any

    from testbed.simulation.assembly import Assembly as Assembly
    from testbed.simulation.assembly import assemble as assemble
    from testbed.simulation.assembly import start_and_setup as start_and_setup
    from testbed.simulation.session import Session as Session
    from testbed.simulation.session import fly as fly

_MODULES = {
    "Assembly": "assembly",
    "Session": "session",
    "assemble": "assembly",
    "fly": "session",
    "start_and_setup": "assembly",
}


def __getattr__(name: str) -> Any:
    """Import on first use: `check` alone needs no simulator."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
