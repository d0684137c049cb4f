"""The random stream of each failure, which depends on its place among the failures of a scenario."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from testbed.failures.base import Failure


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
