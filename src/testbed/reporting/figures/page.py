"""The page that every figure is drawn on: panels above each other over one time axis, title, legend, events at the top.

It uses matplotlib's objects and not pyplot, so there is no global state, and no display is needed.
"""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from testbed.common.files import replacing
from testbed.flight.flight import Flight
from testbed.reporting.figures.marks import Mark, marks, rows_of
from testbed.reporting.figures.signals import band, thin
from testbed.reporting.figures.zoom import zoom_span

DPI = 110
_WIDTH = 10.0  # inches, as all sizes here
_TOP, _BOTTOM, _GAP, _LEFT, _RIGHT = 0.72, 0.55, 0.16, 1.1, 0.25
_LANE_ROW = 0.19
_LABEL = 0.58  # from the axis to its label, with room for the numbers
_ZOOM, _BETWEEN = 2.3, 0.5
"""Width of the panels around the failure, and the gap before them, with room for numbers."""

TRUTH: dict[str, Any] = {"color": "black", "linestyle": "-", "linewidth": 1.3}
"""True values."""
WIDE: dict[str, Any] = {"color": "0.62", "linestyle": "-", "linewidth": 3.4, "solid_capstyle": "butt"}
"""An actuator's position: a wide line, because the command is drawn on top of it."""
REFERENCE: dict[str, Any] = {"color": "#0072B2", "linestyle": (0, (5, 2)), "linewidth": 1.5}
"""A reference, or a controller's estimate."""
COMMAND: dict[str, Any] = {"color": "#D55E00", "linestyle": "-", "linewidth": 1.0}
"""An actuator's command."""
LIMIT: dict[str, Any] = {"color": "0.35", "linestyle": (0, (1, 2)), "linewidth": 1.1}
"""Stops and thresholds."""
SHADE: dict[str, Any] = {"facecolor": "0.9", "edgecolor": "0.7", "hatch": "////", "linewidth": 0, "zorder": 0}
"""The times at which an axis is released or an actuator is flagged."""


class Drawing(Figure):
    """A figure that a notebook shows, also where pyplot has not been imported."""

    def _repr_png_(self) -> bytes:
        memory = io.BytesIO()
        self.savefig(memory, format="png", dpi=DPI)
        return memory.getvalue()


@dataclass
class Page:
    """A figure being drawn: `panels` from top to bottom, all with the time axis `time_s` [rows].

    Beside each panel is one of `zooms`, of the time around the first failure; there are none where that would show no more.
    """

    figure: Figure
    panels: list[Axes]
    flight: Flight
    time_s: np.ndarray
    zooms: list[Axes]

    def views(self, panel: Axes) -> list[Axes]:
        """The panel, and the one that zooms into it."""
        beside = self.zooms[self.panels.index(panel)] if self.zooms else None
        return [panel] if beside is None else [panel, beside]

    def column(self, name: str) -> np.ndarray:
        """A column of the log."""
        return self.flight.data[:, self.flight.columns.index(name)]

    def line(
        self, panel: Axes, values: np.ndarray, label: str, style: dict[str, Any], wraps: bool = False
    ) -> None:
        """Draw a signal [rows], thinned to what can be seen, or as its mean in a band of its extremes where it is dense.

        If it `wraps`, jumps by more than 180 deg are left out of the line.
        """
        for view in self.views(panel):
            first, last = view.get_xlim()
            rows = slice(*np.searchsorted(self.time_s, [first, last + 1e-9]))
            _draw(view, self.time_s[rows], values[rows], label, style, wraps)

    def level(
        self, panel: Axes, value: float, label: str, since_s: float = 0.0, until_s: float = math.inf
    ) -> None:
        """Draw a limit, over all the time or a part of it."""
        span = [since_s, min(until_s, max(self.flight.end_time_s, 1e-3))]
        for view in self.views(panel):
            view.plot(span, [value, value], label=label, **LIMIT)

    def frame(self, panel: Axes, least: float, *signals: np.ndarray) -> None:
        """Fit the y axis to all finite values of signals [rows], with a margin; the zoom's to those that it shows.

        The height is at least `least`, so that small noise looks small.
        """
        for view in self.views(panel):
            first, last = view.get_xlim()
            rows = slice(*np.searchsorted(self.time_s, [first, last + 1e-9]))
            _fit(view, least, [s[rows] if len(s) == len(self.time_s) else s for s in signals])

    def shade(self, panel: Axes, flag: np.ndarray, label: str) -> None:
        """Hatch the times at which a flag [rows] is set."""
        edges = np.flatnonzero(np.diff(np.concatenate(([False], flag > 0.5, [False])).astype(np.int8)))
        end = self.flight.end_time_s
        for first, last in edges.reshape(-1, 2)[:200]:
            until = self.time_s[last] if last < len(self.time_s) else end
            for view in self.views(panel):
                if self.time_s[first] < view.get_xlim()[1] and until > view.get_xlim()[0]:
                    view.axvspan(
                        max(self.time_s[first], view.get_xlim()[0]),
                        min(until, view.get_xlim()[1]),
                        label=label,
                        **SHADE,
                    )
            label = "_"  # one entry in the legend

    def finish(self) -> Figure:
        """Add one legend for all panels, with each entry once; returns the figure."""
        entries: dict[str, Any] = {}
        for panel in self.panels:
            for handle, label in zip(*panel.get_legend_handles_labels(), strict=True):
                entries.setdefault(label, handle)
        self.figure.legend(
            entries.values(), entries, loc="upper right", ncols=max(len(entries), 1),
            frameon=False, fontsize=9,
            bbox_to_anchor=(1 - _RIGHT / _WIDTH, 1 - 0.33 / self.figure.get_figheight()),
            borderaxespad=0.0, handlelength=2.8, columnspacing=1.4,
        )  # fmt: skip
        return self.figure


