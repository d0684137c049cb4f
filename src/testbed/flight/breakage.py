"""Is an actuator broken, and since when? Decided here for events and metrics alike, from the true state and the injections.

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
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from testbed.flight.columns import row_at, stretches

LOST = 0.1
"""An actuator with this true effectiveness or less is lost. It does not depend on a controller's own threshold."""


def lost(log: Mapping[str, np.ndarray], actuator: str) -> np.ndarray:
    """[rows] True while the actuator's true effectiveness is LOST or less."""
    return np.asarray(log[f"{actuator}_effectiveness"] <= LOST)


def broken(
    log: Mapping[str, np.ndarray], actuator: str, injections: Iterable[Mapping[str, Any]]
) -> np.ndarray:
    """[rows] True while the actuator is broken (see the module); `injections` are the events of this kind, in order of time."""
    rows = lost(log, actuator).copy()
    starts: dict[int, int] = {}
    for event in injections:
        if event["actuator"] == actuator and event["type"] != "effectiveness":
            row = row_at(log["time_s"], event["time_s"])
            if event["active"]:
                starts[event["failure"]] = row
            else:
                rows[starts.pop(event["failure"], row) : row] = True
    for start in starts.values():  # never ended: active to the end of the flight
        rows[start:] = True
    return rows


def broken_since(
    log: Mapping[str, np.ndarray], actuator: str, injections: Iterable[Mapping[str, Any]]
) -> np.ndarray:
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
