"""What is measured: a channel is one number, a sensor has one or more channels, and each channel has a unit in YAML."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from testbed.common.signals import RATES, STATE


class Channel(NamedTuple):
    """One measured number: its name, the sensor that it is a part of, what it reads, and its unit in YAML."""

    name: str
    sensor: str
    reads: str
    """A name of `signals.STATE`, or `specific_force_x`."""
    unit: str


CHANNELS = (
    Channel("gyro_p", "gyro", "p", "deg_s"),
    Channel("gyro_q", "gyro", "q", "deg_s"),
    Channel("gyro_r", "gyro", "r", "deg_s"),
    Channel("accelerometer_x", "accelerometer", "specific_force_x", "m_s2"),
    Channel("roll", "attitude", "roll", "deg"),
    Channel("pitch", "attitude", "pitch", "deg"),
    Channel("heading", "heading", "heading", "deg"),
    Channel("airspeed", "airspeed", "airspeed", "m_s"),
    Channel("alpha", "alpha", "alpha", "deg"),
    Channel("beta", "beta", "beta", "deg"),
    Channel("altitude", "altitude", "altitude", "m"),
    Channel("climb_rate", "climb_rate", "climb_rate", "m_s"),
    Channel("position_north", "position", "north", "m"),
    Channel("position_east", "position", "east", "m"),
)

SENSED_ONLY = (
    Channel("accelerometer_y", "accelerometer", "force_y", "m_s2"),
    Channel("accelerometer_z", "accelerometer", "force_z", "m_s2"),
    Channel("velocity_north", "climb_rate", "velocity_north", "m_s"),
    Channel("velocity_east", "climb_rate", "velocity_east", "m_s"),
)
"""What only `signals.SENSED` has. The velocity over the ground has the errors of `climb_rate`, drawn for each axis."""

SI = {"deg_s": math.radians(1.0), "deg": math.radians(1.0), "m_s2": 1.0, "m_s": 1.0, "m": 1.0}
"""Factor to SI of each unit."""

PER_SECOND = {"deg_s": "deg_s2", "deg": "deg_s", "m_s2": "m_s3", "m_s": "m_s2", "m": "m_s"}
"""Unit of the rate of change of each unit."""


def channels_of(name: str) -> list[int]:
    """Indices in CHANNELS of the channel with this name, or of all channels of the sensor with this name."""
    return [i for i, channel in enumerate(CHANNELS) if name in (channel.name, channel.sensor)]


def unit_of(name: str) -> str:
    """Unit of a channel or sensor."""
    return CHANNELS[channels_of(name)[0]].unit


def names() -> list[str]:
    """All sensors and channels, by the names that a fault may give."""
    return list(dict.fromkeys([*(c.sensor for c in CHANNELS), *(c.name for c in CHANNELS)]))


def logged(truth: np.ndarray, readings: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """Log columns that real sensors add: each reading, named after the truth that it reads, and the true rates."""
    for i, channel in enumerate(CHANNELS):
        name = channel.reads if channel.reads in STATE else channel.name
        yield f"{name}_measured_{channel.unit}", readings[:, i] / SI[channel.unit]
    for rate in RATES:
        factor, unit = (1.0, "m_s2") if rate == "u_dot" else (SI["deg"], "deg_s2")
        yield f"{rate}_true_{unit}", truth[:, STATE.index(rate)] / factor


def log_columns() -> tuple[str, ...]:
    """Names of the columns that real sensors add to the log."""
    empty = np.zeros((0, max(len(STATE), len(CHANNELS))))
    return tuple(name for name, _ in logged(empty, empty))
