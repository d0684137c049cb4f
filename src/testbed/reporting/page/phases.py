"""The phases of a flight: healthy, broken and unnoticed, flagged, recovered, lost."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from testbed.flight.recovery import failure_times_s


def phases(events: Sequence[Mapping[str, Any]], end_s: float, planned_s: float) -> list[dict[str, Any]]:
    """{name, from_s, until_s} of each phase, in order, without gaps.

    From a failure on the flight is `unnoticed` until an actuator is flagged, `flagged` from then on, and `recovered` once it has
    recovered and, if anything is ever flagged for this failure, been flagged. A flight that ended early is `lost` from its end
    to where it should have ended.

    Args:
        end_s: when the flight ended [s].
        planned_s: how long it should have been [s].
    """
    found: list[tuple[float, str]] = [(0.0, "healthy")]
    for begin, end in pairwise([*failure_times_s(events), end_s]):
        flagged = _first(events, "detection", begin, end)
        recovered = _first(events, "recovered", begin, end)
        found.append((begin, "unnoticed"))
        if flagged is not None:
            found.append((flagged, "flagged"))
        if recovered is not None:
            found.append((max(recovered, flagged if flagged is not None else recovered), "recovered"))
    ends = [time for time, _ in found[1:]] + [end_s]
    made = [
        {"name": name, "from_s": begin, "until_s": end}
        for (begin, name), end in zip(found, ends, strict=True)
        if end > begin
    ]
    if any(event["kind"] == "lost" for event in events):
        made.append({"name": "lost", "from_s": end_s, "until_s": max(planned_s, end_s)})
    return made


def _first(events: Sequence[Mapping[str, Any]], kind: str, begin: float, end: float) -> float | None:
    times = (e["time_s"] for e in events if e["kind"] == kind and begin <= e["time_s"] < end)
    return next(times, None)
