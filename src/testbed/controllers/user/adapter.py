"""A user's own controller: a class in a file of theirs, in plain Python, flown without touching the package.

    class MyController:
        def __init__(self, setup): ...                      # a `Setup`: design model, trim, stops, time step
        def update(self, time_s, state, reference): ...     # -> commands: servos in radians, motors as throttle 0 to 1

`update` may have a fourth parameter, `sensed`: a `Sensed`, with what an autopilot's own sensors read. A method `close` is called
when the flight is over. `setup.plan` has the flight's seed, its scenario and a folder for files.

`state` is a `State`, as measured, and `reference` is a `Reference`; both are in SI units and radians. The commands are one
number for each actuator, in the order of `setup.model.actuators`. The object may have the attributes `effectiveness` and
`failed`, with one number for each actuator. They are logged, and judged by the metrics, as its estimates and its flags;
without them the log has NaN, and nothing is judged that asks for them. The class may have an attribute
`parameters`, a mapping of names to defaults; `setup.parameters` then has these, with the values of `controller.parameters` in
the scenario or the sweep. A class with `bind` and `step` (see `controllers.Controller`) is flown as it is.

An error in the class is reported as bad input with the user's file and line, and with the time if it happens in flight.
"""

from __future__ import annotations

import inspect
import math
import warnings
from collections.abc import Collection, Sequence
from dataclasses import replace
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np

from testbed.controllers import Controller
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.setup import Setup
from testbed.controllers.user.loader import Factory, in_words, place_of, shown, undeclared
from testbed.inputs.problems import BadInput, Problem, did_you_mean

_UPDATE = "update(time_s, state, reference) -> commands"
_KEPT = ("effectiveness", "failed")
"""Attributes of the user's object that are logged, if it has them."""


_NUMBERS = "biufO"
"""Kinds of numpy arrays of real numbers, or of objects that may be: numpy would make numbers of texts and complex ones, too."""
_LARGEST = 1e12
"""No command comes near it; beyond, products overflow."""
_SLOW_S, _LONG_S = 3.0, 60.0
"""After how long in the user's code it is said how long the flight takes, if that is longer than the second [s]."""


class State(NamedTuple):
    """The measured state (`signals.STATE`), in SI units and radians.

    `north` and `east` [m] are from the start of the flight, `altitude` [m] is above mean sea level. `airspeed` [m/s], `alpha`
    and `beta` [rad] are relative to the air, `climb_rate` [m/s] is over the ground. Positive are a bank to the right, nose up,
    headings clockwise from north, and wind from the right in `beta` [rad]. `p`, `q`, `r` [rad/s] and their derivatives
    [rad/s2] are about the body axes x forward, y right, z down; `u_dot` [m/s2] is along x.
    """

    north: float
    east: float
    altitude: float
    airspeed: float
    climb_rate: float
    roll: float
    pitch: float
    heading: float
    alpha: float
    beta: float
    p: float
    q: float
    r: float
    p_dot: float
    q_dot: float
    r_dot: float
    u_dot: float


class Reference(NamedTuple):
    """The references to follow (`signals.SETPOINT`), rate-limited [m, m/s, rad], and their rates [m/s, m/s2, rad/s]."""

    altitude: float
    airspeed: float
    heading: float
    altitude_rate: float
    airspeed_rate: float
    heading_rate: float


class Sensed(NamedTuple):
    """What an autopilot senses (`signals.SENSED`), in SI units and radians, each as the scenario's sensors read it.

    The force [m/s2] is the specific force along the body axes, without gravity. The velocity [m/s] is over the ground. `pressure`
    [Pa] is the static pressure, which shows the altitude that is read.
    """

    time: float
    p: float
    q: float
    r: float
    force_x: float
    force_y: float
    force_z: float
    velocity_north: float
    velocity_east: float
    velocity_down: float
    north: float
    east: float
    altitude: float
    roll: float
    pitch: float
    heading: float
    airspeed: float
    alpha: float
    beta: float
    pressure: float
    temperature: float


class Adapted:
    """What a user's object is flown by.

    Attributes:
        senses: whether the object wants the rows of `signals.SENSED` too, which `bind_sensed` then takes.
        outside: whether it has a method `close`, as one that holds a process or a connection should have.
    """

    def __init__(self, setup: Setup, flown: Any, name: str, senses: bool) -> None:
        self._dt, self._names, self._flown, self._name = setup.dt_s, setup.model.actuators, flown, name
        self.senses, self.outside = senses, callable(getattr(flown, "close", None))

    def close(self) -> None:
        """Close the user's object when the flight is over, if it has a method for it."""
        if self.outside:
            with in_words(self._name, "while being closed"):
                self._flown.close()


class AsItIs(Adapted):
    """A user's class with `bind` and `step`, and with `reasons` if it gives any."""

    def __init__(self, setup: Setup, flown: Any, name: str) -> None:
        super().__init__(setup, flown, name, callable(getattr(flown, "bind_sensed", None)))
        self._step = flown.step

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """See `Controller.bind`; raises BadInput when the user's code fails."""
        with in_words(self._name, "while being bound"):
            self._flown.bind(_to_read(states), _to_read(setpoints), telemetry)

    def bind_sensed(self, sensed: np.ndarray) -> None:
        """Take the rows of `signals.SENSED`, for a class that has this method."""
        with in_words(self._name, "while being bound"):
            self._flown.bind_sensed(sensed)

    def step(self, step: int) -> np.ndarray:
        """See `Controller.step`; raises BadInput, with the time, when the user's code fails."""
        with in_words(self._name, f"at {step * self._dt:.3f} s"):
            answer = self._step(step)
        return checked(answer, "commands", self._names, self._name, step * self._dt)

    @property
    def reasons(self) -> Sequence[tuple[int, str]]:
        """See `Controller.reasons`; none if the user's class has no such attribute."""
        with in_words(self._name, "in its reasons"):
            return [(int(step), str(why)) for step, why in getattr(self._flown, "reasons", ())]


