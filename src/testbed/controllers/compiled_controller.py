"""A controller whose control step is one compiled function: its records, and how it is bound to the channels of a flight."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from testbed.common.jit import bound
from testbed.controllers.initial_records import model_record
from testbed.controllers.records import work_dtype
from testbed.controllers.setup import Setup


class CompiledController:
    """Calls a compiled `law` in each control step (see `Controller`).

    Args:
        law: takes a row of the channels and `parts`, a tuple: states, setpoints and telemetry (see `Controller.bind`), then the
            records of model, settings, mode, memory and working memory, each an array of one record, and then `more`. They are one
            tuple because a call with it takes a third of the time.
        settings, mode, memory: records of `records.SETTINGS`, `records.MODE` and `records.MEMORY`.
        more: further arrays that the law needs.
    """

    reasons: Sequence[tuple[int, str]] = ()

    def __init__(
        self,
        setup: Setup,
        law: Callable[[int, Any], int],
        settings: np.ndarray,
        mode: np.ndarray,
        memory: np.ndarray,
        more: tuple[np.ndarray, ...] = (),
    ) -> None:
        work = np.zeros(1, work_dtype(len(setup.actuators)))
        self._law, self._records = law, (model_record(setup), settings, mode, memory, work, *more)
        self._commands = memoryview(memory[0].command)  # quicker to go through than the array

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `Controller.bind`)."""
        self._parts = (states, setpoints, telemetry, *self._records)
        self._step = bound(self._law, 0, self._parts)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        self._step(step, self._parts)
        return self._commands
