"""What can break: for each type of failure its fields, and the properties of the JSBSim model that it holds; and which of those of
one scenario overlap.

A failure acts only by holding properties of the model; none is written before it starts. Times are in seconds from the start
of the flight. A failure starts at `at_s`, or when a logged signal passes a limit, and lasts until `until_s` or until the end of
the flight. Two may hold the same property only one after the other, or where the later replaces the earlier. `testbed.injection`
applies failures to a plant.

A new type is one class in `losses`, `held` or `varying`, and one line in TABLE.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from testbed.aircraft.description import Aircraft
from testbed.failures import held, losses, varying
from testbed.failures.base import ActuatorFailure, Capture, Course, Failure, When

__all__ = [
    "TABLE", "ActuatorFailure", "Capture", "Course", "Failure", "When",
    "held_by", "meet", "overlaps", "same_property", "stream_names", "windows",
]  # fmt: skip

Window = tuple[float, float]
"""From when to when a failure holds its properties [s]."""

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


def same_property(name: str) -> str:
    """One spelling of a property: JSBSim takes `a[0]/b` and `a/b` for the same."""
    return name.replace("[0]", "")


def held_by(failure: Failure, aircraft: Aircraft) -> frozenset[str]:
    """The properties that a failure holds, each in one spelling."""
    return frozenset(map(same_property, failure.properties(aircraft)))


def overlaps(failures: Sequence[Failure], aircraft: Aircraft) -> Iterator[tuple[int, int, str]]:
    """Failures that would hold a property which an earlier one holds at that time: (first such index, index, property).

    Two failures may hold the same property only if their `windows` do not meet.
    """
    held = [held_by(failure, aircraft) for failure in failures]
    lasting = windows(failures, held)
    for j in range(len(failures)):
        for i in range(j):
            shared = held[i] & held[j]
            if shared and meet(lasting[i], lasting[j]):
                yield i, j, min(shared)
                break


def windows(failures: Sequence[Failure], held: Sequence[frozenset[str]]) -> list[Window]:
    """When each failure acts: its [at_s, until_s), but for one that gets worse in steps.

    A failure without `until_s` is replaced by the next one of its type on the same property, if both have `at_s` (effectiveness
    0.2 from 5 s, and 0.0 from 15 s). When that one ends, the actuator is healthy. The window of a failure with `when` begins
    at 0, because it may start at any time.

    Args:
        held: the properties that each holds (see `held_by`).
    """
    return [(each.window_s[0], _end(i, failures, held)) for i, each in enumerate(failures)]


def _end(i: int, failures: Sequence[Failure], held: Sequence[frozenset[str]]) -> float:
    """When a failure ends or is replaced [s]."""
    one = failures[i]
    if one.until_s is not None or one.at_s is None:
        return one.window_s[1]
    replaced_at = (
        other.at_s
        for other, names in zip(failures, held, strict=True)
        if other.type == one.type and other.at_s is not None and other.at_s > one.at_s and names & held[i]
    )
    return min(replaced_at, default=math.inf)


def meet(one: Window, other: Window) -> bool:
    """Whether two windows have any time in common."""
    return max(one[0], other[0]) < min(one[1], other[1])


def stream_names(failures: Sequence[Failure]) -> Iterator[str]:
    """Name of each failure's random stream: its type, its actuator, and its number among failures with the same two.

    So the random numbers of a failure stay the same when one of another type or actuator is inserted or removed, and when its
    own time or severity changes.
    """
    seen: Counter[tuple[str, str | None]] = Counter()
    for failure in failures:
        kind = (failure.type, failure.actuator)
        yield f"failure/{failure.type}/{failure.actuator}/{seen[kind]}"
        seen[kind] += 1
