"""Two failures may hold the same property only one after the other, or where the later replaces the earlier."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from testbed.aircraft.description import Aircraft
from testbed.failures.base import Failure


def same_property(name: str) -> str:
    """One spelling of a property: JSBSim takes `a[0]/b` and `a/b` for the same."""
    return name.replace("[0]", "")


def overlaps(failures: Sequence[Failure], aircraft: Aircraft) -> Iterator[tuple[int, int, str]]:
    """Failures that would hold a property which an earlier one holds at that time: (first such index, index, property).

    Two failures may hold the same property only if their windows [at_s, until_s) do not overlap. There is one exception,
    for a failure that gets worse in steps: if two are of one type, both have `at_s` and neither has `until_s`, then the
    later one replaces the earlier one (effectiveness 0.2 from 5 s, and 0.0 from 15 s). The window of a failure with
    `when` begins at 0, because it may start at any time.
    """
    held = [{same_property(name) for name in failure.properties(aircraft)} for failure in failures]
    for j, later in enumerate(failures):
        for i, earlier in enumerate(failures[:j]):
            shared = held[i] & held[j]
            if shared and _meet(earlier, later) and not _replaces(earlier, later):
                yield i, j, min(shared)
                break


def _meet(one: Failure, other: Failure) -> bool:
    return max(one.window_s[0], other.window_s[0]) < min(one.window_s[1], other.window_s[1])


def _replaces(one: Failure, other: Failure) -> bool:
    open_ended = one.until_s is None and other.until_s is None
    timed = one.at_s is not None and other.at_s is not None
    return open_ended and timed and one.type == other.type and one.at_s != other.at_s
