"""Checks of the arguments that both questions take."""

from __future__ import annotations

import math
from typing import Any

from testbed.inputs.problems import BadInput, Problem

_LEAST = {"dimensions": 1, "seed": 0, "budget": 10, "starts": 1}
_CALLED = "a function of [n, d] standard normals that returns [n] values"


def check(limit_state: Any, most_dimensions: int, **given: Any) -> None:
    """Raise BadInput with every problem of the arguments, before the limit state is called.

    Those in _LEAST are whole numbers, the others numbers above 0.
    """
    problems = [] if callable(limit_state) else [Problem("cannot be called", "limit_state", expected=_CALLED)]
    for name, value in given.items():
        expected = _whole(name, value, most_dimensions) if name in _LEAST else _positive(value)
        if expected:
            problems.append(Problem(f"is {value!r}", name, expected=expected))
    if problems:
        raise BadInput(problems)


def check_mirrored(mirrored: Any, dimensions: int) -> None:
    """Raise BadInput unless these are coordinates of so many."""
    if wrong := [each for each in mirrored if each not in range(dimensions)]:
        expected = f"coordinates from 0 to {dimensions - 1}"
        raise BadInput([Problem(f"has {wrong[0]!r}", "mirrored", expected=expected)])


def _whole(name: str, value: Any, most_dimensions: int) -> str:
    """What is expected of a whole number, "" if the value is one."""
    least, most = _LEAST[name], most_dimensions if name == "dimensions" else math.inf
    if hasattr(value, "__index__") and not isinstance(value, bool) and least <= value <= most:
        return ""
    return f"a whole number from {least} " + ("on" if most == math.inf else f"to {most}")


def _positive(value: Any) -> str:
    """Empty if the value is a number above 0, else the words for what was expected."""
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return "" if number and 0 < value < math.inf else "a number above 0"
