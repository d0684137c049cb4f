"""How far the rows of a signal are inside the limits of a requirement, and its robustness: that as one signed number. And the
robustness of a formula (`scenario.formula`).

It is that of signal temporal logic (Fainekos and Pappas, Robustness of temporal logic specifications, 2009; Donze and Maler,
Robust satisfaction of temporal logic over real-valued signals, 2010): an `and` is a minimum, an `or` a maximum, "always" a
minimum over time and "eventually" a maximum. It is negative where the limits are broken, and continuous in the signal.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from testbed.flight.columns import Log
from testbed.scenario.formula import Node
from testbed.scenario.requirement import Requirement

_ARITHMETIC: dict[str, Callable[[np.ndarray, np.ndarray], np.ndarray]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": np.divide,
}  # fmt: skip


def always(distances: np.ndarray) -> float:
    """Robustness of "inside in every row", of the distances [rows] to the limit, positive inside."""
    return float(np.min(distances))


def eventually(distances: np.ndarray) -> float:
    """Robustness of "inside in some row"."""
    return float(np.max(distances))


def never_outside_for(distances: np.ndarray, rows: int) -> float:
    """Robustness of "never outside for this many rows in succession": the least, over time, of the largest in so many rows.

    No less than 0 if there are fewer rows than that.
    """
    if len(distances) < rows:
        return max(0.0, eventually(distances))
    return always(largest_of(distances, rows))


def largest_of(values: np.ndarray, rows: int) -> np.ndarray:
    """The largest of each so many values in succession, from windows that double."""
    width = 1
    while width < rows:
        shift = min(width, rows - width)
        values = np.maximum(values[:-shift], values[shift:])
        width += shift
    return values


class Side(NamedTuple):
    """One limit of a requirement: the values [rows] that it limits, how far inside they are [rows], and robustness 1."""

    values: np.ndarray
    inside: np.ndarray
    scale: float


def sides_of(requirement: Requirement, values: np.ndarray) -> list[Side]:
    """Each limit of a requirement, on the values [rows] of its metric or signal, or of the signal's difference from `of`."""
    away, found = np.abs(values), []
    if requirement.within is not None:
        found.append(Side(away, requirement.within - away, requirement.scale_of("within")))
    if requirement.at_most is not None:
        found.append(Side(values, requirement.at_most - values, requirement.scale_of("at_most")))
    if requirement.at_least is not None:
        found.append(Side(values, values - requirement.at_least, requirement.scale_of("at_least")))
    return found


def scaled(sides: Sequence[Side]) -> np.ndarray:
    """[rows] distance to the nearest limit, in units of its scale."""
    nearest: np.ndarray = np.min([side.inside / side.scale for side in sides], axis=0)
    return nearest


def extreme(sides: Sequence[Side], best: bool = False) -> tuple[float, float]:
    """(margin, value) in the row with the smallest margin, or in that with the largest, for the limit that is nearest."""
    inside = np.array([side.inside for side in sides])
    nearest = inside.min(axis=0)
    row = int(np.argmax(nearest) if best else np.argmin(nearest))
    side = int(np.argmin(inside[:, row]))
    return float(inside[side, row]), float(sides[side].values[row])


def outside(sides: Sequence[Side]) -> np.ndarray:
    """[rows] whether any limit is broken."""
    kept: np.ndarray = np.all([side.inside >= 0.0 for side in sides], axis=0)
    return ~kept


def robustness(node: Node, log: Log, rate_hz: float) -> np.ndarray:
    """[rows] robustness of a formula, in the unit of what it compares: 0 or more where it holds. The log has `rate_hz` rows/s.

    A row is judged from those that follow it, only where its windows end within the log; so a formula over a shorter log has fewer
    rows, and perhaps none.
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


def _values(node: Node, log: Log) -> np.ndarray:
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
