"""The adaptive inversion controller: the compiled law with its records, and the switching of control modes."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from testbed.common.jit import bound
from testbed.common.signals import RATES
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record, trimmed_memory
from testbed.controllers.inversion.modes import (
    Mode,
    NoLevelTrim,
    Regulator,
    design_regulator,
    enumerate_modes,
    regulator_for,
)
from testbed.controllers.inversion.step import adaptive_step, command_step, scratch
from testbed.controllers.records import mode_dtype
from testbed.controllers.setup import Setup


class InversionController:
    """Control inversion with adaptive compensation and automatic goal switching (the paper's figure 2).

    Args:
        setup: design model, gains and actuators.
        adapts: estimate effectiveness (13) and switch modes when an estimate says that an actuator failed (29);
            without, the law is a fixed inversion.

    Attributes:
        command: [n] last commands, servos in rad and motors as throttle.
        reasons: what it has to say of failures that it cannot hold or explain, as (step, text).
    """

    def __init__(self, setup: Setup, adapts: bool = True) -> None:
        n = len(setup.actuators)
        self.setup = setup
        self.scale, self._limits, self._lags = setup.scale, setup.limits, setup.lags
        self.modes = enumerate_modes(setup.model, self.scale, setup.control, setup.settings.released)
        self.model = model_record(setup)
        self.settings = settings_record(
            setup, setup.settings_as(AdaptiveInversionSettings) if adapts else None
        )
        self.mode_record = np.zeros(1, mode_dtype(n))
        self.memory = trimmed_memory(setup)
        self._work = scratch(n)
        self.reasons: list[tuple[int, str]] = []
        self._said: set[object] = set()
        self.command = self.memory[0].command
        self._told = memoryview(self.command)  # the same numbers, quicker to go through
        self.mode = self._enter((), 0)

    def _enter(self, failed: tuple[int, ...], step: int) -> Mode:
        """Put the mode for these failures in force; one that is refused leaves the last mode in force."""
        s, mode = self.memory[0], self.modes.get(failed)
        jammed = {i: float(s.lambda_hat[i]) for i in failed if s.jammed[i] > 0.5}
        for i, position in jammed.items():
            s.designed_for[i] = position
            name = self.setup.model.actuators[i]
            self._say(
                step,
                f"{name}: not a loss of effectiveness, it acts against its command (jammed, offset or reversed)",
            )
        if mode is None or mode.refused:
            self._say(
                step,
                mode.refused if mode else f"{len(failed)} actuators failed: nothing left to control with",
            )
            return self.mode
        regulator = None
        if mode.released:
            try:
                regulator = self._regulator(mode, jammed)
            except NoLevelTrim as reason:
                self._say(step, str(reason))
                return self.mode
            if "altitude" not in regulator.held:
                slope = math.degrees(regulator.x_trim[7] - regulator.x_trim[1])
                self._say(
                    step,
                    f"{', '.join(mode.failed)} failed: altitude cannot be held, there is no level trim within the "
                    f"stops at any airspeed (condition number {mode.condition:.3g}, so it is authority that lacks, "
                    f"not rank); flies at about {slope:.1f} deg",
                    about=mode.failed,
                )
        self._put(mode, regulator, failed)
        return mode

    def _regulator(self, mode: Mode, jammed: Mapping[int, float]) -> Regulator:
        """The mode's regulator; about a trim without the jammed actuators' forces where there is none with them."""
        setup = self.setup
        about = (setup.model, self.scale, mode, setup.control, self._limits, self._lags)
        if jammed:
            try:
                return design_regulator(*about, jammed)
            except NoLevelTrim:
                pass
        return regulator_for(*about)

    def _put(self, mode: Mode, regulator: Regulator | None, failed: tuple[int, ...]) -> None:
        k, s, n = self.mode_record[0], self.memory[0], len(self.scale)
        k.B_hat_inv[:], k.released[:] = mode.inverse, [axis in mode.released for axis in RATES]
        lost = any(self.setup.model.kinds[i] == "motor" for i in failed)
        loops = self.setup.control.loops
        k.protect = loops.slow_descent_s
        k.protect_from = loops.lost_thrust_protect_from_m_s if lost else loops.protect_from_m_s
        k.spare = float(mode.held is not None)
        k.held_inv[:] = 0.0 if mode.held is None else mode.held
        k.alive[:] = [i not in failed for i in range(n)]
        k.regulated, k.r_trim[:], k.faster = float(regulator is not None), 0.0, 0.0
        s.integral[:] = 0.0
        s.integral[1] = self.setup.trim_pitch
        if regulator is not None:
            k.x_trim[:], k.r_trim[:] = regulator.x_trim, regulator.r_trim
            k.K[:], k.K_actuator[:], k.K_integral[:] = regulator.K, regulator.K_actuator, regulator.K_integral
            k.faster = regulator.x_trim[0] - self.setup.model.airspeed_m_s
            s.integral[1] = 0.0

    def _say(self, step: int, text: str, about: object = None) -> None:
        """Once of each: a jammed actuator's mode is designed again and again."""
        if (about or text) not in self._said:
            self._said.add(about or text)
            self.reasons.append((step, text))

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `controllers.Controller`)."""
        own = (self.model, self.settings, self.mode_record, self.memory, self._work)
        self._parts = (states, setpoints, telemetry, *own)
        self._step = bound(adaptive_step, 0, self._parts)
        self._command = bound(command_step, 0, self._parts)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        if self._step(step, self._parts):
            failed = tuple(int(i) for i in np.flatnonzero(self.memory[0].failed > 0.5))
            self.mode = self._enter(failed, step)
            self._command(step, self._parts)
        return self._told
