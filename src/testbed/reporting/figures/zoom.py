"""The time around the first failure, which figures show beside the whole flight: a flag may come 0.1 s after the failure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from testbed.flight.breakage import failure_times_s

_BEFORE_S, _AFTER_S, _LONGEST_S = 0.5, 2.5, 10.0
_WORTH = 0.4  # part of the flight from which on a zoom shows nothing more than the flight does
_ANSWERS = ("detection", "release")


def zoom_span(events: Sequence[Mapping[str, Any]], end_s: float) -> tuple[float, float] | None:
    """(from, until) [s] around the first failure and what the controller made of it; None where there is nothing to zoom into.

    Args:
        events: those of the flight.
        end_s: when the flight ended [s].
    """
    times = failure_times_s(events)
    if not times:
        return None
    begin, longest = times[0], times[0] + _LONGEST_S
    answers = [
        e["time_s"] for e in events if e["kind"] in _ANSWERS and begin <= e["time_s"] <= longest - _AFTER_S
    ]
    first, last = max(begin - _BEFORE_S, 0.0), min(max([begin, *answers[:3]]) + _AFTER_S, end_s)
    return (first, last) if 0.0 < last - first < _WORTH * end_s else None
