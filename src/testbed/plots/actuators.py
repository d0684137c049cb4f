"""Figure 5: what the control law asks of each actuator, what it is told, and what it does."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.flight import Flight
from testbed.plots.page import COMMAND, LIMIT, REFERENCE, WIDE, frame, page

_NEAR = 0.15  # of the travel: a stop is shown once a signal comes this near to it


def actuators(flight: Flight) -> Figure:
    """Reference r, command u and position of each actuator, in its own unit, with the stops that matter."""
    sheet = page(flight, "actuators", [1.7] * len(flight.actuators))
    for panel, (name, facts) in zip(sheet.panels, flight.actuators.items(), strict=True):
        signals = {of: sheet.column(f"{name}_{of}") for of in ("reference", "command", "position")}
        sheet.line(panel, signals["position"], "position (as if fully effective)", WIDE)
        sheet.line(panel, signals["command"], "command u", COMMAND)
        sheet.line(panel, signals["reference"], "reference r", REFERENCE)
        sheet.shade(panel, sheet.column(f"{name}_failed"), "flagged failed")
        frame(panel, 0.5 * float(facts.get("scale", 1.0)), *signals.values())
        _stops(panel, facts.get("limits"))
        panel.set_ylabel(f"{name.replace('_', chr(10))}\n[{facts.get('unit', '-')}]", fontsize=9.5)
    return sheet.finish()


def _stops(panel: Axes, limits: tuple[float, float] | None) -> None:
    """Draw a stop where the signals come near it."""
    if limits is None:
        return
    bottom, top = panel.get_ylim()
    near = _NEAR * (limits[1] - limits[0])
    for stop in limits:
        if bottom - near < stop < top + near:
            panel.axhline(stop, label="stop", **LIMIT)
            bottom, top = min(bottom, stop - 0.3 * near), max(top, stop + 0.3 * near)
    panel.set_ylim(bottom, top)
