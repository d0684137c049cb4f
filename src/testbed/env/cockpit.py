"""What an agent sees and does, in numbers near one: the same in an environment and in a controller that flies a learnt policy.

`Agent` is an agent outside of the loop as a controller: in each control step it commands what was set last.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from testbed.common.angles import wrap
from testbed.common.jit import bound, compiled
from testbed.common.signals import SETPOINT, STATE
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput, Problem

OBSERVED = (
    ("altitude_error", 10.0),  # reference minus measured [m]
    ("airspeed_error", 0.2),  # reference minus measured, as a part of the reference
    ("heading_error", math.radians(30.0)),  # reference minus measured, the short way round
    ("climb_rate", 0.2),  # as a part of the airspeed, as are the next two
    ("altitude_rate", 0.2),  # of the reference
    ("airspeed_rate", 0.2),  # of the reference, in one second
    ("heading_rate", math.radians(10.0)),  # of the reference
    ("roll", math.radians(30.0)),
    ("pitch", math.radians(15.0)),  # from that of trimmed flight
    ("alpha", math.radians(10.0)),
    ("beta", math.radians(10.0)),
    ("p", math.radians(60.0)),
    ("q", math.radians(60.0)),
    ("r", math.radians(60.0)),
)
"""Name of each number of an observation, and what counts as 1 [SI, rad]. Then comes the last action, by the actuators' names."""
MOST = 5.0
"""Observations end here: what is farther off is as bad."""
_SCALE = tuple(scale for _, scale in OBSERVED)
_wrap = compiled(wrap)


class Cockpit:
    """Turns measured states into observations, and actions into commands.

    An action has one number from -1 to 1 for each actuator: 0 commands the trimmed flight in which the flight begins, -1 and 1 the
    stops of a servo, and no or full throttle.

    Attributes:
        names: of the numbers of an observation.
        action: [n] the last one.
    """

    def __init__(self, setup: Setup) -> None:
        n = len(setup.actuators)
        self.names = (*(name for name, _ in OBSERVED), *setup.model.actuators)
        self.action, self._seen = np.zeros(n), np.zeros(len(self.names), np.float32)
        self._pitch = float(setup.trim_pitch)
        self._trim = np.array(setup.trim_commands, dtype=float)
        servo = [kind == "servo" for kind in setup.model.kinds]
        low, high = np.array([(a.low, a.high) for a in setup.actuators]).T
        self._down = self._trim - np.where(servo, low, 0.0)
        self._up = np.where(servo, high, 1.0) - self._trim
        example = (self._pitch, np.zeros(len(STATE)), np.zeros(len(SETPOINT)), self.action, self._seen)
        self._see = bound(see, example)

    def observe(self, state: Sequence[float], reference: Sequence[float]) -> np.ndarray:
        """The observation [14 + n], float32, from -MOST to MOST.

        Args:
            state: measured, by `signals.STATE`, in SI and radians.
            reference: by `signals.SETPOINT`.
        """
        rows = np.array(state, dtype=float), np.array(reference, dtype=float)
        self._see((self._pitch, *rows, self.action, self._seen))
        return self._seen.copy()

    def command(self, action: Sequence[float] | np.ndarray) -> np.ndarray:
        """Commands [n] of an action [n]: servos in radians, motors as throttle; beyond -1 and 1 it is cut.

        Raises BadInput for one that is not finite or has another shape.
        """
        a = np.array(action, dtype=float)
        if a.shape != self._trim.shape or not all(map(math.isfinite, a.tolist())):
            raise BadInput([Problem(f"is {a}", "action", expected=f"{len(self._trim)} finite numbers")])
        self.action[:] = a.clip(-1.0, 1.0, out=a)
        return self._trim + np.where(a < 0.0, self._down, self._up) * a


@compiled
def see(parts):
    """Fill an observation; what is not finite is as far off as can be seen.

    Args:
        parts: pitch of trimmed flight [rad], state [17], reference [6], action [n], observation [14 + n] to be filled.
    """
    pitch, y, ref, action, seen = parts
    altitude, airspeed, climb_rate, heading = y[2], y[3], y[4], y[7]
    seen[0] = ref[0] - altitude
    seen[1] = 1.0 - airspeed / ref[1]
    seen[2] = _wrap(ref[2] - heading)
    seen[3], seen[4], seen[5] = climb_rate / ref[1], ref[3] / ref[1], ref[4] / ref[1]
    seen[6] = ref[5]
    seen[7], seen[8] = y[5], y[6] - pitch
    for i in range(5):  # alpha, beta, p, q, r
        seen[9 + i] = y[8 + i]
    for i in range(len(seen)):
        x = seen[i] / _SCALE[i] if i < len(_SCALE) else action[i - len(_SCALE)]
        seen[i] = min(max(x, -MOST), MOST) if math.isfinite(x) else MOST


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
