"""Checks that a failure acts: compares the response of the plant after an injection with the one that it should have.

From the injection on, the expected response of the actuator to the commands is computed twice: healthy, with the held
properties as they were before, and broken, with the properties as they are. The aircraft's XML must implement the response that
`ServoModel` and `MotorModel` describe, of all properties under the actuator's prefix, such as `actuator/NAME/`. Within
RECEIPT_STEPS control steps in which the two differ, the plant must follow the broken one. The quantities compared are the effective
deflection of a surface, the throttle of a motor (as a fraction of full voltage) or engine, whether an engine runs, and the thrust
that acts on the airframe.
A failure that breaks no actuator is verified when its properties keep their values for RECEIPT_STEPS control steps.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from typing import Any

from testbed.aircraft.description import AnyActuator, MotorActuator, Servo
from testbed.common.units import DEGREES_PER_RADIAN, NEWTONS_PER_POUND
from testbed.plant.jsbsim import Plant

RECEIPT_STEPS = 50
"""Control steps within which an effect must be seen, counting those in which healthy and broken response differ."""
SMALLEST = 1e-6
"""A healthy and a broken response differ if they are further apart than this [deg, throttle, N]."""


@dataclass(slots=True)
class Hold:
    """One property that a failure holds.

    Attributes:
        name: name of the property.
        value: the value to write at the start, or a function that reads it at the start.
        put, get: functions that write and read the property.
        healthy: its value before the flight, which is restored at the end of the failure.
        before: its value just before the failure started.
        first: the value that was written at the start.
        written: the value that was written last.
    """

    name: str
    value: float | Callable[[], float]
    put: Callable[[float], bool]
    get: Callable[[], float]
    healthy: float
    before: float = 0.0
    first: float = 0.0
    written: float = 0.0

    def write(self, value: float) -> None:
        """Write a value, and remember it."""
        self.put(value)
        self.written = value


def reads_back(value: float, written: float) -> bool:
    """Whether a property has the value that was written, but for rounding: JSBSim keeps some in other units."""
    return math.isclose(value, written, rel_tol=1e-9, abs_tol=1e-12)


class Watch:
    """Watches one injection until its effect has been seen, or has not been seen in time.

    Attributes:
        verified: True once the effect was seen. False if it was not seen in time, or if a property did not keep the value that
            was written. None while there is no effect to see, because the responses with and without the failure are equal.
        effect: the last comparison: {quantity, healthy, broken, observed, after_steps}; None if there was none.
        done: whether the watch is over.
    """

    def __init__(self, plant: Plant, actuator: AnyActuator | None, holds: Sequence[Hold]) -> None:
        """`actuator` is the one that the failure breaks, and `holds` are the properties that it holds."""
        self._plant, self._actuator, self._holds = plant, actuator, holds
        self._steps = self._due_steps = 0
        self.verified: bool | None = None
        self.effect: dict[str, Any] | None = None
        self.done = False
        if actuator is not None:
            self._bind(actuator)

    def _bind(self, actuator: AnyActuator) -> None:
        """Look up all properties that `look` reads, and start both models in the present state of the actuator."""
        get = self._plant.getter
        block = f"{actuator.prefix}/"
        self._held = {h.name.removeprefix(block): h for h in self._holds if h.name.startswith(block)}
        names = SERVO if actuator.kind == "servo" else MOTOR
        self._block = {name: get(f"{block}{name}") for name in names}
        self._observed: dict[str, Callable[[], float]]
        self._models: tuple[Model, Model]  # healthy and broken
        full: float | None = None
        if not isinstance(actuator, Servo):
            engine = f"propulsion/engine[{actuator.engine}]"
            thrust, lost = get(f"{engine}/thrust-lbs"), get(f"{block}lost-thrust-lbs")
            self._block["thrust_N"] = lambda: thrust() * NEWTONS_PER_POUND
            self._observed = {
                "throttle": get(f"fcs/throttle-pos-norm[{actuator.engine}]"),
                "thrust_N": lambda: (thrust() + lost()) * NEWTONS_PER_POUND,
            }
            if isinstance(actuator, MotorActuator):
                self._block["rpm"] = get(f"{engine}/propeller-rpm")
                full = actuator.motor.velocity_constant_rpm_v * actuator.motor.max_volts
            else:
                self._observed["running"] = get(f"{engine}/set-running")
            self._models = MotorModel(full), MotorModel(full)
        else:
            effective = get(f"{block}effective-rad")
            demand, position = (get(f"{block}{name}")() for name in ("demand-rad", "servo-rad"))
            self._observed = {"effective_deg": lambda: effective() * DEGREES_PER_RADIAN}
            self._models = ServoModel(demand, position), ServoModel(demand, position)

    def copy(self) -> Watch:
        """One that goes on from here by itself, on the same plant."""
        other = copy(self)
        if self._actuator is not None:
            healthy, broken = self._models
            other._models = copy(healthy), copy(broken)
        return other

    def look(self) -> None:
        """Check the control step that the plant has just made."""
        self._steps += 1
        if not all(reads_back(hold.get(), hold.written) for hold in self._holds):
            self._conclude(False)
        elif self._actuator is None:
            if self._steps >= RECEIPT_STEPS:
                self._conclude(True)
        elif self._follows_broken():
            self._conclude(True)
        elif self._due_steps >= RECEIPT_STEPS:
            self._conclude(False)

    def finish(self) -> None:
        """End the watch with the failure or the flight: an effect that has not been seen by now counts as not seen."""
        if not self.done and self._actuator is None and self._steps:
            self._conclude(True)
        elif not self.done and self._due_steps:
            self._conclude(False)
        self.done = True

    def _conclude(self, verified: bool) -> None:
        self.verified, self.done = verified, True

    def _follows_broken(self) -> bool:
        """Advance both models by the step just made; whether the plant is nearer to the broken response than to the healthy one.

        The quantity compared is the one in which the two responses differ most.
        """
        without, expected = self._responses()
        differences = {q: abs(expected[q] - without[q]) for q in expected}
        quantity = max(differences, key=lambda q: differences[q])
        if differences[quantity] > SMALLEST:
            self._due_steps += 1
        if not self._due_steps:
            return False
        observed = self._observed[quantity]()
        self.effect = {
            "quantity": quantity,
            "healthy": without[quantity],
            "broken": expected[quantity],
            "observed": observed,
            "after_steps": self._steps,
        }
        near = abs(observed - expected[quantity]) <= 0.5 * differences[quantity]
        return near and differences[quantity] > SMALLEST

    def _responses(self) -> tuple[dict[str, float], dict[str, float]]:
        """(healthy, broken) expected responses to the step just made."""
        broken = {name: get() for name, get in self._block.items()}
        healthy = {**broken, **{name: hold.before for name, hold in self._held.items()}}
        dt_s, substeps = self._plant.dt_s, self._plant.substeps
        for_healthy, for_broken = self._models
        return for_healthy.advance(healthy, dt_s, substeps), for_broken.advance(broken, dt_s, substeps)


SERVO = (
    "command-rad", "command-scale", "command-bias-rad", "override-active", "override-rad",
    "servo-lag-rad_sec", "servo-rate-rad_sec", "servo-min-rad", "servo-max-rad", "servo/malfunction/fail_stuck",
    "linkage-bias-rad", "float-active", "float-gain", "incidence-rad", "effectiveness",
)  # fmt: skip
"""Properties of a servo's block that its response depends on."""
MOTOR = (
    "command-norm", "command-scale", "command-bias-norm", "override-active", "override-norm",
    "throttle-min-norm", "throttle-max-norm", "power-lost", "effectiveness",
)  # fmt: skip
"""Properties of a motor's or an engine's block that its response depends on."""

