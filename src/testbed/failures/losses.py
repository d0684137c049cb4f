"""Failures of what an actuator does to the aircraft: a weak or lost surface, propeller or motor."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, StrictBool

from testbed.aircraft.description import Aircraft, Servo
from testbed.failures.base import ActuatorFailure, Capture, Examples, both
from testbed.inputs.base import Number
from testbed.inputs.problems import Issue

LOST = 0.1
"""An actuator with this true effectiveness or less is lost. It does not depend on a controller's own threshold."""
Gain = Annotated[Number, Field(ge=0, le=1.5)]


class Effectiveness(ActuatorFailure):
    """The actuator's force and torque are multiplied by `value`, and its position is not affected: 0 is lost, 1 is healthy."""

    type: Literal["effectiveness"] = "effectiveness"
    value: Gain
    harmless: ClassVar[Mapping[str, Any]] = {"value": 1.0}
    examples: ClassVar[Examples] = both({"value": 0.2})

    def words(self, kind: str, unit: str) -> str:
        percent = f"{100 * self.value:.0f} %"
        if self.value == 0.0:
            return "was lost completely"
        if self.value == 1.0:
            return "had its full effect"
        return (
            f"was lost but for {percent} of its effect"
            if self.value < LOST
            else f"kept {percent} of its effect"
        )

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "effectiveness"): self.value}


class PropLoss(ActuatorFailure):
    """The propeller is gone: no thrust and no torque, while the motor still follows its commands."""

    kinds: ClassVar[tuple[str, ...]] = ("motor",)
    undone: ClassVar[bool] = False
    said: ClassVar[str] = "came off"
    type: Literal["prop_loss"] = "prop_loss"
    examples: ClassVar[Examples] = {"motor": {}}

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "effectiveness"): 0.0}


class MotorStop(ActuatorFailure):
    """No power, ignition or fuel: the propeller windmills, or a short-circuited motor brakes it with `braked: true`."""

    kinds: ClassVar[tuple[str, ...]] = ("motor", "engine")
    type: Literal["motor_stop"] = "motor_stop"
    follows_command: ClassVar[bool] = False
    braked: StrictBool = False
    examples: ClassVar[Examples] = {"motor": {}}

    def words(self, kind: str, unit: str) -> str:
        return "stopped and was braked" if self.braked else "stopped"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        if self.braked:  # at zero volts JSBSim's motor is short-circuited, and brakes
            return {
                self.name(aircraft, "throttle-max-norm"): 0.0,
                self.name(aircraft, "throttle-min-norm"): 0.0,
            }
        return {self.name(aircraft, "power-lost"): 1.0}

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        if self.braked and aircraft.actuators[self.actuator].kind != "motor":
            yield Issue(("braked",), f"{self.actuator} is no electric motor, which could brake", "false")


class SurfaceLost(ActuatorFailure):
    """The surface is gone: its force, its mass, and with the mass its effect on centre of gravity and inertia."""

    kinds: ClassVar[tuple[str, ...]] = ("servo",)
    undone: ClassVar[bool] = False
    said: ClassVar[str] = "broke off"
    type: Literal["surface_lost"] = "surface_lost"
    examples: ClassVar[Examples] = {"servo": {}}

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        servo = aircraft.actuators[self.actuator]
        held: dict[str, float | Capture] = {self.name(aircraft, "effectiveness"): 0.0}
        if isinstance(servo, Servo) and servo.pointmass is not None:
            held[f"inertia/pointmass-weight-lbs[{servo.pointmass}]"] = 0.0
        return held

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        if len(self.properties(aircraft)) == 1:
            what = f"{aircraft.name} gives {self.actuator} no mass that could be lost"
            yield Issue(("actuator",), what, f"effectiveness: 0, or pointmass in {aircraft.name}.yaml")
