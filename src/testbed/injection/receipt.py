"""Did a failure happen? What the plant does after an injection, against what it would do with and without it.

Each actuator is modelled twice from the moment of the injection, fed with the commands that the plant gets: healthy
(held properties at what they were) and broken (at what they are). As soon as the two differ, the plant must be seen to
follow the broken one, within RECEIPT_STEPS control steps. What is compared is the far end of the actuator: a
surface's effective deflection, a motor's throttle (the voltage it gets) and the thrust that reaches the airframe.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from testbed.aircraft.description import Actuator, MotorActuator
from testbed.common.units import DEGREES_PER_RADIAN, NEWTONS_PER_POUND
from testbed.injection.expected_response import MOTOR, SERVO, Model, MotorModel, ServoModel
from testbed.plant.jsbsim import Plant

RECEIPT_STEPS = 50
"""Control steps within which an effect that is due must be seen."""
SMALLEST = 1e-6
"""Differences from here on [deg, throttle, N] count as an effect."""


@dataclass(slots=True)
class Hold:
    """One failure's hold on one property: `healthy` is restored at the end, `before` is what it was at the start."""

    name: str
    value: float | Callable[[], float]
    put: Callable[[float], bool]
    get: Callable[[], float]
    healthy: float
    before: float = 0.0
    first: float = 0.0
    written: float = 0.0

    def write(self, value: float) -> None:
        self.put(value)
        self.written = value


def reads_back(value: float, written: float) -> bool:
    """Whether a property has the value written; some are kept in other units, so to rounding."""
    return math.isclose(value, written, rel_tol=1e-9, abs_tol=1e-12)


class Watch:
    """Follows one injection until its effect has been seen, or was due and has not been seen in time.

    Attributes:
        verified: True seen; False not seen in time, or a property does not stay as written; None nothing to see yet,
            because the actuator does the same with and without the failure.
        effect: what the last look compared: {quantity, healthy, broken, observed, after_steps}.
        done: nothing more to look at.
    """

    def __init__(self, plant: Plant, actuator: Actuator | None, holds: Mapping[str, Hold]) -> None:
        """`holds`: the injection's, by property."""
        self._plant, self._actuator, self._holds = plant, actuator, holds
        self._steps = self._due_steps = 0
        self.verified: bool | None = None
        self.effect: dict[str, Any] | None = None
        self.done = False
        if actuator is not None:
            self._bind(actuator)

    def _bind(self, actuator: Actuator) -> None:
        get = self._plant.getter
        names = SERVO if actuator.kind == "servo" else MOTOR
        self._block = {name: get(f"{actuator.prefix}/{name}") for name in names}
        self._far: dict[str, Callable[[], float]]
        if isinstance(actuator, MotorActuator):
            engine, motor = f"propulsion/engine[{actuator.engine}]", actuator.motor
            thrust, lost = get(f"{engine}/thrust-lbs"), get(f"{actuator.prefix}/lost-thrust-lbs")
            self._block |= {
                "rpm": get(f"{engine}/propeller-rpm"),
                "thrust_N": lambda: thrust() * NEWTONS_PER_POUND,
            }
            throttle = get(f"fcs/throttle-pos-norm[{actuator.engine}]")
            self._far = {"throttle": throttle, "thrust_N": lambda: (thrust() + lost()) * NEWTONS_PER_POUND}
            full = motor.velocity_constant_rpm_v * motor.max_volts
            self._models: tuple[Model, Model] = (MotorModel(full), MotorModel(full))
        else:
            effective = get(f"{actuator.prefix}/effective-rad")
            demand, position = (get(f"{actuator.prefix}/{name}")() for name in ("demand-rad", "servo-rad"))
            self._far = {"effective_deg": lambda: effective() * DEGREES_PER_RADIAN}
            self._models = (ServoModel(demand, position), ServoModel(demand, position))

    def look(self) -> None:
        """Judge the control step that the plant has just made."""
        self._steps += 1
        if not all(reads_back(hold.get(), hold.written) for hold in self._holds.values()):
            self._conclude(False)
        elif self._actuator is None:
            if self._steps >= RECEIPT_STEPS:
                self._conclude(True)
        elif self._follows_broken():
            self._conclude(True)
        elif self._due_steps >= RECEIPT_STEPS:
            self._conclude(False)

    def finish(self) -> None:
        """The failure or the flight ends: what has not been seen by now will not be."""
        if not self.done and self._actuator is None and self._steps:
            self._conclude(True)
        elif not self.done and self._due_steps:
            self._conclude(False)
        self.done = True

    def _conclude(self, verified: bool) -> None:
        self.verified, self.done = verified, True

    def _follows_broken(self) -> bool:
        assert self._actuator is not None
        broken = {name: get() for name, get in self._block.items()}
        healthy = dict(broken)
        for name, hold in self._holds.items():
            if name.startswith(self._actuator.prefix + "/"):
                healthy[name.removeprefix(self._actuator.prefix + "/")] = hold.before
        dt, n = self._plant.dt_s, self._plant.substeps
        without, expected = (
            model.advance(v, dt, n) for model, v in zip(self._models, (healthy, broken), strict=True)
        )
        differences = {q: abs(expected[q] - without[q]) for q in expected}
        quantity = max(differences, key=lambda q: differences[q])
        if differences[quantity] > SMALLEST:
            self._due_steps += 1
        if not self._due_steps:
            return False
        observed = self._far[quantity]()
        self.effect = {
            "quantity": quantity,
            "healthy": without[quantity],
            "broken": expected[quantity],
            "observed": observed,
            "after_steps": self._steps,
        }
        near = abs(observed - expected[quantity]) <= 0.5 * differences[quantity]
        return near and differences[quantity] > SMALLEST
