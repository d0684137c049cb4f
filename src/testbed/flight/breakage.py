"""Is this actuator broken, and since when: the one answer, from the truth of the log and the injections.

An actuator is broken in a row of the log while either holds:

- It is lost: its true effectiveness is LOST or less, whatever the cause.
- A failure of it is active that is of any type but `effectiveness`, from its start to its end. Several at once count
  each: the actuator is broken until the last of them ends. Reduced effectiveness above LOST is not broken: the
  controller is to estimate it, not to flag it.

A `property` failure names no actuator. It is a failure of an actuator if all properties that it holds lie in that
actuator's block of the JSBSim model, as the receipt of the injection says (`testbed.injection`); otherwise it breaks
no actuator, although it may disturb several.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from testbed.flight.columns import row_at, stretches

LOST = 0.1
"""An actuator with this much true effectiveness or less is lost, whatever a controller's own threshold."""


def lost(log: Mapping[str, np.ndarray], actuator: str) -> np.ndarray:
    """[rows] True while the actuator's true effectiveness is LOST or less."""
    return np.asarray(log[f"{actuator}_effectiveness"] <= LOST)


def broken(
    log: Mapping[str, np.ndarray], actuator: str, injections: Iterable[Mapping[str, Any]]
) -> np.ndarray:
    """[rows] True while the actuator is broken, as the module says; `injections` are events of that kind, in order."""
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
    """[rows] When the present breakage began [s]; NaN while the actuator is not broken.

    While the actuator is lost it is the time of the loss, so that one that fades away is not called late for having
    begun to fade. Otherwise it is the start of the stretch in which the actuator is broken without a break.
    """
    since = np.full(len(log["time_s"]), math.nan)
    for rows in (broken(log, actuator, injections), lost(log, actuator)):
        for first, end in stretches(rows):
            since[first:end] = log["time_s"][first]
    return since
