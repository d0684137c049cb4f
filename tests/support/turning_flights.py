"""Flights of the default law in turbulence, with MEMS sensors, which turn and climb before a failure and after it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flights import coefficient_errors

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.flight.flight import Flight
from testbed.inputs.yaml_source import parse
from testbed.simulation import fly
from testbed.studies.drawing.builder import Builder, Task, Variant

BASE = """\
name: turning flight
aircraft: vtail
duration_s: 110
rate_hz: 200
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller: {type: adaptive_inversion}
commands:
  - {at_s: 10, heading_deg: 120}
  - {at_s: 22, altitude_m: 310}
  - {at_s: 70, heading_deg: 90}
  - {at_s: 85, altitude_m: 300}
command_rates: {heading_deg_s: 4, altitude_m_s: 1}
sensors: mems
atmosphere: {turbulence_w20_m_s: 7.62}
requirements:
  - {signal: altitude_m, from_s: 60, within: 5, of: altitude_command_m}
  - {signal: heading_deg, from_s: 60, within: 10, of: heading_command_deg}
"""
FAILURE_S = 40.0


def flown(seed: int, failure: Mapping[str, Any], values: Mapping[str, Any] | None = None) -> Flight:
    """The flight of a seed with this failure from FAILURE_S on, and with these settings."""
    broken = {"failures": [{**failure, "at_s": FAILURE_S}]}
    return fly(
        Builder(parse(BASE), (Variant("", {}),)).scenario(Task(0, 0, seed, {**broken, **(values or {})}))
    )


def loss(actuator: str, value: float = 0.0) -> dict[str, Any]:
    """An actuator that keeps this share of its effect."""
    return {"type": "effectiveness", "actuator": actuator, "value": value}


def model_off(seed: int, size: float = 0.2) -> dict[str, Any]:
    """Settings with which each coefficient of the design model is too large or too small by `size`; the seed decides which."""
    model = load_design_model(load_aircraft("vtail").folder / DESIGN_MODEL)
    return {"controller.model_error": coefficient_errors(model.coefficient_names(), size, seed)}
