"""Our own run folders as flight logs: what was commanded, and what the sensors read."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np

from testbed.flight.breakage import failure_times_s
from testbed.flight.flight import Flight
from testbed.flight.folder import load
from testbed.logs.flight_log import FlightLog, bad, even
from testbed.reporting.panels import response_of, shown_log
from testbed.sensors.channels import CHANNELS, SI

_READ = ("airspeed", "p", "q", "r", "roll", "pitch", "alpha", "beta")


def read(folder: Path) -> tuple[FlightLog, Flight]:
    """The log of a run folder, and its flight. Raises BadInput when it is none, or nothing was commanded."""
    flight = load(folder)
    log = flight.signals
    signals = {name: _reading(flight, name) for name in _READ}
    signals["u_dot"] = log["u_dot_m_s2"]
    units = {
        name: math.radians(1.0) if facts["kind"] == "servo" else 1.0
        for name, facts in flight.actuators.items()
    }
    commands = {name: log[f"{name}_command"] * unit for name, unit in units.items()}
    for name, values in commands.items():
        if not np.any(np.isfinite(values)):
            raise bad("has no numbers: the controller logs no commands", folder, f"{name}_command")
    if not np.any(np.isfinite(signals["u_dot"])):
        del signals["u_dot"]
    made = even(str(folder), log["time_s"], signals, commands, np.ones(len(commands), dtype=bool))
    true = shown_log(flight)
    there = [name for name in flight.actuators if response_of(name) in true]
    truth = {name: np.interp(made.time_s, log["time_s"], true[response_of(name)]) for name in there}
    return replace(made, truth=truth, failures_s=tuple(failure_times_s(flight.events))), flight


def _reading(flight: Flight, name: str) -> np.ndarray:
    """What the sensor read [SI]: with ideal sensors, the truth."""
    unit = next(channel.unit for channel in CHANNELS if channel.reads == name)
    measured = f"{name}_measured_{unit}"
    column = measured if measured in flight.columns else f"{name}_{unit}"
    return flight.signals[column] * SI[unit]
