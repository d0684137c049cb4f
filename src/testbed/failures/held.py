"""Failures between command and position, the same from start to end: reversed, stuck, hard over, afloat, biased, limited, slow."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, field_validator, model_validator

from testbed.aircraft.description import Aircraft, AnyActuator
from testbed.failures.base import (
    ActuatorFailure,
    Capture,
    Examples,
    Failure,
    both,
    stop_words,
    travel_of,
)
from testbed.inputs.base import Number, Positive, refuse
from testbed.inputs.problems import Issue


class CommandScale(ActuatorFailure):
    """Commands are multiplied by `value` before the servo or motor: 0 is no command, 1 is healthy."""

    type: Literal["command_scale"] = "command_scale"
    value: Annotated[Number, Field(ge=0, le=2)]
    harmless: ClassVar[Mapping[str, Any]] = {"value": 1.0}
    examples: ClassVar[Examples] = both({"value": 0.5})

    @property
    def response(self) -> float:
        return self.value

    def words(self, kind: str, unit: str) -> str:
        few = "only " if self.value < 1.0 else ""
        return f"followed {few}{100 * self.value:.0f} % of its commands"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "command-scale"): self.value}


class Reversal(ActuatorFailure):
    """Commands act with the opposite sign, as with a crossed linkage: mirrored about zero deflection, not about trim."""

    kinds: ClassVar[tuple[str, ...]] = ("servo",)
    said: ClassVar[str] = "acted against its commands"
    type: Literal["reversal"] = "reversal"
    follows_command: ClassVar[bool] = False
    examples: ClassVar[Examples] = {"servo": {}}

    @property
    def response(self) -> float:
        return -1.0

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "command-scale"): -1.0}


class Stuck(ActuatorFailure):
    """A surface keeps the position, and a motor the throttle, that it has when the failure starts."""

    said: ClassVar[str] = "got stuck where it was"
    type: Literal["stuck"] = "stuck"
    follows_command: ClassVar[bool] = False
    examples: ClassVar[Examples] = both({})

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        if self.is_servo(aircraft):
            # With JSBSim's own malfunction the position freezes at once. An override would move on through the servo's lag.
            return {self.name(aircraft, "servo/malfunction/fail_stuck"): 1.0}
        return self.override(aircraft, Capture(self.name(aircraft, "throttle-norm")))


class StuckAt(ActuatorFailure):
    """The servo moves to `value`, with its usual lag and rate, and stays there; a motor runs at throttle `value`."""

    said: ClassVar[str] = "got stuck at {0.value:g} {unit}"
    type: Literal["stuck_at"] = "stuck_at"
    follows_command: ClassVar[bool] = False
    value: Number
    examples: ClassVar[Examples] = both({"value": 5.0}, {"value": 0.3})

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return self.override(aircraft, self.inside(aircraft, self.value))

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        return self.outside(aircraft, "value", *self.travel(aircraft))


class Hardover(ActuatorFailure):
    """The servo drives to its highest (`to: max`) or lowest (`to: min`) stop; a motor to full or no throttle."""

    type: Literal["hardover"] = "hardover"
    follows_command: ClassVar[bool] = False
    to: Literal["max", "min"] = "max"
    examples: ClassVar[Examples] = both({"to": "max"})

    def words(self, kind: str, unit: str) -> str:
        if kind == "servo":
            return f"ran to its {stop_words(self.to)}"
        return "ran at full throttle" if self.to == "max" else "ran at its lowest throttle"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return self.override(aircraft, self.inside(aircraft, self.travel(aircraft)[self.to == "max"]))


class Float(ActuatorFailure):
    """The surface floats freely: its deflection is minus `gain` times the local incidence (default: the aircraft's gain)."""

    kinds: ClassVar[tuple[str, ...]] = ("servo",)
    said: ClassVar[str] = "floated freely"
    type: Literal["float"] = "float"
    follows_command: ClassVar[bool] = False
    gain: Annotated[Number, Field(ge=0, le=1)] | None = None
    examples: ClassVar[Examples] = {"servo": {}}

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        gain = {} if self.gain is None else {self.name(aircraft, "float-gain"): self.gain}
        return {self.name(aircraft, "float-active"): 1.0, **gain}


class Bias(ActuatorFailure):
    """`value` is added to the deflection behind the servo, as by a bent linkage, or to the throttle command of a motor."""

    said: ClassVar[str] = "was offset by {0.value:g} {unit}"
    type: Literal["bias"] = "bias"
    value: Number
    harmless: ClassVar[Mapping[str, Any]] = {"value": 0.0}
    examples: ClassVar[Examples] = both({"value": 5.0}, {"value": -0.2})

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        name = self.name(aircraft, "linkage-bias-rad", "command-bias-norm")
        return {name: self.inside(aircraft, self.value)}

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        low, high = self.travel(aircraft)
        return self.outside(aircraft, "value", low - high, high - low)


class PositionLimit(ActuatorFailure):
    """Travel is limited to `low` to `high` (one may be left out); an actuator outside is moved to the new stop at once."""

    type: Literal["position_limit"] = "position_limit"
    low: Number | None = None
    high: Number | None = None
    examples: ClassVar[Examples] = both({"low": 1.0, "high": 3.0}, {"high": 0.3})

    @classmethod
    def neutral(cls, actuator: AnyActuator) -> Mapping[str, Any]:
        return dict(zip(("low", "high"), travel_of(actuator), strict=True))

    @model_validator(mode="after")
    def _some_travel(self) -> PositionLimit:
        if self.low is None and self.high is None:
            raise refuse("has no limit", "low, high or both")
        if self.low is not None and self.high is not None and self.low >= self.high:
            raise refuse(f"from {self.low:g} to {self.high:g} leaves no travel", "low below high")
        return self

    def words(self, kind: str, unit: str) -> str:
        if self.low is None:
            return f"could go no higher than {self.high:g} {unit}"
        if self.high is None:
            return f"could go no lower than {self.low:g} {unit}"
        return f"was limited to {self.low:g} to {self.high:g} {unit}"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        limits = (("min", self.low), ("max", self.high))
        return {
            self.name(aircraft, f"servo-{end}-rad", f"throttle-{end}-norm"): self.inside(aircraft, value)
            for end, value in limits
            if value is not None
        }

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        for field in ("low", "high"):
            yield from self.outside(aircraft, field, *self.travel(aircraft))


class RateLimit(ActuatorFailure):
    """The servo moves by at most `value` per second."""

    kinds: ClassVar[tuple[str, ...]] = ("servo",)
    said: ClassVar[str] = "moved at no more than {0.value:g} {unit}/s"
    type: Literal["rate_limit"] = "rate_limit"
    value: Positive
    examples: ClassVar[Examples] = {"servo": {"value": 2.0}}

    @classmethod
    def neutral(cls, actuator: AnyActuator) -> Mapping[str, Any]:
        return {"value": actuator.rate_limit}

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "servo-rate-rad_sec"): self.inside(aircraft, self.value)}

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        return self.outside(aircraft, "value", 0.0, aircraft.actuators[self.actuator].rate_limit, "/s")


