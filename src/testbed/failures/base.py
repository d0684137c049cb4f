"""What every failure has: when it starts and ends, and which properties of the JSBSim model it holds.

Units: a field whose name ends in a unit is in that unit. `value`, `low`, `high` and `amplitude` are factors, or are in the
actuator's own unit: degrees for a servo, throttle for a motor or engine. `rate` is in that unit per second.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from pydantic import field_validator, model_validator

from testbed.aircraft.description import Aircraft, AnyActuator, Servo
from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, after, refuse
from testbed.inputs.problems import Issue

Examples = Mapping[str, Mapping[str, Any]]
"""Fields of an example of a failure, by kind of actuator; those of a motor are for an engine too."""
Course = Callable[[float, float], float]
"""Value to hold, as a function of the time since the failure started [s] and of the value held at its start."""


@dataclass(frozen=True)
class Capture:
    """The value to hold is that of the property `source` when the failure starts; `source` may be the held property itself."""

    source: str


def both(servo: Mapping[str, Any], motor: Mapping[str, Any] | None = None) -> Examples:
    """Fields for a servo and for a motor; the same for both where `motor` is not given."""
    return {"servo": servo, "motor": servo if motor is None else motor}


def travel_of(actuator: AnyActuator) -> tuple[float, float]:
    """Lowest and highest command, in the actuator's own unit (degrees or throttle)."""
    return actuator.limits if isinstance(actuator, Servo) else actuator.throttle


def stop_words(to: str) -> str:
    """The stop that `to: max` or `to: min` names, in words."""
    return f"{'highest' if to == 'max' else 'lowest'} stop"


class When(Settings):
    """Start of a failure: when a logged signal is first above or below a limit, in the log's unit."""

    signal: Text
    above: Number | None = None
    below: Number | None = None

    @model_validator(mode="after")
    def _one_limit(self) -> When:
        if (self.above is None) == (self.below is None):
            raise refuse("needs one limit", "either above or below")
        return self

    def met(self, value: float) -> bool:
        """Whether this value of the signal is beyond the limit; a value on the limit is not."""
        return value > self.above if self.above is not None else value < (self.below or 0.0)

    def __str__(self) -> str:
        side, limit = ("above", self.above) if self.above is not None else ("below", self.below)
        return f"{self.signal} {side} {limit:g}"


