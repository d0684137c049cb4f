"""The law (13) about a trimmed flight: how an error of one reading moves the error e (10), and how e moves the estimates.

Everything is found by calling the functions that fly, with small changes, so nothing of the law is written here again. In
trimmed flight the positions of the actuators stay as they are: outer loops hold the forces that the flight needs.

Letters as in `testbed.controllers.records`: y measured state, m design model, c settings, s memory, w working memory.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from paper.trimmed_steps import filter_error, follow_newton
from testbed.common.signals import STATE, as_records
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record, trimmed_memory
from testbed.controllers.inversion.law import measured_error, pressure_ratio_of, state_function
from testbed.controllers.inversion.step import regression
from testbed.controllers.records import work_dtype
from testbed.controllers.setup import Setup
from testbed.scenario.load import Scenario
from testbed.sensors.channels import CHANNELS
from testbed.sensors.measurement import derive
from testbed.simulation import start_and_setup

_NAMES = tuple(channel.name for channel in CHANNELS)
_SETTLING_S, _ANSWER_S = 2.0, 0.6  # of the modelled rotors; after a reading has erred once
_CHANGE = {"airspeed": 1e-3}
_SMALL = 1e-5
"""Change of a reading for a derivative [m/s for airspeed, else rad, rad/s, m/s2]."""
_FEW = 1e-4  # a position in place of zero


@dataclass(frozen=True)
class TrimmedLaw:
    """The estimation of one controller in one trimmed flight.

    Attributes:
        setup: what the controller is told.
        settings: the scenario's `controller` block.
        state: of the trimmed flight: airspeed, alpha, beta, pitch [m/s, rad].
    """

    setup: Setup
    settings: AdaptiveInversionSettings
    state: Mapping[str, float]

    @property
    def rate_hz(self) -> float:
        """Control rate."""
        return 1.0 / self.setup.dt_s

    @cached_property
    def model(self) -> np.record:
        """m."""
        return model_record(self.setup)[0]

    @cached_property
    def positions(self) -> np.ndarray:
        """[n] modelled positions of the actuators [scaled]."""
        return np.array(self._settled[0].position)

    @cached_property
    def pressure_ratio(self) -> float:
        """(V/V_0)^2 of surfaces."""
        return float((self.state["airspeed"] / self.model.airspeed) ** 2)

    @cached_property
    def model_error(self) -> np.ndarray:
        """[4] e (10) of healthy actuators in this flight: what the design model has wrong about it, -delta_f of (36)."""
        return self._errors({}, 1)[0]

    def settings_record(self, **changes: Any) -> np.record:
        """c, with some of the scenario's settings changed."""
        chosen = self.settings.model_copy(update=changes)
        return settings_record(self.setup, chosen)[0]

    def error_response(self, channel: str) -> np.ndarray:
        """[steps, 4] change of e in the steps after this channel alone has read one unit too much in one step [per SI unit]."""
        delta = _CHANGE.get(channel, _SMALL)
        steps = round(_ANSWER_S * self.rate_hz)
        up, down = (self._errors({channel: sign * delta}, steps) for sign in (1.0, -1.0))
        return (up - down) / (2.0 * delta)

    def reading(self, channel: str) -> float:
        """What this channel reads in this flight [SI]."""
        return float(self._readings(1)[channel][0])

    def newton_response(self, e: np.ndarray, gamma: float) -> np.ndarray:
        """[steps, n] change of the estimates of (13) for a change e [steps, 4] of the measured error, linearised about 1.

        The recursion of the law's own step at a held position beyond epsilon: d+ = d + gamma dt B^-1 (e - Phi d) / a. With no
        more actuators than rates B^-1 Phi is diag(a), and each estimate is a first-order lag.
        """
        inverse = np.array(self.model.B_inv) / self.force[:, None]
        x = self.filtered(e) @ inverse.T
        step = gamma * self.setup.dt_s
        out = np.empty_like(x)
        follow_newton(step * x, np.eye(len(inverse)) - step * inverse @ self.regressor, out)
        return out

    @cached_property
    def force(self) -> np.ndarray:
        """[n] positions of the actuators, of surfaces times (V/V_0)^2; a position of zero is a very small one."""
        small = np.where(self.positions == 0.0, _FEW, self.positions)
        return small * np.where(self.model.servo, self.pressure_ratio, 1.0)

    def bias(self, scenario: Scenario) -> np.ndarray:
        """[n] what constant errors add to the estimates of (13) in the end: where Phi d = e."""
        e = self.model_error.copy()
        for channel in CHANNELS:
            model = scenario.sensors.of(channel.sensor)
            offset = model.si("bias") + model.scale_error * self.reading(channel.name)
            if offset:
                e += offset * self.error_response(channel.name).sum(axis=0)
        return np.asarray(np.linalg.solve(self.regressor, e))

    def filtered(self, e: np.ndarray) -> np.ndarray:
        """e [steps, 4] behind the two lags of the regression."""
        found = np.array(e, dtype=float)
        filter_error(found, np.zeros((2, 4)), self.settings.filter_rad_s * self.setup.dt_s)
        return found

    @cached_property
    def regressor(self) -> np.ndarray:
        """[4, n] Phi in this flight."""
        w = self._work()
        self._error_of(self._measured(self._readings(1))[0], self._settled.copy()[0], w)
        return np.array(w.phi)

    @cached_property
    def _settled(self) -> np.ndarray:
        """s with healthy actuators, whose modelled rotors have settled at this airspeed."""
        memory = trimmed_memory(self.setup)
        y = self._measured(self._readings(1))[0]
        for _ in range(round(_SETTLING_S * self.rate_hz)):
            advance_actuators(self.setup.dt_s, axial_speed(y), self.model, memory[0])
        return memory

    def _errors(self, wrong: Mapping[str, float], steps: int) -> np.ndarray:
        """[steps, 4] e from the step on in which the readings have these errors, which they have in that step alone."""
        readings = self._readings(steps + 1)
        for channel, error in wrong.items():
            readings[channel][1] += error
        s, w = self._settled.copy()[0], self._work()
        measured = self._measured(readings)
        return np.array([self._error_of(measured[k], s, w) for k in range(1, steps + 1)])

    def _error_of(self, y: np.record, s: np.record, w: np.record) -> np.ndarray:
        """e [4] of one step, as in `inversion.step` but before the lags of the regression."""
        ratio = pressure_ratio_of(y, self.model)
        advance_actuators(self.setup.dt_s, axial_speed(y), self.model, s)
        state_function(y, self.model, w.f)
        regression(y, ratio, self.model, self._unfiltered, s, w)
        measured_error(w.z, w.phi, s, w.e)
        return np.array(w.e)

    @cached_property
    def _unfiltered(self) -> np.record:
        return self.settings_record(filter_rad_s=0.0)

    def _work(self) -> np.record:
        found: np.record = np.zeros(1, work_dtype(len(self.setup.actuators)))[0]
        return found

    def _readings(self, rows: int) -> np.ndarray:
        """[rows] records of what the sensors read in this flight."""
        table = np.zeros((rows, len(_NAMES)))
        readings = as_records(table, _NAMES)
        for name in ("airspeed", "alpha", "beta", "pitch", "roll"):
            readings[name] = self.state[name]
        readings["accelerometer_x"] = -self._inertial_u_dot(readings[:1])
        return readings

    def _inertial_u_dot(self, readings: np.ndarray) -> float:
        """u_dot that `derive` finds without a specific force: minus the specific force of this flight."""
        return float(self._measured(readings)["u_dot"][0])

    def _measured(self, readings: np.ndarray) -> np.ndarray:
        """[rows] records of the measured state, from the readings."""
        rows = as_records(np.zeros((len(readings), len(STATE))), STATE)
        for k in range(len(readings)):
            derive(k, self.rate_hz, readings, rows)
        return rows


def law_of(scenario: Scenario) -> TrimmedLaw:
    """The estimation of a scenario's controller in the flight in which it begins."""
    assert isinstance(scenario.controller, AdaptiveInversionSettings)
    start, setup = start_and_setup(scenario)
    return TrimmedLaw(setup, scenario.controller, start.state)
