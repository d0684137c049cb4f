"""Fly a scenario: make every part new, run them in lockstep with the plant, and judge what was recorded."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from testbed.air.wind import Weather
from testbed.aircraft.changes import chosen
from testbed.aircraft.conventional_shape import drawn_by_effect
from testbed.aircraft.description import Aircraft
from testbed.aircraft.shape import Shape, load_shape
from testbed.common.jit import bound
from testbed.common.signals import SETPOINT, STATE, as_records, telemetry_rows
from testbed.controllers import Controller
from testbed.controllers.config import OracleSettings
from testbed.controllers.make import make_controller
from testbed.controllers.setup import Setup, setup_for
from testbed.controllers.user.adapter import adapted
from testbed.controllers.user.loader import name_of
from testbed.controllers.user.own import unused_parameters
from testbed.flight.columns import Recorded, all_columns, table
from testbed.flight.events import controller_events
from testbed.flight.flight import Outcome
from testbed.flight.loss import loss_event
from testbed.flight.recovery import recovery_events
from testbed.flight.requirements import judge
from testbed.injection.injector import Injector
from testbed.injection.truth import Truth
from testbed.inputs.problems import BadInput
from testbed.metrics import TABLE as METRICS
from testbed.metrics import Readings, adaptation_rates, measure
from testbed.plant.envelope import DIVERGED, GOES_ON, ON_THE_GROUND, OUTSIDE_ENVELOPE, limits_of, observe
from testbed.plant.identification import stored
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, begin_at, trimmed_start
from testbed.reporting.flight import ReportedFlight
from testbed.scenario import conditions
from testbed.scenario.checks import unknown_names
from testbed.scenario.load import Scenario, changed, load_scenario
from testbed.scenario.references import references
from testbed.sensors.suite import IdealSensors, RealSensors, make_sensors

_OUTCOMES = {
    GOES_ON: Outcome.completed,  # the last step was reached without any of the others
    DIVERGED: Outcome.diverged,
    ON_THE_GROUND: Outcome.ground_contact,
    OUTSIDE_ENVELOPE: Outcome.envelope_exceeded,
}


Watch = Callable[[float, np.ndarray], object]
"""Looks at a flight while it is flown: called with time [s] and row of truth of each control step."""


@dataclass
class Assembly:
    """Everything that takes part in one flight; all of it is made for this flight.

    Attributes:
        references: [steps, 6] rate-limited references by `signals.SETPOINT`.
        flown_by: name of the user's controller that flies in place of the scenario's, or empty.
    """

    scenario: Scenario
    aircraft: Aircraft
    plant: Plant
    controller: Controller
    injector: Injector
    weather: Weather
    sensors: IdealSensors | RealSensors
    references: np.ndarray
    shape: Shape
    flown_by: str = ""


def fly(
    scenario: Scenario | str | Path,
    controller: Callable[[Setup], Any] | None = None,
    *,
    set: Mapping[str, Any] | None = None,
    watch: Watch | None = None,
) -> ReportedFlight:
    """Fly a scenario. The same scenario, aircraft and controller give the same flight, to the last bit.

    Nothing is written; `Flight.save` writes a run folder as `testbed run` does.

    Args:
        scenario: the path of a scenario's YAML file, or a `Scenario`; a shipped file is found from any folder.
        controller: a class of your own that flies in place of the scenario's controller. It has
            `__init__(self, setup)` and `update(self, time_s, state, reference)`, as `examples/my_controller.py` shows.
        set: settings to change, as `--set` does: {"sensors": "mems", "failures.0.value": 0.5}, by dotted paths.
        watch: called in each control step with its time [s] and its row of truth (see `flight.columns.Recorded`), which it must
            not change; it may wait, so that the flight is shown in real time.

    Returns:
        The finished flight: `passed`, `outcome`, `log` (a DataFrame), `events`, `metrics`, `requirements`, `plot()`, `save()`.
        An aircraft that is lost is an outcome, not an exception.

    Raises:
        BadInput: the scenario, a name in it, its aircraft, or your controller cannot be used.
    """
    if not isinstance(scenario, Scenario):
        scenario = load_scenario(scenario, set or {})
    elif set:
        scenario = changed(scenario, set)
    parts = assemble(scenario, controller)
    outcome, recorded = lockstep(parts, watch)
    return conclude(parts, outcome, recorded)


def assemble(scenario: Scenario, controller: Callable[[Setup], Any] | None = None) -> Assembly:
    """Make plant, weather, controller, failures and sensors, and put the aircraft into trimmed flight; raises BadInput."""
    aircraft = chosen(scenario.aircraft)
    plant = Plant(
        aircraft, scenario.physics_hz, scenario.physics_steps, scenario.atmosphere.is_own_turbulence
    )
    _check_names(scenario, aircraft, plant)
    start = _start(scenario, aircraft)
    weather = Weather(scenario.atmosphere, plant, scenario.rate_hz, scenario.steps, scenario.seed)
    begin_at(plant, start)
    weather.begin()
    if controller is None and (problems := unused_parameters(scenario.controller)):
        raise BadInput(problems)
    setup = _setup(scenario, aircraft, start)
    injector = Injector(plant, aircraft, scenario.failures, scenario.rate_hz, scenario.seed)
    if controller is None and isinstance(scenario.controller, OracleSettings):
        setup = replace(setup, truth=Truth(plant, injector))
    return Assembly(
        scenario=scenario,
        aircraft=aircraft,
        plant=plant,
        controller=adapted(controller, setup) if controller else make_controller(setup),
        injector=injector,
        weather=weather,
        sensors=make_sensors(scenario.sensors, plant, scenario.rate_hz, scenario.steps, scenario.seed),
        references=references(scenario, start.state["path_angle"]),
        shape=load_shape(aircraft.folder) or drawn_by_effect(setup.model, plant.span_m),
        flown_by=name_of(controller) if controller else "",
    )


def lockstep(parts: Assembly, watch: Watch | None = None) -> tuple[Outcome, Recorded]:
    """Fly until the last control step or until the flight ends early; returns how it ended, and what was recorded.

    Raises BadInput when JSBSim cannot go on, or the user's controller.
    """
    with parts.plant.in_words():
        return _loop(parts, watch)


def _loop(parts: Assembly, watch: Watch | None) -> tuple[Outcome, Recorded]:
    """Step by step.

    In each control step k, at time k / rate: inject failures, set the wind, read and log the truth, measure, command, stop if
    the flight has ended, advance the plant.
    """
    plant, controller, injector = parts.plant, parts.controller, parts.injector
    weather, sensors = parts.weather, parts.sensors
    steps, n = parts.scenario.steps, len(parts.aircraft.actuators)
    truth = np.zeros((steps, len(STATE) + 2 * n))
    measured = np.zeros((steps, len(STATE)))
    telemetry = telemetry_rows(steps, n)
    controller.bind(as_records(measured, STATE), as_records(parts.references, SETPOINT), telemetry)
    sensors.bind(truth, measured)
    injector.observe(Recorded(truth, measured, parts.references, telemetry))
    channels = (plant.raw, plant.factors, limits_of(parts.aircraft.envelope), truth, measured)
    log_truth = bound(observe, 0, channels)
    ending, done = GOES_ON, steps
    for k in range(steps):
        if k >= injector.next_step:
            injector.apply(k)
        if k >= weather.next_step:
            weather.apply(k)
        plant.sample()
        ending = log_truth(k, channels)
        if watch is not None:
            watch(k / parts.scenario.rate_hz, truth[k])
        if sensors.real:
            sensors.measure(k)
        plant.command(controller.step(k))
        for delay in injector.filters:
            delay()
        if ending:
            done = k + 1
            break
        plant.step()
    recorded = Recorded(truth[:done], measured[:done], parts.references[:done], telemetry[:done])
    return _OUTCOMES[ending], recorded


def conclude(parts: Assembly, outcome: Outcome, recorded: Recorded) -> ReportedFlight:
    """The flight, with its log, events, metrics and verdicts on the requirements."""
    scenario, aircraft, steps = parts.scenario, parts.aircraft, len(recorded[0])
    names = all_columns(aircraft, scenario)
    more = {**parts.sensors.columns(recorded[0]), **parts.weather.columns(steps)}
    data = table(aircraft, scenario.rate_hz, recorded, more.values())
    log, every = dict(zip(names, data, strict=True)), scenario.rate_hz // scenario.log_hz
    actuators = {
        name: actuator.model_dump(include={"kind", "unit", "limits", "scale"})
        for name, actuator in aircraft.actuators.items()
    }
    warnings = parts.injector.finish()
    if not parts.flown_by:
        warnings += conditions.warnings(scenario)
    events = _events(parts, log, outcome, actuators)
    gamma = {} if parts.flown_by else adaptation_rates(scenario, actuators)
    metrics = measure(Readings(log, events, actuators, gamma, outcome is Outcome.completed))
    return ReportedFlight(
        scenario=scenario,
        outcome=outcome,
        end_time_s=steps / scenario.rate_hz,
        columns=names,
        data=np.ascontiguousarray(data[:, ::every]).T,
        events=events,
        metrics=metrics,
        requirements=judge(scenario.requirements, log, metrics, scenario.duration_s),
        actuators=actuators,
        warnings=warnings,
        shape=parts.shape,
        flown_by=parts.flown_by,
    )


def _events(
    parts: Assembly, log: dict[str, np.ndarray], outcome: Outcome, actuators: dict[str, dict[str, Any]]
) -> list[dict[str, Any]]:
    """Injections, sensor faults, what the controller flagged and released, its reasons, recoveries and the loss of the
    aircraft, in order of time."""
    injections, survived = parts.injector.receipts, outcome is Outcome.completed
    events = [
        *injections,
        *parts.sensors.receipts(len(log["time_s"])),
        *controller_events(log, tuple(actuators), injections),
        *recovery_events(log, injections, survived),
    ]
    if not survived:
        events.append(loss_event(log, outcome, parts.aircraft.envelope, actuators))
    for step, text in parts.controller.reasons:
        events.append({"time_s": step / parts.scenario.rate_hz, "kind": "diagnosis", "text": text})
    return sorted(events, key=lambda event: event["time_s"])


def _check_names(scenario: Scenario, aircraft: Aircraft, plant: Plant) -> None:
    properties = plant.catalog() if scenario.failures else {}
    problems = unknown_names(scenario, aircraft, all_columns(aircraft, scenario), METRICS, properties)
    if problems:
        raise BadInput(problems)


def _start(scenario: Scenario, aircraft: Aircraft) -> Trim:
    """Trimmed flight at the scenario's initial condition."""
    at = scenario.initial
    heading = math.radians(at.heading_deg)
    return trimmed_start(aircraft, scenario.physics_hz, at.airspeed_m_s, at.altitude_m, heading)


def start_and_setup(scenario: Scenario) -> tuple[Trim, Setup]:
    """The trimmed flight in which a scenario begins, and what its controller is told before it; raises BadInput."""
    aircraft = chosen(scenario.aircraft)
    start = _start(scenario, aircraft)
    return start, _setup(scenario, aircraft, start)


def _setup(scenario: Scenario, aircraft: Aircraft, start: Trim) -> Setup:
    """What the controller is told before the flight: of the aircraft as its files are, also where the truth is changed."""
    if aircraft.changes is not None:
        aircraft = aircraft.nominal
        start = _start(scenario, aircraft)
    return setup_for(
        aircraft,
        stored(aircraft),
        scenario.controller,
        1.0 / scenario.rate_hz,
        start.commands,
        start.positions,
        start.state["pitch"],
    )
