"""`smallest_failure`: the failure nearest to the origin."""

from __future__ import annotations

import math

import numpy as np

from testbed.common.random_streams import generator
from testbed.inputs.problems import BadInput, Problem
from testbed.reliability import arguments
from testbed.reliability.limit_state import Asked, LimitState
from testbed.reliability.results import SmallestFailure, Step
from testbed.sweeps.statistics import proportion

BATCH = 16


def smallest_failure(
    limit_state: LimitState, dimensions: int, *, seed: int = 0, budget: int = 2000, starts: int = 3
) -> SmallestFailure:
    """The failure of `limit_state` (at or below 0) that is nearest to the origin, by `starts` searches within `budget`.

    Raises BadInput for arguments that cannot be used, for a limit state that returns anything but [n] numbers, and if it
    fails at the origin, where there is nothing to search.
    """
    arguments.check(limit_state, dimensions=dimensions, seed=seed, budget=budget, starts=starts)
    asked = Asked(limit_state, int(dimensions), int(budget))
    if asked(np.zeros((1, asked.dimensions)))[0] <= 0:
        raise BadInput([Problem("fails at the origin: nothing is needed to break it", "limit_state")])
    return _by_draws(asked, generator(int(seed), "reliability smallest"))


def _by_draws(asked: Asked, random: np.random.Generator) -> SmallestFailure:
    path: list[Step] = []
    n = failures = 0
    while asked.left:
        values = asked(random.standard_normal((min(BATCH, asked.left), asked.dimensions)))
        n, failures = n + len(values), failures + int((values <= 0).sum())
        if asked.nearest is not None and (not path or asked.nearest is not path[-1].point):
            path.append(Step(asked.evaluations, float(np.linalg.norm(asked.nearest)), asked.nearest))
    found = asked.nearest is not None
    return SmallestFailure(
        found=found,
        design_point=asked.nearest,
        distance=path[-1].distance if found else math.inf,
        limit_state=math.nan,
        evaluations=asked.evaluations,
        path=tuple(path),
        independent=n,
        upper_bound=proportion(failures, n, confidence=0.9, method="exact").high,
        reason="",
    )
