"""Break things in flight: hold JSBSim properties at values from one time to another, and keep a receipt."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

from testbed.aircraft import Aircraft
from testbed.failures import Failure
from testbed.plant import Plant


@dataclass
class _Hold:
    """One failure's hold on one property."""

    index: int
    failure: Failure
    name: str
    value: float
    put: Callable[[float], bool]
    get: Callable[[], float]
    healthy: float


@dataclass
class Injector:
    """Applies a scenario's failures to a plant, step by step.

    Nothing is written before a failure starts, so a flight is bit-identical to the healthy one until then.

    Attributes:
        receipts: one for each start and end: {time_s, failure, type, actuator, active, properties, verified}.
    """

    plant: Plant
    aircraft: Aircraft
    failures: Sequence[Failure]
    rate_hz: float
    receipts: list[dict[str, Any]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._holds = [self._bind(i, f) for i, f in enumerate(self.failures)]
        self._agenda = sorted(self._timed(), key=lambda entry: entry[0])
        self._next = 0
        self.next_step = self._agenda[0][0] if self._agenda else math.inf

    def _bind(self, index: int, failure: Failure) -> list[_Hold]:
        holds = []
        for name, value in failure.properties(self.aircraft).items():
            get = self.plant.getter(name)
            holds.append(_Hold(index, failure, name, value, self.plant.setter(name), get, get()))
        return holds

    def _timed(self) -> list[tuple[int, int, bool]]:
        agenda = []
        for i, failure in enumerate(self.failures):
            start, end = failure.window_s
            agenda.append((self._step(start), i, True))
            if math.isfinite(end):
                agenda.append((self._step(end), i, False))
        return agenda

    def _step(self, time_s: float) -> int:
        """First control step at or after a time; one clock for all, t = step / rate."""
        return math.ceil(time_s * self.rate_hz - 1e-9)

    def apply(self, step: int) -> None:
        """Start and end what is due; call when `step >= next_step`."""
        while self._next < len(self._agenda) and self._agenda[self._next][0] <= step:
            _, index, active = self._agenda[self._next]
            self._switch(step, index, active)
            self._next += 1
        self.next_step = self._agenda[self._next][0] if self._next < len(self._agenda) else math.inf

    def _switch(self, step: int, index: int, active: bool) -> None:
        failure, verified = self.failures[index], True
        for hold in self._holds[index]:
            value = hold.value if active else hold.healthy
            hold.put(value)
            verified = verified and hold.get() == value
        self.receipts.append(
            {
                "time_s": step / self.rate_hz,
                "kind": "injection",
                "failure": index,
                "type": failure.type,
                "actuator": failure.actuator,
                "active": active,
                "properties": {hold.name: hold.get() for hold in self._holds[index]},
                "verified": verified,
            }
        )