class Lag(ActuatorFailure):
    """The servo's first-order lag has the corner frequency `lag_rad_s`, lower than when healthy."""

    kinds: ClassVar[tuple[str, ...]] = ("servo",)
    type: Literal["lag"] = "lag"
    lag_rad_s: Positive
    examples: ClassVar[Examples] = {"servo": {"lag_rad_s": 3.0}}

    @classmethod
    def neutral(cls, actuator: AnyActuator) -> Mapping[str, Any]:
        return {"lag_rad_s": actuator.lag_rad_s}

    def words(self, kind: str, unit: str) -> str:
        return f"became slow (a lag of {1.0 / self.lag_rad_s:.2g} s)"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "servo-lag-rad_sec"): self.lag_rad_s}

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        healthy = aircraft.actuators[self.actuator].lag_rad_s
        if healthy is not None and self.lag_rad_s > healthy:
            what = f"{self.lag_rad_s:g} rad/s is faster than {self.actuator} is"
            yield Issue(("lag_rad_s",), what, f"at most {healthy:g}")


_ACTING = re.compile(
    r"(simulation|ic|trim)/|propulsion/set-running$|atmosphere/updownburst/number-of-cells$", re.IGNORECASE
)
"""Properties that steer JSBSim when they are written, and break no part of the aircraft: they trim, reset, stop or seed the
simulation, write files, or make so many objects as the number says. Found by writing each property of JSBSim 1.3.3 and from its
source; `simulation/do_simple_trim` and `propulsion/set-running` can end the process."""


class Property(Failure):
    """Writable JSBSim properties of the aircraft or the air are held at given values."""

    type: Literal["property"] = "property"
    actuator: None = None
    set: dict[str, Number] = Field(min_length=1)

    @field_validator("set")
    @classmethod
    def _once(cls, held: dict[str, float]) -> dict[str, float]:
        for name in held:
            if "[0]" in name and name.replace("[0]", "") in held:
                raise refuse(f"holds {name} twice", "one spelling of it")
        return held

    def words(self, kind: str, unit: str) -> str:
        return ", ".join(f"{name} was held at {value:g}" for name, value in self.set.items())

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return dict(self.set)

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        for name in self.set:
            if _ACTING.match(name.replace("[0]", "").strip("/")):
                what = f"{name} steers the simulation when it is written"
                yield Issue(("set",), what, "a property of the aircraft or the air")
