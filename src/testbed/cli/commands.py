"""Run a command, and say in one line what goes wrong.

`parser` has the commands, `status` their exit status. An error that no command expects is one line, too, never a traceback.
"""

from __future__ import annotations

import os
import sys
import threading
import time
import traceback
from argparse import Namespace
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path

from testbed.cli import interrupts
from testbed.cli.parser import FIRST_STEPS, parser
from testbed.cli.status import BAD_INPUT, ENDED_EARLY, INTERRUPTED, Ended
from testbed.cli.terminal import give_up, plain_output
from testbed.inputs.problems import BadInput

_TRACEBACK = "TESTBED_TRACEBACK"
"""Environment variable with which a defect of the program shows its traceback."""
_WAIT_S = 3.0


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status; every problem with the input is one line on stderr."""
    with plain_output():
        try:
            try:
                return _run(arguments)
            finally:
                sys.stdout.flush()  # here, so that a full disk is noticed inside this `try`
        except KeyboardInterrupt:
            return _said(interrupts.WORDS, INTERRUPTED)
        except Exception as error:
            if os.environ.get(_TRACEBACK):
                raise
            give_up(sys.stdout)
            return _said(_in_words(error), ENDED_EARLY)


def _run(arguments: Sequence[str] | None) -> int:
    top = parser()
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        argcomplete.autocomplete(top)  # ends the process if a shell asks for completions
    if not (sys.argv[1:] if arguments is None else arguments):
        return _said(FIRST_STEPS.rstrip(), BAD_INPUT)
    options = top.parse_args(arguments)
    try:
        with _parts(options):
            status: int = options.command(options)
    except BadInput as error:
        return _said("\n".join(map(str, error.problems)), BAD_INPUT)
    except Ended as ended:
        return _said(str(ended), ended.status)
    return status


def _parts(options: Namespace) -> AbstractContextManager[object]:
    """The parts of the user's own, for a block; raises BadInput when they cannot be used."""
    if not (files := getattr(options, "parts", None)):
        return nullcontext()
    from testbed.parts import use

    return use(*files)


def _said(words: str, status: int) -> int:
    print(words, file=sys.stderr)
    return status


def _in_words(error: Exception) -> str:
    """One line for an error that no command expects: of the operating system, or a defect of the program."""
    if isinstance(error, OSError):
        where = f"{error.filename}: " if error.filename else ""
        return f"{where}cannot be read or written: {error.strerror or error}"
    if isinstance(error, MemoryError):
        return "there is not enough memory for this"
    if "can't start new thread" in str(error):  # Python says it in no other way
        return "no further thread can be started: this user has as many as are allowed, see `ulimit -u`"
    last = traceback.extract_tb(error.__traceback__)[-1]
    place = f"{Path(last.filename).name}:{last.lineno}"
    words = " ".join(str(error).split())
    return f"a defect of testbed: {type(error).__name__} at {place}: {words}; {_TRACEBACK}=1 shows where it comes from"


def end_despite_threads(status: int) -> int:
    """The exit status, if the process can end by itself; else it says so and ends the process with this status.

    A thread that a user's controller leaves running, and that is no daemon, has some seconds: Python would wait for it for ever.
    """
    until = time.monotonic() + _WAIT_S
    for thread in _left():
        thread.join(max(0.0, until - time.monotonic()))
    if left := _left():
        names = ", ".join(thread.name for thread in left)
        print(f"WARNING: a thread was left running, and is ended: {names}", file=sys.stderr, flush=True)
        try:
            sys.stdout.flush()
        except OSError:  # as `main` has said already
            give_up(sys.stdout)
        os._exit(status)
    return status


def _left() -> list[threading.Thread]:
    ours = threading.current_thread()
    return [thread for thread in threading.enumerate() if not thread.daemon and thread is not ours]
