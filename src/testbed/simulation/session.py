"""One flight in the hand: it is stepped, looked at, broken and mended, and saved as a scenario that flies to the same bytes.

`fly` is a loop over a `Session` to which nothing is done.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from numbers import Integral, Real
from pathlib import Path
from typing import Any, Self

import numpy as np

from testbed.air.config import Gust, TurbulenceChange, WindChange
from testbed.common.signals import first_step_at, longer
from testbed.controllers.setup import Setup
from testbed.failures import Failure, same_property
from testbed.flight.columns import Row, row_columns
from testbed.flight.flight import Outcome
from testbed.injection.injector import Planned, mended, with_failure
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.reporting.flight import ReportedFlight
from testbed.scenario.consistency import MAX_STEPS
from testbed.scenario.flown import altered, flown_part, longer_scenario
from testbed.scenario.load import changed, load_scenario
from testbed.scenario.model import Command, Scenario
from testbed.scenario.references import references
from testbed.sensors.channels import channels_of
from testbed.sensors.faults import SensorFault, with_fault, without_faults
from testbed.simulation.assembly import Lockstep, assemble
from testbed.simulation.conclude import conclude
from testbed.simulation.given import command_of, failure_of, fault_of, gust_of, turbulence_of

Watch = Callable[[float, np.ndarray], object]
"""Looks at a flight while it is flown: called with time [s] and row of truth of each control step."""


class Session:
    """One flight in the hand.

    Each control step reads the truth at its beginning and ends with the plant one step later. So `time_s` is the present, and
    `truth`, `measured`, `references` and `belief` are those of the last control step, which was one step before.

    What is done to the flight begins in the next control step. `scenario` has all that was done, and flies to the same bytes.

        with testbed.Session("scenarios/left_tail_fail.yaml") as session:
            session.run_to(5.0)
            session.inject({"type": "stuck", "actuator": "left_ruddervator"})
            session.run_to(12.0)
            session.mend("left_ruddervator")
            session.step(200)
            print(session.truth["altitude_m"], session.belief["left_ruddervator_failed"])
            flight = session.flight()

    Args:
        scenario: the path of a scenario's YAML file, or a `Scenario`; a shipped file is found from any folder.
        controller: a class of your own that flies in place of the scenario's controller (see `fly`).
        set: settings to change, by dotted paths (see `fly`).

    Raises:
        BadInput: the scenario, a name in it, its aircraft, or your controller cannot be used. The methods raise it for what they
            are given, and then nothing has changed; and when the flight was closed, or stopped by an error.

    Attributes:
        parts: what takes part in the flight.
        loop: what steps it. `scenario` does not know of changes made to `parts` or `loop` directly.
    """

    def __init__(
        self,
        scenario: Scenario | str | Path,
        controller: Callable[[Setup], Any] | None = None,
        *,
        set: Mapping[str, Any] | None = None,
    ) -> None:
        _refuse_others(scenario, controller, set)
        if not isinstance(scenario, Scenario):
            scenario = load_scenario(scenario, set or {})
        elif set:
            scenario = changed(scenario, set)
        self.parts = assemble(scenario, controller)
        self.loop = Lockstep(self.parts)
        self._planned, self._closed = scenario, False
        self._healthy: dict[str, float] = {}
        self._wind_m_s = scenario.atmosphere.wind_m_s
        self._columns = row_columns(self.parts.aircraft)

    # Fly ------------------------------------------------------------------------------------------------------

    def step(self, n: int = 1) -> Outcome | None:
        """Fly n control steps, fewer if the flight ends; returns `ended`."""
        if isinstance(n, bool) or not isinstance(n, Integral) or n < 1:
            raise _refused("step", f"is {n!r}", "a whole number of control steps from 1")
        return self._fly(self.loop.done + int(n))

    def run_to(self, time_s: float) -> Outcome | None:
        """Fly until `time_s` is this [s], or until the flight ends; returns `ended`."""
        now_s, end_s = self.time_s, self._planned.duration_s
        if isinstance(time_s, bool) or not isinstance(time_s, Real) or not now_s <= time_s <= end_s:
            what = f"a time from {now_s:g}, which is now, to duration_s {end_s:g}"
            raise _refused("run_to", f"is {time_s!r}", what)
        return self._fly(first_step_at(time_s, self._planned.rate_hz))

    def _fly(self, until: int) -> Outcome | None:
        """Fly up to a control step. Before the first one, prepare for what may be done: a flight by `fly` needs none of it."""
        self._refuse_stopped()
        if not self._healthy:
            plant = self.parts.plant
            self.parts.weather.log_calm()
            self._healthy = {same_property(name): plant[name] for name in plant.catalog()}
        if until > self.loop.done and self.ended is None:
            self.loop.advance(until)
        return self.ended

    def extend(self, duration_s: float) -> None:
        """Let a flight that goes on last until this time [s], later than planned; a whole number of control steps."""
        self._refuse_over()
        planned, parts = self._planned, self.parts
        steps = math.nan
        if isinstance(duration_s, Real):
            with contextlib.suppress(OverflowError):
                steps = float(duration_s) * planned.rate_hz
        if not planned.steps < steps <= MAX_STEPS or abs(steps - round(steps)) > 1e-6:
            least = f"whole control steps of 1/{planned.rate_hz} s, more than {planned.duration_s:g} s, at most {MAX_STEPS}"
            raise _refused("extend", f"is {duration_s!r}", least)
        self._planned = parts.scenario = longer_scenario(self._whole(), float(duration_s))
        parts.weather.lengthen(self._planned.atmosphere, round(steps))
        if parts.sensors is not None:
            parts.sensors.lengthen(round(steps))
        rows = longer(parts.references, round(steps))
        self.loop.lengthen(references(self._planned, parts.path_angle, rows, self.loop.done))

    # Look -----------------------------------------------------------------------------------------------------

    @property
    def time_s(self) -> float:
        """How long has been flown [s]; also the time of the next control step."""
        return self.loop.done / self._planned.rate_hz

    @property
    def ended(self) -> Outcome | None:
        """How the flight ended; None while it goes on."""
        return self.loop.outcome

    @property
    def truth(self) -> Row:
        """What is true, by the names of the log's columns: {altitude_m, roll_deg, A_position, A_effectiveness, ...}."""
        return self._row("truth")

    @property
    def measured(self) -> Row:
        """The state that the controller was given, by the names of the log's columns: {altitude_m, p_dot_deg_s2, ...}."""
        return self._row("measured")

    @property
    def references(self) -> Row:
        """What the controller is to follow: {altitude_command_m, airspeed_command_m_s, heading_command_deg}."""
        return self._row("references")

    @property
    def belief(self) -> Row:
        """What the controller commands and takes for true: {A_command, A_effectiveness_estimate, A_failed, p_dot_released, ...}."""
        return self._row("telemetry")

    def _row(self, array: str) -> Row:
        self._refuse_empty()
        k = self.loop.done - 1
        return Row(self._columns[array], getattr(self.loop.rows, array)[k], k / self._planned.rate_hz)

    # Intervene ------------------------------------------------------------------------------------------------

    def inject(self, failure: Failure | SensorFault | Mapping[str, Any]) -> None:
        """Break something, as `failures` of a scenario does: now, or at its `at_s`, or when its `when` comes true.

        A failure that holds one of the same properties ends when the new one starts. If a failure that is planned for later will
        hold one, the new one ends when that one starts. So it is with faults of sensors, which name a `sensor` and are written as
        `sensors.faults` are: the flight's sensors may not be ideal ones.
        """
        self._refuse_over()
        if isinstance(failure, SensorFault) or (isinstance(failure, Mapping) and "sensor" in failure):
            fault = fault_of(failure, self.parts, self.loop.done)
            self._fault(with_fault(self._planned.sensors.faults, fault))
            return
        given = failure_of(failure, self.parts, self.loop.recorded)
        self._replan(with_failure(self.parts.injector.planned, given, self.parts.aircraft))

    def mend(self, actuator: str) -> None:
        """End every failure that an actuator has now: its properties get their values of before the flight. Or every fault of a
        sensor, of all its channels or of one."""
        self._refuse_over()
        known = self.parts.aircraft.actuators
        if isinstance(actuator, str) and actuator not in known and channels_of(actuator):
            faults = self._planned.sensors.faults
            left = without_faults(faults, actuator, self.loop.done, self._planned.rate_hz)
            if left == faults:
                raise _refused("mend", f"{actuator} has no fault now")
            self._fault(left)
            return
        if not isinstance(actuator, str) or actuator not in known:
            raise _refused("mend", f"there is no actuator {actuator!r}", *guess(actuator, known))
        self._replan(mended(self.parts.injector.planned, actuator, self.time_s))

    def _fault(self, faults: tuple[SensorFault, ...]) -> None:
        """Take other faults of sensors, which are the same until now."""
        if (sensors := self.parts.sensors) is not None:
            settings = self._planned.sensors.model_copy(update={"faults": faults})
            self._planned = self.parts.scenario = altered(self._planned, sensors=settings)
            sensors.fault(settings, self.loop.done)
            if self.parts.sensed is not None:
                self.parts.sensed.fault(settings, self.loop.done)

    def _replan(self, plan: Sequence[Planned]) -> None:
        """Take other failures. What is healthy is as it was before the flight, whatever holds the properties now."""
        healthy = self._healthy
        value = (lambda name: healthy[same_property(name)]) if healthy else None
        self.parts.injector.plan(plan, self.loop.done, value)

    def order(self, command: Command | Mapping[str, Any]) -> None:
        """Command altitude_m, airspeed_m_s, heading_deg or some of them: now, or at its `at_s`, at the scenario's command rates.

        A command that is planned for the same time is completed or replaced; later ones stay as they are.
        """
        self._refuse_over()
        done = self.loop.done
        new = command_of(command, self.parts, done)
        others = {each.at_s: each for each in self._planned.commands}
        if new.at_s in others:
            new = others[new.at_s].model_copy(update=new.model_dump(exclude_none=True))
        in_order = tuple(sorted({**others, new.at_s: new}.values(), key=lambda each: each.at_s))
        planned = altered(self._planned, commands=in_order)
        references(planned, self.parts.path_angle, self.parts.references, done)
        self._planned = self.parts.scenario = planned

    def blow(self, air: Gust | WindChange | TurbulenceChange | Mapping[str, Any]) -> None:
        """Blow a gust, as `gusts` of a scenario does, now or at its `at_s`; or change the steady wind, now, or the turbulence.

        Args:
            air: {magnitude_m_s, duration_s or length_m, frame, hold_s}; or {wind_m_s, duration_s}: the wind in place of that so
                far, reached within that time, by default 1 s, and saved as a gust that lasts; or {w20_m_s}: the intensity of
                JSBSim's turbulence in place of that so far, as `turbulence_changes` of a scenario has it.
        """
        self._refuse_over()
        if isinstance(air, TurbulenceChange) or (isinstance(air, Mapping) and "w20_m_s" in air):
            self.parts.weather.change(turbulence_of(air, self.parts, self.loop.done))
            return
        gust, self._wind_m_s = gust_of(air, self.parts, self.loop.done, self._wind_m_s)
        self.parts.weather.add(gust)

    # Keep -----------------------------------------------------------------------------------------------------

    @property
    def scenario(self) -> Scenario:
        """What has been done until now: it flies to the same bytes, with `duration_s` the time flown.

        Of a flight that has ended it is all that was planned. Raises BadInput where random numbers depend on what is left out,
        because it begins later and is listed earlier.
        """
        self._refuse_empty()
        whole = self._whole()
        return whole if self.ended is not None else flown_part(whole, self.loop.done)

    def _whole(self) -> Scenario:
        """The scenario with all that was done to the flight, and what is planned still."""
        planned, parts = self._planned, self.parts
        failures = parts.injector.failures
        if failures == planned.failures and parts.weather.settings == planned.atmosphere:
            return planned
        return altered(planned, failures=failures, atmosphere=parts.weather.settings)

    def flight(self) -> ReportedFlight:
        """The flight so far, judged as if it were to last until now; it can be flown on. Raises BadInput as `scenario`."""
        self._refuse_closed()
        return conclude(self.parts, self.scenario, self.ended or Outcome.completed, self.loop.recorded)

    def close(self) -> None:
        """Free the simulator and end the controller; what was read and saved stays. Closing twice does nothing."""
        if not self._closed:
            self._closed = True
            if callable(close := getattr(self.parts.controller, "close", None)):
                close()
            del self.parts, self.loop.parts

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _refuse_closed(self) -> None:
        if self._closed:
            raise _refused("Session", "was closed", "a new one")

    def _refuse_stopped(self) -> None:
        """Raise BadInput if the flight cannot be flown on."""
        self._refuse_closed()
        if (error := self.loop.stopped_by) is not None:
            why = str(error) or type(error).__name__
            raise _refused("Session", f"was stopped at {self.time_s:g} s: {why}", "a new one")

    def _refuse_over(self) -> None:
        """Raise BadInput if nothing can be done to the flight any more."""
        self._refuse_stopped()
        if self.ended is not None:
            what = f"the flight is over: the aircraft {self.ended.sentence}, {self.time_s:g} s"
            raise _refused("Session", what, "a new one")

    def _refuse_empty(self) -> None:
        self._refuse_closed()
        if not self.loop.done:
            raise _refused("Session", "nothing has been flown yet", "step or run_to before")


