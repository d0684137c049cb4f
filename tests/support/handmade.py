"""Flights made by hand: a level, perfect log to put known errors into; no simulator, two actuators."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from testbed.flight.columns import ALWAYS_KNOWN
from testbed.flight.flight import Outcome
from testbed.metrics import Readings
from testbed.reporting.flight import ReportedFlight
from testbed.scenario.load import Scenario, load_scenario
from testbed.scenario.requirement import Requirement

ACTUATORS = {
    "elevon": {"kind": "servo", "unit": "deg", "limits": [-20.0, 20.0], "scale": 10.0},
    "fan": {"kind": "motor", "unit": "N", "limits": [0.0, 8.0], "scale": 2.0},
}
RATE_HZ = 100.0
_LEVEL = {"altitude": (100.0, "m"), "airspeed": (15.0, "m_s"), "heading": (350.0, "deg")}


def level_log(seconds: float = 10.0, rate_hz: float = RATE_HZ) -> dict[str, np.ndarray]:
    """A log of flight exactly on its references, everything healthy, all estimates right."""
    time = np.arange(round(seconds * rate_hz)) / rate_hz
    log = {"time_s": time}
    for name, (value, unit) in _LEVEL.items():
        log[f"{name}_{unit}"] = np.full_like(time, value)
        log[f"{name}_command_{unit}"] = np.full_like(time, value)
    for name in ("roll_deg", "pitch_deg", "alpha_deg", "beta_deg"):
        log[name] = np.zeros_like(time)
    for axis, unit in (("p_dot", "deg_s2"), ("u_dot", "m_s2")):
        for column in (f"{axis}_{unit}", f"{axis}_desired_{unit}", f"{axis}_released"):
            log[column] = np.zeros_like(time)
    for name in ACTUATORS:
        for of, value in (("reference", 1.0), ("command", 1.0), ("position", 1.0), ("failed", 0.0)):
            log[f"{name}_{of}"] = np.full_like(time, value)
        for of in ("effectiveness", "effectiveness_estimate"):
            log[f"{name}_{of}"] = np.ones_like(time)
    return log


def at(time_s: float) -> int:
    """The row of `level_log` at a time."""
    return round(time_s * RATE_HZ)


def lost(from_s: float, to_s: float = 10.0) -> dict[str, np.ndarray]:
    """A level log in which the elevon has no effect from one time to another."""
    log = level_log()
    log["elevon_effectiveness"][at(from_s) : at(to_s)] = 0.0
    return log


def injection(
    time_s: float, actuator: str | None = "elevon", type: str = "effectiveness", **more: Any
) -> dict[str, Any]:
    """The receipt of a failure."""
    event = {"time_s": time_s, "kind": "injection", "failure": 0, "type": type, "actuator": actuator}
    return {**event, "active": True, "properties": {"a/b": 0.5}, "verified": True, **more}


def readings_of(log: Mapping[str, np.ndarray], *events: Mapping[str, Any], **more: Any) -> Readings:
    """What metrics are computed from."""
    return Readings(log, events, ACTUATORS, **{"gamma": {"elevon": 4.0, "fan": 4.0}, **more})


def flight_of(
    log: Mapping[str, np.ndarray],
    events: Sequence[Mapping[str, Any]] = (),
    outcome: Outcome = Outcome.completed,
    requirements: Sequence[Mapping[str, Any]] = (),
    metrics: Mapping[str, float] | None = None,
    name: str = "handmade",
) -> ReportedFlight:
    """A finished flight with this log."""
    scenario = Scenario.model_validate(
        {
            "name": name,
            "aircraft": "vtail",
            "duration_s": 10,
            "rate_hz": 100,
            "initial": {"altitude_m": 100, "airspeed_m_s": 15, "heading_deg": 350},
            "requirements": [Requirement(metric="survived", at_least=1)],
            "failures": [{"type": "effectiveness", "actuator": "elevon", "at_s": 2.0, "value": 0.0}],
        }
    )
    return ReportedFlight(
        scenario=scenario,
        outcome=outcome,
        end_time_s=len(log["time_s"]) / 100.0,
        columns=tuple(log),
        data=np.column_stack(list(log.values())),
        events=events,
        metrics=metrics or {},
        requirements=requirements,
        actuators=ACTUATORS,
    )


def make_flight(rows: int = 100, columns: int = 20, **changes: object) -> ReportedFlight:
    """A flight of numbers that are hard to write exactly, in a shipped scenario."""
    data = np.random.default_rng(1).standard_normal((rows, columns)) * 10.0 ** np.arange(columns)
    data[0, -1], data[1, -1], data[2, -1] = -0.0, 5e-324, 1.7976931348623157e308
    data[3:6, -1] = np.nan, np.inf, -np.inf
    scenario = load_scenario("scenarios/left_tail_fail.yaml")
    data[:, 0] = 60.0 - (rows - np.arange(rows)) / scenario.log_hz
    contents: dict[str, object] = {
        "scenario": scenario,
        "outcome": Outcome.completed,
        "end_time_s": 60.0,
        "columns": (*ALWAYS_KNOWN, *(f"c{i}_deg" for i in range(columns)))[:columns],
        "data": data,
        "events": [
            {"time_s": np.float64(5.0), "kind": "injection", "failure": 0, "verified": np.bool_(True)}
        ],
        "metrics": {"b": np.float64(0.1), "a": math.nan},
        "requirements": [
            {"name": "a", "passed": True, "value": 0.1, "limit": "at most 1", "robustness": 0.25}
        ],
    }
    return ReportedFlight(**(contents | changes))  # type: ignore[arg-type]
