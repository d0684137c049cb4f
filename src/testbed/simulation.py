"""Fly a scenario: assemble everything new, loop in lockstep with the plant, judge the result."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from testbed.air.wind import Weather
from testbed.aircraft.description import Aircraft, Envelope, load_aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.common.jit import bound, compiled
from testbed.common.signals import SETPOINT, STATE, as_records, telemetry_width
from testbed.controllers import Controller
from testbed.controllers.make import make_controller
from testbed.controllers.setup import Setup, setup_for
from testbed.controllers.user.adapter import adapted
from testbed.controllers.user.loader import name_of
from testbed.flight.columns import Recorded, all_columns, table
from testbed.flight.events import controller_events
from testbed.flight.flight import Flight, Outcome
from testbed.flight.verdict import judge
from testbed.injection.injector import Injector
from testbed.inputs.problems import BadInput
from testbed.metrics import TABLE as METRICS
from testbed.metrics import Readings, adaptation_rates, measure
from testbed.plant import identification
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, trim
from testbed.scenario.load import Scenario, check_names, check_properties, load_scenario
from testbed.scenario.references import references
from testbed.sensors.suite import IdealSensors, RealSensors, make_sensors

_SETTLE_S = 1.5  # rotors and servos steady before the flight begins
_GROUND_M = 0.5  # altitude of the centre of gravity at which the aircraft is on the ground
_OUTCOMES = (Outcome.completed, Outcome.diverged, Outcome.ground_contact, Outcome.envelope_exceeded)


@dataclass
class Assembly:
    """Everything that takes part in one flight; made new for it."""

    scenario: Scenario
    aircraft: Aircraft
    plant: Plant
    controller: Controller
    injector: Injector
    weather: Weather
    sensors: IdealSensors | RealSensors
    references: np.ndarray
    limits: np.ndarray
    flown_by: str = ""
    """The user's controller that flew in place of the scenario's, or empty."""


def fly(scenario: Scenario | str | Path, controller: Callable[[Setup], Any] | None = None) -> Flight:
    """Fly a scenario, or the file of one; a pure function of it.

    Args:
        controller: a class of the user's own that flies in place of the scenario's (see `controllers.user.adapter`).

    Raises:
        BadInput: the scenario, a name in it, or the user's controller cannot be used.
    """
    if not isinstance(scenario, Scenario):
        scenario = load_scenario(scenario)
    parts = assemble(scenario, controller)
    outcome, recorded = lockstep(parts)
    return conclude(parts, outcome, recorded)


def assemble(scenario: Scenario, controller: Callable[[Setup], Any] | None = None) -> Assembly:
    """Make plant, controller and failures, and put the aircraft into trimmed flight."""
    aircraft = load_aircraft(scenario.aircraft)
    problems = check_names(scenario, all_columns(aircraft, scenario), METRICS)
    if problems:
        raise BadInput(problems)
    initial = scenario.initial
    start = _start(
        scenario.aircraft, scenario.physics_hz, initial.airspeed_m_s, initial.altitude_m, initial.heading_deg
    )
    plant = Plant(aircraft, scenario.physics_hz, scenario.physics_steps)
    if scenario.failures:
        problems = check_properties(scenario, plant.catalog())
        if problems:
            raise BadInput(problems)
    weather = Weather(scenario.atmosphere, plant, scenario.rate_hz, scenario.steps, scenario.seed)
    plant.command(start.commands)
    plant.place(start.state)
    plant.settle(round(_SETTLE_S * scenario.physics_hz))
    plant.place(start.state)  # the Earth has turned while rotors settled: back to the start
    weather.begin()
    return Assembly(
        scenario=scenario,
        aircraft=aircraft,
        plant=plant,
        controller=_controller(controller, scenario, _setup(scenario, aircraft, start)),
        injector=Injector(plant, aircraft, scenario.failures, scenario.rate_hz, scenario.seed),
        weather=weather,
        sensors=make_sensors(scenario.sensors, plant, scenario.rate_hz, scenario.steps, scenario.seed),
        references=references(scenario),
        limits=_limits(aircraft.envelope),
        flown_by=name_of(controller) if controller else "",
    )


def _controller(own: Callable[[Setup], Any] | None, scenario: Scenario, setup: Setup) -> Controller:
    return adapted(own, setup) if own else make_controller(setup)


def lockstep(parts: Assembly) -> tuple[Outcome, Recorded]:
    """The loop. Each control step k, t = k / rate: inject, read the truth, measure, command, log, end?, step."""
    plant, controller, injector = parts.plant, parts.controller, parts.injector
    weather, sensors = parts.weather, parts.sensors
    steps, n = parts.scenario.steps, len(parts.aircraft.actuators)
    truth = np.zeros((steps, len(STATE) + 2 * n))
    measured = np.zeros((steps, len(STATE)))
    telemetry = np.zeros((steps, telemetry_width(n)))
    controller.bind(as_records(measured, STATE), as_records(parts.references, SETPOINT), telemetry)
    sensors.bind(truth, measured)
    channels = (plant.raw, plant.factors, parts.limits, truth, measured)
    observe = bound(log_truth, 0, channels)
    injector.observe((truth, measured, parts.references, telemetry))
    ending, done = 0, steps
    for k in range(steps):
        if k >= injector.next_step:
            injector.apply(k)
        if k >= weather.next_step:
            weather.apply(k)
        plant.sample()
        ending = observe(k, channels)
        if sensors.real:
            sensors.measure(k)
        plant.command(controller.step(k))
        for delay in injector.filters:
            delay()
        if ending:
            done = k + 1
            break
        plant.step()
    return _OUTCOMES[ending], (truth[:done], measured[:done], parts.references[:done], telemetry[:done])


@compiled
def log_truth(k, channels):  # type: ignore[no-untyped-def]
    """Log the truth in SI, measure it ideally, and say whether the flight goes on: 0, or the index of its outcome."""
    raw, factors, limits, truth, measured = channels
    row = truth[k]
    finite = True
    for i in range(len(raw)):
        row[i] = raw[i] * factors[i]
        finite = finite and math.isfinite(row[i])
    for i in range(measured.shape[1]):
        measured[k, i] = row[i]
    altitude, airspeed, roll, alpha, beta = row[2], row[3], row[5], row[8], row[9]
    if not finite:
        return 1
    if altitude < limits[0]:
        return 2
    if airspeed < limits[1] or airspeed > limits[2] or altitude < limits[6]:
        return 3
    if abs(alpha) > limits[3] or abs(beta) > limits[4] or abs(roll) > limits[5]:
        return 3
    return 0


def conclude(parts: Assembly, outcome: Outcome, recorded: Recorded) -> Flight:
    """Events, metrics and verdicts of what was recorded."""
    scenario, aircraft = parts.scenario, parts.aircraft
    names = all_columns(aircraft, scenario)
    more = {**parts.sensors.columns(recorded[0]), **parts.weather.columns(len(recorded[0]))}
    data = table(aircraft, scenario.rate_hz, recorded, more.values())
    log, every = dict(zip(names, data, strict=True)), scenario.rate_hz // scenario.log_hz
    actuators = {
        name: actuator.model_dump(include={"kind", "unit", "limits", "scale"})
        for name, actuator in aircraft.actuators.items()
    }
    warnings = parts.injector.finish()
    injections = parts.injector.receipts
    events = [
        *injections,
        *parts.sensors.receipts(len(recorded[0])),
        *controller_events(log, tuple(actuators), injections),
    ]
    for step, text in parts.controller.reasons:
        events.append({"time_s": step / scenario.rate_hz, "kind": "diagnosis", "text": text})
    events.sort(key=lambda event: event["time_s"])
    survived = outcome is Outcome.completed
    gamma = {} if parts.flown_by else adaptation_rates(scenario, actuators)
    metrics = measure(Readings(log, events, actuators, gamma, survived))
    return Flight(
        scenario=scenario,
        outcome=outcome,
        end_time_s=len(recorded[0]) / scenario.rate_hz,
        columns=names,
        data=np.ascontiguousarray(data[:, ::every]).T,
        events=events,
        metrics=metrics,
        requirements=judge(scenario.requirements, log, metrics),
        actuators=actuators,
        warnings=warnings,
        flown_by=parts.flown_by,
    )


@lru_cache(maxsize=32)
def _start(
    aircraft: str, physics_hz: int, airspeed_m_s: float, altitude_m: float, heading_deg: float
) -> Trim:
    """Trimmed flight, found on a plant of its own so that it depends on nothing else; kept, as it is costly."""
    plant = Plant(load_aircraft(aircraft), physics_hz)
    return trim(plant, airspeed_m_s, altitude_m, math.radians(heading_deg))


@lru_cache(maxsize=8)
def _design_model(aircraft: str) -> DesignModel:
    return identification.stored(load_aircraft(aircraft))


def _setup(scenario: Scenario, aircraft: Aircraft, start: Trim) -> Setup:
    return setup_for(
        aircraft,
        _design_model(scenario.aircraft),
        scenario.controller,
        1.0 / scenario.rate_hz,
        start.commands,
        start.positions,
        start.state["pitch"],
    )


def _limits(envelope: Envelope) -> np.ndarray:
    """[7] ground, airspeed low and high, alpha, beta, roll, altitude [SI, rad] beyond which a flight ends."""

    def radians(value: float | None) -> float:
        return math.inf if value is None else math.radians(value)

    return np.array(
        [
            _GROUND_M,
            envelope.airspeed_min_m_s or 0.0,
            math.inf if envelope.airspeed_max_m_s is None else envelope.airspeed_max_m_s,
            radians(envelope.alpha_max_deg),
            radians(envelope.beta_max_deg),
            radians(envelope.roll_max_deg),
            -math.inf if envelope.altitude_min_m is None else envelope.altitude_min_m,
        ]
    )
