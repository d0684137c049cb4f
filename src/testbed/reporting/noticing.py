"""When a controller noticed what was broken, for all that says so in words or colours.

It has noticed a failure when it flagged an actuator, when its estimate has gone half of the way to the truth, or when it took the
broken actuator for anything but one that works. What it does not notice it may still hold: that is no recovery.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from testbed.flight.breakage import ActiveFailure, failures_of
from testbed.flight.columns import beliefs, row_at
from testbed.flight.flight import Flight

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
