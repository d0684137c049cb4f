"""The limits of a requirement against the rows of a signal: how far inside each is, and which is nearest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from testbed.scenario.requirement import Requirement


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
