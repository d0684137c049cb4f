"""The space of a search: a standard normal coordinate for each value that varies, so that distance is likelihood.

The value at a coordinate z is exceeded as often as z is (the transformation of independent marginals; Der Kiureghian and Liu
1986, without correlation). A value that is measured from the end of its range, such as a severity from "no effect", has the
coordinate u with P(a value farther from that end) = P(a normal number farther from 0 than u): its distribution is the same, and
u = 0 is that end.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from scipy.special import ndtr, ndtri

from testbed.sweeps.drawing.distributions import Distribution

Origin = Literal["median", "low", "high"]
"""Where in the range of a value its coordinate is 0."""


@dataclass(frozen=True)
class Coordinate:
    """One value that varies: its dotted path, its distribution, and what distance is measured from."""

    path: str
    distribution: Distribution
    origin: Origin = "median"

    def values(self, u: np.ndarray) -> list[Any]:
        """The values at these coordinates [n]."""
        return self.distribution.at_normal(_from_end(u, self.origin))

    @property
    def nominal(self) -> Any:
        """The value at the origin."""
        return self.values(np.zeros(1))[0]


def _from_end(u: np.ndarray, origin: Origin) -> np.ndarray:
    if origin == "median":
        return u
    below = ndtri(2.0 * ndtr(-np.abs(u)))  # infinite at u = 0, which is the end itself
    return below if origin == "high" else -below


@dataclass(frozen=True)
class Space:
    """The coordinates of a search, in the order of its file."""

    coordinates: tuple[Coordinate, ...]

    def __len__(self) -> int:
        return len(self.coordinates)

    def values(self, u: np.ndarray) -> list[dict[str, Any]]:
        """The values by dotted path at each of the points [n, dimensions]."""
        columns = [each.values(u[:, j]) for j, each in enumerate(self.coordinates)]
        paths = [each.path for each in self.coordinates]
        return [dict(zip(paths, row, strict=True)) for row in zip(*columns, strict=True)]


def origin_at(distribution: Distribution, nominal: float) -> Origin | None:
    """Which end of the range a value is; None if it is no end."""
    if distribution.name == "choice":
        return None
    low, high = distribution.ends
    return "low" if nominal == low else "high" if nominal == high else None


def likelihoods(coordinates: Mapping[str, float]) -> dict[str, float]:
    """Probability of a value at least this far from where distance is measured, on this side of it, by dotted path."""
    return {path: float(ndtr(-abs(u))) for path, u in coordinates.items()}
