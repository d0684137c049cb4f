"""Fly many flights at once: by processes of this machine, or by a Dask cluster. Each flight waits in a thread of the parent."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import AbstractContextManager, contextmanager
from itertools import islice

from testbed.studies.drawing.builder import Task
from testbed.studies.flying.cluster import Connection
from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.flying.worker import Children
from testbed.studies.record import Flown

FlyAll = Callable[[Iterable[Task]], Iterator[Flown]]
"""Flies every task; yields each as it finishes, in any order. Tasks are taken as there is room, in the caller's thread."""
Workers = Callable[[Job, int | None, str | None], AbstractContextManager[FlyAll]]
"""What flies a job, for as long as a block lasts: `workers`, or `serial`."""

MOST_JOBS = 1000
"""Most processes of one machine: each takes 250 MB and a thread of the parent's."""


def default_jobs() -> int:
    """Number of cores that this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def workers(job: Job, jobs: int | None = None, cluster: str | None = None) -> Iterator[FlyAll]:
    """What flies tasks in `jobs` processes or on the cluster at this address, until the end of the block.

    The processes start when they are needed, and stay for further tasks. Raises BadInput when they cannot fly.
    """
    there = Children(job, jobs or default_jobs()) if cluster is None else Connection(job, cluster)
    threads = ThreadPoolExecutor(there.most, "flight")
    try:
        yield lambda tasks: _fly_all(threads, there, tasks)
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        there.close()
        threads.shutdown()


@contextmanager
def serial(job: Job, jobs: int | None = None, cluster: str | None = None) -> Iterator[FlyAll]:
    """As `workers`, one flight after the other in this process, which a flight may then end."""
    yield lambda tasks: (fly_task(job, task) for task in tasks)


def _fly_all(
    threads: ThreadPoolExecutor, there: Children | Connection, tasks: Iterable[Task]
) -> Iterator[Flown]:
    feed = iter(tasks)
    flying: set[Future[Flown]] = set()
    while True:
        for task in islice(feed, max(0, there.room() - len(flying))):
            flying.add(threads.submit(there.fly, task))
        if not flying:
            return
        for future in wait(flying, return_when=FIRST_COMPLETED).done:
            flying.remove(future)
            yield future.result()
