"""Fly many flights at once: by processes of this machine, or by a Dask cluster. Each flight waits in a thread of the parent.

A cluster's workers need only this package: everything else is sent with each task. Every flight runs in a child process of a Dask
worker, so that crashes and hangs give the same rows as on one machine. When a Dask worker dies, the scheduler gives its tasks to
another.
"""

from __future__ import annotations

import asyncio
import logging
import os
import pickle
import tempfile
import threading
import zlib
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import replace
from functools import lru_cache
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.aircraft.changes import name_in
from testbed.aircraft.description import load_aircraft
from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Problem
from testbed.scenario.load import placed_name
from testbed.studies.drawing.builder import Task
from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.flying.worker import Children
from testbed.studies.record import Flown

if TYPE_CHECKING:
    from distributed import Future as FarFuture


FlyAll = Callable[[Iterable[Task]], Iterator[Flown]]
"""Flies every task; yields each as it finishes, in any order. Tasks are taken as there is room, in the caller's thread."""
Workers = Callable[[Job, int | None, str | None], AbstractContextManager[FlyAll]]
"""What flies a job, for as long as a block lasts: `workers`, or `serial`."""

MOST_JOBS = 1000
"""Most processes of one machine: each takes 250 MB and a thread of the parent's."""
_ANSWER_S = 8
"""Longest time in which a cluster must answer [s]."""
_NO_DASK = Problem("--cluster needs dask.distributed", expected="pip install 'testbed[cluster]'")
_AHEAD = 3
"""Tasks sent ahead for each thread of the cluster, so that none waits for work."""
_TRIES = 5
"""How often a flight is sent at most if its Dask workers die."""
_WITHOUT_S = 600.0
"""Longest time in which a cluster may be without any worker [s]: they come and go, but a dead one is not waited for all night."""
_LOOK_S = 5.0
"""How often it is asked for its workers while nothing comes back [s]."""
_OWN = "own controllers"
"""Folder of the users' controllers among the unpacked files, with a folder for each."""
_PARTS = "own parts"
"""The same of the users' parts."""


