"""The random errors of a scenario's sensors, each with its size and how long it lasts; and the scenario without any.

White noise of a sensor follows the convention of `testbed.sensors.settings`: the densities in a scenario are one-sided, per root
hertz. A sensor without a low-pass after its noise has a sample's standard deviation of N sqrt(rate / 2).

Not in here: dropouts and other faults, and delays.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.signal import lfilter

from testbed.common.units import GRAVITY_M_S2
from testbed.scenario.load import Scenario, changed
from testbed.sensors.channels import CHANNELS, Channel
from testbed.sensors.settings import SENSORS

LONG_S = 5.0
"""Correlation time beyond which an error lasts."""
_TELLING = ("p", "q", "r", "specific_force_x", "airspeed", "alpha", "beta")
"""What (10) is made of. Pitch and roll cancel in it, and other readings move the aircraft alone."""
_CHANCE = ("noise_", "bias_sigma_", "drift_", "wander_", "resolution_", "scale_error_sigma")


@dataclass(frozen=True)
class ErrorSource:
    """One random error of one channel, independent of the others.

    Attributes:
        name: in words, such as `gyro_p noise`.
        std: its standard deviation in one step [SI].
        correlation_time_s: 0 for white noise, infinite for an offset that lasts the flight.
    """

    name: str
    channel: Channel
    std: float
    correlation_time_s: float

    @property
    def lasts(self) -> bool:
        """Whether an estimate follows it rather than averages it, whatever the gains."""
        return self.correlation_time_s > LONG_S

    def intensity(self, dt_s: float) -> float:
        """Its two-sided intensity at low frequency [SI^2 s]; zero for one that lasts."""
        time = 2.0 * self.correlation_time_s or dt_s
        return 0.0 if self.lasts else self.std**2 * time

    def deviation(self, answer: np.ndarray, dt_s: float) -> np.ndarray:
        """[n] standard deviation of estimates that answer a unit of it in one step by `answer` [steps, n].

        With the autocovariance std^2 c^|k| the variance is std^2 sum_jk h_j h_k c^|j-k|.
        """
        if math.isinf(self.correlation_time_s):
            return self.std * np.abs(answer.sum(axis=0))
        c = math.exp(-dt_s / self.correlation_time_s) if self.correlation_time_s else 0.0
        sums = (answer * (2.0 * lfilter([1.0], [1.0, -c], answer, axis=0) - answer)).sum(axis=0)
        found: np.ndarray = self.std * np.sqrt(np.maximum(sums, 0.0))
        return found


def sources(scenario: Scenario, state: Mapping[str, float]) -> list[ErrorSource]:
    """Every random error that moves the estimates; `state` is that of the trimmed flight [SI], of which a scale error is a part."""
    telling = (channel for channel in CHANNELS if channel.reads in _TELLING)
    return [source for channel in telling for source in _of(channel, scenario, state)]


def _of(channel: Channel, scenario: Scenario, state: Mapping[str, float]) -> Iterator[ErrorSource]:
    """Noise with rounding to digits, wander, and offset of one channel, those that are not zero."""
    model = scenario.sensors.of(channel.sensor)
    reading = {**state, "specific_force_x": GRAVITY_M_S2 * math.sin(state["pitch"])}.get(channel.reads, 0.0)
    digit = model.si("resolution") / math.sqrt(12.0)
    noise = math.hypot(model.si("noise") * math.sqrt(scenario.rate_hz / 2.0), digit)
    drift = model.si("drift") * math.sqrt(scenario.duration_s)
    offset = math.hypot(model.si("bias_sigma"), model.scale_error_sigma * reading, drift)
    for words, std, time_s in (
        ("noise", noise, 0.0),
        ("wander", model.si("wander"), model.wander_time_s),
        ("offset", offset, math.inf),
    ):
        if std:
            yield ErrorSource(f"{channel.name} {words}", channel, std, time_s)


def without_chance(scenario: Scenario) -> Scenario:
    """The scenario whose sensors have their known errors alone, and no faults; its weather stays."""
    known = {sensor: model for sensor, model in _blocks(scenario).items() if sensor in SENSORS}
    for model in known.values():
        model |= {name: 0.0 for name in model if name.startswith(_CHANCE) and name != "wander_time_s"}
    return changed(scenario, {"sensors": known})


def with_error(scenario: Scenario, channel: Channel, size: float, at_s: float) -> Scenario:
    """The scenario one of whose channels reads this much too much from `at_s` on [in its unit], and has no other fault."""
    fault = {"type": "bias", "sensor": channel.name, "at_s": at_s, f"value_{channel.unit}": size}
    return changed(scenario, {"sensors": {**_blocks(scenario), "faults": [fault]}})


def _blocks(scenario: Scenario) -> dict[str, Any]:
    """The `sensors` block as a mapping."""
    written = scenario.sensors.model_dump(mode="json")
    return written if isinstance(written, dict) else {}
