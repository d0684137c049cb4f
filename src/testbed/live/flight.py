"""A flight that goes on until it is stopped: what is done to it by hand is kept, so that it can be flown again up to any time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, assert_never

from testbed.common.signals import first_step_at
from testbed.controllers.setup import Setup
from testbed.live.messages import Act, Blow, Break, Mend, Order
from testbed.scenario.model import Scenario
from testbed.simulation.session import Session

LONGEST_S = 3600.0
"""Longest flight by hand [s]: its log has to fit into memory."""
_AT_ONCE = 2000  # control steps between two looks at whether to give up


class LiveFlight:
    """One flight by hand.

    Attributes:
        session: the flight as it is now.
        acts: what was done to it, each with the control step in which it begins.
    """

    def __init__(self, scenario: Scenario, controller: Callable[[Setup], Any] | None = None) -> None:
        """Raises BadInput as `Session`."""
        self._scenario, self._controller = scenario, controller
        self.acts: list[tuple[int, Act]] = []
        self.session = self._begun()

    def _begun(self) -> Session:
        """A new flight of which there is something to see."""
        session = Session(self._scenario, self._controller)
        session.step()
        return session

    @property
    def rate_hz(self) -> int:
        """Control steps in a second."""
        return self._scenario.rate_hz

    def fly(self, steps: int) -> None:
        """Fly this many control steps, if the flight goes on."""
        if self.session.ended is None and steps > 0:
            _fly(self.session, self.session.loop.done + steps, self.rate_hz)

    def do(self, act: Act) -> None:
        """Do something to the flight, from the next control step on; raises BadInput, and then nothing has changed."""
        _carry_out(self.session, act)
        self.acts.append((self.session.loop.done, act))

    def rewind(self, time_s: float, go_on: Callable[[], bool] = lambda: True) -> None:
        """Go back: fly again from the beginning, with what was done by hand before that time.

        Args:
            go_on: asked now and then; if it says no, everything stays as it was.
        """
        until = min(max(first_step_at(time_s, self.rate_hz), 1), self.session.loop.done)
        acts = [(step, act) for step, act in self.acts if step < until]
        session = self._begun()
        for step, act in acts:
            _fly_far(session, step, self.rate_hz, go_on)
            _carry_out(session, act)
        _fly_far(session, until, self.rate_hz, go_on)
        if go_on():
            session, self.session, self.acts = self.session, session, acts
        session.close()

    def close(self) -> None:
        """Free the simulator."""
        self.session.close()


def _carry_out(session: Session, act: Act) -> None:
    match act:
        case Break():
            session.inject(act.failure)
        case Mend():
            session.mend(act.actuator)
        case Order():
            session.order(act.command)
        case Blow():
            session.blow(act.air)
        case _:
            assert_never(act)


def _fly_far(session: Session, until: int, rate_hz: int, go_on: Callable[[], bool]) -> None:
    while session.loop.done < until and session.ended is None and go_on():
        _fly(session, min(until, session.loop.done + _AT_ONCE), rate_hz)


def _fly(session: Session, until: int, rate_hz: int) -> None:
    """Fly up to a control step; a flight that would end because it was planned to is made longer before."""
    most = int(LONGEST_S * rate_hz)
    while until >= session.loop.steps < most:
        session.extend(min(2 * session.loop.steps, most) / rate_hz)
    if (steps := min(until, session.loop.steps) - session.loop.done) > 0:
        session.step(steps)