def _refused(verb: str, what: str, expected: str = "", suggestion: str = "") -> BadInput:
    return BadInput([Problem(what, verb, expected=expected, suggestion=suggestion)])


def _refuse_others(scenario: object, controller: object, settings: object) -> None:
    """Raise BadInput for arguments of a wrong kind."""
    wrong = []
    if not isinstance(scenario, Scenario | str | Path):
        wrong.append(("scenario", scenario, "the path of a scenario's YAML file, or a Scenario"))
    if controller is not None and not callable(controller):
        wrong.append(("controller", controller, "a class of your own"))
    if not isinstance(settings, Mapping | None):
        wrong.append(("set", settings, "a mapping of dotted paths to values"))
    if wrong:
        raise BadInput([Problem(f"is {value!r:.60}", name, expected=what) for name, value, what in wrong])


def fly(
    scenario: Scenario | str | Path,
    controller: Callable[[Setup], Any] | None = None,
    *,
    set: Mapping[str, Any] | None = None,
    watch: Watch | None = None,
) -> ReportedFlight:
    """Fly a scenario. The same scenario, aircraft and controller give the same flight, to the last bit.

    Nothing is written; `ReportedFlight.save` writes a run folder as `testbed run` does.

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
    with Session(scenario, controller, set=set) as session:
        loop = session.loop  # its steps prepare nothing for what could be done to the flight
        while loop.outcome is None:
            loop.advance(loop.steps if watch is None else loop.done + 1)
            if watch is not None:
                watch((loop.done - 1) / loop.parts.scenario.rate_hz, loop.rows.truth[loop.done - 1])
        flight, plan = session.flight(), session.parts.plan
    return replace(flight, files=plan.files()) if plan.has_folder else flight
