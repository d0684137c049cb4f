"""Copies of the process that flies. Most are frozen at moments of the flight: going back wakes one, which flies on from there.

A copy is a fork. It has JSBSim's inside, too, which cannot be copied otherwise, and it flies on to the same bytes. It also has the
lines to all copies that are earlier than itself, so that after going back there are those that are still needed, and no others:
a frozen copy ends with the process that can wake it.
"""

from __future__ import annotations

import contextlib
import math
import os
import traceback
from collections.abc import Callable
from typing import Any, NoReturn

from testbed.live.line import Line


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
