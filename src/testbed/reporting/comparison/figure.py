"""The static picture of a comparison: errors of altitude and heading, and bank, with all flights in each panel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from testbed.flight.breakage import failures_of
from testbed.reporting.comparison.differences import Compared
from testbed.reporting.comparison.page import began, columns_of, of_all
from testbed.reporting.figures.lines import LOOKS, Mark, Shown
from testbed.reporting.figures.sheet import Sheet, plain_text, png
from testbed.reporting.palette import COLOURS
from testbed.reporting.panels import error_panel, states
from testbed.reporting.words import broke, joined

_TALL = 1.5  # inches, of a panel
_MOST_DEG = 360.0  # of heading: a lost aircraft turns and turns


def picture(comparison: Compared) -> bytes:
    """The figure as a PNG."""
    log = columns_of(comparison.flights)
    title, end_s = comparison.flights[0].scenario.name, max(float(log["time_s"][-1]), 1e-3)
    marks = sorted(_marks(comparison), key=lambda mark: mark.time_s)
    shown = Shown(title, _broken(comparison), end_s, log, marks)
    heading = replace(error_panel("heading"), most=_MOST_DEG)
    panels = of_all([error_panel("altitude"), heading, next(states(comparison.flights[0]))], comparison, log)
    with plain_text():
        return png(Sheet().draw(shown, list(panels), "", _TALL))


def _marks(comparison: Compared) -> Iterator[Mark]:
    """When failures began, and in which flights if not in all, and when each flight was lost, in its colour."""
    for time, having in began(comparison.flights).items():
        every = len(having) == len(comparison.flights)
        whose = "" if every else f" {joined([comparison.keys[i] for i in having])}"
        yield Mark(time, f"failure{whose}", *LOOKS["injection"])
    for i, (name, flight) in enumerate(zip(comparison.keys, comparison.flights, strict=True)):
        if flight.outcome.is_lost:
            style, marker = LOOKS["lost"]
            own = {**style, "linewidth": 1.2, "color": COLOURS[i % 6]}
            yield Mark(flight.end_time_s, f"{name} lost", own, marker)


def _broken(comparison: Compared) -> str:
    """What broke an actuator in all of the flights."""
    first = comparison.flights[0]
    failures = failures_of(first.events)
    same = all(flight.scenario.failures == first.scenario.failures for flight in comparison.flights)
    if not failures or not same or not first.scenario.failures[failures[0].number].actuator:
        return ""
    more = f", and {len(failures) - 1} more" if len(failures) > 1 else ""
    return f"at {failures[0].from_s:g} s {broke(first, failures[0].number)}{more}"
