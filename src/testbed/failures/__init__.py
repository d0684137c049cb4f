"""What can break, and which properties of the plant a failure holds, from when to when.

Adding a type is one class in `losses`, `held` or `varying`, and one line in TABLE. Times are seconds of the flight;
a failure starts at `at_s`, or when a logged signal is beyond a value, and lasts to `until_s` or to the end. Whatever
the type, it acts through properties of the JSBSim model alone; nothing is written before it starts.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Union

from pydantic import Field

from testbed.failures.base import ActuatorFailure, Capture, Course, Failure, Fault, When
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
from testbed.failures.overlaps import overlaps, same_property
from testbed.failures.varying import Decay, Delay, Intermittent, Oscillation, Runaway

__all__ = [
    "TABLE", "ActuatorFailure", "AnyFailure", "Capture", "Course", "Failure", "Fault", "When",
    "overlaps", "same_property",
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

if TYPE_CHECKING:
    AnyFailure = Failure
else:
    AnyFailure = Annotated[Union[tuple(TABLE.values())], Field(discriminator="type")]  # noqa: UP007
