"""Robustness of a formula (`scenario.formula`) in a flight: of each row, from those that follow it.

An `and` is a minimum, an `or` a maximum, `always` a minimum over time and `eventually` a maximum, as in `flight.robustness`. A row
is judged only where its windows end within the log, so that a formula over a shorter log has fewer rows, and perhaps none.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping

import numpy as np

from testbed.flight.robustness import largest_of
from testbed.scenario.formula import Node

_ARITHMETIC: dict[str, Callable[[np.ndarray, np.ndarray], np.ndarray]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": np.divide,
}  # fmt: skip


def robustness(node: Node, log: Mapping[str, np.ndarray], rate_hz: float) -> np.ndarray:
    """[rows] robustness of a formula, in the unit of what it compares: 0 or more where it holds.

    Args:
        log: columns by name, each [rows].
        rate_hz: rows per second.
    """
    if node.form == "above":
        upper, lower = (_values(part, log) for part in node.parts)
        return np.asarray(upper - lower)
    parts = [robustness(part, log, rate_hz) for part in node.parts]
    if node.form in ("and", "or"):
        rows = min(map(len, parts))
        return np.asarray(
            (np.minimum if node.form == "and" else np.maximum).reduce([p[:rows] for p in parts])
        )
    if node.form == "not":
        return -parts[0]
    if node.form == "until":
        return _until(parts[0], parts[1], node.window, rate_hz)
    sign = 1.0 if node.form == "eventually" else -1.0
    return sign * _largest_ahead(sign * parts[0], node.window, rate_hz)


def _largest_ahead(values: np.ndarray, window: tuple[float, float], rate_hz: float) -> np.ndarray:
    """The largest value from the beginning to the end of a window after each row; shorter by the window."""
    first = round(window[0] * rate_hz)
    values = values[first:]
    if window[1] == math.inf:
        return np.maximum.accumulate(values[::-1])[::-1]
    rows = round(window[1] * rate_hz) - first + 1
    return largest_of(values, rows) if len(values) >= rows else values[:0]


def _until(before: np.ndarray, then: np.ndarray, window: tuple[float, float], rate_hz: float) -> np.ndarray:
    """The largest, over the window, of the lesser of `then` and the least of `before` until there (Donze and Maler 2010)."""
    rows = min(len(before), len(then))
    first = round(window[0] * rate_hz)
    last = rows - 1 if window[1] == math.inf else round(window[1] * rate_hz)
    judged = rows - (first if window[1] == math.inf else last)
    if judged <= 0:
        return before[:0]
    best, least = np.full(judged, -math.inf), np.full(judged, math.inf)
    for ahead in range(last + 1):
        held = min(judged, rows - ahead)  # without an end the window is shorter for later rows
        if ahead >= first:
            best[:held] = np.maximum(best[:held], np.minimum(then[ahead : ahead + held], least[:held]))
        least[:held] = np.minimum(least[:held], before[ahead : ahead + held])
    return best


def _values(node: Node, log: Mapping[str, np.ndarray]) -> np.ndarray:
    """[rows] of a part that is a number at each time."""
    if node.form == "column":
        return log[node.name]
    if node.form == "number":
        return np.full(len(log["time_s"]), node.value)
    parts = [_values(part, log) for part in node.parts]
    if node.form == "abs":
        return np.abs(parts[0])
    with np.errstate(all="ignore"):  # what is no number is said of the requirement
        return _ARITHMETIC[node.form](parts[0], parts[1])