class CustomController(Adapted):
    """Flies a user's `update`: gives it state and reference, a `Sensed` if it has a parameter `sensed`, checks the commands that it
    returns, and logs them."""

    reasons: Sequence[tuple[int, str]] = ()

    def __init__(self, setup: Setup, flown: Any, name: str) -> None:
        super().__init__(setup, flown, name, "sensed" in parameters_of(flown.update))
        self._update, self._log, self._spent_s = flown.update, CommandLog(setup), 0.0

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `controllers.Controller`)."""
        self._states, self._setpoints, self._telemetry = states, setpoints, telemetry

    def bind_sensed(self, sensed: np.ndarray) -> None:
        """Take the rows of `signals.SENSED`, with one record for each control step."""
        self._sensed = sensed

    def step(self, step: int) -> np.ndarray:
        """Commands [n] for row `step`; raises BadInput, with the time, when the user's code fails."""
        time_s, begin = step * self._dt, perf_counter()
        state = State._make(self._states[step].tolist())
        reference = Reference._make(self._setpoints[step].tolist())
        given = [Sensed._make(self._sensed[step].tolist())] if self.senses else []
        with in_words(self._name, f"at {time_s:.3f} s"):
            answer = self._update(time_s, state, reference, *given)
            kept = [getattr(self._flown, name, None) for name in _KEPT]
        if step > 0:  # what is done once, as an autopilot's warm-up, says nothing of the others
            self._spent_s += perf_counter() - begin
        if self._spent_s > _SLOW_S:
            self._say_how_long(step)
        commands = checked(answer, "commands", self._names, self._name, time_s)
        self._write_telemetry(step, commands, kept, time_s)
        return commands

    def _say_how_long(self, steps: int) -> None:
        """Warn once of a flight that takes longer than `_LONG_S`."""
        each_s, self._spent_s = self._spent_s / steps, -math.inf
        if (whole_s := each_s * len(self._telemetry)) > _LONG_S:
            words = f"{self._name}: takes {each_s:.2g} s in each control step, {whole_s:.0f} s for the whole flight"
            warnings.warn(words, stacklevel=2)

    def _write_telemetry(self, step: int, commands: np.ndarray, kept: Sequence[Any], time_s: float) -> None:
        n, row = len(self._names), self._telemetry[step]
        self._log.write(row, commands, self._states[step])
        for i, (name, own) in enumerate(zip(_KEPT, kept, strict=True), 2):
            if own is not None:
                row[i * n : (i + 1) * n] = checked(own, name, self._names, self._name, time_s)


def checked(answer: Any, what: str, actuators: Sequence[str], name: str, time_s: float) -> np.ndarray:
    """The answer of the user's code of this name as a finite number for each actuator; raises BadInput when it is anything else."""
    n = len(actuators)
    try:
        given = np.asarray(answer)
        values = given.astype(float) if given.dtype.kind in _NUMBERS else np.full(0, math.nan)
    except (Exception, SystemExit):  # whatever its `__array__` raises
        values = np.full(0, math.nan)
    if values.shape != (n,) or not (np.abs(values) <= _LARGEST).all():
        expected = f"{n} finite numbers of at most {_LARGEST:g}: {', '.join(actuators)}"
        raise BadInput([Problem(f"at {time_s:.3f} s {what} are {shown(answer)}", name, expected=expected)])
    return values


def _to_read(rows: np.ndarray) -> np.ndarray:
    """The same rows, which the user's code cannot change: they are the log."""
    seen = rows.view()
    seen.setflags(write=False)
    return seen


class CommandLog:
    """Logs servos as commanded, and motors as the thrust of the modelled motor: the log's unit is newtons, not throttle."""

    def __init__(self, setup: Setup) -> None:
        self._dt, self._scale = setup.dt_s, setup.scale
        self._servo = np.array([kind == "servo" for kind in setup.model.kinds])
        self._model, self._memory = model_record(setup)[0], trimmed_memory(setup)[0]

    def write(self, row: np.ndarray, commands: np.ndarray, state: Any) -> None:
        """Fill reference and command in a row of telemetry."""
        n, s = len(commands), self._memory
        s.command[:] = commands
        advance_actuators(self._dt, axial_speed(state), self._model, s)
        row[:n] = row[n : 2 * n] = np.where(self._servo, commands / self._scale, s.position)


def parameters_of(function: Any) -> Collection[str]:
    """Names of a function's parameters; none where Python cannot tell."""
    try:
        return inspect.signature(function).parameters
    except (TypeError, ValueError):
        return ()


def adapted(factory: Factory, setup: Setup) -> Controller:
    """The controller that a user's class makes of a set-up; raises BadInput when the class fails or makes no controller."""
    name = place_of(factory)
    with in_words(name, "while being made"):
        return _made(factory, setup, name)


def _made(factory: Factory, setup: Setup, name: str) -> Controller:
    given = setup.settings.parameters
    if problems := undeclared(factory, given):
        raise BadInput(problems)
    setup = replace(setup, parameters={**getattr(factory, "parameters", {}), **given})
    made = factory(setup)
    if callable(getattr(made, "bind", None)) and callable(getattr(made, "step", None)):
        return AsItIs(setup, made, name)
    if not callable(getattr(made, "update", None)):
        known = [word for word in dir(made) if not word.startswith("_")]
        problem = f"{type(made).__name__} has no method update"
        raise BadInput([Problem(problem, name, expected=_UPDATE, suggestion=did_you_mean("update", known))])
    return CustomController(setup, made, name)
