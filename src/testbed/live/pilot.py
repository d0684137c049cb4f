"""The process that flies: it keeps the time, does what is asked, and tells what comes of it. Nothing else touches the flight."""

from __future__ import annotations

import contextlib
import gc
import traceback
from collections.abc import Callable
from pathlib import Path
from time import monotonic
from typing import Any

from testbed.inputs.problems import BadInput, Problem
from testbed.live import messages
from testbed.live.aloft import Copies, Line
from testbed.live.choices import Choices
from testbed.live.flight import LONGEST_S, LiveFlight
from testbed.live.messages import Choose, Ghosts, Pause, Restart, Rewind, Save, Speed
from testbed.reporting.flight import ReportedFlight
from testbed.simulation.session import Session

FRAME_S = 1.0 / 60.0
_MOST_BEHIND_S = 0.25  # what a slow machine has not flown in this time is not caught up with
_STORY_S, _STORY_SHARE = 2.0, 0.04  # the story is told this often, and takes no more of the time than this
_IDLE_S = 0.2
_ANSWER_S = 0.1
"""Time in which a page draws what has changed, before a copy that tells the story takes a core."""
_FROZEN_S = 80.0
"""A copy is frozen at the start and this often [s of flight]: to go back takes less than two seconds."""

Keep = Callable[[ReportedFlight, str | None], tuple[Path, str]]
"""Writes the run folder of a flight, given its `own` controller; returns it, and the command that flies it again."""


