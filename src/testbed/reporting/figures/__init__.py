"""Figures of a finished flight: groups of `reporting.panels`, drawn with matplotlib. To add one, add a line to TABLE."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from testbed.flight.flight import Flight
from testbed.reporting.panels import GROUPS, shown_log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from testbed.reporting.figures.lines import Shown


class Drawn(NamedTuple):
    """A figure: what it shows, as its title says it; its caption; the height of each panel [inches]."""

    what: str
    caption: str
    height: float


TABLE = {
    "states": Drawn("aircraft states", "States against their references (the paper's figure 4)", 1.25),
    "actuators": Drawn("actuators", "Reference, command and position of each actuator (figure 5)", 1.7),
    "effectiveness": Drawn(
        "effectiveness, 1 is healthy",
        "Effectiveness: estimates against truth (figure 6)",
        1.5,
    ),
    "rates": Drawn("controlled rates", "Controlled rates: desired against measured", 1.7),
}
"""By the file's name without its ending, which is also that of the group in `panels.GROUPS`. matplotlib is imported only when a
figure is drawn."""


def plot(flight: Flight, name: str) -> Figure:
    """The figure of this name in TABLE."""
    from testbed.reporting.figures.sheet import Sheet, plain_text

    with plain_text():
        return Sheet().draw(_shown(flight), GROUPS[name].of(flight), TABLE[name].what, TABLE[name].height)


def draw(flight: Flight, folder: str | Path) -> list[Path]:
    """Write `folder/figures/<name>.png` for each of TABLE; returns the files in that order."""
    from testbed.reporting.figures.sheet import Sheet, plain_text, save

    sheet, shown = Sheet(), _shown(flight)
    with plain_text():
        return [
            save(sheet.draw(shown, GROUPS[name].of(flight), what, height), Path(folder), name)
            for name, (what, _, height) in TABLE.items()
        ]


def _shown(flight: Flight) -> Shown:
    """A flight as the sheet draws it."""
    from testbed.reporting.figures.lines import Shown, marks, zoom_span

    end_s = max(flight.end_time_s, 1e-3)
    return Shown(
        f"{flight.scenario.name} — {flight.controller}",
        f"{flight.outcome.sentence}, {flight.end_time_s:g} s; {flight.verdict}",
        end_s, shown_log(flight), marks(flight.events, flight), zoom_span(flight.events, end_s),
        flight.scenario.requirements,
    )  # fmt: skip
