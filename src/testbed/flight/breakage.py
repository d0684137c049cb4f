"""What is broken, and since when; did the aircraft recover, and when did the controller notice? Decided here for events, metrics
and reports alike, from the true state and the injections.

A failure is active from the receipt of its injection to that of its end, or to the end of the flight (`failures_of`).

An actuator is broken in a row of the log if either holds:

- It is lost: its true effectiveness is LOST or less, whatever the cause.
- A failure of it is active that is not of type `effectiveness`. If several are active, the actuator is broken until the
  last of them ends.

An actuator with reduced effectiveness above LOST is not broken: the controller is to estimate it, not to flag it.

A `property` failure names no actuator. It is a failure of an actuator if all properties that it holds lie in that
actuator's block of the JSBSim model; the injection's receipt then names the actuator (`testbed.injection`). Otherwise it
breaks no actuator, although it may disturb several.

An aircraft has recovered from a failure at the first instant, not before the failure began, from which altitude and heading
stay within RECOVERED of their references until the next failure or the end of the flight. They must stay there for at least
DWELL_S; an aircraft that was lost before the next failure has not recovered.

A controller has noticed a failure when it flagged an actuator, when its estimate has gone half of the way to the truth, or when it
took the broken actuator for anything but one that works. What it does not notice it may still hold: that is no recovery.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.failures import Failure
from testbed.failures.losses import LOST as LOST
from testbed.flight.columns import Events, Log, beliefs, row_at, stays_from, stretches

if TYPE_CHECKING:
    from testbed.flight.flight import Flight


class ActiveFailure(NamedTuple):
    """A failure of a flight, and when it was active.

    `until_s` is infinite where it lasted to the end of the flight. `verified` says whether its effect was observed; None where it
    cannot be. `stayed` says whether what it wrote stayed as written.
    """

    number: int
    """Its place in `Scenario.failures`."""
    type: str
    actuator: str
    """The actuator that it breaks; empty where there is none."""
    from_s: float
    until_s: float
    verified: bool | None
    stayed: bool

    def rows(self, log: Log) -> slice:
        """The rows of a log in which it was active."""
        return slice(row_at(log["time_s"], self.from_s), row_at(log["time_s"], self.until_s))


def failures_of(events: Iterable[Mapping[str, Any]]) -> list[ActiveFailure]:
    """The failures that began in a flight, from its events, in order of time."""
    found: list[ActiveFailure] = []
    latest: dict[int, int] = {}  # place in `found` of the last start of each failure
    for event in (event for event in events if event["kind"] == "injection"):
        number = event.get("failure", 0)
        if event.get("active", True):
            latest[number] = len(found)
            who, seen = event.get("actuator") or "", event.get("verified", True)
            kind, wrote = event.get("type", ""), stayed(event)
            found.append(ActiveFailure(number, kind, who, event["time_s"], math.inf, seen, wrote))
        elif number in latest:
            found[latest[number]] = found[latest[number]]._replace(until_s=event["time_s"])
    return found


def stayed(start: Mapping[str, Any]) -> bool:
    """Whether what a failure wrote stayed as written, from the receipt of its start: if not, no response was compared."""
    return start.get("verified", True) is not False or start.get("effect") is not None


def failure_times_s(events: Iterable[Mapping[str, Any]]) -> list[float]:
    """Times at which failures began, each once, in order [s]."""
    return sorted({failure.from_s for failure in failures_of(events)})


def lost(log: Log, actuator: str) -> np.ndarray:
    """[rows] True while the actuator's true effectiveness is LOST or less."""
    return np.asarray(log[f"{actuator}_effectiveness"] <= LOST)


def broken(log: Log, actuator: str, injections: Events) -> np.ndarray:
    """[rows] True while the actuator is broken (see the module); `injections` are the events of this kind."""
    rows = lost(log, actuator).copy()
    for failure in failures_of(injections):
        if failure.actuator == actuator and failure.type != "effectiveness":
            rows[failure.rows(log)] = True
    return rows


def response(
    log: Log, actuator: str, active: Iterable[ActiveFailure], failures: Sequence[Failure]
) -> np.ndarray:
    """[rows] What the actuator truly does for its command: 1 healthy, 0 nothing, -1 the opposite, NaN while it does not follow.

    `active` are the failures of the flight (`failures_of`), `failures` those of its scenario.
    """
    rows = log[f"{actuator}_effectiveness"].copy()
    for failure in active:
        if failure.actuator == actuator and failure.number < len(failures):
            rows[failure.rows(log)] *= failures[failure.number].response
    return rows


def broken_since(log: Log, actuator: str, injections: Events) -> np.ndarray:
    """[rows] Time at which the actuator broke [s]; NaN while it is not broken.

    While the actuator is lost, this is the time at which its effectiveness fell to LOST. So the detection delay of an
    actuator that decays slowly does not count from the start of the decay. Otherwise it is the first row of the unbroken
    stretch of rows in which the actuator is broken.
    """
    since = np.full(len(log["time_s"]), math.nan)
    for rows in (broken(log, actuator, injections), lost(log, actuator)):
        for first, end in stretches(rows):
            since[first:end] = log["time_s"][first]
    return since


