"""The pilot's process as the server sees it."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import Future
from itertools import count
from pathlib import Path
from typing import Any, NoReturn

from testbed.inputs.problems import BadInput, Problem
from testbed.live.copies import Line, done_in
from testbed.live.pilot import Pilot

Tell = Callable[[bytes | dict[str, Any]], object]
"""Takes a frame, or a note in words, for all pages; called in a thread of its own."""

_GONE = "the process that flew has ended: start testbed live again"


class Aloft:
    """A `Pilot` in a process of its own, which nothing of the server can hold up, and which can be forked (see `copies`).

    Attributes:
        facts: what a page has to know of the flight.
        last_saved: the run folder that was written last; None if none was.
    """

    _tell: Tell

    def __init__(self, pilot: Callable[[Line], Pilot]) -> None:
        """`pilot` is called in the new process. Raises BadInput if it does."""
        self._line, theirs = Line.pair()
        self._child = os.fork()
        if not self._child:
            self._line.close()
            _fly(theirs, pilot)
        theirs.close()
        kind, said = self._line.hear()
        if kind == "refused":
            self._reap()
            raise said
        self.facts: dict[str, Any] = said
        self.last_saved: Path | None = None
        self._state: dict[str, Any] = {}
        self._asked: dict[int, Future[None]] = {}
        self._numbers, self._ended, self._gone = count(), False, False
        self._thread = threading.Thread(target=self._listen, name="pilot", daemon=True)

    def start(self, tell: Tell) -> None:
        """Begin to listen."""
        self._tell = tell
        self._thread.start()

    @property
    def state(self) -> dict[str, Any]:
        """The last note of how things are, for a page that has just come."""
        return {**self._state, "note": "state"}

    def ask(self, message: Any) -> Future[None]:
        """Have a message carried out; the result has BadInput if it cannot be."""
        number, answer = next(self._numbers), Future[None]()
        self._asked[number] = answer
        self._line.say(("ask", number, message))
        if self._gone:  # looked at after `_asked` has it: else it could be missed by both
            self._refuse_all()
        return answer

    def look(self, watched: bool) -> None:
        """Say whether a page is there."""
        self._line.say(("look", watched))

    def end(self) -> None:
        """Stop flying. What is being saved is finished first."""
        self._ended = True
        self._line.finish()
        self._thread.join()
        self._reap()

    def _reap(self) -> None:
        with contextlib.suppress(ChildProcessError):
            os.waitpid(self._child, 0)

    def _listen(self) -> None:
        with contextlib.suppress(EOFError):
            while True:
                self._take(self._line.hear())
        if not self._ended:
            self._told({**self.state, "ended": _GONE})
        self._gone = True
        self._refuse_all()

    def _take(self, said: tuple[Any, ...]) -> None:
        match said:
            case ("facts", facts):
                self.facts, self._state = facts, {}
            case ("saved", folder, note):
                self.last_saved = folder
                self._tell(note)
            case ("answer", number, error):
                answer = self._asked.pop(number)
                answer.set_result(None) if error is None else answer.set_exception(error)
            case ("tell", bytes() as frame):
                self._tell(frame)
            case ("tell", note):
                self._told(note)

    def _told(self, note: dict[str, Any]) -> None:
        if note["note"] in ("state", "story"):
            self._state |= note
        self._tell(note)

    def _refuse_all(self) -> None:
        while self._asked:
            with contextlib.suppress(KeyError):
                self._asked.popitem()[1].set_exception(BadInput([Problem(_GONE)]))


def _fly(line: Line, pilot: Callable[[Line], Pilot]) -> NoReturn:
    """Fly, in the new process. Ctrl-C is for the server, which then says nothing more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)

    def flown() -> None:
        try:
            made = pilot(line)
        except BadInput as error:
            line.say(("refused", error))
            return
        made.run()

    done_in(flown)
