"""Worker processes: each reads tasks from a pipe and writes results to it. One may crash or hang without harm to others.

`python -m testbed.studies.flying.worker PIPE LIFELINE` is such a process, with the file descriptors of that pipe and of one that
ends it with its parent; `Child` is its handle there, and `Children` are several. multiprocessing's pool is not used, because it
waits for ever if one of its processes is killed, and because a Dask worker may not start one.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import platform
import signal
import subprocess
import sys
import tempfile
import threading
from dataclasses import replace
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from typing import IO

from testbed.common import arithmetic
from testbed.common.child import command, end_with_parent, environment, signal_name
from testbed.inputs.problems import BadInput, Problem
from testbed.parts import take
from testbed.studies.drawing.builder import Task
from testbed.studies.flying.flight import Job, fly_task, not_flown
from testbed.studies.record import MIXED, Flown

_START_S = 300.0
"""Longest time a process may take to start [s]."""
_SLICE_S = 1.0
"""Longest single wait for a flight [s]: as much counts of a time in which the whole program was stopped."""
_STARTS = 4
"""Attempts at starting a process that is killed while it starts."""
_ATTEMPTS = 2
"""Attempts at a flight whose process dies. It may have died for another reason than the flight, such as a lack of memory."""
_AHEAD = 2
"""Tasks taken for each process, so that none waits while a flight is stored."""


class Child:
    """One worker process, started when it is first needed, and again after it has died."""

    def __init__(self, job: Job) -> None:
        self._job = job
        self._process: subprocess.Popen[bytes] | None = None
        self._closed = threading.Event()

    def fly(self, task: Task) -> Flown:
        """Fly one task. If the flight hangs or ends the process, the result is a record with the reason.

        Raises BadInput when no process can be started, InterruptedError when `close` is called meanwhile.
        """
        died = 0
        for _ in range(_ATTEMPTS):
            self._start()
            flown = self._attempt(task)
            if flown is not None:
                return flown
            died = self.kill()
            if self._closed.is_set():
                raise InterruptedError("closed while flying")
        return not_flown(task, "crashed", f"the process was ended by {_cause(died)}")

    def close(self) -> None:
        """End the process at once; a call of `fly` in another thread then raises InterruptedError."""
        self._closed.set()
        if self._process is not None:
            self._process.kill()

    def kill(self) -> int:
        """End the process and return its exit status, negative for a signal."""
        process, self._process = self._process, None
        if process is None:
            return 0
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(1.0)  # if the process is ending by itself, its own exit status says why
        process.kill()
        self._pipe.close()
        self._lifeline.close()
        return process.wait()

    def _attempt(self, task: Task) -> Flown | None:
        left_s = self._job.time_limit_s
        try:
            self._pipe.send(task)
            while left_s > 0.0:
                if self._pipe.poll(min(left_s, _SLICE_S)):
                    return self._pipe.recv()
                left_s -= _SLICE_S
        except (EOFError, OSError):
            return None
        if self._process is not None:
            self._process.kill()
        self.kill()
        return not_flown(task, "timeout", f"no result within {self._job.time_limit_s:g} s")

    def _start(self) -> None:
        """Have a process that is ready; one that a signal ends while it starts is replaced. Raises as `fly` does."""
        if self._process is not None and self._process.poll() is None:
            return
        reason, status = "", -1
        for _ in range(_STARTS):
            self.kill()
            with _scratch_file() as words:
                try:
                    if self._started(words):
                        return
                    status = self.kill()
                    reason = _last_line(words) or f"it was ended by {_cause(status)}"
                except OSError as error:  # no further process or file is allowed
                    reason, status = error.strerror or str(error), 0
            if self._closed.is_set():
                raise InterruptedError("closed")
            if status >= 0:
                break  # it ended by itself, and would do so again
        raise BadInput([Problem(f"a worker process does not start: {reason}")])

    def _started(self, words: IO[bytes]) -> bool:
        """Start a process that writes its words to this file; whether it got ready. Raises BadInput when it is unlike."""
        self._pipe, theirs = Pipe()
        held, self._lifeline = Pipe(duplex=False)
        with theirs, held:
            given = theirs.fileno(), held.fileno()
            self._process = subprocess.Popen(
                command("testbed.studies.flying.worker", *map(str, given)), pass_fds=given, env=environment(),
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=words,
            )  # fmt: skip
        if self._closed.is_set():  # meanwhile
            self._process.kill()
        with contextlib.suppress(EOFError, OSError):
            self._pipe.send_bytes(pickle.dumps(self._job))
            if not self._pipe.poll(_START_S):
                return False
            other: str = self._pipe.recv()
            if other and not self._job.mixed:
                what = f"a worker on {platform.node()} is unlike where the study was begun, with {other}"
                raise BadInput([Problem(what, expected=MIXED)])
            return True
        return False


class Children:
    """Worker processes for one job, `most` at a time: a flight gets one that is idle, or a new one. Used from several threads."""

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


def _scratch_file() -> IO[bytes]:
    """A file for what a process writes; /dev/null, so without its words, where no file can be made."""
    try:
        return tempfile.TemporaryFile()
    except OSError:
        return open(os.devnull, "w+b")


def _last_line(words: IO[bytes]) -> str:
    words.seek(0)
    return next(reversed(words.read().decode(errors="replace").strip().splitlines()), "")


def _cause(status: int) -> str:
    if status >= 0:
        return f"exit status {status}"
    name = signal_name(-status)
    return name if name == f"signal {-status}" else f"signal {-status} ({name})"


def main(pipe: int, lifeline: int) -> None:
    """The worker process: fly one task after the other, until the pipes with these file descriptors close."""
    end_with_parent(lifeline)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)  # the parent handles them, and closes the pipe
    parent = Connection(pipe)
    job: Job = pickle.loads(parent.recv_bytes())
    sys.path += [entry for entry in job.search_path if entry not in sys.path]
    take(job.parts)
    other = "; ".join(arithmetic.differences(job.environment, arithmetic.environment()))
    parent.send(other)
    with contextlib.suppress(EOFError, OSError):  # the parent is gone
        while True:
            flown = fly_task(job, parent.recv())
            parent.send(replace(flown, record=replace(flown.record, environment=other)))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
