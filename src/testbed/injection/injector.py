"""Start and end the failures of a scenario when they are due, with receipts; `injection` writes to the plant. What is broken or
mended in flight changes the plan: a failure replaces what it would overlap.

`Truth` says of them what an ideal diagnosis would find, to the controller `informed_inversion` alone. No other controller sees the
plant or the failures.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from testbed.aircraft.description import Aircraft
from testbed.common.signals import STATE, begins_within
from testbed.controllers.setup import ActuatorTruth
from testbed.failures import Failure, held_by, meet, stream_names, windows
from testbed.flight.columns import Recorded
from testbed.injection.injection import Injection
from testbed.inputs.problems import BadInput, Problem
from testbed.plant.jsbsim import Plant


class Planned(NamedTuple):
    """A failure of a flight, and what applies it; None for one that is new to the flight."""

    failure: Failure
    injection: Injection | None = None


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
        self._plant, self._aircraft, self._rate_hz, self._seed = plant, aircraft, rate_hz, seed
        self._recorded: Recorded | None = None
        self.filters: list[Callable[[], None]] = []
        self.plan([Planned(failure) for failure in failures], 0)

    def plan(self, plan: Sequence[Planned], step: int, healthy: Callable[[str], float] | None = None) -> None:
        """Take these failures, from control step `step` on.

        Args:
            plan: new failures, and those so far, which may differ in `until_s`.
            healthy: value of a property before the flight, by its name; by default the present value.
        """
        streams = stream_names([each.failure for each in plan])
        self._injections = [
            self._made(each, stream, healthy) for each, stream in zip(plan, streams, strict=True)
        ]
        agenda = (
            (at, starts, each) for each in self._injections for at, starts in each.agenda() if at >= step
        )
        # At one step ends come before starts, so that windows may touch.
        self._agenda = deque(sorted(agenda, key=lambda entry: entry[:2]))
        self._plan(step - 1)

    def _made(self, planned: Planned, stream: str, healthy: Callable[[str], float] | None) -> Injection:
        """The injection of a failure: the one so far, unless it has not started and is to draw other random numbers."""
        so_far = planned.injection
        if so_far is not None and (so_far.started or so_far.stream == stream):
            so_far.failure = planned.failure
            return so_far
        made = Injection(
            self._plant, self._aircraft, planned.failure, self._rate_hz, self._seed, stream, healthy
        )
        made.waiting = so_far.waiting if so_far is not None else made.waiting
        if self._recorded is not None:
            made.observe(self._recorded)
        return made

    @property
    def planned(self) -> list[Planned]:
        """The failures of this flight, and what applies each."""
        return [Planned(each.failure, each) for each in self._injections]

    @property
    def failures(self) -> tuple[Failure, ...]:
        return tuple(each.failure for each in self._injections)

    @property
    def receipts(self) -> list[dict[str, Any]]:
        """A receipt for each start and each end, in order of time; at the same time, ends come first.

        Each is {time_s, kind, failure (its place in the scenario), type, actuator (None if it breaks none), active (true for a
        start), properties, verified}. That of a start also has `effect` (see `testbed.injection.receipt`). `verified` is None if
        there was no effect to see.
        """
        return _in_order(self._injections)

    @property
    def active(self) -> Iterator[Injection]:
        """The failures that have started and not ended."""
        return (injection for injection in self._injections if injection.active)

    def observe(self, recorded: Recorded) -> None:
        """Give failures with `when` the arrays that the loop fills. They read the row of the step before, which is complete."""
        self._recorded = recorded
        for injection in self._injections:
            injection.observe(recorded)

    def apply(self, step: int) -> None:
        """Check the effects in the last step, start and end the failures that are due, and write the values that change."""
        for injection in self._busy:
            injection.look()
        while self._agenda and self._agenda[0][0] <= step:
            self._carry_out(step, *self._agenda.popleft()[1:])
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
            if other.active and not other.names.isdisjoint(
                injection.names
            ):  # the one that starts replaces it
                other.let_go()
        injection.start(step)

    def _plan(self, step: int) -> None:
        """Set `next_step`: the next control step while a failure changes, is watched or waits, else the next start or end."""
        self._busy = [injection for injection in self._injections if injection.busy]
        waiting = any(injection.waiting for injection in self._injections)
        timed = self._agenda[0][0] if self._agenda else math.inf
        self.next_step = step + 1 if self._busy or waiting else timed
        self.filters[:] = [injection.delay for injection in self._injections if injection.delays]

    def concluded(self, steps: int) -> tuple[list[dict[str, Any]], list[str]]:
        """The receipts as they are if the flight ends now, and a warning for each failure that did not act as asked.

        Failures that begin after the flight's control `steps` are left out.
        """
        last = [
            injection.concluded()
            for injection in self._injections
            if begins_within(injection.failure.at_s, self._rate_hz, steps)
        ]
        return _in_order(last), [text for i, each in enumerate(last) for text in each.warnings(i)]


def _in_order(injections: Sequence[Injection]) -> list[dict[str, Any]]:
    receipts = [{**receipt, "failure": i} for i, each in enumerate(injections) for receipt in each.receipts]
    return sorted(receipts, key=lambda receipt: (receipt["time_s"], receipt["active"]))


class Truth:
    """Called in a control step, after the plant has been sampled, it returns what is true in that step."""

    def __init__(self, plant: Plant, injector: Injector) -> None:
        self._plant, self._injector = plant, injector
        self._names = tuple(plant.aircraft.actuators)
        servo = [actuator.kind == "servo" for actuator in plant.aircraft.actuators.values()]
        self._unit = np.where(servo, math.radians(1.0), 1.0)

    def __call__(self) -> ActuatorTruth:
        n = len(self._names)
        row = (self._plant.raw * self._plant.factors)[len(STATE) :]
        deaf = {each.actuator for each in self._injector.active if not each.failure.follows_command}
        return ActuatorTruth(
            effectiveness=row[n:].tolist(),
            follows=[name not in deaf for name in self._names],
            position=(row[:n] * self._unit).tolist(),
        )


def with_failure(planned: Sequence[Planned], failure: Failure, aircraft: Aircraft) -> list[Planned]:
    """The plan with one more failure.

    A failure that holds one of the new one's properties ends when the new one starts. One of the same type that holds no other
    property is replaced by it. If another is planned to hold one of them later, the new one ends then.

    Raises:
        BadInput: what it would end cannot be undone; it starts at no stated time or ends after another one is planned, and they
            hold the same property.
    """
    failure = _until_the_next(planned, failure, aircraft)
    if failure.at_s is None:
        return [*planned, Planned(failure)]
    names = held_by(failure, aircraft)
    # What would start at the same instant has been overtaken before it began.
    others = [
        one
        for one in planned
        if one.failure.at_s != failure.at_s or not names & held_by(one.failure, aircraft)
    ]
    made = list[Planned]()
    for one, (its, window, meets) in zip(others, _beside(others, failure, aircraft), strict=True):
        # One of its type that holds more would be replaced, and leave something broken that nothing mends.
        left = one.failure.until_s is None and window[1] == failure.at_s and not its <= names
        made += _ended(one, failure.at_s) if its & names and (left or meets) else [one]
    return _renumbered([*made, Planned(failure)])


def mended(planned: Sequence[Planned], actuator: str, time_s: float) -> list[Planned]:
    """The plan in which everything that has broken this actuator ends now.

    Raises:
        BadInput: it has no failure now, or one that cannot be undone.
    """
    broken = [one for one in planned if _breaks(one, actuator, time_s)]
    if not broken:
        others = sorted(
            {str(one.injection.actuator) for one in planned if one.injection and one.injection.active}
        )
        what = f"{actuator} has no failure now"
        raise BadInput([Problem(what, "mend", expected=f"one of {', '.join(others)}" if others else "")])
    made = [new for one in planned for new in (_ended(one, time_s) if one in broken else [one])]
    return _renumbered(made)


def _breaks(one: Planned, actuator: str, time_s: float) -> bool:
    """Whether a failure breaks an actuator now, or is just about to."""
    injection = one.injection
    if injection is None or injection.actuator != actuator:
        return False
    return injection.active or (not injection.started and one.failure.at_s == time_s)


def _ended(one: Planned, at_s: float) -> list[Planned]:
    """The failure with its end at this time; none if it would not have begun by then. Raises BadInput."""
    started = one.injection is not None and one.injection.started
    if not one.failure.undone and started:
        what = f"{one.failure.type} of {one.failure.actuator} cannot be undone"
        raise BadInput([Problem(what, path="failure", expected="a failure of another actuator")])
    if one.failure.window_s[0] >= at_s or not one.failure.undone:
        return []
    return [one._replace(failure=one.failure.model_copy(update={"until_s": at_s}))]


def _until_the_next(planned: Sequence[Planned], failure: Failure, aircraft: Aircraft) -> Failure:
    """The failure, with an end where another is planned to hold a property of it later."""
    names, start_s = held_by(failure, aircraft), failure.window_s[0]
    later = [
        window[0]
        for its, window, meets in _beside(planned, failure, aircraft)
        if its & names and meets and (window[0] > start_s or failure.at_s is None)
    ]
    if not later:
        return failure
    if failure.at_s is None or failure.until_s is not None or not failure.undone:
        what = "holds a property that another failure of this flight holds in the same time"
        raise BadInput([Problem(what, "inject", path="failure", expected="at_s, and an end before it")])
    return failure.model_copy(update={"until_s": min(later)})


def _beside(
    planned: Sequence[Planned], failure: Failure, aircraft: Aircraft
) -> Iterator[tuple[frozenset[str], tuple[float, float], bool]]:
    """Of each that is planned: the properties that it holds, when it holds them [s], and whether the failure does so meanwhile."""
    each = [*(one.failure for one in planned), failure]
    held = [held_by(one, aircraft) for one in each]
    lasting = windows(each, held)
    return (
        (its, window, meet(window, lasting[-1])) for its, window in zip(held[:-1], lasting[:-1], strict=True)
    )


def _renumbered(plan: list[Planned]) -> list[Planned]:
    """The plan, or BadInput if one that has started would have drawn other random numbers."""
    for one, stream in zip(plan, stream_names([one.failure for one in plan]), strict=True):
        if one.injection and one.injection.started and one.failure.draws and one.injection.stream != stream:
            what = f"the random numbers of {one.failure.type} at {one.failure.at_s:g} s depend on one that would go"
            raise BadInput([Problem(what, path="failures")])
    return plan
