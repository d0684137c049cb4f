"""Ctrl-C: one line and exit status 130, whenever it comes.

A KeyboardInterrupt in the middle of an import, or in code that numba calls while it compiles, may be swallowed or end in a
traceback. So, until something is being written, Ctrl-C ends the process by itself, at once; nothing has to be tidied up.
"""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Iterator

from testbed.cli.status import INTERRUPTED

WORDS = "interrupted"


def end_at_once() -> None:
    """From now on Ctrl-C ends the process at once; not if SIGINT is ignored or handled already, as under nohup."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _end)


@contextlib.contextmanager
def tidily() -> Iterator[None]:
    """While in the block, Ctrl-C is a KeyboardInterrupt, so that what is being written can be removed or finished."""
    before = signal.getsignal(signal.SIGINT)
    if before is not _end:
        yield
        return
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextlib.contextmanager
def later() -> Iterator[None]:
    """While in the block, Ctrl-C waits: for a moment in which something is made and removed again."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _end(*_: object) -> None:
    with contextlib.suppress(OSError):
        os.write(2, f"{WORDS}\n".encode())
    os._exit(INTERRUPTED)
