"""One failure on one plant: what it writes when it starts, while it lasts, and when it ends."""

from __future__ import annotations

from collections import deque

import numpy as np

from testbed.aircraft.description import Actuator, Aircraft
from testbed.failures import Capture, Course, Failure
from testbed.injection.receipt import Hold, Watch, reads_back
from testbed.plant.jsbsim import Plant


class Injection:
    """One failure bound to a plant: starts, changes with time, ends."""

    def __init__(
        self, plant: Plant, aircraft: Aircraft, failure: Failure, rate_hz: float, random: np.random.Generator
    ):
        self.failure = failure
        self.active = False
        self.watch: Watch | None = None
        self._plant, self._rate_hz = plant, rate_hz
        self.holds = {name: self._hold(name, value) for name, value in failure.properties(aircraft).items()}
        self._course: tuple[str, Course] | None = failure.course(aircraft, random)
        self._late = failure.delay_steps(rate_hz)
        self._actuator = _watched(failure, aircraft)
        self._queue: deque[float] = deque()

    def _hold(self, name: str, value: float | Capture) -> Hold:
        get = self._plant.getter(name)
        held = self._plant.getter(value.source) if isinstance(value, Capture) else value
        return Hold(name, held, self._plant.setter(name), get, healthy=get())

    @property
    def changes(self) -> bool:
        """Whether it has something to do in each step while it is active."""
        return self._course is not None or (self.watch is not None and not self.watch.done)

    @property
    def filters(self) -> bool:
        """Whether it changes the commands of each step."""
        return self.active and self._late is not None

    def start(self, step: int) -> bool:
        """Write; returns whether all properties read back as written."""
        self._start, self.active = step, True
        holds = self.holds.values()
        values = [hold.value() if callable(hold.value) else hold.value for hold in holds]
        for hold in holds:
            hold.before = hold.get()
        self.watch = Watch(self._plant, self._actuator, self.holds)
        for hold, value in zip(holds, values, strict=True):
            hold.first = value
            hold.write(value)
        if self._late:
            self._queue.extend(values * self._late)
        return all(reads_back(hold.get(), hold.written) for hold in holds)

    def change(self, step: int) -> None:
        """The held value of this step."""
        if self._course is not None:
            name, course = self._course
            hold = self.holds[name]
            hold.write(course((step - self._start) / self._rate_hz, hold.first))

    def delay(self) -> None:
        """Put the command of some steps ago in the place of the one just given."""
        (hold,) = self.holds.values()
        hold.before = hold.healthy = hold.get()
        self._queue.append(hold.before)
        hold.write(self._queue.popleft())

    def end(self) -> bool:
        """Restore; returns whether all properties read back as they were."""
        self.stop()
        for hold in self.holds.values():
            hold.put(hold.healthy)
        return all(reads_back(hold.get(), hold.healthy) for hold in self.holds.values())

    def stop(self) -> None:
        """Let go without restoring."""
        self.active = False
        self._queue.clear()
        if self.watch is not None:
            self.watch.finish()


def _watched(failure: Failure, aircraft: Aircraft) -> Actuator | None:
    """The actuator that a receipt looks at: the failure's, or the one whose block has all its properties."""
    for name, actuator in aircraft.actuators.items():
        if name == failure.actuator or all(
            p.startswith(actuator.prefix + "/") for p in failure.properties(aircraft)
        ):
            return actuator
    return None
