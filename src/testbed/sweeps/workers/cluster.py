"""The same flights on a Dask cluster: whatever a flight needs travels with it, workers have only the package.

Every flight runs in a child process of the Dask worker, so that crashes and hangs end in the same rows as at
home. A Dask worker that dies takes no flight along: the scheduler gives its tasks to another.
"""

from __future__ import annotations

import atexit
import hashlib
import itertools
import os
import pickle
import queue
import tempfile
import threading
import zlib
from collections.abc import Generator, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from testbed.aircraft.description import load_aircraft
from testbed.inputs.problems import BadInput, Problem
from testbed.sweeps.drawing.builder import Task
from testbed.sweeps.workers.child import Child
from testbed.sweeps.workers.flying import Flown, Job

_CONNECT_S = 20
_AHEAD = 3
"""Tasks sent for each thread of the cluster: enough to keep it busy, few enough to hold in memory."""
_TRIES = 5
"""How often a flight is sent again whose workers died under it."""


@dataclass(frozen=True)
class Parcel:
    """A sweep's job and its aircraft's files, compressed, with the name of its content."""

    digest: str
    content: bytes


def parcel(job: Job) -> Parcel:
    """Pack a job with every file of its aircraft's folder."""
    folder = load_aircraft(str(job.builder.base.tree["aircraft"])).folder
    files = sorted(f for f in folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)
    packed = {str(file.relative_to(folder.parent)): file.read_bytes() for file in files}
    content = zlib.compress(pickle.dumps((job, folder.name, packed)))
    return Parcel(hashlib.sha256(content).hexdigest()[:32], content)


def fly_on_cluster(
    job: Job, tasks: Iterable[Task], address: str
) -> Generator[tuple[Task, Flown], None, None]:
    """Fly every task on the cluster at this address; yields each as it finishes, in no order.

    Raises BadInput when there is no cluster, it has gone, or its workers cannot fly.
    """
    try:
        from distributed import Client, as_completed
    except ImportError:
        what = "--cluster needs dask.distributed"
        raise BadInput([Problem(what, expected="pip install 'testbed[cluster]'")]) from None
    try:
        client = Client(address, timeout=_CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise BadInput([Problem(f"no cluster answers at {address}: {error}")]) from None
    sent = parcel(job)
    feed = iter(tasks)
    with client:
        pending = {_submit(client, sent, task): (task, 1) for task in itertools.islice(feed, _room(client))}
        completed = as_completed(list(pending), loop=client.loop)
        for future in completed:
            task, tries = pending.pop(future)
            if future.status == "finished":
                yield task, future.result()
                following = list(itertools.islice(feed, max(0, _room(client) - len(pending))))
                again = [(_submit(client, sent, t), (t, 1)) for t in following]
            else:
                _explain(future, tries, address)
                again = [(_submit(client, sent, task), (task, tries + 1))]
            for new, sent_again in again:
                pending[new] = sent_again
                completed.add(new)


def _submit(client: Any, sent: Parcel, task: Task) -> Any:
    return client.submit(fly_parcel, sent, task, pure=False, retries=0)


def _room(client: Any) -> int:
    return _AHEAD * max(1, sum(client.nthreads().values()))


def _explain(future: Any, tries: int, address: str) -> None:
    """Raise unless sending the flight again may help: its worker died, or its data was lost."""
    if future.status == "error":
        error = future.exception()
        if isinstance(error, BadInput):
            raise error
        words = f"{type(error).__name__}: {error}"
    else:
        words = future.status  # cancelled or lost
    if future.client.status != "running" or tries >= _TRIES:
        raise BadInput([Problem(f"the cluster at {address} failed: {words}")])


def fly_parcel(sent: Parcel, task: Task) -> Flown:
    """On a worker: fly one task in a child process, kept for the next task of the same sweep."""
    crew = _crew(sent)
    child = crew.take()
    try:
        return child.fly(task)
    finally:
        crew.idle.put(child)


@dataclass
class _Crew:
    """The child processes of a Dask worker for one sweep."""

    job: Job
    idle: queue.LifoQueue[Child] = field(default_factory=queue.LifoQueue)

    def take(self) -> Child:
        try:
            return self.idle.get_nowait()
        except queue.Empty:
            return Child(self.job)

    def dismiss(self) -> None:
        while not self.idle.empty():
            self.idle.get_nowait().close()


_crews: dict[str, _Crew] = {}
_crews_lock = threading.Lock()


def _crew(sent: Parcel) -> _Crew:
    with _crews_lock:
        if sent.digest not in _crews:
            for old in _crews.values():  # an earlier sweep's
                old.dismiss()
            _crews.clear()
            _crews[sent.digest] = _Crew(_unpack(sent))
        return _crews[sent.digest]


def _unpack(sent: Parcel) -> Job:
    """The job, its aircraft in a folder named by its content; another process may unpack the same at once."""
    job, name, files = pickle.loads(zlib.decompress(sent.content))
    root = Path(tempfile.gettempdir()) / f"testbed-{os.getuid()}-{sent.digest}"
    if not root.is_dir():
        partial = Path(tempfile.mkdtemp(prefix="testbed-unpacking-"))
        for file, content in files.items():
            (partial / file).parent.mkdir(parents=True, exist_ok=True)
            (partial / file).write_bytes(content)
        try:
            partial.rename(root)
        except OSError:  # the other was first
            if not root.is_dir():
                raise
    return Job(
        builder=job.builder.with_aircraft(str(root / name)),
        fly=job.fly,
        save_logs=job.save_logs,
        time_limit_s=job.time_limit_s,
        search_path=(),
    )


@atexit.register
def _dismiss_all() -> None:
    for crew in _crews.values():
        crew.dismiss()
