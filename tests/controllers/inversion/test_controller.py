"""The inversion controller flown: losses and jams in weather, read from the log."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from turning_flights import flown, loss, model_off
from vtail_setup import ACTUATORS, setpoint, trim_state, vtail_setup

import testbed
from testbed.common.signals import RATES, SETPOINT, STATE, record_dtype, telemetry_rows
from testbed.controllers.inversion.controller import InversionController, fixed_inversion
from testbed.controllers.records import REGULATOR_STATE
from testbed.controllers.setup import Setup
from testbed.flight.flight import Flight, Outcome
from testbed.inputs.problems import BadInput


def worst(flight: Flight, from_s: float = 60.0) -> tuple[float, float]:
    """Largest errors of altitude [m] and heading [deg] against the references from a time on."""
    log = flight.log[flight.log.time_s >= from_s]
    heading = (log.heading_deg - log.heading_command_deg + 180.0) % 360.0 - 180.0
    return float((log.altitude_m - log.altitude_command_m).abs().max()), float(heading.abs().max())


def texts_of(flight: Flight, kind: str) -> list[str]:
    return [str(e.get("actuator") or e.get("text")) for e in flight.events if e["kind"] == kind]


# Flights in which a false second flag, or no mode for what was left, once lost the flight.
HARD = [
    ("left_ruddervator", 90),
    ("right_ruddervator", 81),
    ("left_propeller", 94),
    ("left_propeller", 2005),
    ("right_propeller", 45),
    ("right_propeller", 49),
]


@pytest.mark.parametrize(("actuator", "seed"), HARD)
def test_a_total_loss_is_held_with_a_model_that_is_20_percent_off(actuator: str, seed: int) -> None:
    flight = flown(seed, loss(actuator), model_off(seed))
    altitude, heading = worst(flight)
    assert flight.outcome is Outcome.completed
    assert altitude <= 6.0 and heading <= 12.0
    assert set(texts_of(flight, "detection")) == {actuator}
    assert not texts_of(flight, "false_alarm")


def test_sinking_air_costs_height_but_not_the_aircraft() -> None:
    """One propeller left while the air sinks at 3.5 m/s for 15 s: more than full throttle can climb against."""
    gust = {"at_s": 70.0, "magnitude_m_s": [0.0, 0.0, 3.5], "frame": "ned", "duration_s": 3.0, "hold_s": 9.0}
    calm = {"atmosphere.turbulence_w20_m_s": 0.0, "atmosphere.gusts": [gust]}
    flight = flown(3, loss("left_propeller"), calm)
    assert flight.outcome is Outcome.completed
    during = flight.log[flight.log.time_s.between(70.0, 90.0)]
    assert during.wind_down_m_s.max() == pytest.approx(3.5, abs=0.05)
    assert during.airspeed_m_s.min() > 14.5, "speed is what it must not lose"
    assert worst(flight, 105.0)[0] < 2.0, "height comes back"


BROKEN: dict[str, Mapping[str, Any]] = {
    "jammed": {"type": "stuck_at", "actuator": "left_ruddervator", "value": 10.0},
    "reversed": {"type": "reversal", "actuator": "left_ruddervator"},
    "propeller at full throttle": {"type": "hardover", "actuator": "right_propeller", "to": "max"},
}


@pytest.mark.parametrize("name", BROKEN)
def test_what_is_no_loss_of_effectiveness_is_recognised_and_held(name: str) -> None:
    failure = BROKEN[name]
    flight = flown(6, failure)
    altitude, heading = worst(flight)
    assert flight.outcome is Outcome.completed
    # A propeller stuck at full throttle cannot be held as closely: there is no way to have less than its 15 N.
    within = (10.0, 20.0) if "propeller" in name else (5.0, 10.0)
    assert altitude <= within[0] and heading <= within[1]
    jams = [text for text in texts_of(flight, "diagnosis") if "not a loss of effectiveness" in text]
    assert [text.split(":")[0] for text in jams] == [failure["actuator"]]
    failed = {a for a in ACTUATORS if flight.log[f"{a}_failed"].iloc[-1] > 0.5}
    assert failed == {failure["actuator"]}


def test_an_offset_surface_is_held_and_kept() -> None:
    flight = flown(6, {"type": "bias", "actuator": "left_ruddervator", "value": 5.0})
    altitude, heading = worst(flight)
    assert flight.outcome is Outcome.completed
    assert altitude <= 5.0 and heading <= 10.0
    assert not [a for a in ACTUATORS if flight.log[f"{a}_failed"].any()]
    assert any("left_ruddervator: its force follows" in text for text in texts_of(flight, "diagnosis"))


def test_a_loss_is_not_called_a_jam() -> None:
    """Negative control of the last: a lost surface, and one that keeps 30 %."""
    for value in (0.0, 0.3):
        flight = flown(6, loss("left_ruddervator", value))
        assert not [text for text in texts_of(flight, "diagnosis") if "not a loss" in text]


def test_an_aircraft_that_cannot_be_inverted_is_refused_before_the_flight() -> None:
    """What was an AttributeError: bad input that names the aircraft, the condition number and what to change."""
    setup = vtail_setup()
    setup = replace(setup, control=setup.control.model_copy(update={"condition_max": 2.0}))
    for make in (InversionController, fixed_inversion):
        with pytest.raises(
            BadInput, match=r"vtail cannot be flown by inversion: .*condition number .* is above 2"
        ):
            make(setup)


def flown_by_hand(setup: Setup, adapts: bool, effectiveness: float) -> np.ndarray:
    """Telemetry of two seconds in which the measured rates are those of a model with this left tail, at the trim."""
    steps, model = 400, setup.model
    measured = np.zeros(steps, record_dtype(STATE))
    measured[:] = trim_state(model)
    unhealthy = np.array([effectiveness, 1.0, 1.0, 1.0])
    x = {name: float(measured[0][name]) for name in (*REGULATOR_STATE[:8],)}
    rates = model.rates(x, np.array(model.trim), unhealthy)
    for name, value in zip(RATES, rates, strict=False):
        measured[name] = value
    references = np.zeros(steps, record_dtype(SETPOINT))
    references[:] = setpoint(altitude=model.altitude_m, airspeed=model.airspeed_m_s)
    telemetry = telemetry_rows(steps, 4)
    controller = InversionController(setup) if adapts else fixed_inversion(setup)
    controller.bind(measured, references, telemetry)
    for step in range(steps):
        commands = list(controller.step(step))
        assert len(commands) == 4
    return telemetry


def test_the_mode_is_switched_in_the_step_that_flags() -> None:
    """An actuator whose effect is missing: flag and released axis appear in the same row, and that row has commands."""
    telemetry = flown_by_hand(vtail_setup(), True, 0.0)
    failed, released = telemetry[:, 12], telemetry[:, 20 + 2]
    assert failed[-1] == 1.0 and failed[0] == 0.0
    assert np.array_equal(failed, released), "r_dot is given up with the left tail"
    assert telemetry[:, 4:8].any(axis=1).all()


def test_a_fixed_inversion_neither_estimates_nor_flags() -> None:
    telemetry = flown_by_hand(vtail_setup(), False, 0.0)
    assert np.isnan(telemetry[:, 8:16]).all()


def test_airspeed_is_kept_where_the_model_knows_its_drag_badly() -> None:
    """The model's forward force by angle of attack is three times too large, and the flight 5 m/s faster than the design's."""
    faster = {"altitude_m": 200.0, "airspeed_m_s": 30.0, "heading_deg": 90.0}
    asked = {
        "aircraft": "aerosonde", "initial": {**faster, "airspeed_m_s": 25.0}, "commands": [{"at_s": 0, **faster}],
        "failures": [], "requirements": [], "duration_s": 50,
    }  # fmt: skip
    flights = []
    for ablate in ((), ("model_error",)):
        law = {"type": "adaptive_inversion", "model_error": {"CX_alpha": 3.0}, "ablate": list(ablate)}
        flights.append(testbed.fly("scenarios/left_tail_fail.yaml", set={**asked, "controller": law}))
    missed = []
    for flight in flights:
        late = flight.log[flight.log.time_s > 40.0]
        missed.append((late.airspeed_m_s - late.airspeed_command_m_s).abs().max())
    assert missed[0] < 0.1 and missed[1] > 2.0
