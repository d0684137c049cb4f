"""The adaptive inversion controller: the compiled law, its records, and the switching of control modes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from testbed.common.jit import bound
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record, trimmed_memory
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.step import adaptive_step, command_step
from testbed.controllers.records import work_dtype
from testbed.controllers.setup import Setup


class InversionController:
    """Control inversion with adaptive compensation and automatic goal switching (the paper's figure 2).

    Args:
        setup: design model, gains and actuators.
        adapts: estimate effectiveness (13), and switch modes (29) when an actuator is flagged as failed. If false, the
            law is a fixed inversion.

    Raises:
        BadInput: the aircraft's input matrix cannot be inverted, or no steady flight was found for the axes that are
            released from the start.
    """

    def __init__(self, setup: Setup, adapts: bool = True) -> None:
        self._memory = trimmed_memory(setup)
        self._modes = ModeSwitch(setup, self._memory)
        self._own = (
            model_record(setup),
            settings_record(setup, setup.settings_as(AdaptiveInversionSettings) if adapts else None),
            self._modes.record,
            self._memory,
            np.zeros(1, work_dtype(len(setup.actuators))),
        )
        self._commands = memoryview(self._memory[0].command)  # quicker to go through than the array

    @property
    def reasons(self) -> Sequence[tuple[int, str]]:
        """See `Controller.reasons`."""
        return self._modes.reasons

    @property
    def memory(self) -> np.ndarray:
        """The law's memory, an array of one record of `records.MEMORY`."""
        return self._memory

    def switch(self, step: int) -> None:
        """Put the mode in force that belongs to the flags in `memory`, from row `step` on."""
        self._modes.switch(step)

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `controllers.Controller`)."""
        self._parts = (states, setpoints, telemetry, *self._own)
        self._step = bound(adaptive_step, 0, self._parts)
        self._command = bound(command_step, 0, self._parts)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        if self._step(step, self._parts):
            self.switch(step)
            self._command(step, self._parts)
        return self._commands