class Failure(Settings):
    """What all failures share: a beginning (`at_s` or `when`), perhaps an end, and usually an actuator."""

    kinds: ClassVar[tuple[str, ...]] = ("servo", "motor", "engine")
    """Kinds of actuator that can fail in this way."""
    undone: ClassVar[bool] = True
    """Whether it may end before the flight does. False for a part that has fallen off."""
    follows_command: ClassVar[bool] = True
    """Whether the actuator still follows its command, if with less effect, late or with an offset."""
    draws: ClassVar[bool] = False
    """Whether its course is random: then its random numbers depend on its place among the failures of a scenario."""
    harmless: ClassVar[Mapping[str, Any] | None] = None
    """Fields with which it has no effect on any actuator, if there are such."""
    said: ClassVar[str] = ""
    """What it does to its actuator, as `words` says it, which fills in `{0.value:g}` for a field and `{unit}`."""
    examples: ClassVar[Examples] = {}
    """For each kind of actuator, fields with a visible effect; they are flown by the tests and drawn in the catalogue."""

    type: str
    actuator: Text | None = None
    at_s: NonNegative | None = None
    until_s: Positive | None = None
    when: When | None = None

    _after_start = field_validator("until_s")(after("at_s"))

    @field_validator("until_s")
    @classmethod
    def _can_end(cls, until_s: float | None) -> float | None:
        if until_s is not None and not cls.undone:
            raise refuse("is an end, and this failure cannot be undone", "no until_s")
        return until_s

    @model_validator(mode="after")
    def _one_start(self) -> Failure:
        if (self.at_s is None) == (self.when is None):
            raise refuse("has no start" if self.at_s is None else "has two starts", "either at_s or when")
        return self

    @property
    def response(self) -> float:
        """What the actuator does for a command, 1 when healthy; NaN where it does not follow its command at all."""
        return 1.0 if self.follows_command else math.nan

    @classmethod
    def neutral(cls, actuator: AnyActuator) -> Mapping[str, Any] | None:
        """Fields with which the failure has no effect on this actuator; None if there are no such fields."""
        return cls.harmless

    def words(self, kind: str, unit: str) -> str:
        """What it does to its actuator, as the predicate of a sentence: "was lost completely".

        Args:
            kind: of the actuator, one of `kinds`.
            unit: of the failure's values: "deg" for a servo's, "of throttle" for those of a motor or engine.
        """
        if not self.said:
            raise NotImplementedError(f"{type(self).__name__} has neither `said` nor `words`")
        return self.said.format(self, unit=unit)

    def properties(self, aircraft: Aircraft) -> Mapping[str, float | Capture]:
        """JSBSim properties that are held while the failure lasts, each with the value that is written when it starts."""
        raise NotImplementedError

    def course(self, aircraft: Aircraft, random: np.random.Generator) -> tuple[str, Course] | None:
        """The held property whose value changes while the failure lasts, and its value over time; None if none changes.

        `random` is the random stream of this failure, for a value that changes at random.
        """
        return None

    def delay_steps(self, rate_hz: float) -> int | None:
        """Control steps by which the actuator's commands are delayed; None if commands are not touched."""
        return None

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        """What does not fit the aircraft or the control rate. The actuator exists, and is of the right kind."""
        return iter(())

    @property
    def window_s(self) -> tuple[float, float]:
        """Earliest start and latest end [s]. A failure with `when` may start at any time, so its earliest start is 0."""
        return self.at_s or 0.0, math.inf if self.until_s is None else self.until_s


class ActuatorFailure(Failure):
    """A failure of one named actuator."""

    actuator: Text

    def is_servo(self, aircraft: Aircraft) -> bool:
        """Whether its actuator is a servo; otherwise it is a motor or an engine, with a throttle."""
        return aircraft.actuators[self.actuator].kind == "servo"

    def name(self, aircraft: Aircraft, servo: str, motor: str | None = None) -> str:
        """Full name of a property in this actuator's block; `motor` is its name for a motor or engine where that differs."""
        tail = servo if motor is None or self.is_servo(aircraft) else motor
        return f"{aircraft.actuators[self.actuator].prefix}/{tail}"

    def override(self, aircraft: Aircraft, value: float | Capture) -> dict[str, float | Capture]:
        """The properties by which servo or throttle are told this value in place of their commands [rad or throttle]."""
        override = self.name(aircraft, "override-rad", "override-norm")
        return {self.name(aircraft, "override-active"): 1.0, override: value}

    def inside(self, aircraft: Aircraft, value: float) -> float:
        """A value in the actuator's own unit, converted to that of the JSBSim model: radians for a servo, else throttle."""
        return math.radians(value) if self.is_servo(aircraft) else value

    def travel(self, aircraft: Aircraft) -> tuple[float, float]:
        """Lowest and highest command, in the actuator's own unit (degrees or throttle)."""
        return travel_of(aircraft.actuators[self.actuator])

    def unit(self, aircraft: Aircraft) -> str:
        """The actuator's own unit, in words for messages."""
        return aircraft.actuators[self.actuator].unit if self.is_servo(aircraft) else "throttle"

    def outside(
        self, aircraft: Aircraft, field: str, low: float, high: float, per: str = ""
    ) -> Iterator[Issue]:
        """An issue if this field is outside `low` to `high`, in the actuator's own unit followed by `per` (such as "/s")."""
        value = getattr(self, field)
        if value is not None and not low <= value <= high:
            what = f"{value:g} {self.unit(aircraft)}{per} is outside {self.actuator}'s range"
            yield Issue((field,), what, f"{low:g} to {high:g}")
