"""A panel drawn into matplotlib's axes: its series, what the requirements allow, its levels, and the axis that fits them; and the
events of a flight as vertical lines, with styles that can be told apart in grey print, and the time around the first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from testbed.common.angles import wrap_deg
from testbed.flight.breakage import failure_times_s
from testbed.flight.columns import stretches
from testbed.flight.flight import Flight
from testbed.reporting.palette import MET, MISSED, PALETTE, nth
from testbed.reporting.panels import Panel, Series
from testbed.reporting.words import describe
from testbed.scenario.requirement import Requirement

_MOST_LABELS = 12
_MOST_LINES = 60
_CHARACTER = 0.0685  # inches, the mean width of a character of a label
_BEFORE_S, _AFTER_S, _LONGEST_S = 0.5, 2.5, 10.0  # of the zoom
_WORTH = 0.4  # part of the flight from which on a zoom shows nothing more than the flight does

LOOKS: dict[str, tuple[dict[str, Any], str]] = {
    "injection": ({"color": PALETTE["truth"], "linestyle": "-", "linewidth": 1.6}, "v"),
    "detection": ({"color": PALETTE["belief"], "linestyle": (0, (6, 2)), "linewidth": 1.4}, "D"),
    "false_alarm": ({"color": MISSED, "linestyle": (0, (6, 2, 1, 2)), "linewidth": 1.6}, "X"),
    "release": ({"color": "0.35", "linestyle": (0, (1, 1.5)), "linewidth": 1.6}, "s"),
    "recovered": ({"color": MET, "linestyle": (0, (3, 1, 1, 1, 1, 1)), "linewidth": 1.4}, "o"),
    "lost": ({"color": MISSED, "linestyle": "-", "linewidth": 2.4}, "P"),
}
"""By the kind of an event: the style of its line, and what stands at its top, so that kinds are told apart without colour."""


@dataclass(frozen=True)
class Mark:
    """A vertical line at a time [s], with its label and style; the label is empty if there are too many events."""

    time_s: float
    label: str
    style: dict[str, Any]
    marker: str


def marks(events: Sequence[Mapping[str, Any]], flight: Flight) -> list[Mark]:
    """A mark for each of these events of a flight, in order of time; events of one kind at the same time share a mark."""
    texts: dict[tuple[float, str], list[str]] = {}
    for event in events:
        if event["kind"] in LOOKS and event.get("after_s") != 0.0:  # it never left the limits of a recovery
            texts.setdefault((event["time_s"], event["kind"]), []).append(describe(event, flight))
    found = [Mark(time, ", ".join(labels), *LOOKS[kind]) for (time, kind), labels in sorted(texts.items())]
    more = f"and {len(found) - _MOST_LABELS} more events"
    return [
        mark if i < _MOST_LABELS else replace(mark, label=more if i == _MOST_LABELS else "")
        for i, mark in enumerate(found[:_MOST_LINES])
    ]


def label_rows(shown: Sequence[Mark], span: tuple[float, float], width: float) -> list[tuple[Mark, int, str]]:
    """Where each label goes so that no two touch: (mark, row, horizontal alignment of the text at its line).

    Row 0 is next to the panel. Where labels are close, later ones go into lower rows, so that no line crosses the label of
    another.

    Args:
        span: first and last time of the axis [s].
        width: length of the axis [inches].
    """
    inch = width / (span[1] - span[0])
    placed: list[tuple[float, float, int]] = []
    rows: list[tuple[Mark, int, str]] = []
    for mark in reversed([m for m in shown if m.label]):
        x, long = (mark.time_s - span[0]) * inch, len(mark.label) * _CHARACTER + 0.12
        side = "left" if x + long < width or x < 0.5 * width else "right"
        low, high = (x, x + long) if side == "left" else (x - long, x)
        meets = [row for a, b, row in placed if a < high + 0.05 and low < b + 0.05]
        row = max(meets, default=-1) + 1
        placed.append((low, high, row))
        rows.append((mark, row, side))
    return rows[::-1]


def zoom_span(events: Sequence[Mapping[str, Any]], end_s: float) -> tuple[float, float] | None:
    """(from, until) [s] around the first failure and what the controller made of it, which figures show beside the whole flight: a
    flag may come 0.1 s after the failure. None where there is nothing to zoom into, in a flight that ended at `end_s`.
    """
    times = failure_times_s(events)
    if not times:
        return None
    begin, longest = times[0], times[0] + _LONGEST_S
    answers = [
        e["time_s"]
        for e in events
        if e["kind"] in ("detection", "release") and begin <= e["time_s"] <= longest - _AFTER_S
    ]
    first, last = max(begin - _BEFORE_S, 0.0), min(max([begin, *answers[:3]]) + _AFTER_S, end_s)
    return (first, last) if 0.0 < last - first < _WORTH * end_s else None


STYLES: dict[str, dict[str, Any]] = {
    "truth": {"color": PALETTE["truth"], "linestyle": "-", "linewidth": 1.3},
    # Wide, because the command is drawn on top of it.
    "position": {"color": "0.62", "linestyle": "-", "linewidth": 3.4, "solid_capstyle": "butt"},
    "reference": {"color": PALETTE["belief"], "linestyle": (0, (5, 2)), "linewidth": 1.5},
    "belief": {"color": PALETTE["belief"], "linestyle": (0, (5, 2)), "linewidth": 1.8},
    "command": {"color": PALETTE["command"], "linestyle": "-", "linewidth": 1.0},
    "level": {"color": "0.35", "linestyle": (0, (1, 2)), "linewidth": 1.1},
    **{
        f"v{i}": {"lw": 1.7, "ms": 5, "markevery": (0.03 * (i + 1), 0.15), **nth(i, "ls", "marker")}
        for i in range(6)
    },
}
"""By the style of a series; "level" is of stops, thresholds and requirements, "v0" and so on are of flights that are compared."""
_SHADE: dict[str, Any] = {
    "facecolor": "0.9",
    "edgecolor": "0.7",
    "hatch": "////",
    "linewidth": 0,
    "zorder": 0,
}
_PAPER: dict[str, Any] = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1.5}
_NEAR = 0.15  # of the distance of the levels: one is drawn if a signal comes this close to it
_DENSE = 0.35  # crossings of the signal's own spread in a part, from which on a line is a blot
_PIXELS = 4.0  # width of a part of the time axis in which a dense signal is one band
_MOST_SHADES, _MOST_NOTES = 200, 6
_HUGE = 1e6  # values beyond it, of a flight that diverged, do not set an axis


@dataclass(frozen=True)
class Shown:
    """What a figure is of: its title, how it ended, its log by columns [rows], and the marks of its events.

    `zoom` is the stretch of time [s] that is drawn again beside the whole, None for none.
    """

    title: str
    ended: str
    end_s: float
    log: Mapping[str, np.ndarray]
    marks: Sequence[Mark]
    zoom: tuple[float, float] | None = None
    requirements: Sequence[Requirement] = ()


def draw_panel(axes: Axes, panel: Panel, shown: Shown, width: float) -> None:
    """Draw a panel over the axes' time; `width` is that of the axes [pixels]."""
    time = shown.log["time_s"]
    first, last = axes.get_xlim()
    rows = slice(*np.searchsorted(time, [first, last + 1e-9]))
    values = {column: whole[rows] for column, whole in _values(shown.log, panel).items()}
    for series in panel.series:
        _line(axes, time[rows], values[series.column], series, round(width / _PIXELS))
    allowed = list(_allowed(axes, shown, time[rows], values))
    _shade(axes, shown, panel)
    _fit(axes, panel, [_fitted(panel, series, values[series.column]) for series in panel.series] + allowed)
    _levels(axes, panel)
    _notes(axes, panel)