def page(flight: Flight, what: str, heights: Sequence[float]) -> Page:
    """A figure with a panel for each of `heights` [inches], a title, and the events marked in every panel."""
    time = flight.data[:, flight.columns.index("time_s")]
    span = (0.0, max(flight.end_time_s, 1e-3))
    shown, closer = marks(flight.events, flight), zoom_span(flight.events, span[1])
    width = _WIDTH - _LEFT - _RIGHT - (_ZOOM + _BETWEEN if closer else 0.0)
    lane = rows_of(shown, span, width)
    lane_height = _LANE_ROW * (max((row for _, row, _ in lane), default=-1) + 1) + 0.04
    height = _TOP + lane_height + sum(heights) + _GAP * (len(heights) - 1) + _BOTTOM
    figure = Drawing(figsize=(_WIDTH, height), dpi=DPI)
    FigureCanvasAgg(figure)
    _title(figure, flight, what)
    top = height - _TOP - lane_height
    panels = _panels(figure, top, heights, span, _LEFT, width)
    zooms = _panels(figure, top, heights, closer, _WIDTH - _RIGHT - _ZOOM, _ZOOM) if closer else []
    for mark in shown:
        for panel in (*panels, *zooms):
            if panel.get_xlim()[0] <= mark.time_s <= panel.get_xlim()[1]:
                panel.axvline(mark.time_s, **mark.style, alpha=0.75, zorder=1.5)
    _lane(figure, panels[0], lane, lane_height, width)
    if closer:
        _name_zooms(zooms, [mark for mark in shown if closer[0] <= mark.time_s <= closer[1]])
    return Page(figure, panels, flight, time, zooms)


def _name_zooms(zooms: Sequence[Axes], shown: Sequence[Mark]) -> None:
    """Say above the first what they are, and put each event's marker at its line."""
    for zoom in zooms:
        zoom.set_label("zoom")
    first = zooms[0]
    first.set_title("around the failure", fontsize=8.5, color="0.25", pad=11)
    for mark in shown:
        _marker(first, mark, 1.05, first.get_xaxis_transform())


def _title(figure: Figure, flight: Flight, what: str) -> None:
    height = figure.get_figheight()
    verdict = "passed" if flight.passed else "not passed"
    title = f"{flight.scenario.name} — {flight.controller}"
    outcome = f"{flight.outcome.sentence}, {flight.end_time_s:g} s; {verdict}"
    left, right = _LEFT / _WIDTH, 1 - _RIGHT / _WIDTH
    figure.text(left, 1 - 0.22 / height, title, fontsize=12, fontweight="bold", va="center")
    figure.text(right, 1 - 0.22 / height, outcome, fontsize=10, ha="right", va="center")
    figure.text(left, 1 - 0.46 / height, what, fontsize=10, va="center", color="0.25")


