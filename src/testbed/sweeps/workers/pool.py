"""Worker processes on this machine. Each has its own thread in the parent, so that none waits for a slow or hung one."""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Generator, Iterable

from testbed.sweeps.drawing.builder import Task
from testbed.sweeps.workers.flying import Flown, Job
from testbed.sweeps.workers.worker import Child

Done = tuple[Task, Flown]
"""A task, and what is kept of its flight."""

MOST_JOBS = 1000
"""Most processes of one machine: each takes 250 MB and a thread of the parent's."""


def default_jobs() -> int:
    """Number of cores that this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def fly_locally(job: Job, tasks: Iterable[Task], jobs: int | None = None) -> Generator[Done, None, None]:
    """Fly every task in `jobs` processes; yields each as it finishes. Closing the generator ends the processes."""
    feed = _Feed(tasks)
    done: queue.Queue[Done | BaseException | None] = queue.Queue(maxsize=64)
    children = [Child(job) for _ in range(jobs or default_jobs())]
    threads = [threading.Thread(target=_tend, args=(child, feed, done), daemon=True) for child in children]
    for thread in threads:
        thread.start()
    try:
        working = len(threads)
        while working:
            item = done.get()
            if item is None:
                working -= 1
            elif isinstance(item, BaseException):
                raise item
            else:
                yield item
    finally:
        feed.stop()
        for child in children:
            child.close()
        while any(thread.is_alive() for thread in threads):  # a thread may be waiting for room in the queue
            try:
                done.get(timeout=0.05)
            except queue.Empty:
                continue
        for child in children:
            child.kill()


class _Feed:
    """Gives tasks to several threads, one at a time."""

    def __init__(self, tasks: Iterable[Task]) -> None:
        self._tasks = iter(tasks)
        self._lock = threading.Lock()
        self._stopped = False

    def next(self) -> Task | None:
        with self._lock:
            return None if self._stopped else next(self._tasks, None)

    def stop(self) -> None:
        with self._lock:
            self._stopped = True


def _tend(child: Child, feed: _Feed, done: queue.Queue[Done | BaseException | None]) -> None:
    try:
        while (task := feed.next()) is not None:
            done.put((task, child.fly(task)))
        done.put(None)
    except InterruptedError:
        done.put(None)
    except BaseException as error:
        done.put(error)
