"""Throttle for a thrust, for controllers of one's own: commands of motors are throttles, but control laws work with thrust."""

from __future__ import annotations

import math

from testbed.controllers.commands import command_actuators
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.setup import Setup
from testbed.controllers.user.adapter import State
from testbed.inputs.problems import BadInput, Problem, did_you_mean, one_of


class Throttle:
    """Finds the throttle of a motor at which the design model gives a thrust in steady flight.

    throttle = Throttle(setup)                      # once, in __init__
    throttle("motor", 4.0, state)                   # in update
    """

    def __init__(self, setup: Setup) -> None:
        self._model, self._memory = model_record(setup)[0], trimmed_memory(setup)[0]
        names = setup.model.actuators
        self._motors = {name: i for i, name in enumerate(names) if setup.model.kinds[i] != "servo"}

    def __call__(self, actuator: str, thrust_n: float, state: State) -> float:
        """Throttle, 0 to 1. Where none gives this thrust it is 1, or the throttle of the least thrust that the model knows.

        Args:
            actuator: name of a motor or engine.
            thrust_n: wanted thrust, if the actuator is fully effective [N].
            state: as given to `update`; its airspeed along the propeller's axis counts.

        Raises:
            BadInput: the aircraft has no motor or engine of this name.
        """
        if actuator not in self._motors:
            what, near = f"{actuator!r} is no motor of this aircraft", did_you_mean(actuator, self._motors)
            raise BadInput([Problem(what, expected=one_of(self._motors), suggestion=near)])
        i, m, s = self._motors[actuator], self._model, self._memory
        s.u[i] = thrust_n / m.scale[i]
        command_actuators(state.airspeed * math.cos(state.alpha) * math.cos(state.beta), m, s)
        return float(s.command[i])
