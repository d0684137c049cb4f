"""An agent outside of the loop as a controller: in each control step it commands what was set last."""
# mypy: allow-untyped-defs

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from testbed.common.jit import bound, compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.setup import Setup
from testbed.env.cockpit import Cockpit


class Agent:
    """Made once for a flight, and given to `Session` as the class of a controller is: called with the set-up it is the controller.

    Attributes:
        cockpit: what the agent sees and does; there once the flight is assembled.
    """

    reasons: Sequence[tuple[int, str]] = ()
    cockpit: Cockpit

    def __call__(self, setup: Setup) -> Agent:
        """Take what a controller is told before the flight."""
        self.cockpit = Cockpit(setup)
        self._model, self._memory = model_record(setup), trimmed_memory(setup)
        self._dt = setup.dt_s
        self._commands = memoryview(self._memory[0].command)
        return self

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """See `controllers.Controller`."""
        n = len(self._commands)
        telemetry[:, 2 * n : 3 * n] = 1.0  # as of every controller that estimates nothing
        self._parts = (self._dt, states, telemetry, self._model, self._memory)
        self._write = bound(write_commands, 0, self._parts)

    def act(self, action: np.ndarray) -> None:
        """Set the action [n] that is flown from the next control step on."""
        self._memory[0].command[:] = self.cockpit.command(action)

    def step(self, step: int) -> memoryview:
        """See `controllers.Controller`."""
        self._write(step, self._parts)
        return self._commands


@compiled
def write_commands(k, parts):
    """Log reference and command of control step k: of servos as commanded, of motors the thrust of the modelled motor."""
    dt, states, telemetry, models, memories = parts
    m, s, row, n = models[0], memories[0], telemetry[k], len(memories[0].command)
    advance_actuators(dt, axial_speed(states[k]), m, s)
    for i in range(n):
        row[i] = row[n + i] = s.command[i] / m.scale[i] if m.servo[i] else s.position[i]
