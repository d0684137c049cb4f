"""Break things in flight: start and end failures when they are due, and keep a receipt of each."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from testbed.aircraft.description import Aircraft
from testbed.failures import Failure, same_property
from testbed.flight.columns import Recorded, reader
from testbed.injection.injection import Injection
from testbed.injection.receipt import RECEIPT_STEPS
from testbed.plant.jsbsim import Plant

_STREAM = 1
"""The failures' branch of the run's random numbers; each failure has a stream of its own in it."""


@dataclass
class Injector:
    """Applies a scenario's failures to a plant, step by step.

    Nothing is written before a failure starts, so a flight is bit-identical to the healthy one until then.

    Attributes:
        next_step: the control step at which `apply` has to be called next.
        filters: functions to call after each step's commands have been given; empty unless commands are delayed.
        receipts: one for each start and end: {time_s, failure, type, actuator, active, properties, verified}, and
            `effect` of a start (see `testbed.injection.receipt`). `verified` is None where there was nothing to see.
    """

    plant: Plant
    aircraft: Aircraft
    failures: Sequence[Failure]
    rate_hz: float
    seed: int = 0
    filters: list[Callable[[], None]] = field(default_factory=list)
    receipts: list[dict[str, Any]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._all = [
            Injection(self.plant, self.aircraft, failure, self.rate_hz, self._random(index))
            for index, failure in enumerate(self.failures)
        ]
        self._agenda = sorted(self._timed())
        self._next = 0
        self._busy: list[int] = []
        self._starts: dict[int, dict[str, Any]] = {}
        self._waiting: dict[int, Callable[[int], float]] = {}
        self._plan(-1)

    def _random(self, index: int) -> np.random.Generator:
        return np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(_STREAM, index)))

    def _timed(self) -> list[tuple[int, bool, int]]:
        """(step, starts?, failure): at one step, ends come before starts, so that windows may touch."""
        agenda = []
        for i, failure in enumerate(self.failures):
            if failure.at_s is not None:
                agenda.append((self._step(failure.at_s), True, i))
            if failure.until_s is not None:
                agenda.append((self._step(failure.until_s), False, i))
        return agenda

    def _step(self, time_s: float) -> int:
        """First control step at or after a time; one clock for all, t = step / rate."""
        return math.ceil(time_s * self.rate_hz - 1e-9)

    def observe(self, recorded: Recorded) -> None:
        """Let failures with `when` see what the loop records; the row before the present step is complete."""
        for i, failure in enumerate(self.failures):
            if failure.when is not None:
                self._waiting[i] = reader(self.aircraft, self.rate_hz, recorded, failure.when.signal)
        self._plan(-1)

    def apply(self, step: int) -> None:
        """Look at what the last step has shown, start and end what is due; call when `step >= next_step`."""
        for i in self._busy:
            self._look(i)
        while self._next < len(self._agenda) and self._agenda[self._next][0] <= step:
            _, starts, index = self._agenda[self._next]
            if starts:
                self._start(step, index)
            elif self._all[index].active:
                self._end(step, index)
            self._waiting.pop(index, None)
            self._next += 1
        for i in [i for i, read in self._waiting.items() if step > 0 and self._met(i, read(step - 1))]:
            del self._waiting[i]
            self._start(step, i)
        for injection in self._all:
            if injection.active:
                injection.change(step)
        self._plan(step)

    def _met(self, index: int, value: float) -> bool:
        when = self.failures[index].when
        return when is not None and when.met(value)

    def _plan(self, step: int) -> None:
        """When to be called again: in the next step while something changes or is being watched."""
        self._busy = [i for i, injection in enumerate(self._all) if injection.active and injection.changes]
        timed = self._agenda[self._next][0] if self._next < len(self._agenda) else math.inf
        self.next_step = step + 1 if self._busy or self._waiting else timed
        self.filters[:] = [injection.delay for injection in self._all if injection.filters]

    def _look(self, index: int) -> None:
        watch = self._all[index].watch
        if watch is not None and not watch.done:
            watch.look()
            self._note(index)

    def _note(self, index: int) -> None:
        """Bring the start's receipt up to what the watch knows."""
        watch, receipt = self._all[index].watch, self._starts[index]
        if watch is not None and receipt["verified"] is not False:
            receipt["verified"], receipt["effect"] = watch.verified, watch.effect

    def _start(self, step: int, index: int) -> None:
        injection = self._all[index]
        names = set(map(same_property, injection.holds))
        for other, earlier in enumerate(self._all):
            if earlier.active and names & set(map(same_property, earlier.holds)):  # this one takes over
                earlier.stop()
                self._note(other)
        read_back = injection.start(step)
        self._starts[index] = self._receipt(step, index, True, None if read_back else False)

    def _end(self, step: int, index: int) -> None:
        restored = self._all[index].end()
        self._note(index)
        self._receipt(step, index, False, restored)

    def _receipt(self, step: int, index: int, active: bool, verified: bool | None) -> dict[str, Any]:
        receipt = {
            "time_s": step / self.rate_hz,
            "kind": "injection",
            "failure": index,
            "type": self.failures[index].type,
            "actuator": self.failures[index].actuator,
            "active": active,
            "properties": {name: hold.get() for name, hold in self._all[index].holds.items()},
            "verified": verified,
        }
        self.receipts.append(receipt)
        return receipt

    def finish(self) -> list[str]:
        """The flight is over: settle the receipts; returns a warning for each failure that did not act."""
        for index in self._starts:
            injection = self._all[index]
            if injection.active:
                self._look(index)  # at the flight's last step
                injection.stop()
                self._note(index)
        return [text for index in range(len(self.failures)) for text in self._warnings(index)]

    def _warnings(self, index: int) -> list[str]:
        failure = self.failures[index]
        name = f"failures.{index} ({failure.type}{f', {failure.actuator}' if failure.actuator else ''})"
        if index not in self._starts:
            why = f"{failure.when} did not happen" if failure.when else "the flight ended before"
            return [f"{name} never started: {why}"]
        mine = [receipt for receipt in self.receipts if receipt["failure"] == index]
        texts = {
            (True, False): f"did NOT take effect within {RECEIPT_STEPS} control steps",
            (True, None): "had no observable effect: with and without it the actuator does the same",
            (False, False): "was NOT undone: its properties do not read back as they were",
        }
        keys = [((receipt["active"], receipt["verified"]), receipt["time_s"]) for receipt in mine]
        return [f"{name} at {time:g} s {texts[key]}" for key, time in keys if key in texts]
