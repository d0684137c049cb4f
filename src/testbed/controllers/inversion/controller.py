"""Controllers whose control step is a compiled law, and the one of the adaptive inversion, which switches control modes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from testbed.common.jit import bound
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record, trimmed_memory
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.step import adaptive_step, command_step
from testbed.controllers.records import work_dtype
from testbed.controllers.setup import Setup

Law = Callable[[int, Any], int]
"""A compiled control step of a row of the channels and `parts`, a tuple: states, setpoints and telemetry (see `Controller.bind`),
then the records of model, settings, mode, memory and working memory, each an array of one record, and then more. They are one tuple
because a call with it takes a third of the time."""


class CompiledController:
    """Calls a law in each control step (see `Controller`).

    Args:
        settings, mode, memory: records of `records.SETTINGS`, `records.MODE` and `records.MEMORY`.
        more: further arrays that the law needs.
    """

    reasons: Sequence[tuple[int, str]] = ()

    def __init__(
        self,
        setup: Setup,
        law: Law,
        settings: np.ndarray,
        mode: np.ndarray,
        memory: np.ndarray,
        more: tuple[np.ndarray, ...] = (),
    ) -> None:
        work = np.zeros(1, work_dtype(len(setup.actuators)))
        self._law, self._records = law, (model_record(setup), settings, mode, memory, work, *more)
        self._commands = memoryview(memory[0].command)  # quicker to go through than the array

    def bind(
        self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray, *more: np.ndarray
    ) -> None:
        """Take the channels of a flight (see `Controller.bind`), and `more` for the law."""
        self._parts = (states, setpoints, telemetry, *self._records, *more)
        self._step = bound(self._law, 0, self._parts)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        self._step(step, self._parts)
        return self._commands


class InversionController(CompiledController):
    """Control inversion with adaptive compensation and automatic goal switching (the paper's figure 2).

    Args:
        setup: design model, gains and actuators.
        settings: [1] record of `records.settings_dtype`; by default that of the scenario.
        law: by default the adaptive one; it returns what `adaptive_step` does.
        more: arrays that `law` needs beside those of `CompiledController`. The last of its parts are the measured states.

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
        law: Law = adaptive_step,
        more: tuple[np.ndarray, ...] = (),
    ) -> None:
        if settings is None:
            settings = settings_record(setup, setup.settings_as(AdaptiveInversionSettings))
        self.memory = trimmed_memory(setup)
        self._modes = ModeSwitch(setup, self.memory)
        self.reasons = self._modes.reasons
        super().__init__(setup, law, settings, self._modes.record, self.memory, more)

    def switch(self, step: int) -> None:
        """Put the mode in force that belongs to the flags in `memory`, from row `step` on."""
        self._modes.switch(step, float(self._parts[0][step].airspeed))

    def bind(
        self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray, *more: np.ndarray
    ) -> None:
        """Take the channels of a flight (see `Controller.bind`). What the adaptive law believes is a channel of its own."""
        believed = np.zeros_like(states) if self._law is adaptive_step else states
        super().bind(believed, setpoints, telemetry, states, *more)
        self._common = self._parts[:8]
        self._command = bound(command_step, 0, self._common)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        if self._step(step, self._parts):
            self.switch(step)
            self._command(step, self._common)
        return self._commands


def fixed_inversion(setup: Setup) -> InversionController:
    """The inversion (6) with all actuators taken for healthy: no estimation, no monitor."""
    return InversionController(setup, settings_record(setup, None))
