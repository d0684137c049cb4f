"""The adaptive inversion controller: the compiled law with its records, and the switching of control modes."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from testbed.common.jit import bound
from testbed.common.signals import RATES
from testbed.controllers.inversion.diagnosis import HEALTHY_VARIANCE
from testbed.controllers.inversion.modes import (
    Mode,
    NoLevelTrim,
    Regulator,
    design_regulator,
    enumerate_modes,
    regulator_for,
)
from testbed.controllers.inversion.step import adaptive_step, command_step, scratch
from testbed.controllers.records import memory_dtype, mode_dtype, model_dtype, settings_dtype
from testbed.controllers.setup import Setup

# Losses and 20 % of model error leave at most 2.6 standard deviations for a second, 5 deg of offset 4.2 and more.
_JAM_SIGMA = 4.0


class InversionController:
    """Control inversion with adaptive compensation and automatic goal switching (the paper's figure 2).

    Args:
        setup: design model, gains and actuators.
        adapts: estimate effectiveness (13); without, the law is a fixed inversion.
        monitors: switch modes when an estimate says that an actuator failed (29).

    Attributes:
        command: [n] last commands, servos in rad and motors as throttle.
        reasons: what it has to say of failures that it cannot hold or explain, as (step, text).
    """

    def __init__(self, setup: Setup, adapts: bool = True, monitors: bool = True) -> None:
        n = len(setup.actuators)
        self.setup = setup
        self.scale = np.array([a.scale for a in setup.actuators])
        self._limits = np.array([(a.low / a.scale, a.high / a.scale) for a in setup.actuators])
        self._lags = np.array([a.lag_rad_s for a in setup.actuators])
        released = setup.settings.get("released", ())
        self.modes = enumerate_modes(setup.model, self.scale, setup.control, released)  # type: ignore[arg-type]
        self.model = model_record(setup, self.scale, self._limits)
        self.settings = _settings_record(setup, adapts, monitors)
        self.mode_record = np.zeros(1, mode_dtype(n))
        self.memory = np.zeros(1, memory_dtype(n))
        self._work = scratch(n)
        self._start_memory(setup)
        self.reasons: list[tuple[int, str]] = []
        self._said: set[object] = set()
        self.command = self.memory[0].command
        self._told = memoryview(self.command)  # the same numbers, quicker to go through
        self.mode = self._enter((), 0)

    def _start_memory(self, setup: Setup) -> None:
        s, model = self.memory[0], self.model[0]
        position = np.asarray(setup.trim_positions) / self.scale
        s.lambda_hat[:], s.since[:] = 1.0, math.inf
        n = len(self.scale)
        s.P[:n, :n] = np.diag(np.full(n, HEALTHY_VARIANCE))
        s.command[:] = setup.trim_commands
        for name in ("r", "u", "position", "servo_input", "servo_lagged"):
            s[name][:] = position
        axial = setup.model.airspeed_m_s * math.cos(setup.model.alpha_rad)
        for i, propulsor in enumerate(setup.model.propulsors):
            if propulsor is not None:
                s.rotor[i] = propulsor.speed_at(setup.trim_positions[i], axial, float(model.density))

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


def model_record(setup: Setup, scale: np.ndarray, limits: np.ndarray) -> np.ndarray:
    """The design model as the compiled pages read it: a record of `model_dtype`, in scaled units [n] and stops [n, 2]."""
    model, n = setup.model, len(scale)
    record = np.zeros(1, model_dtype(n))
    m = record[0]
    m.airspeed, m.alpha, m.density = model.airspeed_m_s, model.alpha_rad, model.density_kg_m3
    m.servo[:] = [kind == "servo" for kind in model.kinds]
    m.scale[:], m.low[:], m.high[:] = scale, limits[:, 0], limits[:, 1]
    m.lag[:] = [a.lag_rad_s for a in setup.actuators]
    m.rate[:] = [a.rate / a.scale for a in setup.actuators]
    m.hold[:] = np.array(model.trim) / scale
    m.offset[:] = np.array(model.offset_matrix).sum(axis=1)[:4]
    m.bias[:] = np.array(model.bias)[:4] + m.offset
    m.A[:], m.B[:] = np.array(model.derivatives)[:4], np.array(model.input_matrix)[:4] * scale
    m.B_inv[:], m.B_torque[:] = np.linalg.pinv(m.B), np.array(model.torque_matrix)[:4]
    axial = model.airspeed_m_s * math.cos(model.alpha_rad)
    for i, p in enumerate(model.propulsors):
        if p is None:
            continue
        _, slope = p.torque_at(model.trim[i], axial, model.density_kg_m3)
        m.torque_slope[i] = slope * scale[i]
        m.c_thrust[i], m.c_torque[i] = p.thrust, p.torque
        m.diameter[i], m.rotor_inertia[i], m.max_volts[i] = p.diameter_m, p.rotor_inertia_kg_m2, p.max_volts
        m.advance_min[i] = p.advance[0]
        m.advance_step[i] = (p.advance[1] - p.advance[0]) / (len(p.thrust) - 1)
        m.k_v[i], m.k_t[i] = p.velocity_constant_rps_v, p.torque_constant_n_m_a
        m.resistance[i], m.no_load_current[i] = p.resistance_ohm, p.no_load_current_a
    return record


def _settings_record(setup: Setup, adapts: bool, monitors: bool) -> np.ndarray:
    n, chosen, loops = len(setup.actuators), setup.settings, setup.control.loops
    record = np.zeros(1, settings_dtype(n))
    c = record[0]
    for name, value in loops.model_dump().items():
        if name.endswith("_deg"):
            c[name.removesuffix("_deg")] = math.radians(value)
        elif name.removesuffix("_m_s").removesuffix("_m") in c.dtype.names:  # the rest is the modes'
            c[name.removesuffix("_m_s").removesuffix("_m")] = value
    for name, default in (("gamma", 4.0), ("epsilon", 0.05)):
        value = chosen.get(name, default)
        c[name][:] = [value[kind] if isinstance(value, Mapping) else value for kind in setup.model.kinds]
    c.dt, c.adapts, c.monitors = setup.dt_s, float(adapts), float(monitors)
    defaults = {"threshold": 0.1, "recovery": 0.5, "persistence_s": 0.1, "recovery_s": 1.0, "walk_rts": 0.1}
    defaults |= {"lambda_min": 0.05, "lambda_max": 1.1, "filter_rad_s": 0.0}
    names = {"recovery_s": "recovery_time", "persistence_s": "persistence", "walk_rts": "walk"}
    names["filter_rad_s"] = "filter"
    for name, default in defaults.items():
        c[names.get(name, name)] = chosen.get(name, default)
    c.divisor_min = 0.1
    c.jam_sigma, c.jam_time, c.jam_walk, c.residual_time = _JAM_SIGMA, 1.0, 1.0, 1.0
    weighted = chosen.get("estimation") == "weighted"
    c.weighted, c.certain = float(weighted), chosen.get("certain", 0.15) if weighted else math.inf
    c.noise[:] = [setup.control.disturbance[rate] for rate in RATES]
    c.doubt[:] = [setup.control.doubt[rate] for rate in RATES]
    c.doubt_rate, c.model_doubt = 1.0 / setup.control.doubt_s, setup.control.model_doubt
    return record
