"""Start and end the failures of a scenario when they are due, and keep a receipt of each start and end."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from testbed.aircraft.description import Aircraft
from testbed.common.random_streams import generator
from testbed.failures import Failure
from testbed.flight.columns import Recorded
from testbed.injection.injection import Injection
from testbed.plant.jsbsim import Plant


class Injector:
    """Applies a scenario's failures to a plant, step by step.

    No property is written before a failure starts, so until then the flight is bit-identical to the healthy one.
    The loop calls `apply(step)` when `step >= next_step`; while no failure is due it calls nothing.

    Attributes:
        next_step: the control step at which `apply` has to be called next.
        filters: functions that the loop calls after it has given the commands of a step; empty unless commands are delayed.
    """

    def __init__(
        self, plant: Plant, aircraft: Aircraft, failures: Sequence[Failure], rate_hz: float, seed: int = 0
    ) -> None:
        """`seed` is that of the flight; each failure has a random stream of its own."""
        streams = (generator(seed, name) for name in stream_names(failures))
        self._injections = [
            Injection(plant, aircraft, failure, index, rate_hz, random)
            for index, (failure, random) in enumerate(zip(failures, streams, strict=True))
        ]
        self._agenda = sorted(
            ((step, starts, each) for each in self._injections for step, starts in each.agenda()),
            key=lambda entry: entry[:2],  # at one step ends come before starts, so that windows may touch
        )
        self._due = 0  # first entry of the agenda that has not been carried out
        self.filters: list[Callable[[], None]] = []
        self._plan(-1)

    @property
    def receipts(self) -> list[dict[str, Any]]:
        """A receipt for each start and each end, in order of time; at the same time, ends come first.

        Each is {time_s, kind, failure (its place in the scenario), type, actuator (None if it breaks none), active (true for a
        start), properties, verified}. That of a start also has `effect` (see `testbed.injection.receipt`). `verified` is None if
        there was no effect to see.
        """
        receipts = [receipt for injection in self._injections for receipt in injection.receipts]
        return sorted(receipts, key=lambda receipt: (receipt["time_s"], receipt["active"]))

    @property
    def active(self) -> Iterator[Injection]:
        """The failures that have started and not ended."""
        return (injection for injection in self._injections if injection.active)

    def observe(self, recorded: Recorded) -> None:
        """Give failures with `when` the arrays that the loop fills. They read the row of the step before, which is complete."""
        for injection in self._injections:
            injection.observe(recorded)
        self._plan(-1)

    def apply(self, step: int) -> None:
        """Check the effects in the last step, start and end the failures that are due, and write the values that change."""
        for injection in self._busy:
            injection.look()
        while self._due < len(self._agenda) and self._agenda[self._due][0] <= step:
            self._carry_out(step, *self._agenda[self._due][1:])
            self._due += 1
        for injection in self._injections:
            if injection.waiting and injection.triggered(step):
                self._start(step, injection)
        for injection in self._injections:
            if injection.active:
                injection.change(step)
        self._plan(step)

    def _carry_out(self, step: int, starts: bool, injection: Injection) -> None:
        if starts:
            self._start(step, injection)
        elif injection.active:
            injection.end(step)
        injection.waiting = False  # its `until_s` has passed

    def _start(self, step: int, injection: Injection) -> None:
        for other in self._injections:
            if other.active and other.shares(injection):  # the one that starts replaces it
                other.let_go()
        injection.start(step)

    def _plan(self, step: int) -> None:
        """Set `next_step`: the next control step while a failure changes, is watched or waits, else the next start or end."""
        self._busy = [injection for injection in self._injections if injection.busy]
        waiting = any(injection.waiting for injection in self._injections)
        timed = self._agenda[self._due][0] if self._due < len(self._agenda) else math.inf
        self.next_step = step + 1 if self._busy or waiting else timed
        self.filters[:] = [injection.delay for injection in self._injections if injection.delays]

    def finish(self) -> list[str]:
        """Complete the receipts at the end of the flight; returns a warning for each failure that did not act as asked."""
        for injection in self._injections:
            if injection.active:
                injection.look()  # at the flight's last step
                injection.let_go()
        return [text for injection in self._injections for text in injection.warnings()]


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