class Pilot:
    """Flies a `LiveFlight` while somebody looks.

    It hears ("look", whether a page is there; while none is, time stands still) and ("ask", number, message). It says
    ("facts", what a page has to know of the flight), ("tell", a frame, or a note in words, for all pages),
    ("answer", number, the exception, or None if it was done) and ("saved", folder, note).
    """

    def __init__(self, choices: Choices, line: Line, keep: Keep) -> None:
        """Raises BadInput if the first of the choices cannot be flown."""
        self._choices, self._line, self._keep = choices, line, keep
        self._copies = Copies()
        self._watched, self._paused, self._times = False, False, 1.0
        self._take_off(choices.flight(**choices.given), choices.given)

    def _take_off(self, flight: LiveFlight, chosen: dict[str, str]) -> None:
        self.flight = flight
        choices = {"choices": self._choices.names, "chosen": chosen}
        self._line.say(("facts", messages.facts(flight.session) | choices))
        self._begin_to_tell()

    def _begin_to_tell(self) -> None:
        """Nothing has been told of this flight."""
        self._error, self._next_story_s = "", 0.0
        self._state: dict[str, Any] = {}
        self._told: dict[str, Any] = {"story": [], "events": []}
        self._teller: Line | None = None

    def tell(self, what: bytes | dict[str, Any]) -> None:
        """Send a frame or a note to all pages."""
        self._line.say(("tell", what))

    def run(self) -> None:
        """Fly until nobody can ask for anything any more."""
        gc.freeze()  # collecting touches what it looks at, and a touched page is no longer shared with the copies
        with contextlib.suppress(EOFError):
            self._run()
        self.flight.close()

    def _run(self) -> None:
        last, owed_s = monotonic(), 0.0
        due = last
        while True:
            flying = self._watched and not self._paused and not self._over
            wait_s = max(due - monotonic(), 0.0) if flying else _IDLE_S
            if self._take(wait_s):
                # what was done is seen once one step has been flown
                due = min(due, last + self._step_s - owed_s)
                continue
            now = monotonic()
            due = max(due, now - FRAME_S) + FRAME_S  # a late frame does not make the next ones later
            if flying:
                owed_s = min(owed_s + now - last, _MOST_BEHIND_S)
                owed_s -= self._advance(owed_s)
            last = now
            self._publish(flying, now)
            if self._freeze():
                last, owed_s = monotonic(), 0.0

    @property
    def _step_s(self) -> float:
        """How long a control step takes [s of this machine's time]."""
        return 1.0 / (self._times * self.flight.rate_hz)

    @property
    def _over(self) -> bool:
        return bool(self._error) or self.flight.session.ended is not None

    def _take(self, wait_s: float) -> bool:
        """Carry out the next message, if one comes within this time; returns whether one came. Raises EOFError after the last."""
        match self._line.hear(wait_s):
            case None:
                return False
            case ("look", watched):
                self._watched = watched
            case (_, number, message):
                self._answer(number, lambda: self._do(number, message))
        # A page that has just come sees something, too, while time stands still.
        self._publish(True, monotonic())
        return True

    def _answer(self, number: int, act: Callable[[], object]) -> None:
        """Do what was asked, and say how it went."""
        error: Exception | None = None
        try:
            act()
        except BadInput as problem:
            error = problem
        except Exception as defect:
            traceback.print_exc()
            error = BadInput([Problem(f"a defect of testbed: {type(defect).__name__}")])
        self._line.say(("answer", number, error))

    def _do(self, number: int, message: Any) -> None:
        match message:
            case Pause():
                self._paused = message.on
                self._next_story_s = 0.0
            case Speed():
                self._times = message.times
            case Save():
                self._copies.begin(self._write)
            case Rewind() | Restart():
                self._rewind(number, message.time_s if isinstance(message, Rewind) else 0.0)
            case Ghosts():
                self.flight.accompany(message.controllers, self._goes_on)
            case Choose():
                self._choose(message)
            case act:
                self._refuse_over()
                self.flight.do(act)

    def _refuse_over(self) -> None:
        if self._over:
            what = self._error or "the flight is over"
            raise BadInput([Problem(what, expected="going back to an earlier time, or starting again")])

    # Going back -----------------------------------------------------------------------------------------------

    def _rewind(self, number: int, time_s: float) -> None:
        """Go back. Where a frozen copy can, it goes on in place of this process, and gives the answer."""
        flight, step = self.flight, self.flight.step_at(time_s)
        ghosts, asked = list(flight.ghosts), (self._watched, self._paused, self._times)
        self._copies.wake(step, (number, step, flight.acts, ghosts, asked))
        flight.rewind(time_s, self._goes_on)
        self._error, self._next_story_s = "", 0.0

    def _freeze(self) -> bool:
        """Freeze a copy, if it is time for one; returns whether this is a copy that has been woken."""
        done = self.flight.session.loop.done
        if done < self._copies.last + _FROZEN_S * self.flight.rate_hz or not self.flight.can_be_copied:
            return False
        self.flight.put_away()
        try:
            woken = self._copies.freeze(done)
        except OSError:  # no memory is left for one: going back takes longer
            return False
        if woken is None:
            return False
        number, step, acts, ghosts, (self._watched, self._paused, self._times) = woken
        self._begin_to_tell()
        self._answer(number, lambda: self.flight.fly_again(acts, step, ghosts, self._goes_on))
        self._publish(True, monotonic())
        return True

    def _goes_on(self) -> bool:
        return not self._line.gone

    # Other things that are asked ------------------------------------------------------------------------------

    def _choose(self, choice: Choose) -> None:
        """Fly something else. Pages load again: they show another aircraft then."""
        chosen = choice.model_dump(include=set(self._choices.given))
        flight = self._choices.flight(**chosen)
        self.flight.close()
        self._copies.drop()
        self._take_off(flight, chosen)
        self._paused = False
        self.tell({"note": "other"})

    def _advance(self, owed_s: float) -> float:
        """Fly what is owed [s of this machine's time]; returns how much of it whole control steps were."""
        steps = int(owed_s / self._step_s)
        try:
            self.flight.fly(steps)
        except Exception as error:  # of JSBSim, or of a controller of the user's; the past can be flown again
            self._error = f"the flight cannot go on: {str(error) or type(error).__name__}"
        return steps * self._step_s

    def _write(self) -> None:
        """Write the run folder, in a copy: the flight goes on meanwhile, and what is being saved is finished after its end, too."""
        try:
            flight = self.flight.session.flight()
            folder, command = self._keep(flight, self.flight.own)
        except Exception as error:  # a full disk must not end the flight
            self.tell({"note": "not saved", "why": str(error) or type(error).__name__})
            return
        note = {"note": "saved", "folder": str(folder), "command": command, "time_s": flight.end_time_s}
        self._line.say(("saved", folder, note))

    # What pages are told --------------------------------------------------------------------------------------

    def _publish(self, flew: bool, now: float) -> None:
        session = self.flight.session
        state = {
            "paused": self._paused,
            "speed": self._times,
            "ended": self._ending(),
            "broken": messages.broken(session),
            "ghosts": {name: _outcome(ghost) for name, ghost in self.flight.ghosts.items()},
        }
        if state != self._state:
            self._state, self._next_story_s = state, min(self._next_story_s, now + _ANSWER_S)
            self.tell({"note": "state", **state})
        if flew:  # after the state, which says whose rows a frame has
            self.tell(messages.frame(session, *self.flight.ghosts.values()))
        self._tell_story(now)

    def _ending(self) -> str:
        """Why it does not go on; empty while it does."""
        session = self.flight.session
        if self._error or session.ended is None:
            return self._error
        if session.time_s >= LONGEST_S:
            return "an hour has been flown, which is as long as a flight by hand can be"
        return f"the aircraft {_outcome(session)}"

    def _tell_story(self, now: float) -> None:
        """Tell the story when it is time for it. A copy makes it, since that of an hour takes longer than a frame."""
        if self._teller is None and now >= self._next_story_s:
            self._teller, end = Line.pair()
            with contextlib.suppress(OSError):
                self._copies.begin(lambda: end.say(self._story()))
            end.close()
        if (teller := self._teller) is None:
            return
        told, took_s = self._told, 0.0
        with contextlib.suppress(EOFError):  # of a copy that could not be made
            if (said := teller.hear(0.0)) is None:
                return
            told, took_s = said
        teller.close()
        self._teller, self._next_story_s = None, now + max(_STORY_S, took_s / _STORY_SHARE)
        if told != self._told:
            self._told = told
            self.tell({"note": "story", **told})

    def _story(self) -> tuple[dict[str, Any], float]:
        """What is told, and how long that took [s]."""
        begun_s = monotonic()
        try:
            told = messages.told(self.flight.session.so_far())
        except BadInput as error:
            told = {**self._told, "story": [str(error)]}
        return told, monotonic() - begun_s


def _outcome(session: Session) -> str:
    """How a flight ended; empty while it goes on."""
    if session.loop.stopped_by is not None:
        return f"cannot go on, {session.time_s:.1f} s"
    return "" if session.ended is None else f"{session.ended.sentence}, {session.time_s:.1f} s"
