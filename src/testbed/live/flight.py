"""A flight that goes on until it is stopped: what is done to it by hand is kept, so that it can be flown again up to any time.

Of it only the last rows take memory: older ones are in files that have no name and go with the process. A file takes the place of
memory at the same address, so nothing that reads the rows notices. What is written there later is this process's own, and no file
is written twice: copies of the process that fly on differently never see each other's rows.
"""

from __future__ import annotations

import contextlib
import ctypes
import mmap
import os
from collections.abc import Callable, Iterator, Sequence
from tempfile import TemporaryFile
from typing import Any, assert_never

import numpy as np

from testbed.common.signals import first_step_at
from testbed.controllers.setup import Setup
from testbed.flight.flight import Flying, Outcome
from testbed.inputs.problems import BadInput, Problem
from testbed.live.messages import Act, Blow, Break, Mend, Order
from testbed.scenario.load import changed
from testbed.scenario.model import Scenario
from testbed.sensors.measurement import ERROR, FAULT, OFFSET, READING, SENSED
from testbed.simulation.conclude import so_far
from testbed.simulation.session import Session

_KEPT_S = 60.0
"""Rows of so much flight stay in memory at most [s]."""
_FOLDER = "/var/tmp"  # /tmp is memory on many systems
_FIXED = 0x10  # MAP_FIXED, which Python does not name
_LIBC = ctypes.CDLL(None, use_errno=True)
_LIBC.mmap.restype = ctypes.c_void_p
_LIBC.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, *3 * [ctypes.c_int], ctypes.c_long]
_LIBC.madvise.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int]


class LongSession(Session):
    """A `Session` that puts its rows away while it flies."""

    def __init__(self, *args: Any) -> None:
        """As `Session`."""
        super().__init__(*args)
        self._away, self._next = 0, 0
        self._known: dict[int, tuple[np.ndarray, object]] = {}
        self._filled: object = None

    def step(self, n: int = 1) -> Outcome | None:
        """As `Session.step`. What `extend` and faults of sensors have filled of later rows is put away soon, too: it takes a few
        hundred megabytes."""
        ended = super().step(n)
        filled = (self.loop.steps, self.parts.scenario.sensors.faults)
        if self.loop.done >= self._next or filled != self._filled:
            self._filled = filled
            self.put_away()
        return ended

    def put_away(self) -> None:
        """Put the rows of all control steps flown into a file. They stay in memory where there can be none."""
        known, done = self._known, self.loop.done
        self._known, self._next = {}, done + int(_KEPT_S * self.parts.scenario.rate_hz)
        try:
            with TemporaryFile(dir=_FOLDER, buffering=0) as file:
                for rows, ahead in self._rows():
                    address = rows.ctypes.data
                    new = address not in known or known[address][1] != ahead
                    _map(rows, 0 if new else self._away, len(rows) if new and ahead else done, file.fileno())
                    self._known[address] = (rows, ahead)
        except OSError:  # a full disk
            self._known = {}
        self._away = done

    def so_far(self) -> Flying:
        """The flight so far, as it is told in words, in a process that is for this alone: what it reads takes no memory."""
        return so_far(
            self.parts, self.scenario, self.ended or Outcome.completed, self.loop.recorded, self._leave
        )

    def _leave(self) -> None:
        """Give back the memory of the rows that are in a file."""
        for rows in self.loop.rows:
            if rows.ctypes.data in self._known:
                low, high = _pages(rows, 0, self._away)
                _LIBC.madvise(low, max(high - low, 0), mmap.MADV_DONTNEED)

    def _rows(self) -> Iterator[tuple[np.ndarray, object]]:
        """Each array [steps, ...] of the flight; and, if its later rows have been filled too, what these depend on."""
        parts, loop = self.parts, self.loop
        yield from ((rows, None) for rows in (loop.rows.truth, loop.rows.measured, parts.weather.wind))
        yield loop.rows.telemetry, loop.steps
        yield loop.rows.references, (loop.steps, len(parts.scenario.commands))
        if parts.sensors is not None:
            drawn = (ERROR, OFFSET, FAULT) if parts.sensors.settings.faults else (ERROR,)
            for layer in (*drawn, SENSED, READING):
                ahead = (loop.steps, parts.sensors.settings.faults if layer != ERROR else ())
                yield parts.sensors.table[layer], ahead if layer in drawn else None


