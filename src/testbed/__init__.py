"""A flight-control failure testbed: JSBSim is the truth, and a controller that never saw it flies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from testbed.flight import load as load
    from testbed.simulation import fly as fly

__all__ = ["fly", "load"]


def __getattr__(name: str) -> Any:
    """Import on first use: `import testbed` stays quick, and reading results needs no simulator."""
    if name == "fly":
        from testbed.simulation import fly

        return fly
    if name == "load":
        from testbed.flight import load

        return load
    raise AttributeError(f"module 'testbed' has no attribute {name!r}")
