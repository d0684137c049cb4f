"""How a command ends: its exit status, as docs/reference/command_line.md says to users, and Ctrl-C.

Ctrl-C is one line and exit status 130, whenever it comes. SIGTERM and SIGHUP, as of a scheduler or a closed terminal, do the same.
A KeyboardInterrupt in the middle of an import, in a callback of a weak reference, or in code that numba calls while it
compiles, may be swallowed, and one in a callback of native code may come out as another exception. So, until something is being
written, Ctrl-C ends the process by itself, at once; nothing has to be tidied up. After that, an interrupt that was swallowed is
sent again, and another exception after it is taken for it.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Iterator

MET = 0
"""Every requirement was met, or the command has none."""
NOT_MET = 1
"""Flown, but a requirement was not met or the aircraft was lost."""
BAD_INPUT = 2
"""Bad input: nothing was flown or written."""
ENDED_EARLY = 3
"""The command could not be carried out to its end, as on a full disk; what a sweep has flown is kept."""
INTERRUPTED = 130
"""Ctrl-C, or SIGTERM or SIGHUP: 128 and the number of the signal SIGINT, as shells have it."""

INTERRUPTED_WORDS = "interrupted"
"""What is said of it."""

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

_AGAIN_S = 0.01
"""An interrupt that was swallowed is sent again after this time, when the callback that swallowed it has returned."""


class Ended(Exception):
    """A command could not be carried out to its end: what to say on stderr, and the exit status."""

    def __init__(self, words: str, status: int) -> None:
        super().__init__(words)
        self.status = status


def end_at_once() -> None:
    """From now on Ctrl-C ends the process at once; not a signal that is ignored or handled already, as under nohup."""
    for number in _SIGNALS:
        if signal.getsignal(number) in (signal.default_int_handler, signal.SIG_DFL):
            signal.signal(number, _end)


def end_undisturbed() -> None:
    """From now on Ctrl-C is ignored: the command has finished, and Python, which takes itself apart, handles no signal any more."""
    for number in _SIGNALS:
        if signal.getsignal(number) is _end:
            signal.signal(number, signal.SIG_IGN)


@contextlib.contextmanager
def tidily() -> Iterator[None]:
    """While in the block, Ctrl-C is a KeyboardInterrupt, so that what is being written can be removed or finished."""
    ours = [number for number in _SIGNALS if signal.getsignal(number) is _end]
    if not ours:
        yield
        return
    hook = sys.unraisablehook
    came = False

    def interrupt(*_: object) -> None:
        nonlocal came
        came = True
        raise KeyboardInterrupt

    for number in ours:
        signal.signal(number, interrupt)
    sys.unraisablehook = _send_again
    try:
        yield
    except Ended:  # which has words of its own for an interrupt
        raise
    except Exception as error:
        if came:
            raise KeyboardInterrupt from error
        raise
    finally:
        for number in ours:
            signal.signal(number, _end)
        sys.unraisablehook = hook


@contextlib.contextmanager
def later() -> Iterator[None]:
    """While in the block, Ctrl-C waits: for a moment in which something is made and removed again."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, _SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _send_again(swallowed: sys.UnraisableHookArgs) -> None:
    """The interpreter calls this with what it cannot raise, such as an exception in a callback of a weak reference."""
    if not isinstance(swallowed.exc_value, KeyboardInterrupt):
        sys.__unraisablehook__(swallowed)
        return
    from threading import Timer  # here, since until Ctrl-C is handled every millisecond of imports counts

    # To the process, so that a main thread that waits wakes.
    again = Timer(_AGAIN_S, os.kill, [os.getpid(), signal.SIGINT])
    again.daemon = True
    again.start()


def _end(*_: object) -> None:
    with contextlib.suppress(OSError):
        os.write(2, f"{INTERRUPTED_WORDS}\n".encode())
    os._exit(INTERRUPTED)
