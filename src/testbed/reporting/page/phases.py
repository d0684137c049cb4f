"""The phases of a flight: healthy, broken and unnoticed, flagged, recovered, lost."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from testbed.flight.breakage import ActiveFailure, failure_times_s, failures_of


def phases(events: Sequence[Mapping[str, Any]], end_s: float, planned_s: float) -> list[dict[str, Any]]:
    """{name, from_s, until_s} of each phase, in order, without gaps.

    From a failure on the flight is `unnoticed` until an actuator is flagged, `flagged` from then on, and `recovered` once it has
    recovered and, if anything is ever flagged for this failure, been flagged. Once a failure ends that was neither, the phase
    is what is left of the earlier ones: `flagged` if what is broken is, `unnoticed` if not, `healthy` if nothing is broken.
    A flight that ended early is `lost` from its end to where it should have ended.

    Args:
        end_s: when the flight ended [s].
        planned_s: how long it should have been [s].
    """
    found: list[tuple[float, str]] = [(0.0, "healthy")]
    failures = failures_of(events)
    for begin, end in pairwise([*failure_times_s(events), end_s]):
        flagged = _first(events, "detection", begin, end)
        recovered = _first(events, "recovered", begin, end)
        found.append((begin, "unnoticed"))
        if flagged is not None:
            found.append((flagged, "flagged"))
        if recovered is not None:
            found.append((max(recovered, flagged if flagged is not None else recovered), "recovered"))
        if flagged is None and recovered is None:
            for time in sorted({failure.until_s for failure in failures if begin < failure.until_s < end}):
                name = _phase_of([f for f in failures if f.from_s <= time < f.until_s], events, time)
                found.extend([(time, name)] if name != "unnoticed" else [])
    ends = [time for time, _ in found[1:]] + [end_s]
    made = [
        {"name": name, "from_s": begin, "until_s": end}
        for (begin, name), end in zip(found, ends, strict=True)
        if end > begin
    ]
    if any(event["kind"] == "lost" for event in events):
        made.append({"name": "lost", "from_s": end_s, "until_s": max(planned_s, end_s)})
    return made


def _phase_of(broken: Sequence[ActiveFailure], events: Sequence[Mapping[str, Any]], time_s: float) -> str:
    """The phase that the failures make which are active after this time."""
    if not broken:
        return "healthy"
    return "flagged" if all(_noticed(events, failure, time_s) for failure in broken) else "unnoticed"


def _noticed(events: Sequence[Mapping[str, Any]], failure: ActiveFailure, time_s: float) -> bool:
    """Whether the failure's actuator was flagged from its beginning to this time."""
    return any(
        e["kind"] == "detection" and e["actuator"] == failure.actuator
        and failure.from_s <= e["time_s"] <= time_s
        for e in events
    )  # fmt: skip


def _first(events: Sequence[Mapping[str, Any]], kind: str, begin: float, end: float) -> float | None:
    times = (e["time_s"] for e in events if e["kind"] == kind and begin <= e["time_s"] < end)
    return next(times, None)
