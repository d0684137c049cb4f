"""Break things in flight: start and end failures when they are due, and keep a receipt of each start and end."""

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

    Nothing is written before a failure starts, so a flight is bit-identical to the healthy one until then.
    The loop calls `apply(step)` when `step >= next_step`, and nothing else while no failure is due.

    Attributes:
        next_step: the control step at which `apply` has to be called next.
        filters: functions to call after each step's commands have been given; empty unless commands are delayed.
    """

    def __init__(
        self, plant: Plant, aircraft: Aircraft, failures: Sequence[Failure], rate_hz: float, seed: int = 0
    ) -> None:
        """`seed` is the flight's: each failure draws from a stream of its own."""
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
        """One for each start and end, in order of time; at one time ends come first.

        Each is {time_s, kind, failure (its place in the scenario), type, actuator (None if it breaks none), active,
        properties, verified}; a start's has also `effect` (see `testbed.injection.receipt`). `verified` is None where
        there was nothing to see.
        """
        receipts = [receipt for injection in self._injections for receipt in injection.receipts]
        return sorted(receipts, key=lambda receipt: (receipt["time_s"], receipt["active"]))

    def observe(self, recorded: Recorded) -> None:
        """Let failures with `when` see what the loop records; the row before the present step is complete."""
        for injection in self._injections:
            injection.observe(recorded)
        self._plan(-1)

    def apply(self, step: int) -> None:
        """Look at what the last step has shown, start and end what is due, and write what changes."""
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
            if other.active and other.shares(injection):  # the later one replaces it
                other.let_go()
        injection.start(step)

    def _plan(self, step: int) -> None:
        """Decide when to be called again: in the next step while a failure changes, is watched or waits."""
        self._busy = [injection for injection in self._injections if injection.busy]
        waiting = any(injection.waiting for injection in self._injections)
        timed = self._agenda[self._due][0] if self._due < len(self._agenda) else math.inf
        self.next_step = step + 1 if self._busy or waiting else timed
        self.filters[:] = [injection.delay for injection in self._injections if injection.delays]

    def finish(self) -> list[str]:
        """The flight is over: settle the receipts; returns a warning for each failure that did not act as asked."""
        for injection in self._injections:
            if injection.active:
                injection.look()  # at the flight's last step
                injection.let_go()
        return [text for injection in self._injections for text in injection.warnings()]


def stream_names(failures: Sequence[Failure]) -> Iterator[str]:
    """Name of each failure's random stream: its type, its actuator, and which of these it is in the scenario.

    So a failure keeps its draws when one of another type or another actuator is inserted or removed, and when its own
    time or severity changes.
    """
    seen: Counter[tuple[str, str | None]] = Counter()
    for failure in failures:
        kind = (failure.type, failure.actuator)
        yield f"failure/{failure.type}/{failure.actuator}/{seen[kind]}"
        seen[kind] += 1
