"""What is broken, and since when? Decided here for events, metrics and reports alike, from the true state and the injections.

A failure is active from the receipt of its injection to that of its end, or to the end of the flight (`failures_of`).

An actuator is broken in a row of the log if either holds:

- It is lost: its true effectiveness is LOST or less, whatever the cause.
- A failure of it is active that is not of type `effectiveness`. If several are active, the actuator is broken until the
  last of them ends.

An actuator with reduced effectiveness above LOST is not broken: the controller is to estimate it, not to flag it.

A `property` failure names no actuator. It is a failure of an actuator if all properties that it holds lie in that
actuator's block of the JSBSim model; the injection's receipt then names the actuator (`testbed.injection`). Otherwise it
breaks no actuator, although it may disturb several.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from testbed.failures import Failure
from testbed.failures.losses import LOST as LOST
from testbed.flight.columns import Events, Log, row_at, stretches


class ActiveFailure(NamedTuple):
    """A failure of a flight, and when it was active.

    `until_s` is infinite where it lasted to the end of the flight. `verified` says whether its effect was observed; None where it
    cannot be.
    """

    number: int
    """Its place in `Scenario.failures`."""
    type: str
    actuator: str
    """The actuator that it breaks; empty where there is none."""
    from_s: float
    until_s: float
    verified: bool | None

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
            found.append(ActiveFailure(number, event.get("type", ""), who, event["time_s"], math.inf, seen))
        elif number in latest:
            found[latest[number]] = found[latest[number]]._replace(until_s=event["time_s"])
    return found


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
