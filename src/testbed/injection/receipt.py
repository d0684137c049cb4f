"""Checks that a failure acts: compares the response of the plant after an injection with the one that it should have.

From the injection on, the expected response of the actuator to the commands is computed twice: healthy, with the held
properties as they were before, and broken, with the properties as they are. Within RECEIPT_STEPS control steps in which the
two differ, the plant must follow the broken one. The quantities compared are the effective deflection of a surface, the
throttle of a motor (as a fraction of full voltage) or engine, whether an engine runs, and the thrust that acts on the airframe.
A failure that breaks no actuator is verified when its properties keep their values for RECEIPT_STEPS control steps.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from typing import Any

from testbed.aircraft.description import AnyActuator, MotorActuator, Servo
from testbed.common.units import DEGREES_PER_RADIAN, NEWTONS_PER_POUND
from testbed.injection.expected_response import MOTOR, SERVO, Model, MotorModel, ServoModel
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
