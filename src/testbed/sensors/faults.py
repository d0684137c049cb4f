"""How a sensor can fail. A new type is one class here and one line in TABLE.

The name of a fault's value ends in the unit of its sensor: `value_deg_s` for a gyro, `value_m` for the altimeter.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, TypeVar

import numpy as np
from pydantic import Field, create_model, field_validator, model_validator

from testbed.common.signals import first_step_at
from testbed.common.units import unit
from testbed.inputs.base import NonNegative, Number, Positive, Settings, after, refuse
from testbed.inputs.problems import guess
from testbed.sensors.channels import CHANNELS, PER_SECOND, SI, channels_of, names, unit_of

Fault = TypeVar("Fault", bound="SensorFault")

READS, HOLDS, REPLACED = 0.0, 1.0, 2.0
"""What a channel does in a control step: it reads the sensor plus an offset, or repeats its last reading, or reads the offset
alone."""


class Span(NamedTuple):
    """One channel in the control steps of a fault, all known before the flight.

    Attributes:
        steps: [count] control steps since `at_s`.
        random: random stream of this fault and channel.
        offset: [count] added to the reading, or in its place [SI]; to be written.
        state: [count] READS, HOLDS or REPLACED, at first READS; to be written.
    """

    steps: np.ndarray
    rate_hz: float
    random: np.random.Generator
    offset: np.ndarray
    state: np.ndarray


class SensorFault(Settings):
    """What all faults have: a channel (`gyro_q`) or a whole sensor (`gyro`), a beginning, and perhaps an end [s]."""

    key: ClassVar[str] = ""
    """Name of its value in YAML, with {} in place of the unit; "" for a fault without a value."""
    needs_value: ClassVar[bool] = True
    said: ClassVar[str] = ""
    """What it did to its sensor, with {} in place of its value with the unit; "" for a fault of which `words` says more."""
    replaces: ClassVar[bool] = False
    """Whether it replaces the reading; otherwise it adds to the reading."""

    type: str
    sensor: str
    at_s: NonNegative
    until_s: Positive | None = None

    @field_validator("sensor")
    @classmethod
    def _known(cls, sensor: str) -> str:
        if not channels_of(sensor):
            raise refuse(f"unknown sensor {sensor!r}", *guess(sensor, names()))
        return sensor

    _after_start = field_validator("until_s")(after("at_s"))

    @model_validator(mode="after")
    def _right_unit(self) -> SensorFault:
        if not self.key:
            return self
        wanted = value_name(self.key, unit_of(self.sensor))
        given = [name for u in SI if getattr(self, name := value_name(self.key, u)) is not None]
        if any(name != wanted for name in given):
            raise refuse(f"{self.sensor} does not take {given[0]}", wanted)
        if self.needs_value and not given:
            raise refuse("has no value", wanted)
        return self

    @property
    def value(self) -> float | None:
        """Its value in SI, if it has one."""
        if not self.key:
            return None
        unit = unit_of(self.sensor)
        value = getattr(self, value_name(self.key, unit))
        return None if value is None else float(value) * SI[unit]

    def enter(self, span: Span) -> None:
        """Write into `span.offset` and `span.state`, in place, what the fault does to one channel."""
        raise NotImplementedError

    def words(self) -> str:
        """What it did to its sensor: `was off by 3 deg`."""
        return self.said.format(self._amount()) if self.said else f"had {self.type.replace('_', ' ')}"

    def _amount(self) -> str:
        """Its value with its unit."""
        name = value_name(self.key, unit_of(self.sensor))
        return f"{getattr(self, name):g} {unit(name)}"

    def window(self, rate_hz: float) -> tuple[float, float]:
        """First control step of the fault, and the first after it: infinity if it does not end."""
        end = math.inf if self.until_s is None else first_step_at(self.until_s, rate_hz)
        return first_step_at(self.at_s, rate_hz), end


def value_name(key: str, unit: str) -> str:
    """Name of a fault's value in YAML, for a sensor that reads in a unit."""
    return key.format(unit, per_second=PER_SECOND[unit])


def valued(fault: type[Fault]) -> type[Fault]:
    """The class of a fault, extended by one optional field for each unit that its value can have."""
    kind = NonNegative if fault.key.startswith("noise") else Number
    fields: dict[str, Any] = {value_name(fault.key, u): (kind | None, None) for u in SI}
    module, doc = fault.__module__, fault.__doc__
    return create_model(fault.__name__, __base__=fault, __module__=module, __doc__=doc, **fields)


