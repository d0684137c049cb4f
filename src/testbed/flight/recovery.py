"""Did the aircraft recover from a failure, and when? Decided here for events, metrics and reports alike.

An aircraft has recovered from a failure at the first instant, not before the failure began, from which altitude and heading
stay within RECOVERED of their references until the next failure or the end of the flight. They must stay there for at least
DWELL_S; an aircraft that was lost before the next failure has not recovered.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.breakage import failure_times_s
from testbed.flight.columns import Events, Log, row_at, stays_from

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
