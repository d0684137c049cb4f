"""The log of a flight: what its columns are called, and how they are made of what the loop recorded."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from testbed.aircraft import Aircraft
from testbed.atmosphere import COLUMNS as WIND
from testbed.scenario import Scenario
from testbed.sensors.channels import log_columns as sensor_columns
from testbed.signals import RATES, SETPOINT, STATE, TELEMETRY

_DEG = 180.0 / math.pi
_TRUTH = (
    ("north_m", "north", 1.0), ("east_m", "east", 1.0), ("altitude_m", "altitude", 1.0),
    ("airspeed_m_s", "airspeed", 1.0), ("climb_rate_m_s", "climb_rate", 1.0),
    ("roll_deg", "roll", _DEG), ("pitch_deg", "pitch", _DEG), ("heading_deg", "heading", _DEG),
    ("alpha_deg", "alpha", _DEG), ("beta_deg", "beta", _DEG),
    ("p_deg_s", "p", _DEG), ("q_deg_s", "q", _DEG), ("r_deg_s", "r", _DEG),
)  # fmt: skip
_REFERENCES = (
    ("altitude_command_m", "altitude", 1.0),
    ("airspeed_command_m_s", "airspeed", 1.0),
    ("heading_command_deg", "heading", _DEG),
)
_RATE_UNITS = {"p_dot": "deg_s2", "q_dot": "deg_s2", "r_dot": "deg_s2", "u_dot": "m_s2"}

Recorded = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
"""What the loop recorded, a row a step: truth (as `Plant.read`), measured state, references, telemetry."""


def columns(aircraft: Aircraft) -> tuple[str, ...]:
    """Names of the columns that every log has."""
    n = len(aircraft.actuators)
    empty = (np.zeros((0, len(STATE) + 2 * n)), np.zeros((0, len(STATE))), np.zeros((0, len(SETPOINT))))
    return tuple(name for name, _ in _columns(aircraft, 1.0, (*empty, np.zeros((0, 4 * n + 8)))))


def all_columns(aircraft: Aircraft, scenario: Scenario) -> tuple[str, ...]:
    """Names of the log's columns in a scenario: those of real sensors and of moving air come last."""
    sensors = () if scenario.sensors.is_ideal else sensor_columns()
    return (*columns(aircraft), *sensors, *(() if scenario.atmosphere.is_calm else WIND))


def table(aircraft: Aircraft, rate_hz: float, recorded: Recorded, every: int = 1) -> np.ndarray:
    """[rows, columns] the log of every so many steps."""
    return np.column_stack([column for _, column in _columns(aircraft, rate_hz, recorded)])[::every]


def _columns(aircraft: Aircraft, rate_hz: float, recorded: Recorded) -> Iterator[tuple[str, np.ndarray]]:
    """Each column's name where it is filled."""
    truth, measured, references, telemetry = recorded
    n = len(aircraft.actuators)
    yield "time_s", np.arange(len(truth)) / rate_hz
    for name, of, factor in _TRUTH:
        yield name, truth[:, STATE.index(of)] * factor
    for name, of, factor in _REFERENCES:
        value = references[:, SETPOINT.index(of)] * factor
        yield name, np.mod(value, 360.0) if of == "heading" else value
    for i, rate in enumerate(RATES):
        unit = _RATE_UNITS[rate]
        factor = 1.0 if rate == "u_dot" else _DEG
        yield f"{rate}_{unit}", measured[:, STATE.index(rate)] * factor
        yield f"{rate}_desired_{unit}", telemetry[:, len(TELEMETRY) * n + i] * factor
    for i, rate in enumerate(RATES):
        yield f"{rate}_released", telemetry[:, len(TELEMETRY) * n + len(RATES) + i]
    for i, (name, actuator) in enumerate(aircraft.actuators.items()):
        yield f"{name}_reference", telemetry[:, i] * actuator.scale
        yield f"{name}_command", telemetry[:, n + i] * actuator.scale
        yield f"{name}_position", truth[:, len(STATE) + i]
        yield f"{name}_effectiveness", truth[:, len(STATE) + n + i]
        yield f"{name}_effectiveness_estimate", telemetry[:, 2 * n + i]
        yield f"{name}_failed", telemetry[:, 3 * n + i]
