"""The parts of one flight, all made new for it; and the loop: in each control step all of them take their turn, and its rows are
recorded."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from testbed.air.wind import Weather
from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.conventional_shape import shape_of
from testbed.aircraft.description import Aircraft
from testbed.aircraft.shape import Shape
from testbed.common.jit import bound
from testbed.common.signals import SETPOINT, STATE, as_records, longer, telemetry_rows
from testbed.controllers import Controller
from testbed.controllers.config import InformedSettings
from testbed.controllers.make import make_controller
from testbed.controllers.setup import FlightPlan, Setup, setup_for
from testbed.controllers.user.loader import name_of
from testbed.controllers.user.own import digest_of
from testbed.flight.columns import Recorded
from testbed.flight.flight import Outcome
from testbed.injection.injector import Injector, Truth
from testbed.plant.envelope import DIVERGED, GOES_ON, ON_THE_GROUND, OUTSIDE_ENVELOPE, limits_of, observe
from testbed.plant.identification import stored
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, begin_at, trimmed_start
from testbed.scenario.model import Scenario
from testbed.scenario.references import references
from testbed.sensors.suite import RealSensors, Sensed
from testbed.simulation.check import check, start_of

_OUTCOMES = {
    GOES_ON: Outcome.completed,  # the last step was reached without any of the others
    DIVERGED: Outcome.diverged,
    ON_THE_GROUND: Outcome.ground_contact,
    OUTSIDE_ENVELOPE: Outcome.envelope_exceeded,
}


@dataclass
class Assembly:
    """Everything that takes part in one flight; all of it is made for this flight.

    Attributes:
        sensors: those with errors; None for ideal ones.
        sensed: what an autopilot outside of the program is given; None if the controller does not ask for it.
        references: [steps, 6] rate-limited references by `signals.SETPOINT`.
        path_angle: of the steady flight in which the flight begins [rad].
        plan: what the controller was told of the flight; its folder has the controller's own files.
        flown_by: name of the user's controller that flies in place of the scenario's, or empty.
        flown_by_sha256: digest of its files and arguments (see `user.own.digest_of`).
    """

    scenario: Scenario
    aircraft: Aircraft
    plant: Plant
    controller: Controller
    injector: Injector
    weather: Weather
    sensors: RealSensors | None
    references: np.ndarray
    path_angle: float
    shape: Shape
    plan: FlightPlan
    flown_by: str = ""
    flown_by_sha256: str = ""
    sensed: Sensed | None = None


def assemble(scenario: Scenario, controller: Callable[[Setup], Any] | None = None) -> Assembly:
    """Make plant, weather, controller, failures and sensors, and put the aircraft into trimmed flight.

    Raises BadInput with everything that `check` finds, or when the controller cannot be made.
    """
    aircraft = check(scenario, remembered=False)
    plant = Plant(
        aircraft, scenario.physics_hz, scenario.physics_steps, scenario.atmosphere.is_own_turbulence
    )
    start = trimmed_start(aircraft, *start_of(scenario))
    weather = Weather(scenario.atmosphere, plant, scenario.rate_hz, scenario.steps, scenario.seed)
    begin_at(plant, start)
    weather.begin()
    setup = _setup(scenario, aircraft, start)
    injector = Injector(plant, aircraft, scenario.failures, scenario.rate_hz, scenario.seed)
    if controller is None and isinstance(scenario.controller, InformedSettings):
        setup = replace(setup, truth=Truth(plant, injector))
    sensors = None
    if not scenario.sensors.is_ideal:
        force = plant.specific_force_reader("x")
        sensors = RealSensors(scenario.sensors, force, scenario.rate_hz, scenario.steps, scenario.seed)
    plan = FlightPlan(scenario.seed, without_what_fails(scenario))
    made = make_controller(replace(setup, plan=plan), controller)
    sensed = None
    if getattr(made, "senses", False):
        sensed = Sensed(sensors, plant.air_and_ground_reader(), scenario.rate_hz)
    return Assembly(
        scenario=scenario,
        aircraft=aircraft,
        plant=plant,
        controller=made,
        injector=injector,
        weather=weather,
        sensors=sensors,
        references=references(scenario, start.state["path_angle"]),
        path_angle=start.state["path_angle"],
        shape=shape_of(aircraft, setup.model, plant.span_m),
        flown_by=name_of(controller) if controller else "",
        flown_by_sha256=digest_of(controller) if controller else "",
        sensed=sensed,
        plan=plan,
    )


def without_what_fails(scenario: Scenario) -> dict[str, Any]:
    """A scenario as its file holds it, without what goes wrong in it: a controller is not told."""
    said = scenario.model_dump(mode="json", exclude={"failures", "aircraft", "requirements"})
    if isinstance(sensors := said.get("sensors"), dict):
        sensors.pop("faults", None)
    return said


def start_and_setup(scenario: Scenario) -> tuple[Trim, Setup]:
    """The trimmed flight in which a scenario begins, and what its controller is told before it; raises BadInput."""
    aircraft = load_with_changes(scenario.aircraft)
    start = trimmed_start(aircraft, *start_of(scenario))
    return start, _setup(scenario, aircraft, start)


def _setup(scenario: Scenario, aircraft: Aircraft, start: Trim) -> Setup:
    """What the controller is told before the flight: of the aircraft as its files are, also where the truth is changed."""
    if aircraft.changes is not None:
        aircraft = aircraft.nominal
        start = trimmed_start(aircraft, *start_of(scenario))
    return setup_for(
        aircraft,
        stored(aircraft),
        scenario.controller,
        1.0 / scenario.rate_hz,
        start.commands,
        start.positions,
        start.state["pitch"],
    )


class Lockstep:
    """The parts of one flight, and what they have recorded.

    Attributes:
        rows: one row for each control step of the whole flight; those flown are filled.
        done: number of control steps flown.
        outcome: how the flight ended; None while it goes on.
        stopped_by: the error that stopped the flight; None if none did.
    """

    def __init__(self, parts: Assembly) -> None:
        self.parts, self.done = parts, 0
        self.outcome: Outcome | None = None
        self.stopped_by: BaseException | None = None
        n, steps = len(parts.aircraft.actuators), parts.scenario.steps
        truth = np.zeros((steps, len(STATE) + 2 * n))
        measured = np.zeros((steps, len(STATE)))
        self._bind(Recorded(truth, measured, parts.references, telemetry_rows(steps, n)))

    def _bind(self, rows: Recorded) -> None:
        """Give the parts the rows that the flight fills."""
        parts, (truth, measured, setpoints, telemetry) = self.parts, rows
        self.rows = rows
        parts.controller.bind(as_records(measured, STATE), as_records(setpoints, SETPOINT), telemetry)
        if parts.sensors is not None:
            parts.sensors.bind(truth, measured)
        if parts.sensed is not None:
            parts.sensed.bind(truth, measured)
            parts.controller.bind_sensed(parts.sensed.rows)  # type: ignore[attr-defined]
        parts.injector.observe(rows)
        limits = limits_of(parts.aircraft.envelope)
        wind = (
            parts.weather.now if parts.sensors is None else np.zeros(3)
        )  # real sensors measure u_dot themselves
        self._channels = (parts.plant.raw, parts.plant.factors, wind, limits, truth, measured)
        self._log_truth = bound(observe, 0, self._channels)

    @property
    def steps(self) -> int:
        """Control steps of the whole flight."""
        return len(self.rows.truth)

    @property
    def recorded(self) -> Recorded:
        """The rows of the control steps flown."""
        return Recorded(*(rows[: self.done] for rows in self.rows))

    def lengthen(self, references: np.ndarray) -> None:
        """Take more control steps: `references` [steps, 6] begin with those so far, and weather and sensors have theirs."""
        so_far, steps = self.rows, len(references)
        telemetry = longer(so_far.telemetry, steps, math.nan)
        truth, measured = longer(so_far.truth, steps), longer(so_far.measured, steps)
        self.parts.references = references
        self._bind(Recorded(truth, measured, references, telemetry))

    def advance(self, until: int) -> None:
        """Fly up to this control step, or until the flight ends.

        In each control step k, at time k / rate: inject failures, set the wind, read and log the truth, measure, command, stop if
        the flight has ended, advance the plant.

        Raises BadInput when JSBSim cannot go on, or the user's controller.
        """
        plant, controller, injector = self.parts.plant, self.parts.controller, self.parts.injector
        weather, sensors, sensed = self.parts.weather, self.parts.sensors, self.parts.sensed
        log_truth, channels, steps = self._log_truth, self._channels, self.steps
        k, ending = self.done, GOES_ON
        try:
            with plant.in_words():
                for k in range(self.done, min(until, steps)):
                    if k >= injector.next_step:
                        injector.apply(k)
                    if k >= weather.next_step:
                        weather.apply(k)
                    plant.sample()
                    ending = log_truth(k, channels)
                    if sensors is not None:
                        sensors.measure(k)
                    if sensed is not None:
                        sensed.read(k)
                    plant.command(controller.step(k))
                    for delay in injector.filters:
                        delay()
                    if ending:
                        break
                    plant.step()
        except BaseException as error:
            self.done, self.stopped_by = k, error
            raise
        self.done = k + 1
        if ending or self.done == steps:
            self.outcome = _OUTCOMES[ending]
