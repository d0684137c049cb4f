"""The panels that `reporting.panels` declares, as `web/src/panels.js` draws them: groups, columns, bands of requirements."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.columns import row_at, stretches
from testbed.flight.flight import Flight
from testbed.reporting.panels import GROUPS, TRACKED, Panel
from testbed.scenario.requirement import Requirement

SHOWN = ("errors", "effectiveness", "actuators", "own", "attitude", "rates")
"""The groups of `reporting.panels` on the page of a flight."""
_NOTES = 2  # of a panel that its title has, the last ones
_STYLES = {"position": "truth", "reference": "command"}
"""Styles of the figures that are another on the page."""


def groups(flight: Flight, log: Mapping[str, np.ndarray]) -> list[dict[str, Any]]:
    """{name, title, folded, panels} of each group that has panels, from the columns of `panels.shown_log`."""
    made = [
        group_of(name, GROUPS[name].title, GROUPS[name].folded, GROUPS[name].of(flight)) for name in SHOWN
    ]
    for panel in made[0]["panels"]:
        panel |= _verdicts(flight, panel["series"][0]["column"], log)
    return [group for group in made if group["panels"]]


def group_of(name: str, title: str, folded: bool, panels: Iterable[Panel]) -> dict[str, Any]:
    """A group for the page's script."""
    drawn = [_drawn(panel) for panel in panels]
    return {"name": name, "title": title, "folded": folded, "panels": drawn}


def _drawn(panel: Panel) -> dict[str, Any]:
    notes = (
        f"{words} from {since:.1f} {'s on' if math.isinf(until) else f'to {until:.1f} s'}"
        for since, until, words in panel.notes[-_NOTES:]
    )
    said: dict[str, Any] = {
        "title": "; ".join([panel.heading, *notes]),
        "series": [
            {"column": each.column, "label": each.label, "style": _STYLES.get(each.style, each.style)}
            for each in panel.series
            if each.on_page
        ],
        "least": panel.least,
        "limits": list(panel.levels or ()),
    }
    return said if panel.span is None else {**said, "range": list(panel.span)}


def _verdicts(flight: Flight, column: str, log: Mapping[str, np.ndarray]) -> dict[str, list[dict[str, Any]]]:
    """Bands of the requirements on an error, and the stretches in which it is outside of them."""
    of = next(of for of in TRACKED.values() if of.error == column)
    time, error, end_s = log["time_s"], log[column], float(log["time_s"][-1])
    bands: list[dict[str, Any]] = []
    missed: list[dict[str, Any]] = []
    for requirement, verdict in zip(flight.scenario.requirements, flight.requirements, strict=False):
        limit = requirement.within
        if limit is None or requirement.of != of.reference:
            continue
        begin, end = requirement.begins_s, end_s if requirement.until_s is None else requirement.until_s
        bands.append(
            {"from_s": begin, "until_s": end, "low": -limit, "high": limit, "passed": verdict["passed"]}
        )
        if not (requirement.eventually and verdict["passed"]):
            rows = slice(row_at(time, begin), row_at(time, end))
            missed += _missed(
                requirement, time[rows], wrap_deg(error[rows]) if of is TRACKED["heading"] else error[rows]
            )
    return {"bands": bands, "missed": missed}


def _missed(requirement: Requirement, time: np.ndarray, error: np.ndarray) -> Iterator[dict[str, float]]:
    """The stretches outside of a requirement that are longer than it allows."""
    longest = requirement.never_for_longer_than_s or 0.0
    outside = ~(np.abs(error) <= float(requirement.within or 0.0))
    for first, last in stretches(outside):
        if time[last - 1] - time[first] >= longest:
            yield {"from_s": float(time[first]), "until_s": float(time[last - 1])}
