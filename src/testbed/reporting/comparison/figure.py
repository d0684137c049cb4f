"""The static picture of a comparison: errors of altitude and heading, and bank, with all flights in each panel."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from testbed.common.angles import unwrapped_deg
from testbed.flight.breakage import failure_times_s, failures_of
from testbed.flight.flight import Flight
from testbed.flight.recovery import UNITS, tracking_error
from testbed.reporting.comparison.differences import Compared
from testbed.reporting.figures.sheet import Drawing, plain_text, png
from testbed.reporting.figures.signals import thin
from testbed.reporting.palette import nth
from testbed.reporting.words import broke

_LEAST = {"altitude": 1.0, "heading": 3.0, "roll": 10.0}  # an axis shows at least this much, either way
_MOST = {"heading": 360.0}  # and at most this much
_TITLES = {"altitude": "altitude\nerror [m]", "heading": "heading\nerror [deg]", "roll": "bank\n[deg]"}


def picture(comparison: Compared) -> bytes:
    """The figure as a PNG."""
    with plain_text():
        return png(draw(comparison))


def draw(comparison: Compared, width: float = 9.0) -> Figure:
    """A panel for each of altitude, heading and bank, `width` inches wide."""
    figure = Drawing(figsize=(width, 5.2), layout="constrained")
    panels = np.ravel(figure.subplots(len(_TITLES), 1, sharex=True))
    for panel, (quantity, text) in zip(panels, _TITLES.items(), strict=True):
        _panel(panel, comparison, quantity)
        panel.set_ylabel(text, fontsize=9)
    panels[-1].set_xlabel("time [s]", fontsize=9)
    entries = panels[0].get_legend_handles_labels()
    figure.legend(
        *entries, loc="outside lower center", ncols=len(comparison.flights), fontsize=9, frameon=False
    )
    figure.suptitle(_title(comparison), fontsize=11)
    return figure


def _signal(flight: Flight, quantity: str) -> np.ndarray:
    if quantity not in UNITS:
        return flight.column(f"{quantity}_deg")
    error = tracking_error(flight.signals, quantity)
    return unwrapped_deg(error) if quantity == "heading" else error


def _panel(panel: Any, comparison: Compared, quantity: str) -> None:
    signals = [_signal(flight, quantity) for flight in comparison.flights]
    low, high = _range(signals, quantity)
    for i, (flight, values) in enumerate(zip(comparison.flights, signals, strict=True)):
        time, few = thin(flight.column("time_s"), values)
        lost = flight.outcome.is_lost
        label = comparison.names[i] + (f" (lost at {flight.end_time_s:.1f} s)" if lost else "")
        look = nth(i, "ls", "marker")
        panel.plot(time, few, lw=1.7, ms=5, markevery=(0.03 * (i + 1), 0.15), label=label, **look)
        if lost:
            end = np.clip(few[-1], low, high)
            panel.plot(time[-1], end, "X", color=look["color"], ms=10, clip_on=False, zorder=5)
    for instant in failure_times_s(comparison.flights[0].events):
        panel.axvline(instant, color="black", lw=1.1, alpha=0.7)
    panel.set_ylim(low, high)
    panel.margins(x=0.01)
    panel.grid(alpha=0.3)
    for side in ("top", "right"):
        panel.spines[side].set_visible(False)


def _range(signals: list[np.ndarray], quantity: str) -> tuple[float, float]:
    """Limits of the axis: all that is finite, but not beyond _MOST."""
    values = np.concatenate(signals)
    values = values[np.isfinite(values)]
    least, most = _LEAST[quantity], _MOST.get(quantity, np.inf)
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 0.0)
    return 1.06 * max(min(low, -least), -most), 1.06 * min(max(high, least), most)


def _title(comparison: Compared) -> str:
    """The first flight's scenario, and what broke an actuator in all of them."""
    first = comparison.flights[0]
    failures = failures_of(first.events)
    same = all(flight.scenario.failures == first.scenario.failures for flight in comparison.flights)
    if not failures or not same or not first.scenario.failures[failures[0].number].actuator:
        return first.scenario.name
    more = f", and {len(failures) - 1} more" if len(failures) > 1 else ""
    return f"{first.scenario.name}: at {failures[0].from_s:g} s {broke(first, failures[0].number)}{more}"
