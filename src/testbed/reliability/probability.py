"""`failure_probability`: how likely a limit state is at or below 0, whose values may be computed by several processes."""

from __future__ import annotations

import multiprocessing
import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any

import numpy as np

from testbed.common.random_streams import generator
from testbed.inputs.problems import guess
from testbed.reliability.adaptive import adaptive
from testbed.reliability.importance import importance
from testbed.reliability.limit_state import Asked, LimitState, check, refused
from testbed.reliability.results import FailureProbability
from testbed.reliability.subset import plain, subset

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
        raise refused("method", f"is no method: {method}", *guess(method, TABLE))
    with spread(limit_state, jobs, client) as wherever:
        asked = Asked(wherever, int(dimensions), int(budget))
        return TABLE[method](asked, generator(int(seed), f"reliability {method}"), cov)


_PIECES = 4
"""Pieces for each process, so that none is idle while another has a long one."""


@contextmanager
def spread(limit_state: LimitState, jobs: int | None = None, client: Any = None) -> Iterator[LimitState]:
    """The limit state, for a block, with each batch spread; arguments as of `failure_probability`."""
    if jobs is not None and client is not None:
        raise refused("jobs", "are for this machine, and a client is given", "one of them")
    if jobs is not None and (isinstance(jobs, bool) or not isinstance(jobs, int) or jobs < 1):
        raise refused("jobs", f"is {jobs!r}", "a whole number from 1 on")
    if client is not None:
        workers = max(1, sum(client.nthreads().values()))
        yield _pieces(lambda parts: client.gather(client.map(limit_state, parts, pure=False)), workers)
    elif jobs is None:
        yield limit_state
    else:
        try:
            pickle.dumps(limit_state)
        except Exception as error:
            what = f"cannot be sent to another process: {error}"
            raise refused("limit_state", what, "a function at the top of a module") from None
        with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
            yield _pieces(lambda parts: list(pool.map(limit_state, parts)), jobs)


def _pieces(called: Callable[[list[np.ndarray]], list[Any]], workers: int) -> LimitState:
    def values(points: np.ndarray) -> np.ndarray:
        parts = np.array_split(points, min(len(points), _PIECES * workers) or 1)
        try:
            found = called(parts)
        except BrokenProcessPool as error:
            expected = "one that runs in other processes, and a script with `if __name__ == '__main__':`"
            raise refused("limit_state", f"ended its process: {error}", expected) from None
        shapes = [np.shape(piece) for piece in found]
        if shapes != [(len(part),) for part in parts]:
            what = f"returned arrays of shapes {shapes[:3]}"
            raise refused("limit_state", what, "one number for each point")
        return np.concatenate([np.asarray(piece, dtype=float) for piece in found])

    return values
