"""The adaptive law's diagnosis beside another control law: sensor guard, estimation, monitor and jam test on a memory of their own.

What they flag puts the mode for that failure in force. So a control law that neither estimates nor monitors, or does so for its
own purpose, can be compared with the adaptive law at the same diagnosis.

Letters: those of `records`; c the settings and d the memory of the diagnosis, s the memory of the control law.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from testbed.common.jit import bound, compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import settings_record, trimmed_memory
from testbed.controllers.inversion.controller import CompiledController
from testbed.controllers.inversion.law import state_function
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.sensor_guard import believe
from testbed.controllers.inversion.step import estimate
from testbed.controllers.setup import Setup


@compiled
def diagnose(step, parts):
    """One step of the adaptive law's diagnosis beside the control; returns 1 when a flag changed or a jam moved. The last part is
    the measured states, and the first those that are believed, which the control law reads."""
    believed, setpoints, telemetry, models, _, modes, memories, works, settings, diagnoses, states = parts
    ref, m, c, s, d, w = setpoints[step], models[0], settings[0], memories[0], diagnoses[0], works[0]
    changed = believe(step, states, believed, ref, telemetry[step], m, c, modes[0], d)
    y = believed[step]
    for i in range(len(d.command)):
        d.command[i] = s.command[i]
    advance_actuators(c.dt, axial_speed(y), m, d)
    state_function(y, m, w.f)
    changed += estimate(y, ref, m, c, d, w)
    for i in range(len(d.probe)):
        s.probe[i] = d.probe[i]
    return changed


class DiagnosedController(CompiledController):
    """A control law with modes, which are switched for what the diagnosis flags.

    Args:
        law: as of `CompiledController`; its further arrays are settings and memory of the diagnosis.
        settings: record of the control law's settings.
        active: whether there is to be a diagnosis; without it nothing is flagged and nothing is said.

    Raises:
        BadInput: as in `InversionController`.
    """

    def __init__(
        self, setup: Setup, law: Callable[[int, Any], int], settings: np.ndarray, active: bool
    ) -> None:
        self._memory, self._diagnosed, self._active = trimmed_memory(setup), trimmed_memory(setup), active
        self._modes = ModeSwitch(setup, self._memory)
        self.reasons = self._modes.reasons
        chosen = settings_record(setup, AdaptiveInversionSettings() if active else None)
        more = (chosen, self._diagnosed)
        super().__init__(setup, law, settings, self._modes.record, self._memory, more)

    def bind(
        self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray, *more: np.ndarray
    ) -> None:
        """Take the channels of a flight (see `Controller.bind`). What the sensor guard believes is a channel of its own."""
        super().bind(np.zeros_like(states) if self._active else states, setpoints, telemetry, *more)
        if self._active:
            self._diagnosis = (*self._parts, states)
            self._diagnose = bound(diagnose, 0, self._diagnosis)

    def step(self, step: int) -> memoryview:
        """Diagnose row `step`, put the mode in force for what has been flagged; commands [n]."""
        if self._active and self._diagnose(step, self._diagnosis):
            self._take_over(step)
        self._step(step, self._parts)
        return self._commands

    def _take_over(self, step: int) -> None:
        """The estimate of a jammed actuator becomes its position, and that of one that is lost, or used again, 1: a lost one is
        not used, and does not act. The others keep theirs. A law that divides by no estimate uses a reversed one with its sign."""
        s, d = self._memory[0], self._diagnosed[0]
        s.lambda_hat[(s.failed == 1) | (d.failed == 1)] = 1.0
        s.lambda_hat[d.jammed == 1] = d.lambda_hat[d.jammed == 1]
        s.failed[:], s.jammed[:], s.early[:], s.stuck[:] = d.failed, d.jammed, d.early, d.stuck
        s.reversed[:] = d.reversed & self._records[1][0].uncompensated
        s.moved[:], s.offset_timer[:] = d.moved, d.offset_timer  # for what is said alone
        self._modes.switch(step, float(self._parts[0][step].airspeed))
        d.designed_position[:], d.failed[:], d.early[:] = s.designed_position, s.failed, s.early
