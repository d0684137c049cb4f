"""The adaptive inversion controller: the compiled law, its records, and the switching of control modes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from testbed.common.jit import bound
from testbed.common.signals import STATE, as_records
from testbed.controllers.compiled_controller import CompiledController
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import settings_record, trimmed_memory
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.step import adaptive_step, believed_command_step, command_step
from testbed.controllers.setup import Setup


class InversionController(CompiledController):
    """Control inversion with adaptive compensation and automatic goal switching (the paper's figure 2).

    Args:
        setup: design model, gains and actuators.
        settings: [1] record of `records.settings_dtype`; by default that of the scenario.
        law: the compiled step, by default the adaptive one; it takes and returns what `adaptive_step` does.
        more: arrays that `law` needs beyond those of `adaptive_step`.

    Attributes:
        memory: the law's memory, an array of one record of `records.MEMORY`.

    Raises:
        BadInput: the aircraft's input matrix cannot be inverted, or no steady flight was found for the axes that are
            released from the start.
    """

    def __init__(
        self,
        setup: Setup,
        settings: np.ndarray | None = None,
        law: Callable[[int, Any], int] = adaptive_step,
        more: tuple[np.ndarray, ...] = (),
    ) -> None:
        if law is adaptive_step:
            more = (as_records(np.zeros((1, len(STATE))), STATE),)
        self._commanding = believed_command_step if law is adaptive_step else command_step
        if settings is None:
            settings = settings_record(setup, setup.settings_as(AdaptiveInversionSettings))
        self.memory = trimmed_memory(setup)
        self._modes = ModeSwitch(setup, self.memory)
        self.reasons = self._modes.reasons
        super().__init__(setup, law, settings, self._modes.record, self.memory, more)

    def switch(self, step: int) -> None:
        """Put the mode in force that belongs to the flags in `memory`, from row `step` on."""
        self._modes.switch(step, float(self._parts[0][step].airspeed))

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `Controller.bind`)."""
        super().bind(states, setpoints, telemetry)
        self._common = self._parts[:9] if self._commanding is believed_command_step else self._parts[:8]
        self._command = bound(self._commanding, 0, self._common)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        if self._step(step, self._parts):
            self.switch(step)
            self._command(step, self._common)
        return self._commands


def fixed_inversion(setup: Setup) -> InversionController:
    """The inversion (6) with all actuators taken for healthy: no estimation, no monitor."""
    return InversionController(setup, settings_record(setup, None))
