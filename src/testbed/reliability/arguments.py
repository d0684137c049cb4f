"""Checks of the arguments that both questions take."""

from __future__ import annotations

import math
from typing import Any

from testbed.inputs.problems import BadInput, Problem

MOST_DIMENSIONS = 100_000


def check(limit_state: Any, **given: Any) -> None:
    """Raise BadInput with every problem of the arguments, before the limit state is called."""
    problems = [] if callable(limit_state) else [Problem("cannot be called", "limit_state", expected=_CALLED)]
    problems += [problem for name, value in given.items() if (problem := _problem(name, value))]
    if problems:
        raise BadInput(problems)


_CALLED = "a function of [n, d] standard normals that returns [n] values"
_LEAST = {"dimensions": 1, "seed": 0, "budget": 10, "starts": 1}


def _problem(name: str, value: Any) -> Problem | None:
    """What is wrong with one argument: a whole number with its least value in _LEAST, else a number above 0."""
    least = _LEAST.get(name)
    if least is None:
        if isinstance(value, (int, float)) and not isinstance(value, bool) and 0 < value < math.inf:
            return None
        return Problem(f"is {value!r}", name, expected="a number above 0")
    if _whole(value) and least <= value <= (MOST_DIMENSIONS if name == "dimensions" else math.inf):
        return None
    most = f" to {MOST_DIMENSIONS}" if name == "dimensions" else " on"
    return Problem(f"is {value!r}", name, expected=f"a whole number from {least}{most}")


def _whole(value: Any) -> bool:
    return hasattr(value, "__index__") and not isinstance(value, bool)
