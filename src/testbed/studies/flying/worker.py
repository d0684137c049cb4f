"""A worker process: it reads tasks from one pipe and writes results to another. It may crash or hang without harm to others.

`python -m testbed.studies.flying.worker READ WRITE` is the process, with the file descriptors of the two pipes; `Child` is
its handle in the parent. multiprocessing's pool is not used, because it waits for ever if one of its processes is killed,
and because a Dask worker may not start one.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
from multiprocessing.connection import Connection
from typing import IO

from testbed.common.child import command, environment, signal_name
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.drawing.builder import Task
from testbed.studies.flying.flight import Job, fly_task, not_flown
from testbed.studies.record import Flown

_START_S = 300.0
"""Longest time a process may take to start [s]."""
_GRACE_S = 10.0
"""If its parent is gone, a process ends itself this long after the time limit of its flight [s]."""
_STARTS = 4
"""Attempts at starting a process that is killed while it starts."""
_ATTEMPTS = 2
"""Attempts at a flight whose process dies. It may have died for another reason than the flight, such as a lack of memory."""


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
        self._to.close()
        self._from.close()
        return process.wait()

    def _attempt(self, task: Task) -> Flown | None:
        limit = self._job.time_limit_s
        try:
            self._to.send(task)
            if self._from.poll(limit):
                flown: Flown = self._from.recv()
                return flown
        except (EOFError, OSError):
            return None
        if self._process is not None:
            self._process.kill()
        self.kill()
        return not_flown(task, "timeout", f"no result within {limit:g} s")

    def _start(self) -> None:
        """Have a process that is ready; one that a signal ends while it starts is replaced. Raises as `fly` does."""
        if self._process is not None and self._process.poll() is None:
            return
        status: int | None = 0
        for _ in range(_STARTS):
            self.kill()
            status, words = self._started()
            if status is None:
                return
            if self._closed.is_set():
                raise InterruptedError("closed")
            if status >= 0:
                break  # it ended by itself, and would do so again
        lines = words.decode(errors="replace").strip().splitlines()
        reason = lines[-1] if lines else f"it was ended by {_cause(status or 0)}"
        raise BadInput([Problem(f"a worker process does not start: {reason}")])

    def _started(self) -> tuple[int | None, bytes]:
        """Start a process. Returns (None, b"") when it is ready, else its exit status and what it wrote to stderr."""
        if self._closed.is_set():
            return 0, b""
        theirs_in, ours_out = os.pipe()
        ours_in, theirs_out = os.pipe()
        self._to, self._from = Connection(ours_out, readable=False), Connection(ours_in, writable=False)
        with _scratch_file() as words:
            self._process = subprocess.Popen(
                command("testbed.studies.flying.worker", str(theirs_in), str(theirs_out)),
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=words,
                pass_fds=(theirs_in, theirs_out), env=environment(), close_fds=True,
            )  # fmt: skip
            os.close(theirs_in)
            os.close(theirs_out)
            if self._closed.is_set():  # meanwhile
                self._process.kill()
            with contextlib.suppress(EOFError, OSError):
                self._to.send_bytes(pickle.dumps(self._job))
                if self._from.poll(_START_S) and self._from.recv():
                    return None, b""
            status = self.kill()
            words.seek(0)
            return status, words.read()


def _scratch_file() -> IO[bytes]:
    """A file for what a process writes; /dev/null, so without its words, where no file can be made."""
    try:
        return tempfile.TemporaryFile()
    except OSError:
        return open(os.devnull, "w+b")


def _cause(status: int) -> str:
    if status >= 0:
        return f"exit status {status}"
    name = signal_name(-status)
    return name if name == f"signal {-status}" else f"signal {-status} ({name})"


def main(read: int, write: int) -> None:
    """The worker process: fly one task after the other, until the pipe closes. `read` and `write` are file descriptors."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent handles Ctrl-C, and closes the pipe
    tasks, answers = Connection(read, writable=False), Connection(write, readable=False)
    job: Job = pickle.loads(tasks.recv_bytes())
    sys.path += [entry for entry in job.search_path if entry not in sys.path]
    answers.send(True)
    while True:
        try:
            task = tasks.recv()
        except EOFError:
            return
        # A timer of the operating system ends a hung process even if its parent is gone.
        signal.setitimer(signal.ITIMER_REAL, job.time_limit_s + _GRACE_S)
        flown = fly_task(job, task)
        signal.setitimer(signal.ITIMER_REAL, 0)
        try:
            answers.send(flown)
        except BrokenPipeError:
            return


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
