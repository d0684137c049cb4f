"""The static picture of a comparison: errors of altitude and heading, and bank, with all flights in each panel."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from testbed.flight.flight import Flight, Outcome
from testbed.flight.recovery import UNITS, failure_times_s, tracking_error
from testbed.reporting.failure_words import predicate
from testbed.reporting.figures.page import plain_text
from testbed.reporting.figures.signals import thin
from testbed.reporting.story import title
from testbed.reporting.sweep_page.curves import unwrapped

if TYPE_CHECKING:
    from testbed.reporting.comparison import Comparison

_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")  # by Okabe and Ito
_LINES = ("-", "--", ":", "-.", (0, (5, 1)), (0, (1, 1)))
_MARKERS = "os^Dvp"
_LEAST = {"altitude": 1.0, "heading": 3.0, "roll": 10.0}  # an axis shows at least this much, either way
_MOST = {"heading": 360.0}  # and at most this much
_TITLES = {"altitude": "altitude\nerror [m]", "heading": "heading\nerror [deg]", "roll": "bank\n[deg]"}


def png(comparison: Comparison, width: float = 9.0) -> bytes:
    """The picture as a PNG, `width` inches wide."""
    stream = io.BytesIO()
    with plain_text():
        draw(comparison, width).savefig(stream, format="png", dpi=110, metadata={"Software": None})
    return stream.getvalue()


def draw(comparison: Comparison, width: float = 9.0) -> Figure:
    """The figure: a panel for each of altitude, heading and bank."""
    figure = Figure(figsize=(width, 5.2), layout="constrained")
    FigureCanvasAgg(figure)
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
    log = dict(zip(flight.columns, flight.data.T, strict=True))
    if quantity not in UNITS:
        return log[f"{quantity}_deg"]
    error = tracking_error(log, quantity)
    return unwrapped(error[None])[0] if quantity == "heading" else error


def _panel(panel: Any, comparison: Comparison, quantity: str) -> None:
    signals = [_signal(flight, quantity) for flight in comparison.flights]
    low, high = _range(signals, quantity)
    for i, (flight, values) in enumerate(zip(comparison.flights, signals, strict=True)):
        time, few = thin(flight.data[:, flight.columns.index("time_s")], values)
        lost = flight.outcome is not Outcome.completed
        label = comparison.names[i] + (f" (lost at {flight.end_time_s:.1f} s)" if lost else "")
        style = {"color": _COLOURS[i % 6], "ls": _LINES[i % 6], "marker": _MARKERS[i % 6], "ms": 5}
        panel.plot(time, few, lw=1.7, markevery=(0.03 * (i + 1), 0.15), label=label, **style)
        if lost:
            end = np.clip(few[-1], low, high)
            panel.plot(time[-1], end, "X", color=_COLOURS[i % 6], ms=10, clip_on=False, zorder=5)
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


def _title(comparison: Comparison) -> str:
    first = comparison.flights[0]
    starts = [e for e in first.events if e["kind"] == "injection" and e.get("active", True)]
    differ = any(flight.scenario.failures != first.scenario.failures for flight in comparison.flights)
    if not starts or differ:
        return first.scenario.name
    event = starts[0]
    if not event["actuator"] or event["type"] == "property":
        return first.scenario.name
    what = predicate(first.scenario.failures[event["failure"]], first.actuators.get(event["actuator"], {}))
    more = f", and {len(starts) - 1} more" if len(starts) > 1 else ""
    return f"{first.scenario.name}: at {event['time_s']:g} s the {title(event['actuator'])} {what}{more}"
