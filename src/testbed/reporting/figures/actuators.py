"""The paper's figure 5: reference, command and position of each actuator."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.flight.flight import Flight
from testbed.reporting.figures.page import COMMAND, REFERENCE, WIDE, Page, page

_NEAR = 0.15  # fraction of the travel: a stop is drawn if a signal comes this close to it


def actuators(flight: Flight) -> Figure:
    """Reference r, command u and position of each actuator, in its own unit, with the stops that signals come close to."""
    sheet = page(flight, "actuators", [1.7] * len(flight.actuators))
    for panel, (name, facts) in zip(sheet.panels, flight.actuators.items(), strict=True):
        signals = {of: sheet.column(f"{name}_{of}") for of in ("reference", "command", "position")}
        sheet.line(panel, signals["position"], "position", WIDE)
        sheet.line(panel, signals["command"], "command u", COMMAND)
        sheet.line(panel, signals["reference"], "reference r", REFERENCE)
        sheet.shade(panel, sheet.column(f"{name}_failed"), "flagged failed")
        sheet.frame(
            panel, 0.5 * float(facts.get("scale", 1.0)), *_near_travel(signals.values(), facts.get("limits"))
        )
        _stops(sheet, panel, facts.get("limits"))
        panel.set_ylabel(f"{name.replace('_', chr(10))}\n[{facts.get('unit', '-')}]", fontsize=9.5)
    return sheet.finish()


def _near_travel(signals: Iterable[np.ndarray], limits: tuple[float, float] | None) -> Iterator[np.ndarray]:
    """Signals cut off a little beyond the stops, to set the y axis: a reference may be far beyond them."""
    for values in signals:
        if limits is not None:
            near = _NEAR * (limits[1] - limits[0])
            values = np.clip(values, limits[0] - near, limits[1] + near)
        yield values


def _stops(sheet: Page, panel: Axes, limits: tuple[float, float] | None) -> None:
    """Draw a stop where the signals come near it."""
    if limits is None:
        return
    views = sheet.views(panel)
    heights = [view.get_ylim() for view in views]
    near = _NEAR * (limits[1] - limits[0])
    for stop in limits:
        if heights[0][0] - near < stop < heights[0][1] + near:
            sheet.level(panel, stop, "stop")
            heights = [
                (min(bottom, stop - 0.3 * near), max(top, stop + 0.3 * near))
                if bottom - near < stop < top + near
                else (bottom, top)
                for bottom, top in heights
            ]
    for view, height in zip(views, heights, strict=True):
        view.set_ylim(*height)
