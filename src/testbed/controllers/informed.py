"""Controllers that are told the truth: the inversion law with the true state of every actuator in each control step.

They estimate nothing. True effectiveness takes the place of the estimates, and true failures that of the flags. What they are told,
by `Setup.truth`, no other controller has. None is a bound by itself: the law's choices after a failure, such as which axis is given
up, may be worse than others. So there are several choices, and the best of them and of all controllers in a flight is taken for
what could be held in it (`rivals.INFORMED`).

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import write_diagnosis, write_telemetry
from testbed.controllers.config import InformedSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.jam_detection import REDESIGN_AFTER
from testbed.controllers.inversion.law import measured_error, pressure_ratio_of, state_function
from testbed.controllers.inversion.step import add_unused, regression
from testbed.controllers.outer_loops import virtual_control
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput, Problem


@compiled
def informed_step(step, parts):
    """Invert and command for one measured state with what `InformedController` has written into the memory; returns 0.

    With `c.adapts` (`increments`), the measured error (10) is taken from nu: it is then what the truth about the actuators leaves
    unexplained.
    """
    states, setpoints, telemetry, models, settings, modes, memories, works, _ = parts
    y, ref, w = states[step], setpoints[step], works[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    pressure_ratio, axial = pressure_ratio_of(y, m), axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    state_function(y, m, w.f)
    if c.adapts:
        regression(y, pressure_ratio, m, c, s, w)
        measured_error(w.z, w.phi, s, w.e)  # (10)
    add_unused(w.f, pressure_ratio, m, k, s)
    virtual_control(y, ref, m, c, k, s, w)
    for i in range(4):
        w.nu[i] -= w.e[i]  # zero without `increments`
    allocate_and_command(w.nu, pressure_ratio, axial, m, c, k, s, w)
    write_telemetry(telemetry[step], k.released, s)
    write_diagnosis(telemetry[step], c, s)
    return 0


class InformedController(InversionController):
    """The inversion law without estimation and monitor; before each of its steps the truth is written into its memory.

    Raises:
        BadInput: the set-up has no `truth`; otherwise as in `InversionController`.
    """

    def __init__(self, setup: Setup) -> None:
        self._chosen = chosen = setup.settings_as(InformedSettings)
        if setup.truth is None:
            what = f"{chosen.type} is told the truth by the simulation, and this set-up has none"
            raise BadInput([Problem(what, path="controller.type", expected="a flight of `testbed.fly`")])
        self._truth, self._setup = setup.truth, setup
        settings = settings_record(setup, None)
        settings[0].estimates = settings[0].monitors = True  # it is told: this is what it believes
        settings[0].adapts, settings[0].filter_rate = chosen.increments, chosen.filter_rad_s
        super().__init__(setup, settings, informed_step)
        self._broken_s = [0.0] * len(setup.actuators)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        if self._learn():
            if self._chosen.keeps_axes:
                self._keep_axes()
            else:
                self.switch(step)
        return super().step(step)

    def _learn(self) -> bool:
        """Write the truth into the law's memory; returns whether the mode must be put in force anew."""
        s, scale, changed = self.memory[0], self._setup.scale, False
        for i, (effectiveness, follows, position) in enumerate(zip(*self._truth(), strict=True)):
            lost = effectiveness <= self._chosen.threshold
            broken = lost or not follows
            self._broken_s[i] = self._broken_s[i] + self._setup.dt_s if broken else 0.0
            known = broken and self._broken_s[i] > self._chosen.patience_s
            flags = (int(known), int(known and not lost))
            changed = changed or flags != (s.failed[i], s.jammed[i])
            s.failed[i], s.jammed[i] = flags
            s.lambda_hat[i] = effectiveness * (position / scale[i] if s.jammed[i] else 1.0)
            changed = changed or bool(
                s.jammed[i] and abs(s.lambda_hat[i] - s.designed_position[i]) > REDESIGN_AFTER
            )
        return changed

    def _keep_axes(self) -> None:
        """Go on with all axes: the actuators that remain share them by the weights of the allocation."""
        k, s, setup = self._modes.record[0], self.memory[0], self._setup
        k.available[:] = s.failed == 0
        s.designed_position[:] = s.lambda_hat
        used = np.flatnonzero(k.available)
        weighted = np.array(setup.model.input_matrix)[:4].T * setup.scale[:, None] * k.row_weight
        k.B_hat_inv[:] = 0.0
        k.B_hat_inv[used] = np.linalg.solve(k.hessian[np.ix_(used, used)], weighted[used])
