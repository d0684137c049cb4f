"""What can break, and which properties of the plant a failure holds, from when to when.

Adding a type is one class here and one line in TYPES. Times are seconds of the flight; a failure starts at
`at_s`, or when a logged signal first crosses a value, and lasts to `until_s` or to the end.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Union

from pydantic import Field, ValidationInfo, field_validator, model_validator

from testbed.aircraft import Aircraft
from testbed.settings import NonNegative, Number, Positive, Settings, Text, refuse


class When(Settings):
    """A failure that starts when a logged signal first goes above or below a value."""

    signal: Text
    above: Number | None = None
    below: Number | None = None

    @model_validator(mode="after")
    def _one_limit(self) -> When:
        if (self.above is None) == (self.below is None):
            raise refuse("needs one limit", "either above or below")
        return self


class Failure(Settings):
    """What all failures share: a beginning (`at_s` or `when`), perhaps an end, and usually an actuator."""

    kinds: ClassVar[tuple[str, ...]] = ("servo", "motor")
    """Kinds of actuator that can fail in this way."""

    type: str
    actuator: Text | None = None
    at_s: NonNegative | None = None
    until_s: Positive | None = None
    when: When | None = None

    @field_validator("until_s")
    @classmethod
    def _after_start(cls, until_s: float | None, info: ValidationInfo) -> float | None:
        start = info.data.get("at_s")
        if until_s is not None and start is not None and until_s <= start:
            raise refuse(f"{until_s:g} s is not after at_s", f"more than {start:g}")
        return until_s

    @model_validator(mode="after")
    def _one_start(self) -> Failure:
        if (self.at_s is None) == (self.when is None):
            raise refuse("has no start" if self.at_s is None else "has two starts", "either at_s or when")
        return self

    def properties(self, aircraft: Aircraft) -> dict[str, float]:
        """JSBSim properties that are held, and their values, while the failure lasts."""
        raise NotImplementedError

    @property
    def window_s(self) -> tuple[float, float]:
        """Earliest start and latest end [s]; one that waits for a signal may start at any time."""
        return self.at_s or 0.0, math.inf if self.until_s is None else self.until_s


class ActuatorFailure(Failure):
    """A failure of one named actuator."""

    actuator: Text

    def property_name(self, aircraft: Aircraft, name: str) -> str:
        """Full name of a property in this actuator's block."""
        return f"{aircraft.actuators[self.actuator].prefix}/{name}"


class Effectiveness(ActuatorFailure):
    """The actuator's force (and torque) is scaled by `value`, after the servo: 0 is lost, 1 is healthy."""

    type: Literal["effectiveness"] = "effectiveness"
    value: Annotated[Number, Field(ge=0, le=1.5)]

    def properties(self, aircraft: Aircraft) -> dict[str, float]:
        return {self.property_name(aircraft, "effectiveness"): self.value}


class Property(Failure):
    """Any writable JSBSim properties are held at given values."""

    type: Literal["property"] = "property"
    actuator: None = None
    set: dict[str, Number] = Field(min_length=1)

    def properties(self, aircraft: Aircraft) -> dict[str, float]:
        return dict(self.set)


TYPES: dict[str, type[Failure]] = {
    "effectiveness": Effectiveness,
    "property": Property,
}

if TYPE_CHECKING:
    AnyFailure = Failure
else:
    AnyFailure = Annotated[Union[tuple(TYPES.values())], Field(discriminator="type")]  # noqa: UP007


def same_property(name: str) -> str:
    """One spelling of a property: JSBSim takes `a[0]/b` and `a/b` for the same."""
    return name.replace("[0]", "")


def overlaps(failures: Sequence[Failure], aircraft: Aircraft) -> Iterator[tuple[int, int, str]]:
    """Pairs of failures that would write one property at one time: (first index, second index, property).

    Two failures may hold the same property only in windows [at_s, until_s) that do not meet. One exception:
    of two failures of one type, both with `at_s` and neither with `until_s`, the one that starts later takes
    over from the other (0.2 from 5 s, 0.0 from 15 s). One with `when` may start at any time: its window begins
    at 0.
    """
    held: list[dict[str, Any]] = [dict.fromkeys(map(same_property, f.properties(aircraft))) for f in failures]
    for j, later in enumerate(failures):
        for i, earlier in enumerate(failures[:j]):
            shared = held[i].keys() & held[j].keys()
            if shared and _meet(earlier, later) and not _takes_over(earlier, later):
                yield i, j, min(shared)


def _meet(one: Failure, other: Failure) -> bool:
    return max(one.window_s[0], other.window_s[0]) < min(one.window_s[1], other.window_s[1])


def _takes_over(one: Failure, other: Failure) -> bool:
    open_ended = one.until_s is None and other.until_s is None
    timed = one.at_s is not None and other.at_s is not None
    return open_ended and timed and one.type == other.type and one.at_s != other.at_s
