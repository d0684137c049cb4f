"""How far the rows of a signal are inside the limits of a requirement, and its robustness: that as one signed number.

It is that of signal temporal logic (Fainekos and Pappas, Robustness of temporal logic specifications, 2009; Donze and Maler,
Robust satisfaction of temporal logic over real-valued signals, 2010): an `and` is a minimum, an `or` a maximum, "always" a
minimum over time and "eventually" a maximum. It is negative where the limits are broken, and continuous in the signal.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from testbed.scenario.requirement import Requirement


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
