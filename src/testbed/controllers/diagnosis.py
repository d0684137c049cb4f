"""The adaptive law's diagnosis beside another control law: estimation, monitor and jam test on a memory of their own.

What they flag puts the mode for that failure in force. So a control law that neither estimates nor monitors, or does so for its
own purpose, can be compared with the adaptive law at the same diagnosis.

Letters: y measured state, m design model, c settings of the diagnosis, s memory of the control law, d memory of the diagnosis,
w working memory; their fields, shapes and units are in `records`.
"""

from __future__ import annotations

import numpy as np

from testbed.common.jit import bound, compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import settings_record, trimmed_memory
from testbed.controllers.inversion.law import state_function
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.step import estimate
from testbed.controllers.setup import Setup


@compiled
def diagnose(step, parts):
    """One step of the adaptive law's diagnosis beside the control; returns 1 when a flag changed or a jam moved.

    Args:
        step: row of the channels.
        parts: states, setpoints, then model, settings of the diagnosis, memory of the control, memory of the diagnosis, and working
            memory.
    """
    states, setpoints, models, settings, memories, diagnoses, works = parts
    y, ref, m, c = states[step], setpoints[step], models[0], settings[0]
    s, d, w = memories[0], diagnoses[0], works[0]
    for i in range(len(d.command)):
        d.command[i] = s.command[i]
    advance_actuators(c.dt, axial_speed(y), m, d)
    state_function(y, m, w.f)
    return estimate(y, ref, m, c, d, w)


class Diagnosis:
    """The diagnosis of one flight.

    Args:
        model, memory, work: records of the control law.
        modes: the control law's modes, which are switched for what is flagged.
        active: whether there is to be a diagnosis; without it nothing is flagged and nothing is said.

    Attributes:
        records: settings and memory of the diagnosis, each an array of one record.
    """

    def __init__(
        self,
        setup: Setup,
        model: np.ndarray,
        memory: np.ndarray,
        work: np.ndarray,
        modes: ModeSwitch,
        active: bool,
    ) -> None:
        self._modes, self._control, self._active = modes, memory, active
        settings = settings_record(setup, AdaptiveInversionSettings() if active else None)
        self.records = (settings, trimmed_memory(setup))
        self._own = (model, settings, memory, self.records[1], work)

    def bind(self, states: np.ndarray, setpoints: np.ndarray) -> None:
        """Take the measured states and the references of a flight (see `controllers.Controller.bind`)."""
        self._parts = (states, setpoints, *self._own)
        if self._active:
            self._diagnose = bound(diagnose, 0, self._parts)

    def step(self, step: int) -> None:
        """Diagnose row `step`, and put the mode in force for what has been flagged."""
        if self._active and self._diagnose(step, self._parts):
            self._take_over(step)

    def _take_over(self, step: int) -> None:
        """The estimate of a jammed actuator becomes its position, and that of one that is lost, or used again, 1: a lost one is
        not used, and does not act. The others keep theirs."""
        s, d = self._control[0], self.records[1][0]
        s.lambda_hat[(s.failed == 1) | (d.failed == 1)] = 1.0
        s.lambda_hat[d.jammed == 1] = d.lambda_hat[d.jammed == 1]
        s.failed[:], s.jammed[:], s.early[:] = d.failed, d.jammed, d.early
        self._modes.switch(step, float(self._parts[0][step].airspeed))
        d.designed_position[:], d.failed[:], d.early[:] = s.designed_position, s.failed, s.early