def default_jobs() -> int:
    """Number of cores that this process may run on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def workers(job: Job, jobs: int | None = None, cluster: str | None = None) -> Iterator[FlyAll]:
    """What flies tasks in `jobs` processes or on the cluster at this address, until the end of the block.

    The processes start when they are needed, and stay for further tasks. Raises BadInput when they cannot fly.
    """
    there = Children(job, jobs or default_jobs()) if cluster is None else Cluster(job, cluster)
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
    threads: ThreadPoolExecutor, there: Children | Cluster, tasks: Iterable[Task]
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


def pack(job: Job) -> bytes:
    """A job with every file of its aircraft's folder, and the code of the user's controllers, compressed."""
    base = job.builder.base
    folder = load_aircraft(placed_name(name_in(base.tree["aircraft"]), base.file)).folder
    files = sorted(f for f in folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)
    contents = {
        str(Path(_OWN, name, file)): code for name, own in job.builder.own.items() for file, code in own.code
    }
    contents |= {
        str(Path(_PARTS, parts.name, file)): code for parts in job.parts for file, code in parts.code
    }
    contents |= {str(file.relative_to(folder.parent)): file.read_bytes() for file in files}
    return zlib.compress(pickle.dumps((job, folder.name, contents)))


def refuse_dead(address: str, within_s: float | None = None) -> None:
    """Raise BadInput when no Dask cluster answers at an address; before anything is written.

    Args:
        within_s: how long to wait for an answer [s], as for a cluster that starts; by default 8 s.
    """
    wait_s = _ANSWER_S if within_s is None else within_s
    try:
        from distributed import rpc
    except ImportError:
        raise BadInput([_NO_DASK]) from None

    async def answer() -> None:
        async with rpc(address, timeout=wait_s) as scheduler:
            await asyncio.wait_for(scheduler.identity(), wait_s)

    try:
        with ThreadPoolExecutor(1) as beside:  # a notebook has a loop of its own in this thread
            beside.submit(asyncio.run, answer()).result()
    except (OSError, ValueError) as error:
        raise _dead(address, error, wait_s) from None


def _dead(address: str, error: Exception, wait_s: float) -> BadInput:
    what = f"no cluster answers at {address}: {str(error) or f'no answer within {wait_s:g} s'}"
    expected = "the address that `dask scheduler` prints, as tcp://host:8786"
    return BadInput([Problem(what, "--cluster", expected=expected)])


class Cluster:
    """A job at a cluster, as `Children` are one on this machine; raises BadInput when none answers."""

    most = 1000
    """Most flights that wait for the cluster at a time, each in a thread."""

    def __init__(self, job: Job, address: str) -> None:
        refuse_dead(address)
        from distributed import Client

        self._packed, self._address, self._quiet = pack(job), address, ExitStack()
        for each in _printing():
            each.addFilter(_silent)
            self._quiet.callback(each.removeFilter, _silent)
        try:
            self._client = Client(address, timeout=_ANSWER_S, set_as_default=False)
        except (OSError, ValueError) as error:
            self._quiet.close()
            raise _dead(address, error, _ANSWER_S) from None

    def room(self) -> int:
        """How many flights to send before the first has returned."""
        return _AHEAD * max(1, sum(self._client.nthreads().values()))

    def fly(self, task: Task) -> Flown:
        """Fly one task there, again where that may help, as when its Dask worker died or its result was lost.

        Raises BadInput when the cluster fails, or its workers cannot fly.
        """
        for _ in range(_TRIES):
            future = self._client.submit(fly_packed, self._packed, task, pure=False, retries=0)
            try:
                return self._result(future)
            except BadInput:
                raise
            except Exception as error:
                words = f"{type(error).__name__}: {error}"
            except asyncio.CancelledError:  # no Exception
                words = str(future.status)
            if self._client.status != "running":
                words = "the connection was lost"
                break
        raise BadInput([Problem(f"the cluster at {self._address} failed: {words}")])

    def _result(self, future: FarFuture) -> Flown:
        """What a flight returns; raises BadInput when the cluster is without workers for too long."""
        without_s = 0.0
        while True:
            try:
                return future.result(_LOOK_S)
            except TimeoutError:
                if future.done():
                    raise
                without_s = 0.0 if self._client.nthreads() else without_s + _LOOK_S
                if without_s >= _WITHOUT_S:
                    what = f"the cluster at {self._address} has had no worker for {_WITHOUT_S:g} s"
                    raise BadInput([Problem(what)]) from None

    def close(self) -> None:
        """Leave the cluster; what is being flown there is lost."""
        self._client.close()
        self._quiet.close()


def _printing() -> Iterator[logging.Filterer]:
    """What prints Dask's tracebacks when a scheduler dies: its loggers, and what they write by."""
    for name in ("distributed", "distributed.client", "tornado.application", "asyncio"):
        logger = logging.getLogger(name)
        yield from (logger, *logger.handlers)


def _silent(_: logging.LogRecord) -> bool:
    """A filter that lets nothing through: what a cluster's failure means is said in a sentence."""
    return False


def fly_packed(packed: bytes, task: Task) -> Flown:
    """On a Dask worker: fly one task in a child process, which then waits for the next task of the same study."""
    with _lock:
        children, _folder = _children(packed)
    return children.fly(task)


_lock = threading.Lock()


@lru_cache(maxsize=1)
def _children(packed: bytes) -> tuple[Children, tempfile.TemporaryDirectory[str]]:
    """The processes that fly a study, with the folder of its files. Both end when nothing refers to them any longer."""
    job, name, files = pickle.loads(zlib.decompress(packed))
    folder = tempfile.TemporaryDirectory(prefix="testbed-", ignore_cleanup_errors=True)
    for file, content in files.items():
        write(Path(folder.name, file), content, within=Path(folder.name))
    own = {name: each.unpacked(Path(folder.name, _OWN, name)) for name, each in job.builder.own.items()}
    builder = replace(job.builder.with_aircraft(str(Path(folder.name, name))), own=own)
    parts = tuple(each.sent(Path(folder.name, _PARTS, each.name)) for each in job.parts)
    return Children(replace(job, builder=builder, parts=parts, search_path=())), folder
