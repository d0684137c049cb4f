"""The parser of the command line: what it refuses it says as every other problem with the input is said."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from typing import Any, NoReturn

from testbed.inputs.problems import did_you_mean, guess

_UNKNOWN = re.compile(r"unrecognized arguments: (.*)", re.DOTALL)


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
            words = unknown[1].split(" ")
            close = [
                did_you_mean(word.partition("=")[0], _options(self)) for word in words if word[:1] == "-"
            ]
            meant = "".join(f", did you mean {option}?" for option in dict.fromkeys(filter(None, close)))
            message = f"not known: {unknown[1]}{meant}"
        super().error(message)


def _options(parser: argparse.ArgumentParser) -> Iterator[str]:
    """The options of a parser and of its commands."""
    for action in parser._actions:
        yield from action.option_strings
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _options(command)


def whole_number(text: str) -> int:
    """The value of an option that is a whole number."""
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"is {text!r}, expected a whole number") from None


def number(text: str) -> float:
    """The value of an option that is a number."""
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"is {text!r}, expected a number") from None
