"""A resolved search: its parts, each a search of its own, and the flight at each of their points. Nothing here flies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from testbed.studies.drawing.builder import Task
from testbed.studies.drawing.sampling import hashed
from testbed.studies.model import Search
from testbed.studies.plan import Plan
from testbed.studies.search.space import Space

Point = tuple[float, ...]
"""Coordinates of a flight in the space of its part."""


@dataclass(frozen=True)
class Part:
    """One search of those that a file asks for: one variant, with one option of every `choice`.

    Attributes:
        options: the option of each choice by its dotted path.
        weight: probability of these options.
    """

    number: int
    variant: int
    options: Mapping[str, Any]
    weight: float
    space: Space


@dataclass(frozen=True, kw_only=True)
class SearchPlan(Plan):
    """A resolved search. As a plan it is the sweep over the same values, with whose first runs its scenarios are checked."""

    study: Search
    parts: tuple[Part, ...]
    histories: ClassVar[bool] = False

    @property
    def size(self) -> int:
        """The most flights that it may make."""
        return self.study.budget * len(self.parts)

    @property
    def total(self) -> str:
        """As `Plan.total`."""
        return f"at most {self.size}"

    def label(self, part: Part) -> str:
        """The variant and the options of a part in words; empty if there is only one part."""
        options = [
            value if isinstance(value, str) else f"{path} {value}" for path, value in part.options.items()
        ]
        return ", ".join(filter(None, [self.variants[part.variant].label, *options]))

    def seed(self, part: Part) -> int:
        """Seed of the search's own random numbers: the same for all variants, which so meet the same points."""
        return hashed(self.study.seed, "search", *sorted(f"{p}={v}" for p, v in part.options.items()))

    def tasks(self, part: Part, points: np.ndarray, first: int) -> list[Task]:
        """The flights at these points [n, dimensions], numbered from `first` on."""
        drawn = part.space.values(points)
        return [
            Task(first + i, part.variant, self._flight_seed(point), {**part.options, **values})
            for i, (point, values) in enumerate(zip(points, drawn, strict=True))
        ]

    def _flight_seed(self, point: np.ndarray) -> int:
        """Seed of what a flight draws for itself, such as turbulence.

        In the search for the smallest failure it is the same for all flights, which then differ in their point only. For a
        probability it is drawn anew with each point: it acts as further random numbers, which the search does not move.
        """
        if self.study.goal == "smallest":
            return hashed(self.study.seed, "flight")
        return hashed(self.study.seed, "flight", point.astype("<f8").tobytes().hex())


def coordinates(key: bytes) -> Point:
    """The point of the flight that has this key."""
    return tuple(np.frombuffer(key[4:], dtype=">f8").tolist())


def key_of(part: Part, point: Point) -> bytes:
    """The key by which the flight of a part at a point is stored (see `folder.store`)."""
    return part.number.to_bytes(4, "big") + (np.array(point, dtype=">f8") + 0.0).tobytes()  # + 0.0: no -0.0
