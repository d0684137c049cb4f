"""Several worker processes, used from several threads: by the pool of this machine, and by a Dask worker."""

from __future__ import annotations

import threading

from testbed.studies.drawing.builder import Task
from testbed.studies.flying.flight import Job
from testbed.studies.flying.worker import Child
from testbed.studies.record import Flown

_AHEAD = 2
"""Tasks taken for each process, so that none waits while a flight is stored."""


class Children:
    """Worker processes for one job, `most` at a time: a flight gets one that is idle, or a new one."""

    def __init__(self, job: Job, most: int = 1) -> None:
        self.job, self.most = job, most
        self._all: list[Child] = []
        self._idle: list[Child] = []
        self._lock = threading.Lock()
        self._closed = False

    def room(self) -> int:
        """How many flights to take before the first has finished."""
        return _AHEAD * self.most

    def fly(self, task: Task) -> Flown:
        """Fly one task, as `Child.fly`."""
        child = self._taken()
        try:
            return child.fly(task)
        finally:
            self._idle.append(child)

    def close(self) -> None:
        """End the processes at once: a flight that is running raises InterruptedError, and so does any that is begun afterwards."""
        with self._lock:
            self._closed = True
        for child in self._all:
            child.close()
        for child in list(self._idle):
            child.kill()

    def _taken(self) -> Child:
        with self._lock:
            if self._closed:
                raise InterruptedError("closed")
            if not self._idle:
                self._all.append(Child(self.job))
                return self._all[-1]
            return self._idle.pop()
