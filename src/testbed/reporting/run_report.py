"""The report of a run folder: one page with the story of a flight, its replay, its panels, and every number."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.conventional_shape import conventional
from testbed.flight.breakage import failure_times_s
from testbed.flight.flight import Flight
from testbed.flight.folder import load
from testbed.reporting import html
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.page import sections
from testbed.reporting.page.columns import packed
from testbed.reporting.page.panels import groups
from testbed.reporting.page.phases import phases
from testbed.reporting.panels import error_columns, has_estimates
from testbed.reporting.words import describe

_REPLAYED = ("north_m", "east_m", "altitude_m", "airspeed_m_s", "roll_deg", "pitch_deg", "heading_deg")
"""Columns without which there is nothing to replay."""


def write_report(folder: str | Path) -> Path:
    """Write `report.html` into a run folder, from its log, summary and figures; returns the file.

    Raises BadInput when it is not a run folder.
    """
    folder = Path(folder)
    return write_page(load(folder), folder / "report.html", folder / "figures")


def write_page(
    flight: Flight,
    file: Path,
    figures: Path | None = None,
    again: str = sections.AGAIN,
    back: str = "",
    within: Path | None = None,
) -> Path:
    """Write the page of a flight; returns its file. Raises OSError when it cannot be written.

    Args:
        figures: folder of the static figures, if there are any.
        again: HTML that says how to fly it again.
        back: HTML above the title, such as a link to where the flight comes from.
        within: the folder that was asked for; by default the file's own.
    """
    parts = _parts(flight, figures, again, back)
    return html.write_page(file, flight.scenario.name, parts, ["uplot.css"], within)


def _parts(flight: Flight, figures: Path | None, again: str, back: str) -> Iterator[str]:
    log = dict(flight.signals)
    moving = len(flight.data) > 1 and all(name in log for name in _REPLAYED)
    yield back
    yield sections.head(flight)
    if moving:
        log |= error_columns(log)
        told, columns = packed(log)
        shown = groups(flight, log)
        yield _moving(shown, list(log))
    if figures is not None:
        yield _figures(figures)
    yield sections.requirements(flight)
    yield sections.events(flight)
    yield sections.metrics(flight)
    yield sections.again(flight, again)
    if moving:
        yield html.data(_for_the_script(flight, told, shown, log), "flight")
        yield html.script(columns, "text/plain", "columns")
        yield html.script(html.asset("flight.js"))


def _moving(shown: list[dict[str, Any]], columns: list[str]) -> str:
    """The places that the script fills: timeline, replay, panels, and a panel of any column."""
    parts = ['<div class="moving"><h2>The flight</h2><div id="timeline"></div><div id="replay"></div>']
    parts.append(
        '<p class="note">Drag in a panel to zoom, double-click for the whole flight, click to go there.</p>'
    )
    parts += map(html.panels, shown)
    options = "".join(f"<option>{escape(name)}</option>" for name in columns if name != "time_s")
    chosen = f'<div id="any-column"><label>column <select>{options}</select></label></div>'
    parts.append(html.folded("Any column of the log", chosen))
    return "\n".join([*parts, "</div>"])


def _for_the_script(
    flight: Flight, told: Mapping[str, Any], shown: list[dict[str, Any]], log: Mapping[str, np.ndarray]
) -> dict[str, Any]:
    return {
        "data": told,
        "panels": shown,
        "phases": phases(flight.events, flight.end_time_s, flight.scenario.duration_s),
        "failures_s": failure_times_s(flight.events),
        "events": [
            {"time_s": event["time_s"], "kind": event["kind"], "text": describe(event, flight)}
            for event in flight.events
        ],
        "actuators": flight.actuators,
        "estimates": has_estimates(log, flight.actuators),
        "shape": (flight.shape or conventional()).model_dump(),
    }


def _figures(folder: Path) -> str:
    """The static figures; they are hidden where the script runs, and printed."""
    shown = html.figures(folder, {name: figure.caption for name, figure in FIGURES.items()})
    return "\n".join(['<div class="still"><h2>Figures</h2>', *shown, "</div>"]) if shown else ""