@valued
class Stuck(SensorFault):
    """The reading stays at `value_<unit>`, or at the last reading before the fault if no value is given."""

    key, needs_value, replaces = "value_{}", False, True
    type: Literal["stuck"] = "stuck"

    def enter(self, span: Span) -> None:
        span.state[:] = HOLDS if self.value is None else REPLACED
        span.offset[:] = self.value or 0.0

    def words(self) -> str:
        return f"stuck at {'its last reading' if self.value is None else self._amount()}"


class Dropout(SensorFault):
    """Samples are lost, each with probability `fraction` (default 1: all).

    In their place `reads` is given: `zero` (default) or the `last` reading.
    """

    replaces = True
    type: Literal["dropout"] = "dropout"
    fraction: Annotated[Number, Field(gt=0, le=1)] = 1.0
    reads: Literal["zero", "last"] = "zero"

    def enter(self, span: Span) -> None:
        lost = span.random.random(len(span.state)) < self.fraction
        span.state[:] = np.where(lost, HOLDS if self.reads == "last" else REPLACED, READS)

    def words(self) -> str:
        read = "read zero" if self.reads == "zero" else "repeated its last reading"
        return read if self.fraction == 1.0 else f"{read} in {100 * self.fraction:g} % of the control steps"


@valued
class Bias(SensorFault):
    """`value_<unit>` is added."""

    key, said = "value_{}", "was off by {}"
    type: Literal["bias"] = "bias"

    def enter(self, span: Span) -> None:
        span.offset[:] += self.value or 0.0


@valued
class Drift(SensorFault):
    """An offset that grows by `rate_<unit per second>` from `at_s` on, and is gone at `until_s`."""

    key, said = "rate_{per_second}", "drifted by {}"
    type: Literal["drift"] = "drift"

    def enter(self, span: Span) -> None:
        span.offset[:] += (self.value or 0.0) * span.steps / span.rate_hz


@valued
class Noise(SensorFault):
    """White noise of one-sided density `noise_<unit>_rthz` is added to the sensor's own."""

    key, said = "noise_{}_rthz", "had more noise, of {}"
    type: Literal["noise"] = "noise"

    def enter(self, span: Span) -> None:
        sigma = (self.value or 0.0) * math.sqrt(span.rate_hz / 2.0)
        span.offset[:] += sigma * span.random.standard_normal(len(span.offset))


TABLE: dict[str, type[SensorFault]] = {
    "stuck": Stuck,
    "dropout": Dropout,
    "bias": Bias,
    "drift": Drift,
    "noise": Noise,
}


def clash(one: SensorFault, other: SensorFault) -> str:
    """Name of a channel for which two faults conflict, or "" if there is none.

    Faults that add to a reading may overlap in time. A fault that replaces the reading may not overlap any other.
    """
    shared = set(channels_of(one.sensor)) & set(channels_of(other.sensor))
    ends = [math.inf if f.until_s is None else f.until_s for f in (one, other)]
    meet = max(one.at_s, other.at_s) < min(ends)
    conflict = one.replaces or other.replaces
    return CHANNELS[min(shared)].name if shared and meet and conflict else ""


def with_fault(faults: tuple[SensorFault, ...], new: SensorFault) -> tuple[SensorFault, ...]:
    """The faults with one more. Of two that conflict the earlier one ends when the later one begins."""
    for each in faults:
        if clash(each, new) and each.at_s > new.at_s:
            new = new.model_copy(update={"until_s": each.at_s})
    made, at = list(faults), len(faults)
    for i in reversed([i for i, each in enumerate(faults) if clash(each, new) and each.at_s <= new.at_s]):
        if faults[i].at_s < new.at_s:
            made[i] = faults[i].model_copy(update={"until_s": new.at_s})
        else:  # in its place, which names random numbers
            del made[i]
            at = i
    return (*made[:at], new, *made[at:])


def without_faults(
    faults: tuple[SensorFault, ...], sensor: str, step: int, rate_hz: float
) -> tuple[SensorFault, ...]:
    """The faults, where those that a sensor or channel has now end with this control step, or with the next if they begin in it."""
    mended = set(channels_of(sensor))

    def ended(fault: SensorFault) -> SensorFault:
        start, end = fault.window(rate_hz)
        if not (start <= step < end and mended.intersection(channels_of(fault.sensor))):
            return fault
        return fault.model_copy(update={"until_s": max(step, start + 1) / rate_hz})

    return tuple(map(ended, faults))
