"""The commands in their order, and the parser, which says what was probably meant by a word that it does not know."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

from testbed.inputs.problems import did_you_mean, guess

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
