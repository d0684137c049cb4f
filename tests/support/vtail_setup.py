"""The v-tail's set-up and records at its reference trim, without a simulator."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, DesignModel, load_design_model
from testbed.common.signals import SETPOINT, STATE, record_dtype
from testbed.controllers.actuator_model import throttle_for
from testbed.controllers.config import AdaptiveInversionSettings, ControllerSettings
from testbed.controllers.initial_records import model_record, settings_record, trimmed_memory
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.records import work_dtype
from testbed.controllers.setup import Setup, setup_for

ACTUATORS = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")
WEATHER = AdaptiveInversionSettings()
PAPER = AdaptiveInversionSettings(preset="paper")
DT = 0.005


def vtail() -> tuple[Aircraft, DesignModel]:
    aircraft = load_aircraft("vtail")
    return aircraft, load_design_model(aircraft.folder / DESIGN_MODEL)


def vtail_setup(settings: ControllerSettings | None = None, **changes: Any) -> Setup:
    """Set-up at the design model's trim, of the paper's law if no settings are given; `changes` replace fields of it."""
    aircraft, model = vtail()
    positions = [math.degrees(p) if k == "servo" else p for p, k in zip(model.trim, model.kinds, strict=True)]
    chosen = settings or PAPER
    setup = setup_for(aircraft, model, chosen, DT, [0.0] * 4, positions, model.alpha_rad)
    m, s = model_record(setup)[0], trimmed_memory(setup)[0]
    commands = [
        p if k == "servo" else throttle_for(i, p, axial(model), m, s)
        for i, (p, k) in enumerate(zip(model.trim, model.kinds, strict=True))
    ]
    return replace(setup, trim_commands=commands, **changes)


def axial(model: DesignModel) -> float:
    """Airspeed along the propellers' axis at the reference trim."""
    return model.airspeed_m_s * math.cos(model.alpha_rad)


class Records(NamedTuple):
    """One record of each kind, by its letter."""

    m: Any
    c: Any
    k: Any
    s: Any
    w: Any


def records_of(setup: Setup) -> Records:
    """The records of a controller at the beginning of a flight."""
    memory = trimmed_memory(setup)
    estimation = setup.settings if isinstance(setup.settings, AdaptiveInversionSettings) else None
    return Records(
        model_record(setup)[0],
        settings_record(setup, estimation)[0],
        ModeSwitch(setup, memory).record[0],
        memory[0],
        np.zeros(1, work_dtype(len(setup.actuators)))[0],
    )


def state(**values: float) -> Any:
    """A measured state with these values, others zero."""
    record = np.zeros(1, record_dtype(STATE))[0]
    for name, value in values.items():
        record[name] = value
    return record


def trim_state(model: DesignModel, **changes: float) -> Any:
    """The state at the reference trim, level and heading north."""
    alpha = model.alpha_rad
    values = {"altitude": model.altitude_m, "airspeed": model.airspeed_m_s, "alpha": alpha, "pitch": alpha}
    return state(**{**values, **changes})


def setpoint(**values: float) -> Any:
    """References with these values, others zero."""
    record = np.zeros(1, record_dtype(SETPOINT))[0]
    for name, value in values.items():
        record[name] = value
    return record