RECOVERED = {"altitude": 5.0, "heading": 15.0}
"""Largest distance from the reference at which the aircraft counts as recovered [m, deg]. Gusts of moderate turbulence alone
move an aircraft of 5 kg by 3 m and 6 deg, so a narrower limit would judge the weather."""
DWELL_S = 5.0
"""Shortest time within RECOVERED that counts [s]."""
UNITS = {"altitude": "m", "airspeed": "m_s", "heading": "deg"}
"""Units, as in the names of the log's columns, of the quantities that follow references."""


def tracking_error(log: Log, quantity: str) -> np.ndarray:
    """[rows] altitude, airspeed or heading minus its reference [m, m/s, deg]; headings the short way round."""
    unit = UNITS[quantity]
    error: np.ndarray = log[f"{quantity}_{unit}"] - log[f"{quantity}_command_{unit}"]
    return wrap_deg(error) if quantity == "heading" else error


def recoveries(log: Log, failures_s: Sequence[float], survived: bool) -> list[tuple[float, float | None]]:
    """(time at which a failure began, time at which the aircraft had recovered from it or None) of each failure [s].

    `failures_s` are the times at which failures began, in order [s]; `survived` says whether the aircraft was flown to the end.
    """
    time = log["time_s"]
    # A value that is not a number compares as false, so it does not count as within the limits.
    inside = np.all([np.abs(tracking_error(log, q)) <= limit for q, limit in RECOVERED.items()], axis=0)
    found: list[tuple[float, float | None]] = []
    rows = [*(row_at(time, begin) for begin in failures_s), len(time)]
    for begin, (first, end) in zip(failures_s, pairwise(rows), strict=True):
        lost = end == len(time) and not survived
        row = None if lost else stays_from(inside, first, end)
        enough = row is not None and time[end - 1] - time[row] >= DWELL_S
        found.append((begin, float(time[row]) if row is not None and enough else None))
    return found


def recovery_events(log: Log, injections: Events, survived: bool) -> Iterator[dict[str, Any]]:
    """An event for each failure from which the aircraft recovered; `after_s` is the time since that failure began."""
    for begin, recovered in recoveries(log, failure_times_s(injections), survived):
        if recovered is not None:
            yield {"time_s": recovered, "kind": "recovered", "after_s": recovered - begin}


_LOSS = 0.1  # of effect, that an estimate is to find


def noticed_s(flight: Flight) -> list[float]:
    """Times at which it noticed something that was broken, in order [s]."""
    log, failures = flight.signals, failures_of(flight.events)
    flags = [event["time_s"] for event in flight.events if event["kind"] == "detection"]
    taken = [
        b["time_s"]
        for b in signs(log, {failure.actuator for failure in failures if failure.actuator})
        if any(f.actuator == b["actuator"] and f.from_s <= b["time_s"] < f.until_s for f in failures)
    ]
    return sorted([*flags, *taken, *_estimated(log, failures)])


def signs(log: Mapping[str, np.ndarray], actuators: Iterable[str]) -> list[dict[str, Any]]:
    """The beliefs (see `flight.columns.beliefs`) that say that something is broken."""
    return [b for b in beliefs(log, actuators) if b["belief"] not in ("works", "doubted")]


def unnoticed(log: Mapping[str, np.ndarray], failures: Iterable[ActiveFailure]) -> list[ActiveFailure]:
    """Those of some failures of actuators of which the log's columns [rows] have no sign while they were active."""
    return [failure for failure in failures if not _seen(log, failure)]


def _seen(log: Mapping[str, np.ndarray], failure: ActiveFailure) -> bool:
    first, end = (row_at(log["time_s"], t) for t in (failure.from_s, failure.until_s))
    flagged = log.get(f"{failure.actuator}_failed")  # a summary may name what the log does not have
    return (
        (flagged is not None and bool(np.any(flagged[first:end] > 0.0)))
        or any(
            b["time_s"] < failure.until_s and b["until_s"] >= failure.from_s
            for b in signs(log, [failure.actuator])
        )
        or next(_estimated(log, [failure]), None) is not None
    )


def _estimated(log: Mapping[str, np.ndarray], failures: Sequence[ActiveFailure]) -> Iterator[float]:
    """When the estimate of each broken actuator was first half of the way from what it was to the truth."""
    for failure in failures:
        true, estimate = (
            log.get(f"{failure.actuator}_{of}") for of in ("effectiveness", "effectiveness_estimate")
        )
        if true is None or estimate is None:
            continue
        first, end = (row_at(log["time_s"], t) for t in (failure.from_s, failure.until_s))
        before = estimate[max(first - 1, 0)]
        loss = np.abs(true[first:end] - before)
        found = (loss > _LOSS) & (np.abs(estimate[first:end] - before) >= 0.5 * loss)
        if found.any():
            yield float(log["time_s"][first + int(found.argmax())])