Values = Mapping[str, float]
"""Values of the properties of an actuator's block, by name without the prefix; for a motor also `rpm` and `thrust_N` of its
rotor, for an engine its `thrust_N`."""


class ServoModel:
    """A servo and its surface: {effective_deg: deflection times effectiveness [deg]}.

    The servo has lag (Tustin), rate limit, the malfunction stuck and stops, in the order of JSBSim's actuator component. Behind
    the servo, the bias of the linkage is added. A floating surface follows the local flow instead. Effectiveness scales the
    result.
    """

    def __init__(self, demand: float, position: float) -> None:
        """`demand` and `position` [rad] are those of the servo at present."""
        self._input, self._lagged, self._output = demand, position, position

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        demand = v["command-rad"] * v["command-scale"] + v["command-bias-rad"]
        if v["override-active"]:
            demand = v["override-rad"]
        if not v["servo/malfunction/fail_stuck"]:
            for _ in range(substeps):
                self._follow(demand, v["servo-lag-rad_sec"] * dt_s, v["servo-rate-rad_sec"] * dt_s)
        position = min(max(self._output, v["servo-min-rad"]), v["servo-max-rad"]) + v["linkage-bias-rad"]
        if v["float-active"]:
            position = -v["float-gain"] * v["incidence-rad"]
        return {"effective_deg": v["effectiveness"] * position * DEGREES_PER_RADIAN}

    def _follow(self, demand: float, lag: float, rate: float) -> None:
        """One physics step; `lag` is the lag's corner frequency times the step [1], `rate` the rate limit times the step [rad]."""
        lagged = (lag * (demand + self._input) + (2.0 - lag) * self._lagged) / (2.0 + lag)
        self._output += min(max(lagged - self._output, -rate), rate)
        self._input, self._lagged = demand, lagged


@dataclass(frozen=True)
class MotorModel:
    """A motor with its propeller, or an engine: {throttle [0 to 1], thrust_N: what reaches the airframe [N]}, and of an engine
    {running: 1, or 0 without ignition or fuel}.

    The throttle follows the command at once. Of a motor without power it is the voltage that the windmilling motor generates, over
    full voltage. Speed and thrust of the rotor are not computed here: they are read from the plant.
    """

    rpm_at_full: float | None
    """The motor's speed without load at full voltage [rpm]; None for an engine."""

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        thrust = {"thrust_N": v["effectiveness"] * v["thrust_N"]}
        if self.rpm_at_full is None:
            return {"throttle": _throttle(v), "running": 0.0 if v["power-lost"] else 1.0, **thrust}
        return {"throttle": v["rpm"] / self.rpm_at_full if v["power-lost"] else _throttle(v), **thrust}


Model = ServoModel | MotorModel
"""Expected response of one actuator. `advance` makes one control step of `substeps` physics steps of `dt_s` [s] each, and returns
what acts on the airframe by the name of the quantity: see the classes."""


def _throttle(v: Values) -> float:
    """What a motor or engine is asked for, after scale, bias, override and stops."""
    throttle = v["command-norm"] * v["command-scale"] + v["command-bias-norm"]
    if v["override-active"]:
        throttle = v["override-norm"]
    return max(v["throttle-min-norm"], min(v["throttle-max-norm"], throttle))
