"""Fly batches with the sweeps' workers: processes that stay for the whole search, or a Dask cluster."""

from __future__ import annotations

import queue
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import closing, contextmanager
from typing import Protocol

from testbed.sweeps.drawing.builder import Task
from testbed.sweeps.run import Options
from testbed.sweeps.workers import cluster
from testbed.sweeps.workers.flying import Job
from testbed.sweeps.workers.pool import Done, default_jobs
from testbed.sweeps.workers.worker import Child


class Flying(Protocol):
    """What flies batches."""

    def fly(self, tasks: Sequence[Task]) -> Iterable[Done]:
        """Fly these tasks; yields each as it finishes, in any order."""
        ...


class Workers:
    """Flies one batch after the other. On this machine the processes wait for the next batch, each with a thread of its own."""

    def __init__(self, job: Job, options: Options) -> None:
        self._job, self._cluster = job, options.cluster
        self._children = [Child(job) for _ in range(options.jobs or default_jobs())]
        self._idle: queue.LifoQueue[Child] = queue.LifoQueue()
        for child in self._children:
            self._idle.put(child)
        self._threads = ThreadPoolExecutor(len(self._children))

    def fly(self, tasks: Sequence[Task]) -> Iterator[Done]:
        """Fly these tasks; yields each as it finishes, in any order. Raises BadInput when the workers cannot fly."""
        if self._cluster is not None:
            with closing(cluster.fly_on_cluster(self._job, tasks, self._cluster)) as flying:
                yield from flying
        else:
            for future in as_completed([self._threads.submit(self._fly, task) for task in tasks]):
                yield future.result()

    def _fly(self, task: Task) -> Done:
        child = self._idle.get()
        try:
            return task, child.fly(task)
        finally:
            self._idle.put(child)

    def close(self) -> None:
        """End the processes at once."""
        for child in self._children:
            child.close()
        self._threads.shutdown(cancel_futures=True)
        for child in self._children:
            child.kill()


@contextmanager
def workers(job: Job, options: Options) -> Iterator[Workers]:
    """Workers that are ended with the block."""
    made = Workers(job, options)
    try:
        yield made
    finally:
        made.close()