def _draw(
    panel: Axes, time: np.ndarray, values: np.ndarray, label: str, style: dict[str, Any], wraps: bool
) -> None:
    first, last = panel.get_xlim()
    dense = None if wraps else band(time, values, last - first, _parts(panel))
    if dense is not None:
        look = {"color": style["color"], "alpha": 0.22, "linewidth": 0}
        panel.fill_between(dense.time_s, dense.low, dense.high, label="extremes", **look)
        time, values = dense.time_s, dense.mean
    time, values = thin(time, values)
    if wraps:
        jumps = np.flatnonzero(np.abs(np.diff(values)) > 180.0) + 1
        time, values = np.insert(time, jumps, math.nan), np.insert(values, jumps, math.nan)
    panel.plot(time, values, label=label, **style)


def _parts(panel: Axes) -> int:
    """Parts of the panel's time axis that are some pixels wide each."""
    return round(panel.get_position().width * _WIDTH * DPI / 4.0)


def _marker(axes: Axes, mark: Mark, y: float, transform: Any) -> None:
    colour = mark.style["color"]
    axes.plot([mark.time_s], [y], mark.marker, color=colour, markersize=5, transform=transform, clip_on=False)


def _panels(
    figure: Figure,
    top: float,
    heights: Sequence[float],
    span: tuple[float, float],
    left: float,
    wide: float,
) -> list[Axes]:
    """Panels above each other from `top`; `left` and `wide` are where they begin and their width [inches]."""
    panels: list[Axes] = []
    width, height = wide / _WIDTH, figure.get_figheight()
    for tall in heights:
        top -= tall
        panel = figure.add_axes((left / _WIDTH, top / height, width, tall / height))
        top -= _GAP
        panel.set_xlim(*span)
        panel.grid(True, color="0.88", linewidth=0.6)
        panel.set_axisbelow(True)
        panel.tick_params(labelsize=8.5, labelbottom=False)
        panel.ticklabel_format(useOffset=False)
        panel.locator_params(axis="y", nbins=5)
        panel.yaxis.set_label_coords(-_LABEL / wide, 0.5)
        for side in ("top", "right"):
            panel.spines[side].set_visible(False)
        panels.append(panel)
    panels[-1].tick_params(labelbottom=True)
    panels[-1].set_xlabel("time [s]", fontsize=9.5)
    return panels


def _lane(
    figure: Figure, panel: Axes, lane: Sequence[tuple[Mark, int, str]], tall: float, width: float
) -> None:
    """Write the label of each event above the first panel, at its line."""
    box = panel.get_position()
    axes = figure.add_axes((box.x0, box.y1, box.width, tall / figure.get_figheight()))
    axes.set_xlim(panel.get_xlim())
    axes.set_ylim(0.0, tall)
    axes.set_axis_off()
    axes.set_label("events")
    reach = 0.1 / width * (panel.get_xlim()[1] - panel.get_xlim()[0])
    for mark, row, side in lane:
        y = _LANE_ROW * (row + 0.5)
        axes.plot([mark.time_s, mark.time_s], [0.0, y + 0.07], **mark.style)
        _marker(axes, mark, y, axes.transData)
        x = mark.time_s + (reach if side == "left" else -reach)
        axes.text(x, y, mark.label, fontsize=8.5, ha=side, va="center", color=mark.style["color"])


def _fit(panel: Axes, least: float, signals: Sequence[np.ndarray]) -> None:
    values = np.concatenate(signals) if signals else np.zeros(0)
    values = values[np.isfinite(values) & (np.abs(values) < 1e6)]
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 0.0)
    half, middle = max(0.5 * (high - low) * 1.12, 0.5 * least), 0.5 * (low + high)
    panel.set_ylim(middle - half, middle + half)


def plain_text() -> AbstractContextManager[None]:
    """While in this context, `$` in a name is a dollar, not the beginning of a formula that may be wrong."""
    return rc_context({"text.parse_math": False})


def save(figure: Figure, file: Path) -> Path:
    """Write a PNG, completely or not at all; returns the file."""
    with replacing(file) as partial:
        figure.savefig(
            partial, format="png", dpi=DPI, metadata={"Software": None}, pil_kwargs={"compress_level": 3}
        )
    return file
