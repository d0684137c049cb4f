"""A flight-control failure testbed: JSBSim is the truth, and a controller that never saw it flies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from testbed.loading import load as load
    from testbed.monte_carlo import sweep as sweep
    from testbed.simulation import fly as fly

__all__ = ["fly", "load", "sweep"]


def __getattr__(name: str) -> Any:
    """Import on first use: `import testbed` stays quick, and reading results needs no simulator."""
    if name == "fly":
        from testbed.simulation import fly

        return fly
    if name == "load":
        from testbed.loading import load

        return load
    if name == "sweep":
        from testbed.monte_carlo import sweep

        return sweep
    raise AttributeError(f"module 'testbed' has no attribute {name!r}")