def _values(log: Mapping[str, np.ndarray], panel: Panel) -> dict[str, np.ndarray]:
    """{column: values [rows]} of a panel's series; a heading is on the same turn as its reference, which does not jump."""
    values = {series.column: log[series.column] for series in panel.series}
    if "heading_command_deg" in values:
        wanted = np.unwrap(values["heading_command_deg"], period=360.0)
        values["heading_deg"] = wanted + wrap_deg(values["heading_deg"] - wanted)
        values["heading_command_deg"] = wanted
    return values


def _line(axes: Axes, time: np.ndarray, values: np.ndarray, series: Series, parts: int) -> None:
    """Draw a signal [rows], or its mean in a band of its extremes where it is dense.

    Jumps of an angle by more than 180 deg are left out of the line.
    """
    style, label = STYLES[series.style], series.label
    wraps = series.column in ("roll_deg", "heading_deg")
    first, last = axes.get_xlim()
    dense = None if wraps else band(time, values, last - first, parts)
    if dense is not None:
        look = {"color": style["color"], "alpha": 0.22, "linewidth": 0}
        time, low, high, values = dense
        axes.fill_between(time, low, high, label="extremes", **look)
    if wraps:
        jumps = np.flatnonzero(np.abs(np.diff(values)) > 180.0) + 1
        time, values = np.insert(time, jumps, math.nan), np.insert(values, jumps, math.nan)
    axes.plot(time, values, label=label, **style)


