"""What can break: for each type of failure its fields, and the properties of the JSBSim model that it holds.

A failure acts only by holding properties of the model; none is written before it starts. Times are in seconds from the start
of the flight. A failure starts at `at_s`, or when a logged signal passes a limit, and lasts until `until_s` or until the end of
the flight. `testbed.injection` applies failures to a plant.

A new type is one class in `losses`, `held` or `varying`, and one line in TABLE.
"""

from __future__ import annotations

from testbed.failures import held, losses, varying
from testbed.failures.base import ActuatorFailure, Capture, Course, Failure, When
from testbed.failures.overlaps import held_by, meet, overlaps, same_property, stream_names, windows

__all__ = [
    "TABLE", "ActuatorFailure", "Capture", "Course", "Failure", "When",
    "held_by", "meet", "overlaps", "same_property", "stream_names", "windows",
]  # fmt: skip

TABLE: dict[str, type[Failure]] = {
    "effectiveness": losses.Effectiveness,
    "command_scale": held.CommandScale,
    "stuck": held.Stuck,
    "stuck_at": held.StuckAt,
    "hardover": held.Hardover,
    "float": held.Float,
    "bias": held.Bias,
    "position_limit": held.PositionLimit,
    "rate_limit": held.RateLimit,
    "lag": held.Lag,
    "delay": varying.Delay,
    "oscillation": varying.Oscillation,
    "runaway": varying.Runaway,
    "reversal": held.Reversal,
    "intermittent": varying.Intermittent,
    "decay": varying.Decay,
    "prop_loss": losses.PropLoss,
    "motor_stop": losses.MotorStop,
    "surface_lost": losses.SurfaceLost,
    "property": held.Property,
}
