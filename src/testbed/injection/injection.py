"""One failure on one plant: what it writes when it starts, while it lasts and when it ends, and its receipts."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from copy import copy
from typing import Any

from testbed.aircraft.description import Aircraft
from testbed.common.random_streams import generator
from testbed.common.signals import first_step_at
from testbed.failures import Capture, Course, Failure, held_by
from testbed.flight.breakage import stayed
from testbed.flight.columns import Recorded, reader
from testbed.injection.receipt import RECEIPT_STEPS, Hold, Watch, reads_back
from testbed.plant.jsbsim import Plant

_NOT_AS_ASKED = {
    (True, False): f"did NOT take effect within {RECEIPT_STEPS} control steps",
    (True, None): "had no observable effect: with and without it the actuator does the same",
    (False, False): "was NOT undone: its properties do not read back as they were",
}
"""Warnings, by `active` and `verified` of a receipt."""


class Injection:
    """One failure bound to a plant. It starts at most once, and ends at most once.

    Attributes:
        failure: the failure as the scenario has it.
        actuator: name of the actuator that it breaks; None if its properties are not all in the block of one actuator.
        active: whether it has started and has not ended.
        waiting: whether it waits for its `when` to come true.
        receipts: one of its start and one of its end, once these have happened (see `Injector`, which numbers them).
        names: the properties that it holds, each in one spelling.
        stream: the name of its random stream.
    """

    def __init__(
        self,
        plant: Plant,
        aircraft: Aircraft,
        failure: Failure,
        rate_hz: float,
        seed: int,
        stream: str,
        healthy: Callable[[str], float] | None = None,
    ) -> None:
        """A failure that has not started, in a flight with this `seed`.

        `healthy` gives the value of a property before the flight, by default the present one. In flight, another failure may hold
        the property, and the present value is not the one to be restored.
        """
        self.failure, self.active, self.waiting = failure, False, failure.when is not None
        self.actuator = broken_actuator(failure, aircraft)
        self.receipts: list[dict[str, Any]] = []
        self._plant, self._aircraft, self._rate_hz = plant, aircraft, rate_hz
        properties = failure.properties(aircraft)
        self._holds = [self._hold(name, value, healthy) for name, value in properties.items()]
        self.names, self.stream = held_by(failure, aircraft), stream
        self._watch: Watch | None = None
        self._changes: tuple[Hold, Course] | None = None
        if (changing := failure.course(aircraft, generator(seed, stream))) is not None:
            (hold,) = (hold for hold in self._holds if hold.name == changing[0])
            self._changes = hold, changing[1]
        self._delay_steps = failure.delay_steps(rate_hz)
        self._late_commands: deque[float] = deque()
        self._signal: Callable[[int], float] | None = None

    def _hold(self, name: str, value: float | Capture, healthy: Callable[[str], float] | None) -> Hold:
        get = self._plant.getter(name)
        held = self._plant.getter(value.source) if isinstance(value, Capture) else value
        return Hold(name, held, self._plant.setter(name), get, healthy(name) if healthy else get())

    @property
    def started(self) -> bool:
        """Whether it has started, even if it has ended since."""
        return bool(self.receipts)

    def agenda(self) -> Iterator[tuple[int, bool]]:
        """(control step, whether it starts) for its start and for its end, where the scenario gives a time."""
        if self.failure.at_s is not None:
            yield first_step_at(self.failure.at_s, self._rate_hz), True
        if self.failure.until_s is not None:
            yield first_step_at(self.failure.until_s, self._rate_hz), False

    def observe(self, recorded: Recorded) -> None:
        """Take the arrays that the loop fills, if this failure waits for a signal in them."""
        if self.failure.when is not None:
            signal = self.failure.when.signal
            self._signal = reader(self._aircraft, self._rate_hz, recorded, signal)

    def triggered(self, step: int) -> bool:
        """Whether the signal of `when` was beyond its limit in the step before this one."""
        when, signal = self.failure.when, self._signal
        return step > 0 and when is not None and signal is not None and when.met(signal(step - 1))

    @property
    def busy(self) -> bool:
        """Whether it has something to do in each control step: a value to change, or an effect to watch for."""
        watching = self._watch is not None and not self._watch.done
        return self.active and (watching or self._changes is not None)

    @property
    def delays(self) -> bool:
        """Whether it now delays the commands of its actuator."""
        return self.active and self._delay_steps is not None

    def start(self, step: int) -> None:
        """Write the values of its properties, and begin to watch for the effect."""
        self._start, self.active, self.waiting = step, True, False
        for hold in self._holds:
            hold.first = hold.value() if callable(hold.value) else hold.value
            hold.before = hold.get()
        actuator = self._aircraft.actuators[self.actuator] if self.actuator else None
        self._watch = Watch(self._plant, actuator, self._holds)
        for hold in self._holds:
            hold.write(hold.first)
        if self._delay_steps:
            self._late_commands.extend([hold.first for hold in self._holds] * self._delay_steps)
        as_written = all(reads_back(hold.get(), hold.written) for hold in self._holds)
        self._add_receipt(step, active=True, verified=None if as_written else False)

    def look(self) -> None:
        """Look for its effect in the control step that the plant has just made."""
        if self._watch is not None and not self._watch.done:
            self._watch.look()
            self._bring_up_to_date()

    def change(self, step: int) -> None:
        """Write the value of this control step."""
        if self._changes is not None:
            hold, course = self._changes
            hold.write(course((step - self._start) / self._rate_hz, hold.first))

    def delay(self) -> None:
        """Replace the command just given by the one given `delay_steps` control steps ago."""
        (hold,) = self._holds
        hold.before = hold.healthy = hold.get()
        self._late_commands.append(hold.before)
        hold.write(self._late_commands.popleft())

    def end(self, step: int) -> None:
        """Put its properties back as they were before the flight."""
        self.let_go()
        for hold in self._holds:
            hold.put(hold.healthy)
        restored = all(reads_back(hold.get(), hold.healthy) for hold in self._holds)
        self._add_receipt(step, active=False, verified=restored)

    def concluded(self) -> Injection:
        """As it is if the flight ends now, after a step of the plant; this one goes on."""
        last = copy(self)
        last.receipts = [dict(receipt) for receipt in self.receipts]
        last._watch = self._watch and self._watch.copy()
        if last.active:
            last.look()
            last.let_go()
        return last

    def let_go(self) -> None:
        """End without restoring anything: a later failure replaces this one, or the flight is over."""
        self.active = False
        self._late_commands = deque()
        if self._watch is not None:
            self._watch.finish()
            self._bring_up_to_date()

    def _add_receipt(self, step: int, active: bool, verified: bool | None) -> None:
        """Add the receipt of a start or an end."""
        self.receipts.append(
            {
                "time_s": step / self._rate_hz,
                "kind": "injection",
                "failure": -1,  # the injector knows its place
                "type": self.failure.type,
                "actuator": self.actuator,
                "active": active,
                "properties": {hold.name: hold.get() for hold in self._holds},
                "verified": verified,
            }
        )

    def _bring_up_to_date(self) -> None:
        """Update the receipt of the start with what has been seen. If a property did not read back as written, it stays False."""
        start = self.receipts[0]
        if self._watch is not None and start["verified"] is not False:
            start["verified"], start["effect"] = self._watch.verified, self._watch.effect

    def warnings(self, place: int) -> Iterator[str]:
        """One sentence for each thing that did not happen as the scenario asked; `place` is that in the scenario."""
        what = f"{self.failure.type}, {self.actuator}" if self.actuator else self.failure.type
        name, when = f"failures.{place} ({what})", self.failure.when
        if not self.receipts:
            yield f"{name} never started: {f'{when} did not happen' if when else 'the flight ended before'}"
        for receipt in self.receipts:
            text = _NOT_AS_ASKED.get((receipt["active"], receipt["verified"]))
            if receipt["active"] and not stayed(receipt):
                text = "did NOT stay as written: the simulation computes some property of it anew"
            if text:
                yield f"{name} at {receipt['time_s']:g} s {text}"


def broken_actuator(failure: Failure, aircraft: Aircraft) -> str | None:
    """Name of the actuator that a failure breaks: the one that it names, or else the one whose block has all its properties;
    None if there is none."""
    if failure.actuator is not None:
        return failure.actuator
    for name, actuator in aircraft.actuators.items():
        if all(held.startswith(f"{actuator.prefix}/") for held in failure.properties(aircraft)):
            return name
    return None
