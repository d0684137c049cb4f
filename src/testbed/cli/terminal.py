"""What the commands print: text that a terminal shows and does not obey, in any encoding; warnings as one line each.

Only the verdict has a colour, and only on a terminal, unless NO_COLOR is set (no-color.org) or TERM is dumb. A line on stderr, if
that is a terminal, says what is being done and for how long, where it takes longer than a second, and goes when the work is done.
It needs no colour and hides no cursor, since Ctrl-C may end the process at any time (see `ending`).
"""

from __future__ import annotations

import contextlib
import io
import os
import sys
import threading
import warnings
from collections.abc import Iterator
from time import monotonic
from typing import Any, TextIO, cast

from testbed.common.text import printable

_GREEN, _RED = "32", "31"
_QUIET_S, _EVERY_S = 1.0, 0.5
_shown, _lock = {"line": ""}, threading.Lock()  # what stands on the terminal now


class _Printable:
    """A text stream that writes what `printable` makes of a text, as long as somebody reads it; all else is the stream's own."""

    def __init__(self, stream: TextIO | None) -> None:
        self._stream = stream or open(os.devnull, "w")  # noqa: SIM115  (None if the shell has closed it, as by `>&-`)

    def write(self, text: str) -> int:
        erase()
        with _read_or_not(self._stream):
            self._stream.write(printable(text))
        return len(text)

    def flush(self) -> None:
        with _read_or_not(self._stream):
            self._stream.flush()

    def write_in_colour(self, text: str, code: str) -> None:
        """Write `text` in the colour of an ANSI code, if the stream is a terminal that may have colours."""
        plain = (
            not self._stream.isatty() or bool(os.environ.get("NO_COLOR")) or os.environ.get("TERM") == "dumb"
        )
        erase()
        with _read_or_not(self._stream):
            self._stream.write(printable(text) if plain else f"\x1b[{code}m{printable(text)}\x1b[0m")

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


@contextlib.contextmanager
def _read_or_not(stream: TextIO) -> Iterator[None]:
    """A reader that goes away, as of `testbed list | head -1`, changes nothing of what a command does and finds."""
    try:
        yield
    except BrokenPipeError:
        give_up(stream)


@contextlib.contextmanager
def plain_output() -> Iterator[None]:
    """While in the block, what is printed is `printable`, no character is an error, and a warning is one line on stderr."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    out, err = (cast(TextIO, _Printable(stream)) for stream in (sys.stdout, sys.stderr))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), warnings.catch_warnings():
        warnings.showwarning = _show
        yield


def print_verdict_word(word: str, good: bool) -> None:
    """Print a word without a new line, green if it is good news, red if not."""
    if isinstance(sys.stdout, _Printable):
        sys.stdout.write_in_colour(word, _GREEN if good else _RED)
    else:  # called from Python, outside a command
        print(word, end="")


def _show(message: Warning | str, *_: object, **__: object) -> None:
    print(f"WARNING: {' '.join(str(message).split())}", file=sys.stderr)


def give_up(stream: TextIO) -> None:
    """Let what is still to be written vanish, because its reader has gone or its disk is full.

    The remedy is that of the notes on SIGPIPE in Python's `signal` module: the flush at exit then succeeds.
    """
    # ValueError: it has no file descriptor, as in a test. AttributeError: a controller of the user's has set it to None.
    with contextlib.suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


@contextlib.contextmanager
def working(what: str) -> Iterator[None]:
    """While in the block, and once it has taken a second, the terminal shows `what` and the time that it has taken."""
    stream = sys.__stderr__  # not sys.stderr: commands let no control character pass there
    if stream is None or stream.closed or not stream.isatty():
        yield
        return
    done = threading.Event()
    thread = threading.Thread(target=_count, args=(stream, what, done), daemon=True)
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


def _count(stream: TextIO, what: str, done: threading.Event) -> None:
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
