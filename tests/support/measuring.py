"""Sensors on a made-up flight: a smooth truth, what is read of it, and faults that each sensor can have."""

from __future__ import annotations

import numpy as np

from testbed.common.signals import STATE
from testbed.scenario.load import Scenario, load_scenario
from testbed.sensors.channels import CHANNELS, PER_SECOND, SI, channels_of
from testbed.sensors.measurement import READING
from testbed.sensors.settings import Sensors
from testbed.sensors.suite import RealSensors

RATE = 200
FORCE_M_S2 = 0.3
"""What the accelerometer feels."""


NAMES = [channel.name for channel in CHANNELS]


SENSED = {channel.reads for channel in CHANNELS}


def truth_rows(steps: int) -> np.ndarray:
    """A made-up, smooth flight; every entry is another."""
    time = np.arange(steps)[:, None] / RATE
    rows = 0.2 + 0.1 * np.sin(time * (1.0 + 0.1 * np.arange(len(STATE)))) + 0.01 * np.arange(len(STATE))
    rows[:, STATE.index("airspeed")] += 18.0
    rows[:, STATE.index("altitude")] += 300.0
    return np.hstack([rows, np.ones((steps, 8))])


def measured(settings: object, truth: np.ndarray, seed: int = 1) -> tuple[RealSensors, np.ndarray]:
    """The sensors after a flight, and [steps, state] what the controller was told."""
    sensors = RealSensors(Sensors.model_validate(settings), lambda: FORCE_M_S2, RATE, len(truth), seed)
    told = np.full((len(truth), len(STATE)), np.nan)  # so that what is not written shows
    sensors.bind(truth, told)
    for k in range(len(truth)):
        sensors.measure(k)
    return sensors, told


def readings(settings: object, channel: str, steps: int = 400, seed: int = 1) -> np.ndarray:
    """Errors of one channel that looks at a constant [the channel's unit]."""
    truth = np.repeat(truth_rows(1), steps, axis=0)
    index = NAMES.index(channel)
    sensors, _ = measured(settings, truth, seed)
    reads = CHANNELS[index].reads
    true = truth[:, STATE.index(reads)] if reads in STATE else FORCE_M_S2
    return (sensors.table[READING, :, index] - true) / SI[CHANNELS[index].unit]


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=4", "failures=[]", "requirements=[]", *settings]
    )


def fault_of(kind: str, sensor: str) -> dict[str, object]:
    """A fault of this type that this sensor can have, from 0.5 to 1 s."""
    unit = CHANNELS[channels_of(sensor)[0]].unit
    value = {
        "stuck": {f"value_{unit}": 1.0},
        "dropout": {},
        "bias": {f"value_{unit}": 0.5},
        "drift": {f"rate_{PER_SECOND[unit]}": 0.5},
        "noise": {f"noise_{unit}_rthz": 0.1},
    }[kind]
    return {"type": kind, "sensor": sensor, "at_s": 0.5, "until_s": 1.0, **value}
