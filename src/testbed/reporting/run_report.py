"""The report of a flight: one page with its story, its replay, its panels, and every number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from testbed.common.angles import unwrapped_deg
from testbed.flight.flight import Flight
from testbed.reporting import html
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.page import sections
from testbed.reporting.page.columns import packed
from testbed.reporting.page.drawn import can_be_replayed, drawn
from testbed.reporting.page.panels import groups
from testbed.reporting.panels import TRACKED, shown_log
from testbed.reporting.words import describe


def write_page(
    flight: Flight,
    file: Path,
    figures: Path | None = None,
    again: Html = sections.AGAIN,
    back: Part = None,
    within: Path | None = None,
) -> Path:
    """Write the page of a flight; returns its file. Raises OSError when it cannot be written.

    Args:
        figures: folder of the static figures, if there are any.
        again: HTML that says how to fly it again.
        back: what stands above the title, such as a link to where the flight comes from.
        within: the folder that was asked for; by default the file's own.
    """
    log = shown_log(flight)
    if not can_be_replayed(log):
        parts = _parts(flight, None, figures, again, back)
        return html.write_page(file, flight.scenario.name, parts, within=within)
    turned = TRACKED["heading"].error
    log |= {turned: unwrapped_deg(log[turned])} if turned in log else {}  # it goes on beyond a half turn
    shown = groups(flight, log)
    told, columns = packed(log)
    happened = [
        {"time_s": event["time_s"], "kind": event["kind"], "text": describe(event, flight)}
        for event in flight.events
    ]
    script = {"data": told, "panels": shown, **drawn(flight, log), "events": happened}
    parts = _parts(flight, to_fill(shown, log), figures, again, back)
    data = {"flight": script, "columns": columns}
    return html.write_page(file, flight.scenario.name, parts, "flight.js", data, within)


def _parts(flight: Flight, moving: Part, figures: Path | None, again: Html, back: Part) -> Iterator[Part]:
    yield back
    yield sections.head(flight)
    yield moving
    if figures is not None:  # hidden where the script runs, and printed
        captions = {name: figure.caption for name, figure in FIGURES.items()}
        shown = html.figures(figures, captions)
        yield tag("div", tag("h2", "Figures"), shown, class_="still") if shown else None
    yield sections.requirements(flight)
    yield sections.events(flight)
    yield sections.metrics(flight)
    yield sections.again(flight, again)


def to_fill(shown: list[dict[str, Any]], columns: Iterable[str]) -> Html:
    """The places that the script fills: timeline, replay, panels, and a panel of any column."""
    said = "Drag in a panel to zoom, double-click for the whole flight, click to go there."
    chosen = tag("select", [tag("option", name) for name in columns if name != "time_s"])
    any_column = tag("div", tag("label", "column ", chosen), id="any-column")
    return tag(
        "div", tag("h2", "The flight"), [tag("div", id=place) for place in ("timeline", "replay")], html.note(said),
        map(html.panels, shown), html.folded("Any column of the log", any_column), class_="moving",
    )  # fmt: skip
