"""The events of a flight as vertical lines, with styles that can be told apart in grey print; the time around the first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from testbed.flight.breakage import failure_times_s
from testbed.flight.flight import Flight
from testbed.reporting.palette import MET, MISSED, PALETTE
from testbed.reporting.words import describe

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


def rows_of(shown: Sequence[Mark], span: tuple[float, float], width: float) -> list[tuple[Mark, int, str]]:
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
