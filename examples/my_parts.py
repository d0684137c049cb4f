"""Parts of one's own, one of each kind: testbed run SCENARIO --with my_parts.py; `testbed check my_parts.py` tests them."""

import math
from typing import Annotated, ClassVar, Literal

import numpy as np
from pydantic import Field

from testbed.parts import ActuatorFailure, Panel, SensorFault, Series, valued


class Sticky(ActuatorFailure):
    """The servo sticks, and lets go for `free_s` at the end of every `period_s`."""

    kinds: ClassVar = ("servo",)
    type: Literal["sticky"] = "sticky"
    period_s: Annotated[float, Field(gt=0)] = 1.0
    free_s: Annotated[float, Field(gt=0)] = 0.2
    examples: ClassVar = {"servo": {"period_s": 0.5}}

    def words(self, kind, unit):
        return f"stuck, and let go for {self.free_s:g} s in every {self.period_s:g} s"

    def properties(self, aircraft):
        return {self.name(aircraft, "servo/malfunction/fail_stuck"): 1.0}

    def course(self, aircraft, random):
        (name,) = self.properties(aircraft)
        return name, lambda t, start: float(t % self.period_s < self.period_s - self.free_s)


@valued
class Spikes(SensorFault):
    """`value_<unit>` is added to one reading in twenty."""

    key = "value_{}"
    type: Literal["spikes"] = "spikes"

    def enter(self, span):
        span.offset[span.random.random(len(span.steps)) < 0.05] += self.value


def worst_bank_deg(readings):
    """Largest bank angle, either way, in the whole flight [deg]."""
    return np.abs(readings.log["roll_deg"]).max()


def tail(flight):
    """Both tail surfaces in one panel."""
    names = [name for name in flight.actuators if name.endswith("ruddervator")]
    styles = ("truth", "second")
    series = [Series(f"{name}_position", name, style) for name, style in zip(names, styles, strict=False)]
    yield Panel("tail", "deg", tuple(series), 1.0)


def weave(scenario, time, rows):
    """Headings 10 deg to either side of the command, once in 20 s."""
    rate = 2 * math.pi / 20
    rows[:, 2] += math.radians(10) * np.sin(rate * time)
    rows[:, 5] += math.radians(10) * rate * np.cos(rate * time)
    return rows


FAILURES = [Sticky]
SENSOR_FAULTS = [Spikes]
SENSORS = {"tactical": {"gyro": {"noise_deg_s_rthz": 0.002, "bias_sigma_deg_s": 0.005}}}
METRICS = [worst_bank_deg]
PANELS = [tail]
REFERENCES = [weave]
