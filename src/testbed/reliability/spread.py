"""A limit state whose values are computed by several processes, or by a cluster: in pieces, whose order is kept."""

from __future__ import annotations

import multiprocessing
import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any

import numpy as np

from testbed.inputs.problems import BadInput, Problem
from testbed.reliability.limit_state import LimitState

_PIECES = 4
"""Pieces for each process, so that none is idle while another has a long one."""


@contextmanager
def spread(limit_state: LimitState, jobs: int | None = None, client: Any = None) -> Iterator[LimitState]:
    """The limit state, for a block, with each batch spread; arguments as of `failure_probability`."""
    if jobs is not None and client is not None:
        raise BadInput(
            [Problem("are for this machine, and a client is given", "jobs", expected="one of them")]
        )
    if jobs is not None and (isinstance(jobs, bool) or not isinstance(jobs, int) or jobs < 1):
        raise BadInput([Problem(f"is {jobs!r}", "jobs", expected="a whole number from 1 on")])
    if client is not None:
        workers = max(1, sum(client.nthreads().values()))
        yield _pieces(lambda parts: client.gather(client.map(limit_state, parts, pure=False)), workers)
    elif jobs is None:
        yield limit_state
    else:
        _refuse_unsendable(limit_state)
        with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
            yield _pieces(lambda parts: list(pool.map(limit_state, parts)), jobs)


def _refuse_unsendable(limit_state: LimitState) -> None:
    """Raise BadInput for a function that another process cannot import."""
    try:
        pickle.dumps(limit_state)
    except Exception as error:
        what = f"cannot be sent to another process: {error}"
        raise BadInput([Problem(what, "limit_state", expected="a function at the top of a module")]) from None


def _pieces(called: Callable[[list[np.ndarray]], list[Any]], workers: int) -> LimitState:
    def values(points: np.ndarray) -> np.ndarray:
        parts = np.array_split(points, min(len(points), _PIECES * workers) or 1)
        try:
            found = called(parts)
        except BrokenProcessPool as error:
            expected = "one that runs in other processes, and a script with `if __name__ == '__main__':`"
            raise BadInput(
                [Problem(f"ended its process: {error}", "limit_state", expected=expected)]
            ) from None
        shapes = [np.shape(piece) for piece in found]
        if shapes != [(len(part),) for part in parts]:
            expected = "one number for each point"
            raise BadInput(
                [Problem(f"returned arrays of shapes {shapes[:3]}", "limit_state", expected=expected)]
            )
        return np.concatenate([np.asarray(piece, dtype=float) for piece in found])

    return values
