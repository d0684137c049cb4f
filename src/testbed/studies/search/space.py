"""The space of a search: a standard normal coordinate for each value that varies, so that distance is likelihood.

The value at a coordinate z is exceeded as often as z is (the transformation of independent marginals; Der Kiureghian and Liu
1986, without correlation). A value that is measured from the end of its range, such as a severity from "no effect", has the
coordinate u with P(a value farther from that end) = P(a normal number farther from 0 than u): its distribution is the same, and
u = 0 is that end.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from scipy.integrate import quad
from scipy.special import ndtr, ndtri

from testbed.studies.drawing.distributions import Distribution

Origin = Literal["median", "low", "high"]
"""Where in the range of a value its coordinate is 0."""
_TAIL = 9.0
"""Standard deviations after which the density of a normal number is taken for zero."""


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

    def distance(self, u: float) -> float:
        """The coordinate, without its sign where the value is measured from an end: u and -u are the same value there."""
        return u if self.origin == "median" else abs(u)

    def beyond(self, u: float) -> float:
        """Probability of a value at least this far from where distance is measured, on this side of it."""
        return float(ndtr(-abs(u))) * (1.0 if self.origin == "median" else 2.0)


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

    @property
    def mirrored(self) -> tuple[int, ...]:
        """Which coordinates have the same value at u and -u: those measured from an end."""
        return tuple(j for j, each in enumerate(self.coordinates) if each.origin != "median")

    def values(self, u: np.ndarray) -> list[dict[str, Any]]:
        """The values by dotted path at each of the points [n, dimensions]."""
        columns = [each.values(u[:, j]) for j, each in enumerate(self.coordinates)]
        paths = [each.path for each in self.coordinates]
        return [dict(zip(paths, row, strict=True)) for row in zip(*columns, strict=True)]

    def beyond(self, u: np.ndarray) -> float:
        """Probability of what lies beyond a limit that is flat at the point u [dimensions]: P(n z > |u|), with n = u / |u|.

        Where a value is measured from an end, z and -z are the same value, so z there is the size of a normal number: with m such
        coordinates the probability is 2^m P(n z > |u|, all m positive), which is 2 P(z > u) if u is one of them alone. Given
        n z = r, the coordinate i has the mean n_i r and the variance 1 - n_i^2. Between two of them its correlation is neglected.
        """
        distance = float(np.linalg.norm(u))
        ends = list(self.mirrored)
        if distance == 0.0 or not ends:
            return float(ndtr(-distance))
        n = np.abs(u[ends]) / distance
        slope = n / np.sqrt(np.maximum(1.0 - n * n, np.finfo(float).tiny))

        def density(past: float) -> float:
            """That of n z at |u| + past, as a share of the normal density at |u|."""
            return math.exp(-past * (distance + 0.5 * past)) * float(
                np.prod(2.0 * ndtr(slope * (distance + past)))
            )

        normal = math.exp(-0.5 * distance * distance) / math.sqrt(2.0 * math.pi)
        return min(1.0, normal * quad(density, 0.0, _TAIL)[0])


def origin_at(distribution: Distribution, nominal: float) -> Origin | None:
    """Which end of the range a value is; None if it is no end."""
    if distribution.name == "choice":
        return None
    low, high = distribution.ends
    return "low" if nominal == low else "high" if nominal == high else None
