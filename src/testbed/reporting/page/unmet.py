"""What was not met, and its worst moment: the verdict names it and leads there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from testbed.flight.flight import Flight
from testbed.flight.recovery import UNITS, tracking_error
from testbed.flight.requirements import worst_s
from testbed.reporting.html import Html, joined, tag
from testbed.scenario.requirement import Requirement

_NAMED = 3
"""Requirements that the verdict names; the others are in the table below."""


def unmet(flight: Flight) -> Html:
    """The requirements that were not met, each a link to its worst moment; "" if all were met."""
    links = list(_links(flight))
    if not links:
        return Html("")
    more = [tag("a", f"{len(links) - _NAMED} more", href="#requirements")] if links[_NAMED:] else []
    return joined([" Not met: ", joined([*links[:_NAMED], *more], "; "), "."])


def _links(flight: Flight) -> Iterator[Html]:
    judged = flight.requirements
    asked = [*flight.scenario.requirements, *[None] * len(judged)]  # another version may have judged others
    for requirement, verdict in zip(asked, judged, strict=False):
        if verdict["passed"] is False:
            time_s = moment_s(requirement, flight.signals)
            at = "" if time_s is None else f", worst at {time_s:.1f} s"
            name = verdict["name"]
            yield tag(
                "a", name, at, href="#requirements", data_go=None if time_s is None else f"{time_s:.3f}"
            )


def moment_s(requirement: Requirement | None, log: Mapping[str, np.ndarray]) -> float | None:
    """When a requirement was furthest from being met [s]; of an error's metric, when that error was largest. None if unknown."""
    if requirement is None:
        return None
    if requirement.metric is None:
        return worst_s(requirement, log)
    quantity = next((q for q in UNITS if requirement.metric.startswith(f"{q}_error")), None)
    return None if quantity is None else _largest_s(np.abs(tracking_error(log, quantity)), log["time_s"])


def _largest_s(values: np.ndarray, time_s: np.ndarray) -> float | None:
    return float(time_s[np.nanargmax(values)]) if np.isfinite(values).any() else None


def told(flight: Flight, verdict: Mapping[str, Any]) -> str:
    """When a requirement that was judged so was furthest from being met, in words for a terminal; "" if that is unknown."""
    number = list(flight.requirements).index(verdict)
    asked = flight.scenario.requirements
    time_s = moment_s(asked[number], flight.signals) if number < len(asked) else None
    return "" if time_s is None else f", worst at {time_s:.1f} s"