def _map(rows: np.ndarray, first: int, end: int, file: int) -> None:
    """Append the whole pages of these rows to a file, and have it in their place. Raises OSError."""
    low, high = _pages(rows, first, end)
    if high <= low:
        return
    offset = os.lseek(file, 0, os.SEEK_END)
    data = memoryview((ctypes.c_char * (high - low)).from_address(low))
    while data:
        data = data[os.write(file, data) :]
    how = (mmap.PROT_READ | mmap.PROT_WRITE, mmap.MAP_PRIVATE | _FIXED)
    if _LIBC.mmap(low, high - low, *how, file, offset) != low:
        raise OSError(ctypes.get_errno(), "a file cannot be mapped")
    # Pages of two megabytes would be shared with copies of this process, and kept by each.
    _LIBC.madvise(high, rows.ctypes.data + rows.nbytes - high, mmap.MADV_NOHUGEPAGE)


def _pages(rows: np.ndarray, first: int, end: int) -> tuple[int, int]:
    """Addresses of the first whole page of these rows, which may begin with others, and of what follows the last."""
    start, size, page = rows.ctypes.data, rows.strides[0], mmap.PAGESIZE
    return max(-(-start // page), (start + first * size) // page) * page, (start + end * size) // page * page


LONGEST_S = 3600.0
"""Longest flight by hand [s]: its log has to fit into memory."""
_LEAST_S = 120.0
"""What is made longer gets this long at least [s]: rows then have room for an hour, and are not copied again."""
_MOST_GHOSTS = 3
_AT_ONCE = 2000  # control steps between two looks at whether to give up


GoOn = Callable[[], bool]
"""Asked now and then while the past is flown again; if it says no, that is given up."""


class LiveFlight:
    """One flight by hand, and the flights of other controllers beside it.

    Attributes:
        session: the flight as it is now.
        acts: what was done to it, each with the control step in which it begins.
        ghosts: the same flight, with the same done to it, by other controllers; by their types.
        own: how a command names the class of the user's own that flies; None if the scenario's controller does.
    """

    def __init__(
        self, scenario: Scenario, controller: Callable[[Setup], Any] | None = None, own: str | None = None
    ) -> None:
        """Raises BadInput as `Session`."""
        self._scenario, self._controller, self.own = scenario, controller, own
        self.acts: list[tuple[int, Act]] = []
        self.session = self._begun()
        self.ghosts: dict[str, LongSession] = {}

    def _begun(self, ghost: str | None = None) -> LongSession:
        """A new flight of which there is something to see; by the controller of a ghost, if one is named."""
        own = ghost is None
        scenario = self._scenario if own else changed(self._scenario, {"controller": {"type": ghost}})
        session = LongSession(scenario, self._controller if own else None)
        session.step()
        return session

    @property
    def rate_hz(self) -> int:
        """Control steps in a second."""
        return self._scenario.rate_hz

    def fly(self, steps: int) -> None:
        """Fly this many control steps, if the flight goes on. A ghost that cannot go on stays where it is."""
        if self.session.ended is not None or steps <= 0:
            return
        _fly(self.session, self.session.loop.done + steps, self.rate_hz)
        for ghost in self.ghosts.values():
            if ghost.ended is None and ghost.loop.stopped_by is None:
                with contextlib.suppress(Exception):
                    _fly(ghost, self.session.loop.done, self.rate_hz)

    def do(self, act: Act) -> None:
        """Do something to the flight, from the next control step on; raises BadInput, and then nothing has changed."""
        _carry_out(self.session, act)
        self.acts.append((self.session.loop.done, act))
        for session in self.ghosts.values():
            with contextlib.suppress(BadInput):  # a ghost that is lost
                _carry_out(session, act)

    def accompany(self, controllers: Sequence[str], go_on: GoOn = lambda: True) -> None:
        """Fly these types of controllers beside the flight, and no others: each flies its past first; raises BadInput."""
        if len(set(controllers)) > _MOST_GHOSTS:
            raise BadInput([Problem(f"are {len(controllers)}", "ghosts", expected=f"at most {_MOST_GHOSTS}")])
        done = self.session.loop.done
        made = {name: self._begun(name) for name in controllers if name not in self.ghosts}
        for session in made.values():
            self._fly_past(session, self.acts, done, go_on)
        for name in self.ghosts.keys() - set(controllers):
            self.ghosts.pop(name).close()
        self.ghosts |= made

    def step_at(self, time_s: float) -> int:
        """The control step up to which has been flown, once the flight has gone back to a time [s]."""
        return min(max(first_step_at(min(time_s, LONGEST_S), self.rate_hz), 1), self.session.loop.done)

    def rewind(self, time_s: float, go_on: GoOn = lambda: True) -> None:
        """Go back: fly again from the beginning, with what was done by hand before that time. If given up, all stays as it was."""
        again = LiveFlight(self._scenario, self._controller, self.own)
        again.fly_again(self.acts, self.step_at(time_s), list(self.ghosts), go_on)
        if go_on():
            self.session, again.session = again.session, self.session
            self.ghosts, again.ghosts = again.ghosts, self.ghosts
            self.acts = again.acts
        again.close()

    def fly_again(
        self, acts: Sequence[tuple[int, Act]], until: int, ghosts: Sequence[str], go_on: GoOn = lambda: True
    ) -> None:
        """Fly on up to a control step as before, where this flight's acts are the first of those that were done by hand, with these
        ghosts beside it."""
        more = [(step, act) for step, act in acts[len(self.acts) :] if step < until]
        for session in self._all:
            self._fly_past(session, more, until, go_on)
        self.acts += more
        self.accompany(ghosts, go_on)

    @property
    def can_be_copied(self) -> bool:
        """Whether a fork of this process flies on by itself: no controller holds anything outside, such as a process of its own."""
        return not any(getattr(each.parts.controller, "outside", False) for each in self._all)

    @property
    def _all(self) -> tuple[LongSession, ...]:
        return (self.session, *self.ghosts.values())

    def _fly_past(self, session: Session, acts: Sequence[tuple[int, Act]], until: int, go_on: GoOn) -> None:
        """Fly a new flight up to a control step, and do on the way what was done."""
        for step, act in acts:
            _fly_far(session, step, self.rate_hz, go_on)
            with contextlib.suppress(BadInput):  # to a flight that goes on, but too late for a ghost
                _carry_out(session, act)
        _fly_far(session, until, self.rate_hz, go_on)

    def put_away(self) -> None:
        """Free the memory of all rows flown: a copy that is frozen now need not have them."""
        for session in self._all:
            session.put_away()

    def close(self) -> None:
        """Free the simulators."""
        for session in self._all:
            session.close()


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


def _fly_far(session: Session, until: int, rate_hz: int, go_on: GoOn) -> None:
    while session.loop.done < until and session.ended is None and go_on():
        _fly(session, min(until, session.loop.done + _AT_ONCE), rate_hz)


def _fly(session: Session, until: int, rate_hz: int) -> None:
    """Fly up to a control step; a flight that would end because it was planned to is made longer before."""
    most = int(LONGEST_S * rate_hz)
    while until >= session.loop.steps < most:
        longer = max(2 * session.loop.steps, int(_LEAST_S * rate_hz))
        session.extend(min(longer, most) / rate_hz)
    if (steps := min(until, session.loop.steps) - session.loop.done) > 0:
        session.step(steps)
