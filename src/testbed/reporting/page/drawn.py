"""What the picture of a flight is drawn from, in a page of one flight and of several: its phases above all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from testbed.aircraft.conventional_shape import conventional
from testbed.common.signals import Belief
from testbed.flight.breakage import ActiveFailure, failure_times_s, failures_of
from testbed.flight.flight import Flight
from testbed.reporting.noticing import noticed_s
from testbed.reporting.panels import has_estimates

_REPLAYED = ("north_m", "east_m", "altitude_m", "airspeed_m_s", "roll_deg", "pitch_deg", "heading_deg")


def can_be_replayed(log: Mapping[str, np.ndarray]) -> bool:
    """Whether a log says where the aircraft was and how it lay, in more than one row: else there is no picture of it."""
    return len(log["time_s"]) > 1 and all(name in log for name in _REPLAYED)


def drawn(flight: Flight, log: Mapping[str, np.ndarray]) -> dict[str, Any]:
    """Phases, failures, actuators, the words of beliefs, and the shape, as `web/src/scene.js` and `timeline.js` read them."""
    planned_s = flight.scenario.duration_s
    return {
        "phases": phases(flight.events, flight.end_time_s, planned_s, noticed_s(flight)),
        "failures_s": failure_times_s(flight.events),
        "actuators": flight.actuators,
        "beliefs": {belief.value: belief.name for belief in Belief},
        "estimates": has_estimates(log, flight.actuators),
        "shape": (flight.shape or conventional()).model_dump(),
    }


def phases(
    events: Sequence[Mapping[str, Any]], end_s: float, planned_s: float, noticed_s: Sequence[float]
) -> list[dict[str, Any]]:
    """{name, from_s, until_s} of each phase, in order, without gaps.

    From a failure on the flight is `unnoticed` until it is noticed, and `flagged` from then on. Once it has left the limits of a
    recovery and come back to stay, it is `recovered`, not before it has noticed if it ever does. A flight that never left them is
    `held` from where it noticed the failure, and `unseen` all the time if it never did: it held without noticing.
    Once a failure ends that was none of these, the phase is what is left of the earlier ones: `flagged` if what is broken was
    noticed, `unnoticed` if not, `healthy` if nothing is broken.
    A flight that ended early is `lost` from its end to where it should have ended (`planned_s`). `noticed_s` are the times at which
    something broken was noticed, in order.
    """
    found: list[tuple[float, str]] = [(0.0, "healthy")]
    failures = failures_of(events)
    for begin, end in pairwise([*failure_times_s(events), end_s]):
        noticed = next((time for time in noticed_s if begin <= time < end), None)
        back = next((e for e in events if e["kind"] == "recovered" and begin <= e["time_s"] < end), None)
        found.append((begin, "unnoticed"))
        if noticed is not None:
            found.append((noticed, "flagged"))
        if back is not None:
            since = back["time_s"] if noticed is None else max(back["time_s"], noticed)
            within = "unseen" if noticed is None else "held"
            found.append((since, "recovered" if back["after_s"] else within))
        if noticed is None and back is None:
            for time in sorted({failure.until_s for failure in failures if begin < failure.until_s < end}):
                name = _phase_of([f for f in failures if f.from_s <= time < f.until_s], events, time)
                found.extend([(time, name)] if name != "unnoticed" else [])
    made = [
        {"name": name, "from_s": begin, "until_s": end}
        for (begin, name), (end, _) in pairwise([*found, (end_s, "")])
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
