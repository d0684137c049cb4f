"""A line on the terminal that says what is being done and for how long, where it takes longer than a second.

It is written to stderr if that is a terminal, and is gone when the work is done. It needs no colour and hides no cursor, since
Ctrl-C may end the process at any time (see `interrupts`).
"""

from __future__ import annotations

import contextlib
import sys
import threading
from collections.abc import Iterator
from time import monotonic
from typing import TextIO

_QUIET_S, _EVERY_S = 1.0, 0.5
_shown, _lock = {"line": ""}, threading.Lock()  # what stands on the terminal now


@contextlib.contextmanager
def working(what: str) -> Iterator[None]:
    """While in the block, and once it has taken a second, the terminal shows `what` and the time that it has taken."""
    stream = sys.__stderr__  # not sys.stderr: commands let no control character pass there
    if stream is None or stream.closed or not stream.isatty():
        yield
        return
    done = threading.Event()
    thread = threading.Thread(target=_show, args=(stream, what, done), daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()
        erase()


def erase() -> None:
    """Remove the line, before anything else is printed; it comes back while the work goes on."""
    if _shown["line"]:
        _replace(sys.__stderr__, "")


def _show(stream: TextIO, what: str, done: threading.Event) -> None:
    start, wait = monotonic(), _QUIET_S
    while not done.wait(wait):
        _replace(stream, f"{what}: {monotonic() - start:.0f} s")
        wait = _EVERY_S


def _replace(stream: TextIO | None, line: str) -> None:
    with _lock, contextlib.suppress(OSError, ValueError):  # a terminal that has gone must not cost the result
        before, _shown["line"] = _shown["line"], line
        if stream is not None:
            stream.write(f"\r{' ' * len(before)}\r{line}")
            stream.flush()
