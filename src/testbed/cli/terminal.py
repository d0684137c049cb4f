"""What the commands print: text that a terminal shows and does not obey, in any encoding; warnings as one line each.

Only the verdict has a colour, and only on a terminal, unless NO_COLOR is set (no-color.org) or TERM is dumb.
"""

from __future__ import annotations

import contextlib
import io
import os
import sys
import warnings
from collections.abc import Iterator
from typing import Any, TextIO, cast

from testbed.cli.working import erase
from testbed.common.text import printable

_GREEN, _RED = "32", "31"


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
        _give_up(stream)


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


def give_up_stdout() -> None:
    """Let what is still to be written to stdout vanish, because its disk is full."""
    _give_up(sys.stdout)


def _give_up(stream: TextIO) -> None:
    """The remedy is that of the notes on SIGPIPE in Python's `signal` module: the flush at exit then succeeds."""
    # ValueError: it has no file descriptor, as in a test. AttributeError: a controller of the user's has set it to None.
    with contextlib.suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
