"""When failures may share a property: in windows that do not meet, or one of a type taking over from another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from testbed.aircraft.description import Aircraft
from testbed.failures.base import Failure


def same_property(name: str) -> str:
    """One spelling of a property: JSBSim takes `a[0]/b` and `a/b` for the same."""
    return name.replace("[0]", "")


def overlaps(failures: Sequence[Failure], aircraft: Aircraft) -> Iterator[tuple[int, int, str]]:
    """Pairs of failures that would write one property at one time: (first index, second index, property).

    Two failures may hold the same property only in windows [at_s, until_s) that do not meet. One exception:
    of two failures of one type, both with `at_s` and neither with `until_s`, the one that starts later takes
    over from the other (0.2 from 5 s, 0.0 from 15 s). One with `when` may start at any time, so its window
    begins at 0.
    """
    held = [{same_property(name) for name in failure.properties(aircraft)} for failure in failures]
    for j, later in enumerate(failures):
        for i, earlier in enumerate(failures[:j]):
            shared = held[i] & held[j]
            if shared and _meet(earlier, later) and not _takes_over(earlier, later):
                yield i, j, min(shared)


def _meet(one: Failure, other: Failure) -> bool:
    return max(one.window_s[0], other.window_s[0]) < min(one.window_s[1], other.window_s[1])


def _takes_over(one: Failure, other: Failure) -> bool:
    open_ended = one.until_s is None and other.until_s is None
    timed = one.at_s is not None and other.at_s is not None
    return open_ended and timed and one.type == other.type and one.at_s != other.at_s