def _allowed(
    axes: Axes, shown: Shown, time: np.ndarray, values: Mapping[str, np.ndarray]
) -> Iterator[np.ndarray]:
    """Draw what the requirements allow the panel's signals, and give the values that the axis is to hold as well."""
    for requirement in shown.requirements:
        if requirement.signal not in values:
            continue
        since, until = requirement.begins_s, requirement.until_s or math.inf
        for limit in (requirement.at_most, requirement.at_least):
            if limit is not None:
                _level(axes, limit, "requirement", since, min(until, shown.end_s))
                yield np.array([limit])
        if requirement.within is not None and requirement.of in values:
            inside = (time >= since) & (time <= until)
            for size in (-requirement.within, requirement.within):
                allowed = np.where(inside, values[str(requirement.of)] + size, math.nan)
                axes.plot(time, allowed, label="requirement", **STYLES["level"])
                yield allowed


def _level(axes: Axes, value: float, label: str, since_s: float, until_s: float) -> None:
    axes.plot([since_s, until_s], [value, value], label=label, **STYLES["level"])


def _shade(axes: Axes, shown: Shown, panel: Panel) -> None:
    """Hatch the times at which the panel's flag is set."""
    if not panel.flag:
        return
    time, (left, right) = shown.log["time_s"], axes.get_xlim()
    for first, end in stretches(shown.log[panel.flag] > 0.5)[:_MOST_SHADES]:
        since, until = time[first], time[end] if end < len(time) else shown.end_s
        if since < right and until > left:
            axes.axvspan(max(since, left), min(until, right), label=panel.flagged, **_SHADE)


def _fitted(panel: Panel, series: Series, values: np.ndarray) -> np.ndarray:
    """What of a series the axis is to hold."""
    if series.spikes and np.isfinite(values).any():
        return np.asarray(np.nanpercentile(values, [0.5, 99.5]))
    if panel.levels and panel.span is None:  # a reference may be far beyond the stops
        near = _near(panel)
        return np.clip(values, min(panel.levels) - near, max(panel.levels) + near)
    return values


def _fit(axes: Axes, panel: Panel, signals: Sequence[np.ndarray]) -> None:
    """Fit the y axis to all finite values, with a margin; it is no shorter than `Panel.least`, so that noise looks small."""
    values = np.concatenate([*signals, np.array(panel.span or ())])
    values = values[np.isfinite(values) & (np.abs(values) <= min(panel.most, _HUGE))]
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 0.0)
    half, middle = max(0.5 * (high - low) * 1.12, 0.5 * panel.least), 0.5 * (low + high)
    axes.set_ylim(middle - half, middle + half)


def _near(panel: Panel) -> float:
    levels = panel.levels or {0.0: ""}
    return _NEAR * (max(levels) - min(levels))


def _levels(axes: Axes, panel: Panel) -> None:
    """Draw each level that the signals come near, and make room for it."""
    near = _near(panel)
    (first, last), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    for value, label in (panel.levels or {}).items():
        if bottom - near < value < top + near:
            _level(axes, value, label, first, last)
            bottom, top = min(bottom, value - 0.3 * near), max(top, value + 0.3 * near)
    axes.set_ylim(bottom, top)


def _notes(axes: Axes, panel: Panel) -> None:
    """Write each text of a note where it first begins, one below the other."""
    first, last = axes.get_xlim()
    begins: dict[str, float] = {}
    for since, until, words in panel.notes:
        if since < last and until > first:
            begins.setdefault(words, since)
    for i, (words, since) in enumerate(list(begins.items())[:_MOST_NOTES]):
        place, y = (max(since, first) - first) / (last - first), 0.72 - 0.18 * (i % 3)
        side, by = ("left", 0.01) if place < 0.6 else ("right", -0.01)
        axes.text(place + by, y, words, fontsize=8, ha=side, va="top", transform=axes.transAxes, bbox=_PAPER)


def band(time: np.ndarray, values: np.ndarray, span_s: float, parts: int) -> np.ndarray | None:
    """[4, parts] the signal as a band: middle of each part in time, least, greatest and mean value; None where a line can be read.

    It is dense if, over the time it is drawn in, its path up and down is many times its spread (10 to 90 % of its values).

    Args:
        time: [rows] ascending [s].
        values: [rows] of the signal.
        span_s: length of the time axis [s].
        parts: into how many parts the time axis is divided, each some pixels wide.
    """
    each = round(len(values) * span_s / max(float(np.ptp(time)), 1e-9) / parts) if len(values) > 1 else 0
    if each < 8 or not np.all(np.isfinite(values)):
        return None
    spread = float(np.ptp(np.percentile(values, [10, 90])))
    if spread <= 0.0 or np.abs(np.diff(values)).sum() < _DENSE * 2.0 * len(values) / each * spread:
        return None
    first = np.arange(0, len(values) - each + 1, each)
    blocks = values[: len(first) * each].reshape(-1, each)
    return np.stack([time[first + each // 2], blocks.min(axis=1), blocks.max(axis=1), blocks.mean(axis=1)])
