"""How much the actuators were moved, and how long their commands were at the stops."""

from __future__ import annotations

import math

import numpy as np

from testbed.flight.events import at_stops
from testbed.metrics.flight_view import Readings


def control_effort_per_s(readings: Readings) -> float:
    """Integral of the squared rates of all commands, each in units of its actuator's scale [1/s].

    Computed as the sum over actuators and rows of (change of command / scale)^2 / (time between rows). A step of a command
    therefore counts for more if the control step is shorter. NaN if an actuator's scale is not known.
    """
    total = 0.0
    for name, facts in readings.actuators.items():
        change = np.diff(readings.log[f"{name}_command"])
        total += float(np.square(change).sum()) / float(facts.get("scale", math.nan)) ** 2
    return total / readings.step_s if readings.step_s else math.nan


def saturated_time_s(readings: Readings) -> float:
    """Time during which the command of some actuator that is not flagged is at a stop, to 0.1 % of its travel [s].

    NaN if an actuator's stops are not known.
    """
    saturated = np.zeros(len(readings.time_s), dtype=bool)
    for name, facts in readings.actuators.items():
        if "limits" not in facts:
            return math.nan
        at_low, at_high = at_stops(readings.log[f"{name}_command"], *facts["limits"])
        saturated |= (at_low | at_high) & ~(readings.log[f"{name}_failed"] > 0.0)
    return float(np.count_nonzero(saturated) * readings.step_s)


TABLE = (control_effort_per_s, saturated_time_s)
