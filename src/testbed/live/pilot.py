"""The thread that flies: it keeps the time, does what is asked, and tells what comes of it. Nothing else touches the flight."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from time import monotonic
from typing import Any

from testbed.inputs.problems import BadInput, Problem
from testbed.live import frames
from testbed.live.choices import Choices
from testbed.live.flight import LONGEST_S, LiveFlight
from testbed.live.messages import Choose, Ghosts, Pause, Restart, Rewind, Save, Speed
from testbed.reporting.flight import ReportedFlight
from testbed.simulation.session import Session

FRAME_S = 1.0 / 60.0
_MOST_BEHIND_S = 0.25  # what a slow machine has not flown in this time is not caught up with
_STORY_S, _STORY_SHARE = 2.0, 0.04  # the story is told this often, and takes no more of the time than this
_IDLE_S = 0.2

Tell = Callable[[bytes | dict[str, Any]], object]
"""Takes a frame, or a note in words, for all pages; called in the pilot's thread or in that which saves."""
Keep = Callable[[ReportedFlight, str | None], tuple[Path, str]]
"""Writes the run folder of a flight, given its `own` controller; returns it, and the command that flies it again."""


class Pilot(threading.Thread):
    """Flies a `LiveFlight` while somebody looks.

    Attributes:
        watched: whether a page is there; while none is, time stands still.
        facts: what a page has to know of the flight.
        last_saved: the run folder that was written last; None if none was.
    """

    def __init__(self, choices: Choices, tell: Tell, keep: Keep) -> None:
        """Raises BadInput if the first of the choices cannot be flown."""
        super().__init__(name="pilot", daemon=True)
        self._choices, self.tell, self._keep = choices, tell, keep
        self._take_off(choices.first())
        self.watched = False
        self.last_saved: Path | None = None
        self._paused, self._times = False, 1.0
        self._stopping = False
        self._inbox: queue.SimpleQueue[tuple[Any, Future[None]] | None] = queue.SimpleQueue()
        self._saver = ThreadPoolExecutor(1, "saver")
        self._saved: list[dict[str, str]] = []
        self._state: dict[str, Any] = {}

    def _take_off(self, flight: LiveFlight) -> None:
        self.flight, self._error = flight, ""
        self.facts = {**frames.facts(flight.session), "choices": self._choices.names}
        self._told: dict[str, Any] = {"story": [], "events": []}
        self._next_story_s = 0.0

    def ask(self, message: Any) -> Future[None]:
        """Have a message carried out; the result has BadInput if it cannot be."""
        answer: Future[None] = Future()
        self._inbox.put((message, answer))
        return answer

    @property
    def state(self) -> dict[str, Any]:
        """The last note of how things are, for a page that has just come."""
        return {"note": "state", **self._state, **self._told}

    def look(self, watched: bool) -> None:
        """Say whether a page is there."""
        self.watched = watched
        self._inbox.put(None)

    def end(self) -> None:
        """Stop flying. What is being saved is finished first."""
        self._stopping = True
        self._inbox.put(None)
        self.join()
        self._saver.shutdown()
        self.flight.close()

    def run(self) -> None:
        last, owed_s = monotonic(), 0.0
        due = last
        while not self._stopping:
            flying = self.watched and not self._paused and not self._over
            wait_s = max(due - monotonic(), 0.0) if flying else _IDLE_S
            if self._take(wait_s):
                continue
            now = monotonic()
            due = max(due, now - FRAME_S) + FRAME_S  # a late frame does not make the next ones later
            if flying:
                owed_s = min(owed_s + now - last, _MOST_BEHIND_S)
                owed_s -= self._advance(owed_s)
            last = now
            self._publish(flying, now)

    @property
    def _over(self) -> bool:
        return bool(self._error) or self.flight.session.ended is not None

    def _take(self, wait_s: float) -> bool:
        """Carry out the next message, if one comes within this time; returns whether one came."""
        try:
            item = self._inbox.get(timeout=wait_s) if wait_s > 0.0 else self._inbox.get_nowait()
        except queue.Empty:
            return False
        if item is not None:
            message, answer = item
            try:
                self._do(message)
            except Exception as error:
                answer.set_exception(error)
            else:
                answer.set_result(None)
        self._publish(
            True, monotonic()
        )  # a page that has just come sees something, too, while time stands still
        return item is not None

    def _do(self, message: Any) -> None:
        match message:
            case Pause():
                self._paused = message.on
                self._next_story_s = 0.0
            case Speed():
                self._times = message.times
            case Save():
                self._save()
            case Rewind() | Restart():
                self._rewind(message.time_s if isinstance(message, Rewind) else 0.0)
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

    def _rewind(self, time_s: float) -> None:
        self.flight.rewind(time_s, self._goes_on)
        self._error, self._next_story_s = "", 0.0

    def _goes_on(self) -> bool:
        return not self._stopping

    def _choose(self, choice: Choose) -> None:
        """Fly something else. Pages load again: they show another aircraft then."""
        flight = self._choices.flight(choice.flight, choice.controller)
        self.flight.close()
        self._take_off(flight)
        self._paused = False
        self.tell({"note": "other"})

    def _advance(self, owed_s: float) -> float:
        """Fly what is owed [s of this machine's time]; returns how much of it whole control steps were."""
        per_s = self._times * self.flight.rate_hz
        steps = int(owed_s * per_s)
        try:
            self.flight.fly(steps)
        except Exception as error:  # of JSBSim, or of a controller of the user's; the past can be flown again
            self._error = f"the flight cannot go on: {str(error) or type(error).__name__}"
        return steps / per_s

    def _save(self) -> None:
        flight = self.flight.session.flight()
        self._saver.submit(self._write, flight, self.flight.own)

    def _write(self, flight: ReportedFlight, own: str | None) -> None:
        try:
            folder, command = self._keep(flight, own)
        except Exception as error:  # a full disk must not end the flight
            self.tell({"note": "not saved", "why": str(error) or type(error).__name__})
            return
        self.last_saved = folder
        self._saved.append({"folder": str(folder), "command": command})
        self.tell({"note": "saved", "folder": str(folder), "command": command, "time_s": flight.end_time_s})

    def _publish(self, flew: bool, now: float) -> None:
        session = self.flight.session
        state = {
            "paused": self._paused,
            "speed": self._times,
            "ended": self._ending(),
            "broken": frames.broken(session),
            "ghosts": {name: _outcome(ghost) for name, ghost in self.flight.ghosts.items()},
            "saved": self._saved[-5:],
        }
        if state != self._state:
            self._state, self._next_story_s = state, min(self._next_story_s, now + FRAME_S)
            self.tell({"note": "state", **state})
        if flew:  # after the state, which says whose rows a frame has
            self.tell(frames.frame(session, *self.flight.ghosts.values()))
        if now >= self._next_story_s:
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
        try:
            told = frames.told(self.flight.session.flight())
        except BadInput as error:
            told = {**self._told, "story": [str(error)]}
        took_s = monotonic() - now
        self._next_story_s = now + max(_STORY_S, took_s / _STORY_SHARE)
        if told != self._told:
            self._told = told
            self.tell({"note": "story", **told})


def _outcome(session: Session) -> str:
    """How a flight ended; empty while it goes on."""
    if session.loop.stopped_by is not None:
        return f"cannot go on, {session.time_s:.1f} s"
    return "" if session.ended is None else f"{session.ended.sentence}, {session.time_s:.1f} s"
