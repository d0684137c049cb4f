"""The truth about a flight's actuators, for the controller `informed_inversion` alone.

No other controller sees the plant or the failures. It is told, in each control step, what an ideal diagnosis would find.
"""

from __future__ import annotations

import math

import numpy as np

from testbed.common.signals import STATE
from testbed.controllers.setup import ActuatorTruth
from testbed.injection.injector import Injector
from testbed.plant.jsbsim import Plant


class Truth:
    """Called in a control step, after the plant has been sampled, it returns what is true in that step."""

    def __init__(self, plant: Plant, injector: Injector) -> None:
        self._plant, self._injector = plant, injector
        self._names = tuple(plant.aircraft.actuators)
        servo = [actuator.kind == "servo" for actuator in plant.aircraft.actuators.values()]
        self._unit = np.where(servo, math.radians(1.0), 1.0)

    def __call__(self) -> ActuatorTruth:
        n = len(self._names)
        row = (self._plant.raw * self._plant.factors)[len(STATE) :]
        deaf = {each.actuator for each in self._injector.active if not each.failure.follows_command}
        return ActuatorTruth(
            effectiveness=row[n:].tolist(),
            follows=[name not in deaf for name in self._names],
            position=(row[:n] * self._unit).tolist(),
        )
