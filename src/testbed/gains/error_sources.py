"""The errors in a scenario: noise, wander and offset of each sensor, and gusts, as disturbances of the measured error e.

White noise of a sensor follows the convention of `testbed.sensors.settings`: the densities in a scenario are one-sided, per root
hertz. A sensor without a low-pass after its noise has a sample's standard deviation of N sqrt(rate / 2).

Not in here: dropouts and other faults, delays, and gusts that the air data measure. A gust at the centre of gravity changes the
measured alpha, beta and airspeed as it changes the true ones (d_x of (30)), so f_m answers it. What f_m cannot know is the rolling
of the air about the aircraft.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter

from testbed.air.config import Atmosphere, severity
from testbed.air.dryden import EXCEEDED_FT, EXCEEDED_FT_S, intensities_and_lengths, rolling_intensity
from testbed.controllers.records import D_P
from testbed.gains.trimmed_law import TrimmedLaw
from testbed.scenario.load import Scenario
from testbed.sensors.channels import CHANNELS, Channel
from testbed.sensors.settings import SensorModel

ROLLING = "rolling gusts"
LONG_S = 5.0
"""Correlation time beyond which an error lasts."""


@dataclass(frozen=True)
class ErrorSource:
    """One random error, independent of the others.

    Attributes:
        name: in words, such as `gyro_p noise`.
        sensor: as in the scenario's `sensors`, or `turbulence`.
        response: [steps, 4] change of e in the steps after a unit of it in one step.
        std: its standard deviation in one step.
        correlation_time_s: 0 for white noise, infinite for an offset that lasts the flight.
    """

    name: str
    sensor: str
    response: np.ndarray
    std: float
    correlation_time_s: float = 0.0

    @property
    def lasts(self) -> bool:
        """Whether an estimate follows it rather than averages it, whatever the gains."""
        return self.correlation_time_s > LONG_S

    def intensity(self, dt_s: float) -> np.ndarray:
        """[4, 4] two-sided intensity at low frequency of what it does to e; zero for one that lasts."""
        effect = self.std * self.response.sum(axis=0)
        time = dt_s if self.correlation_time_s == 0.0 else 2.0 * self.correlation_time_s
        return np.outer(effect, effect) * (0.0 if self.lasts else time)

    def deviation(self, estimates: np.ndarray, dt_s: float) -> np.ndarray:
        """[n] standard deviation of estimates that answer a unit of it in one step by `estimates` [steps, n].

        With the autocovariance std^2 c^|k| the variance is std^2 sum_jk h_j h_k c^|j-k|.
        """
        if self.correlation_time_s == 0.0:
            found: np.ndarray = self.std * np.sqrt(np.square(estimates).sum(axis=0))
        elif math.isinf(self.correlation_time_s):
            found = self.std * np.abs(estimates.sum(axis=0))
        else:
            c = math.exp(-dt_s / self.correlation_time_s)
            sums = (estimates * (2.0 * lfilter([1.0], [1.0, -c], estimates, axis=0) - estimates)).sum(axis=0)
            found = self.std * np.sqrt(np.maximum(sums, 0.0))
        return found


def sources(law: TrimmedLaw, scenario: Scenario) -> list[ErrorSource]:
    """Every random error of the scenario that moves the estimates."""
    found: list[ErrorSource] = []
    for channel in CHANNELS:
        model = scenario.sensors.of(channel.sensor)
        if _errs(model):
            response = law.error_response(channel.name)
            if np.abs(response).max() > 1e-9:
                found += _of_sensor(channel, model, response, law, scenario.duration_s)
    return [*found, *_gusts(law, scenario.atmosphere, scenario.initial.altitude_m)]


def known_offset(law: TrimmedLaw, scenario: Scenario) -> np.ndarray:
    """[4] constant part of e that is no chance: biases and scale errors of the scenario, and the design model's own error here."""
    total = law.model_error.copy()
    for channel in CHANNELS:
        model = scenario.sensors.of(channel.sensor)
        offset = model.si("bias") + model.scale_error * law.reading(channel.name)
        if offset:
            total += offset * law.error_response(channel.name).sum(axis=0)
    return total


def _errs(model: SensorModel) -> bool:
    return any(model.si(name) for name in ("noise", "bias_sigma", "drift", "wander", "resolution")) or bool(
        model.scale_error_sigma
    )


def _of_sensor(
    channel: Channel, model: SensorModel, response: np.ndarray, law: TrimmedLaw, seconds: float
) -> Iterator[ErrorSource]:
    """Noise with rounding to digits, wander, and offset of one channel, those that are not zero."""
    digit = model.si("resolution")
    noise = math.hypot(model.si("noise") * math.sqrt(law.rate_hz / 2.0), digit / math.sqrt(12.0))
    scale = model.scale_error_sigma * law.reading(channel.name)
    offset = math.hypot(model.si("bias_sigma"), scale, model.si("drift") * math.sqrt(seconds))
    for words, std, time in (
        ("noise", noise, 0.0),
        ("wander", model.si("wander"), model.wander_time_s),
        ("offset", offset, math.inf),
    ):
        if std:
            yield ErrorSource(f"{channel.name} {words}", channel.sensor, response, std, time)


def _gusts(law: TrimmedLaw, air: Atmosphere, height_m: float) -> Iterator[ErrorSource]:
    """The rolling of the air about the aircraft by gusts that vary along its span, as a first-order process."""
    span = law.setup.model.span_m
    if not air.turbulence_w20_m_s or not span:
        return
    rolling, time = _rolling(air, height_m, span, law.state["airspeed"])
    response = np.array(law.model.A[:, D_P])[None] * law.state["airspeed"] / law.model.airspeed
    yield ErrorSource(ROLLING, "turbulence", response, rolling, time)


def _rolling(air: Atmosphere, height_m: float, span: float, airspeed: float) -> tuple[float, float]:
    """Standard deviation [rad/s] and correlation time [s] of the rolling gusts.

    MIL-F-8785C, 3.7.5, for Dryden's turbulence; for JSBSim's MIL-STD-1797A, table VI: sigma_p = 1.9 sigma_w / sqrt(L_w b), time
    constant sqrt(L_w b) / (2.6 V). JSBSim turns its rotary gusts from the ground's axes to the body's, so this is felt whole
    only heading north or south: flown there the deviation is 0.98 of it, and 0.84 heading east, with half of the slow part.
    """
    exceeded = np.array([EXCEEDED_FT, EXCEEDED_FT_S[severity(air.turbulence_w20_m_s)]])
    _, sigma_w, _, length_w = intensities_and_lengths(height_m, air.turbulence_w20_m_s, exceeded)
    if air.model == "jsbsim":
        length = math.sqrt(length_w * span)
        return 1.9 * sigma_w / length, length / (2.6 * airspeed)
    return rolling_intensity(sigma_w, length_w, span), 4.0 * span / (math.pi * airspeed)
