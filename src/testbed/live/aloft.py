"""The process that flies, as the server sees it, and its copies. Most of these are frozen at moments of the flight: going back
wakes one, which flies on from there.

A copy is a fork. It has JSBSim's inside, too, which cannot be copied otherwise, and it flies on to the same bytes. It also has the
lines to all copies that are earlier than itself, so that after going back there are those that are still needed, and no others:
a frozen copy ends with the process that can wake it.
"""

from __future__ import annotations

import contextlib
import math
import os
import pickle
import select
import signal
import socket
import threading
import traceback
import zlib
from collections.abc import Callable
from concurrent.futures import Future
from itertools import count
from pathlib import Path
from typing import Any, NoReturn, Protocol, Self

from testbed.inputs.problems import BadInput, Problem

_LONGEST = 8_000_000  # [bytes]
_LONG = 50_000  # longer ones are compressed: the system takes about 200 000 bytes at once
_COMPRESSED = 0x78  # the first byte of zlib's; pickle's is another


class Line:
    """One end of a line between two processes of this machine, for whole messages, which copies of a process can send on it, too.

    Both ends are this program's own: what comes is believed.
    """

    def __init__(self, end: socket.socket) -> None:
        self._end = end

    @classmethod
    def pair(cls) -> tuple[Self, Self]:
        """Both ends of a new line."""
        one, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        return cls(one), cls(other)

    def say(self, what: Any) -> None:
        """Send something; if the other end is gone, nobody hears it."""
        data = pickle.dumps(what)
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            self._end.send(data if len(data) < _LONG else zlib.compress(data, 1))

    def hear(self, wait_s: float | None = None) -> Any:
        """The next message; None if none comes within this time [s]. Raises EOFError if the other end is gone."""
        if wait_s is not None and not select.select([self._end], [], [], wait_s)[0]:
            return None
        try:
            data = self._end.recv(_LONGEST)
        except ConnectionResetError:
            data = b""
        if not data:
            raise EOFError
        return pickle.loads(zlib.decompress(data) if data[0] == _COMPRESSED else data)

    @property
    def gone(self) -> bool:
        """Whether the other end says nothing any more, even if messages of it are left."""
        poll = select.poll()
        poll.register(self._end, select.POLLRDHUP)
        return bool(poll.poll(0))

    def finish(self) -> None:
        """Say that nothing more will be said; the other end can go on to speak."""
        with contextlib.suppress(OSError):
            self._end.shutdown(socket.SHUT_WR)

    def close(self) -> None:
        """Give this end up; copies of this process keep theirs."""
        self._end.close()


class Copies:
    """The copies that this process has."""

    def __init__(self) -> None:
        self._frozen: list[tuple[int, Line]] = []
        self._children: list[int] = []

    @property
    def last(self) -> float:
        """Control step of the last frozen copy; minus infinity if there is none."""
        return self._frozen[-1][0] if self._frozen else -math.inf

    def begin(self, work: Callable[[], object]) -> None:
        """Do something in a copy, which ends then. Raises OSError if there can be no copy."""
        if not self._forked():
            self.drop()  # else the frozen ones could not end before it
            done_in(work)

    def freeze(self, step: int) -> Any:
        """Freeze a copy at a control step. Returns None; in a copy that is woken, what it was woken with. Raises OSError."""
        ours, theirs = Line.pair()
        if self._forked():
            theirs.close()
            self._frozen.append((step, ours))
            return None
        ours.close()
        return self._asleep(step, theirs)

    def _asleep(self, step: int, line: Line) -> Any:
        """Wait, in a frozen copy. Each waking makes a copy that goes on; this one sleeps on."""
        while True:
            try:
                woken = line.hear()
            except EOFError:
                os._exit(0)
            ours, again = Line.pair()
            self._children.clear()
            if self._forked():
                ours.close()
                line.close()
                line = again
                continue
            again.close()
            line.say("awake")
            line.close()
            self._frozen.append((step, ours))
            return woken

    def wake(self, step: int, what: Any) -> None:
        """Have the last copy not later than a control step go on in place of this process, which ends. Returns if none can."""
        for at, line in reversed(self._frozen):
            if at <= step:
                with contextlib.suppress(EOFError, OSError):
                    line.say(what)
                    line.hear()
                    os._exit(0)
        self.drop()

    def drop(self) -> None:
        """Let all frozen copies end: they are of another flight."""
        for _, line in self._frozen:
            line.close()
        self._frozen.clear()

    def _forked(self) -> bool:
        """Fork; returns whether this is the one that was there."""
        self._children = [child for child in self._children if os.waitpid(child, os.WNOHANG)[0] == 0]
        if child := os.fork():
            self._children.append(child)
            return True
        self._children = []
        return False


def done_in(work: Callable[[], object]) -> NoReturn:
    """Do something in a process that has been forked for it, and end it: nothing of the process that it was goes on."""
    status = 1
    try:
        work()
        status = 0
    except BaseException:
        traceback.print_exc()
    finally:
        os._exit(status)


Tell = Callable[[bytes | dict[str, Any]], object]
"""Takes a frame, or a note in words, for all pages; called in a thread of its own."""

_GONE = "the process that flew has ended: start testbed live again"


class Flies(Protocol):
    """What flies in the new process: a `Pilot`."""

    def run(self) -> None: ...


class Aloft:
    """A `Pilot` in a process of its own, which nothing of the server can hold up, and which can be forked (see `Copies`).

    Attributes:
        facts: what a page has to know of the flight.
        last_saved: the run folder that was written last; None if none was.
    """

    _tell: Tell

    def __init__(self, pilot: Callable[[Line], Flies]) -> None:
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


def _fly(line: Line, pilot: Callable[[Line], Flies]) -> NoReturn:
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
