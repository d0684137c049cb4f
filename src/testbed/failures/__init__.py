"""What can break: for each type of failure its fields, and the properties of the JSBSim model that it holds.

A failure acts only by holding properties of the model; none is written before it starts. Times are in seconds from the start
of the flight. A failure starts at `at_s`, or when a logged signal passes a limit, and lasts until `until_s` or until the end of
the flight. `testbed.injection` applies failures to a plant.

A new type is one class in `losses`, `held` or `varying`, and one line in TABLE.
"""

from __future__ import annotations

from testbed.failures.base import ActuatorFailure, Capture, Course, Failure, When
from testbed.failures.held import (
    Bias,
    CommandScale,
    Float,
    Hardover,
    Lag,
    PositionLimit,
    Property,
    RateLimit,
    Reversal,
    Stuck,
    StuckAt,
)
from testbed.failures.losses import Effectiveness, MotorStop, PropLoss, SurfaceLost
from testbed.failures.overlaps import held_by, meet, overlaps, same_property, stream_names, windows
from testbed.failures.varying import Decay, Delay, Intermittent, Oscillation, Runaway

__all__ = [
    "TABLE", "ActuatorFailure", "Capture", "Course", "Failure", "When",
    "held_by", "meet", "overlaps", "same_property", "stream_names", "windows",
]  # fmt: skip

TABLE: dict[str, type[Failure]] = {
    "effectiveness": Effectiveness,
    "command_scale": CommandScale,
    "stuck": Stuck,
    "stuck_at": StuckAt,
    "hardover": Hardover,
    "float": Float,
    "bias": Bias,
    "position_limit": PositionLimit,
    "rate_limit": RateLimit,
    "lag": Lag,
    "delay": Delay,
    "oscillation": Oscillation,
    "runaway": Runaway,
    "reversal": Reversal,
    "intermittent": Intermittent,
    "decay": Decay,
    "prop_loss": PropLoss,
    "motor_stop": MotorStop,
    "surface_lost": SurfaceLost,
    "property": Property,
}
