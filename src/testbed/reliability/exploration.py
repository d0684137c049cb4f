"""The exploration of a search for the smallest failure: a survey of directions and then, in few dimensions, kriging."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from testbed.reliability.kriging import krige
from testbed.reliability.surface import Search
from testbed.reliability.survey import Directions, survey

SURVEYED, KRIGED = 0.1, 0.4
"""Shares of the budget for each survey, and for the first kriging."""
MOST_KRIGED = 300
"""Evaluations chosen by kriging at a time: beyond them the searches do better."""
FARTHEST = 5.0
"""Radius to look within before the first failure, in few dimensions: a probability of 3e-7 on one side."""
MOST_DIMENSIONS = 6
"""In more, some hundred points are too far apart for kriging to know anything between them."""


@dataclass
class Exploration:
    """Looks for failures nearer than the nearest one known, in all directions."""

    search: Search
    scale: float
    random: np.random.Generator
    directions: Directions = field(init=False)

    def __post_init__(self) -> None:
        asked = self.search.asked
        self.directions = Directions(
            asked.dimensions, 2 * asked.dimensions <= SURVEYED * asked.budget, self.search.folded
        )

    @property
    def outer(self) -> float:
        """Radius to look within before the first failure."""
        return max(FARTHEST, 2 + math.sqrt(self.search.asked.dimensions))

    @property
    def kriges(self) -> bool:
        """Whether there are few enough dimensions for kriging."""
        return self.search.asked.dimensions <= MOST_DIMENSIONS

    def begin(self) -> None:
        """Survey and krige with their shares of the budget."""
        self._explore(KRIGED)

    def go_on(self) -> None:
        """Survey further directions and krige with what is left."""
        self._explore(1.0)

    def _explore(self, kriged: float) -> None:
        budget = self.search.asked.budget
        self.search.begin(int(SURVEYED * budget))
        survey(self.search, self.directions, self.outer, self.random)
        if self.kriges:
            share = kriged if self.search.path else kriged / 2  # the searches have to find the first failure
            self.search.begin(min(MOST_KRIGED, int(share * budget)))
            krige(self.search, self.outer, self.scale, self.random)
