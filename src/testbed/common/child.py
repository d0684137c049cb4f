"""Child processes of this package, for work that may end its process, never return, or take all memory.

`ask` runs a module in a child and returns its answers and how it ended. The module calls `answer`. The child is no copy of the
process that starts it, so a script needs no `__main__` guard.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import resource
import select
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NoReturn

Answer = dict[str, Any]
"""What JSON can hold."""

_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
_PATIENCE = 12
"""A child is waited for this many times its processor time: a busy machine slows it, and it might wait itself."""
_OUT_OF_TIME = -signal.SIGXCPU
"""Exit status of a process that has used up its processor time."""


@dataclass(frozen=True)
class Limits:
    """What a child may use. Its time is counted on the processor: time on the clock depends on what else the machine does."""

    processor_s: int
    memory_bytes: int = 4_000_000_000
    writes_files: bool = True


@dataclass(frozen=True)
class Ended:
    """How a child ended: what it answered, what it wrote to stderr, and its exit status, negative for a signal."""

    answers: tuple[Answer, ...] = ()
    errors: str = ""
    status: int = 0
    overtime: str = ""
    """The time within which it did not end, such as `10 s of processor time`; empty if it ended by itself."""

    @property
    def last(self) -> Answer:
        """The last answer; empty if there is none."""
        return self.answers[-1] if self.answers else {}

    @property
    def signal(self) -> str:
        """The name of the signal that ended it; empty if none did."""
        return signal_name(-self.status) if self.status < 0 else ""


def ask(module: str, request: object, limits: Limits) -> Ended:
    """What a module of this package answers to a request in a child, in an empty folder; raises OSError if none can be started."""
    longest_s = _PATIENCE * limits.processor_s
    held, lifeline = os.pipe()  # the child's end of the second sees the end of this process
    asked = {"request": request, "limits": asdict(limits), "lifeline": held}
    try:
        with tempfile.TemporaryDirectory() as empty:  # modules beside the user's files are not imported
            done = subprocess.run(
                command(module, may_write=limits.writes_files), input=json.dumps(asked), capture_output=True, text=True,
                errors="replace", timeout=longest_s, cwd=empty, env=environment(), pass_fds=(held,), check=False,
            )  # fmt: skip
    except subprocess.TimeoutExpired:
        return Ended(overtime=f"{longest_s:g} s")
    finally:
        os.close(held)
        os.close(lifeline)
    used_up = done.returncode == _OUT_OF_TIME
    overtime = f"{limits.processor_s:g} s of processor time" if used_up else ""
    return Ended(tuple(_answers(done.stdout)), done.stderr, done.returncode, overtime)


def command(module: str, *arguments: str, may_write: bool = True) -> list[str]:
    """The command that runs a module of this package; without `may_write`, Python does not try to keep what it compiles."""
    return [sys.executable, *([] if may_write else ["-B"]), "-m", module, *arguments]


def environment() -> dict[str, str]:
    """The environment of a child: this package first on its path, and one thread for each library, because several would
    compete for the cores."""
    package = str(Path(__file__).resolve().parents[2])
    path = os.pathsep.join(
        dict.fromkeys([package, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))])
    )
    return {**os.environ, **dict.fromkeys(_THREADS, "1"), "PYTHONPATH": path}


def signal_name(number: int) -> str:
    """Name of a signal, or its number where it has none."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def _answers(text: str) -> list[Answer]:
    """The JSON objects among the lines of a child's output; JSBSim may have written others."""
    found = []
    for line in text.splitlines():
        with contextlib.suppress(ValueError):
            found.append(json.loads(line))
    return [line for line in found if isinstance(line, dict)]


# In the child ---------------------------------------------------------------------------------------------------


def answer(function: Callable[[Any], Iterable[Answer]]) -> NoReturn:
    """Answer the request that this process was started for, within its limits, and end it."""
    asked = json.load(sys.stdin)
    _hold_back(Limits(**asked["limits"]))
    end_with_parent(asked["lifeline"])
    for each in function(asked["request"]):
        print(f"\n{json.dumps(each)}", flush=True)  # on a line of its own, whatever JSBSim has written
    os._exit(0)  # at once: JSBSim may abort while it takes a model apart


def _hold_back(limits: Limits) -> None:
    """Keep this process within its limits, and let it leave no core."""
    most = {resource.RLIMIT_CORE: 0, resource.RLIMIT_CPU: limits.processor_s}
    most[resource.RLIMIT_AS] = limits.memory_bytes
    if not limits.writes_files:
        most[resource.RLIMIT_FSIZE] = 0
    for what, limit in most.items():
        _, hard = resource.getrlimit(what)
        lower = limit if hard == resource.RLIM_INFINITY else min(limit, hard)
        # The soft limit sends the signal that tells that time ran out.
        resource.setrlimit(what, (lower, hard))


def end_with_parent(lifeline: int) -> None:
    """Let the operating system end this process as soon as nobody holds the other end of this pipe, whatever it is computing.

    The signal that tells of it, SIGIO, ends a process that does not handle it.
    """
    fcntl.fcntl(lifeline, fcntl.F_SETOWN, os.getpid())
    fcntl.fcntl(lifeline, fcntl.F_SETFL, os.O_ASYNC)
    if select.select([lifeline], [], [], 0)[0]:  # nothing is ever written there: it was closed before
        os._exit(1)
