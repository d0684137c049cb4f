"""Failures that change with time: late, oscillating, running away, intermittent, decaying."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from testbed.aircraft.description import Aircraft
from testbed.failures.base import ActuatorFailure, Capture, Course, Examples, both, stop_words
from testbed.failures.losses import Gain
from testbed.inputs.base import NonNegative, Number, Positive
from testbed.inputs.problems import Issue

MAX_DELAY_S = 5.0
"""Longest delay that a scenario may ask for [s], because all delayed commands are kept in memory."""


class Delay(ActuatorFailure):
    """Commands arrive `delay_s` late, to the nearest control step; before the first of them the last healthy one is held."""

    said: ClassVar[str] = "followed its commands {0.delay_s:g} s late"
    type: Literal["delay"] = "delay"
    delay_s: Annotated[Number, Field(ge=0, le=MAX_DELAY_S)]
    harmless: ClassVar[Mapping[str, Any]] = {"delay_s": 0.0}
    examples: ClassVar[Examples] = both({"delay_s": 0.15})

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        command = self.name(aircraft, "command-rad", "command-norm")
        return {command: Capture(command)}

    def delay_steps(self, rate_hz: float) -> int:
        return math.floor(self.delay_s * rate_hz + 0.5)

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        if self.delay_s > 0 and not self.delay_steps(rate_hz):
            what = f"{self.delay_s:g} s is less than half a control step: nothing would be late"
            yield Issue(("delay_s",), what, f"0 or at least {0.5 / rate_hz:g}")


class Oscillation(ActuatorFailure):
    """A sine of `amplitude` and `frequency_hz` is added to the commands of the servo or motor."""

    said: ClassVar[str] = (
        "had a sine of {0.amplitude:g} {unit} at {0.frequency_hz:g} Hz added to its commands"
    )
    type: Literal["oscillation"] = "oscillation"
    amplitude: NonNegative
    frequency_hz: Positive
    harmless: ClassVar[Mapping[str, Any]] = {"amplitude": 0.0, "frequency_hz": 3.0}
    examples: ClassVar[Examples] = both(
        {"amplitude": 4.0, "frequency_hz": 3.0}, {"amplitude": 0.15, "frequency_hz": 3.0}
    )

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "command-bias-rad", "command-bias-norm"): 0.0}

    def course(self, aircraft: Aircraft, random: np.random.Generator) -> tuple[str, Course]:
        amplitude, omega = self.inside(aircraft, self.amplitude), 2.0 * math.pi * self.frequency_hz
        (name,) = self.properties(aircraft)
        return name, lambda t, start: amplitude * math.sin(omega * t)

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        low, high = self.travel(aircraft)
        yield from self.outside(aircraft, "amplitude", 0.0, high - low)
        if self.frequency_hz > 0.25 * rate_hz:
            what = f"{self.frequency_hz:g} Hz cannot be made of steps at {rate_hz:g} Hz"
            yield Issue(("frequency_hz",), what, f"at most a quarter of rate_hz, {0.25 * rate_hz:g}")


class Runaway(ActuatorFailure):
    """The servo or throttle moves from where it is, at `rate` per second, to its highest (`to: max`) or lowest (`to: min`) stop."""

    type: Literal["runaway"] = "runaway"
    follows_command: ClassVar[bool] = False
    rate: Positive
    to: Literal["max", "min"] = "max"
    examples: ClassVar[Examples] = both({"rate": 10.0}, {"rate": 0.3})

    def words(self, kind: str, unit: str) -> str:
        return f"moved to its {stop_words(self.to)} at {self.rate:g} {unit}/s"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return self.override(aircraft, Capture(self.name(aircraft, "servo-rad", "throttle-norm")))

    def course(self, aircraft: Aircraft, random: np.random.Generator) -> tuple[str, Course]:
        name = self.name(aircraft, "override-rad", "override-norm")
        rate, (low, high) = self.inside(aircraft, self.rate), self.travel(aircraft)
        if self.to == "max":
            stop = self.inside(aircraft, high)
            return name, lambda t, start: max(start, min(start + rate * t, stop))
        stop = self.inside(aircraft, low)
        return name, lambda t, start: min(start, max(start - rate * t, stop))

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        if self.is_servo(aircraft):
            yield from self.outside(aircraft, "rate", 0.0, aircraft.actuators[self.actuator].rate_limit, "/s")


class Intermittent(ActuatorFailure):
    """Effectiveness alternates between `value`, for `off_s` on average, and 1, for `on_s` on average; each duration is random."""

    type: Literal["intermittent"] = "intermittent"
    draws: ClassVar[bool] = True
    value: Annotated[Number, Field(ge=0, le=1)] = 0.0
    off_s: Positive
    on_s: Positive
    harmless: ClassVar[Mapping[str, Any]] = {"value": 1.0, "off_s": 0.2, "on_s": 0.3}
    examples: ClassVar[Examples] = both({"value": 0.0, "off_s": 0.2, "on_s": 0.3})

    def words(self, kind: str, unit: str) -> str:
        share = f"at {100 * self.value:.0f} % for {self.off_s:g} s"
        return f"began to fail on and off ({share}, healthy for {self.on_s:g} s on average)"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        return {self.name(aircraft, "effectiveness"): self.value}

    def course(self, aircraft: Aircraft, random: np.random.Generator) -> tuple[str, Course]:
        """Durations are exponentially distributed, and drawn as the flight goes on; the first is one with effectiveness `value`."""
        healthy = 1.0
        ends_at, broken = random.exponential(self.off_s), True

        def value_at(t: float, start: float) -> float:
            nonlocal ends_at, broken
            while t >= ends_at:
                broken = not broken
                ends_at += random.exponential(self.off_s if broken else self.on_s)
            return self.value if broken else healthy

        return self.name(aircraft, "effectiveness"), value_at

    def faults(self, aircraft: Aircraft, rate_hz: float) -> Iterator[Issue]:
        for field, spell in (("off_s", self.off_s), ("on_s", self.on_s)):
            if spell * rate_hz < 1.0:
                yield Issue(
                    (field,), f"{spell:g} s is shorter than a control step", f"at least {1.0 / rate_hz:g}"
                )


class Decay(ActuatorFailure):
    """Effectiveness goes to `value`: linearly within `over_s`, or with `shape: exponential` with the time constant `over_s`."""

    type: Literal["decay"] = "decay"
    value: Gain
    over_s: Positive
    shape: Literal["linear", "exponential"] = "linear"
    harmless: ClassVar[Mapping[str, Any]] = {"value": 1.0, "over_s": 0.8}
    examples: ClassVar[Examples] = both({"value": 0.2, "over_s": 0.8})

    def words(self, kind: str, unit: str) -> str:
        how = "within" if self.shape == "linear" else "with a time constant of"
        return f"began to lose its effect (to {100 * self.value:.0f} % {how} {self.over_s:g} s)"

    def properties(self, aircraft: Aircraft) -> dict[str, float | Capture]:
        name = self.name(aircraft, "effectiveness")
        return {name: Capture(name)}

    def course(self, aircraft: Aircraft, random: np.random.Generator) -> tuple[str, Course]:
        value, over = self.value, self.over_s
        (name,) = self.properties(aircraft)
        if self.shape == "linear":
            return name, lambda t, start: value if t >= over else start + (value - start) * (t / over)
        return name, lambda t, start: value + (start - value) * math.exp(-t / over)
