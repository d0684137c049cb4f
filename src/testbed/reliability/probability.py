"""`failure_probability`: how likely a limit state is at or below 0."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from testbed.common.random_streams import generator
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.reliability.adaptive import adaptive
from testbed.reliability.importance import importance
from testbed.reliability.limit_state import Asked, LimitState, check
from testbed.reliability.plain import plain
from testbed.reliability.results import FailureProbability
from testbed.reliability.spread import spread
from testbed.reliability.subset import subset

Method = Callable[[Asked, np.random.Generator, float], FailureProbability]

TABLE: dict[str, Method] = {
    "subset": subset,
    "importance": importance,
    "adaptive": adaptive,
    "plain": plain,
}

MOST_DIMENSIONS = 10_000


def failure_probability(
    limit_state: LimitState,
    dimensions: int,
    *,
    seed: int = 0,
    cov: float = 0.3,
    budget: int = 4000,
    method: str = "importance",
    jobs: int | None = None,
    client: Any = None,
) -> FailureProbability:
    """Probability that `limit_state` is at or below 0 when its inputs are independent standard normals.

    `method` is `importance` (subset simulation to find the failures, then importance sampling about the nearest of them
    where that can be trusted), `adaptive` (the same about all failures, from mixtures fitted to them), `subset` (subset
    simulation alone) or `plain` (independent draws).

    `limit_state` takes an array [n, dimensions] and returns [n] values. It is called until the coefficient of variation of
    the estimate is at most `cov`, or `budget` evaluations are spent. The result says which, and has a 95 % interval. The
    same seed and the same values of the limit state give the same batches and the same result.

    `jobs` processes of this machine compute each batch in pieces, or the workers of `client`, a `distributed.Client`. Then
    the limit state is a function at the top of a module that they can import. The result does not depend on their number.

    Raises BadInput for arguments that cannot be used, and for a limit state that returns anything but [n] numbers.
    """
    check(limit_state, MOST_DIMENSIONS, dimensions=dimensions, seed=seed, cov=cov, budget=budget)
    if method not in TABLE:
        expected, suggestion = guess(method, TABLE)
        raise BadInput(
            [Problem(f"is no method: {method}", "method", expected=expected, suggestion=suggestion)]
        )
    with spread(limit_state, jobs, client) as wherever:
        asked = Asked(wherever, int(dimensions), int(budget))
        return TABLE[method](asked, generator(int(seed), f"reliability {method}"), cov)
