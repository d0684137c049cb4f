"""A flight as one line of text, and as a short piece of HTML for notebooks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from testbed.flight.flight import Flight

KEY_NUMBERS = {
    "altitude_error_max_m": "largest altitude error [m]",
    "heading_error_max_deg": "largest heading error [deg]",
    "airspeed_error_max_m_s": "largest airspeed error [m/s]",
    "detection_delay_s": "longest detection delay [s]",
    "missed_detections": "missed detections",
    "false_alarms": "false alarms",
}
"""Metrics that are shown of every flight, and their titles."""
_MOST_ROWS = 12  # requirements shown in a notebook; the report has all of them


def line(flight: Flight) -> str:
    """`<Flight 'left tail failure': completed at 60 s, passed (25 of 25 requirements), ...>`."""
    met = sum(bool(r["passed"]) for r in flight.requirements)
    rows, columns = flight.data.shape
    return (
        f"<Flight {flight.scenario.name!r}: {flight.outcome} at {flight.end_time_s:g} s, "
        f"{'passed' if flight.passed else 'not passed'} ({met} of {len(flight.requirements)} requirements), "
        f"{rows} rows x {columns} columns, {_count(len(flight.events), 'event')}>"
    )


def html(flight: Flight, story: Iterable[str] = ()) -> str:
    """HTML with the verdict, the lines of the flight's story, the requirements (those not met first), and KEY_NUMBERS."""
    told = (f"<p>{escape(line)}</p>" for line in story)
    return "\n".join(["<div>", *_verdict(flight), *told, *_requirements(flight), *_numbers(flight), "</div>"])


def _verdict(flight: Flight) -> Iterator[str]:
    missed = sum(not r["passed"] for r in flight.requirements)
    said = f"{missed} of {_count(len(flight.requirements), 'requirement')} not met" if missed else ""
    if not missed and flight.requirements:
        said = f"all {len(flight.requirements)} requirements met"
    verdict = "Passed" if flight.passed else "Not passed"
    how = "; ".join(filter(None, (f"{flight.outcome.sentence} ({flight.end_time_s:g} s)", said)))
    name, controller = escape(flight.scenario.name), escape(flight.controller)
    yield f"<p><strong>{name}</strong>, {controller}: {verdict}. {how[0].upper()}{escape(how[1:])}.</p>"
    for warning in flight.warnings:
        yield f"<p>Warning: {escape(warning)}</p>"


def _requirements(flight: Flight) -> Iterator[str]:
    order = sorted(flight.requirements, key=lambda r: bool(r["passed"]))
    if order:
        rows = (
            (r["name"], "met" if r["passed"] else "NOT MET", _number(r.get("value")), r.get("reason", ""))
            for r in order[:_MOST_ROWS]
        )
        yield from _table(("requirement", "", "worst value", ""), rows)
    if len(order) > _MOST_ROWS:
        yield f"<p>and {len(order) - _MOST_ROWS} more</p>"


def _numbers(flight: Flight) -> Iterator[str]:
    metrics: Mapping[str, Any] = flight.metrics
    rows = [(what, _number(metrics[name])) for name, what in KEY_NUMBERS.items() if name in metrics]
    if rows:
        yield from _table(("of the whole flight", ""), rows)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield "<table>"
    yield "<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>"
    for row in rows:
        yield "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>"
    yield "</table>"


def _number(value: float | None) -> str:
    """A number with four digits; a dash if there is no value."""
    return "-" if value is None or not math.isfinite(value) else f"{value:.4g}"


def _count(number: int, of: str) -> str:
    return f"{number} {of}" if number == 1 else f"{number} {of}s"
