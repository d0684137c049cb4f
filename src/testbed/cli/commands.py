"""The commands in their order; run one, and say in one line what goes wrong.

The parser says what was probably meant by a word that it does not know. `ending` has the exit status and Ctrl-C. An error that no
command expects is one line, too, never a traceback.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
import threading
import time
import traceback
from argparse import Namespace
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

from testbed.cli import ending
from testbed.cli.ending import BAD_INPUT, ENDED_EARLY, INTERRUPTED, Ended
from testbed.cli.terminal import give_up, plain_output
from testbed.inputs.problems import BadInput, did_you_mean, guess

_COMMANDS = (
    "run", "live", "sweep", "search", "matrix", "benchmark", "merge", "report", "compare", "export", "validate", "identify",
    "diagnose", "design", "adopt", "certify", "list", "schema", "check", "init", "completion",
)  # fmt: skip
TABLE = {name: import_module(f"testbed.cli.{name}") for name in _COMMANDS}
"""The modules of the commands (see `testbed.cli`), in the order of `--help`."""
_WITHOUT_PARTS = ("identify", "adopt", "init", "completion", "check")
"""Commands for which parts of the user's own mean nothing."""
_PARTS = "use the failures, sensors, metrics, panels and references of your own in this file; repeatable"

FIRST_STEPS = """\
testbed breaks the actuators of a small aircraft in flight, and shows what its controller does about it.

  testbed run left_tail_fail.yaml   fly a shipped scenario; report.html in its folder shows the flight
  testbed list scenarios            what else can be flown
  testbed init my_project           a scenario, a sweep and a controller to begin with
  testbed --help                    every command; testbed COMMAND --help: its options, with examples
"""
"""What `testbed` says when it is given no command."""

_UNKNOWN = re.compile(r"unrecognized arguments: (.*)", re.DOTALL)


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = Parser(prog="testbed", description="A flight-control failure testbed.")
    top.add_argument("--version", action=_Version, nargs=0, help="print the version")
    commands = top.add_subparsers(required=True, metavar="COMMAND")
    for name, command in TABLE.items():
        one = commands.add_parser(
            name,
            help=command.PURPOSE,
            description=command.PURPOSE,
            epilog="\n  ".join(["examples:", *command.EXAMPLES]),
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        one.set_defaults(command=command.run)
        command.arguments(one)
        if name not in _WITHOUT_PARTS:
            one.add_argument(
                "--with", dest="parts", type=Path, action="append", metavar="FILE.py", help=_PARTS
            )
    return top


class _Version(argparse.Action):
    """Finds the version only when it is asked for, because that takes a quarter of the time of `--help`."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        from testbed import __version__

        print(f"testbed {__version__}")
        parser.exit()


class Parser(argparse.ArgumentParser):
    """Says what was probably meant by a command, a choice or an option that does not exist."""

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            expected, suggestion = guess(value, map(str, action.choices))
            words = f", did you mean {suggestion}?" if suggestion else f", expected {expected}"
            raise argparse.ArgumentError(action, f"{value!r} is not known{words}")

    def error(self, message: str) -> NoReturn:
        """Print usage and what is wrong, and end the process with status 2."""
        unknown = _UNKNOWN.fullmatch(message)
        if unknown:
            options = [word.partition("=")[0] for word in unknown[1].split(" ") if word[:1] == "-"]
            close = {option: did_you_mean(option, _options(self)) for option in options}
            meant = "".join(
                f", did you mean {near}?" if near != option else f", {option} is an option of other commands"
                for option, near in close.items()
                if near
            )
            message = f"not known: {unknown[1]}{meant}"
        super().error(message)


def _options(parser: argparse.ArgumentParser) -> Iterator[str]:
    """The options of a parser and of its commands."""
    for action in parser._actions:
        yield from action.option_strings
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _options(command)


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
            return _said(ending.INTERRUPTED_WORDS, INTERRUPTED)
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
