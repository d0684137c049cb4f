"""Fly a sweep on a Dask cluster. Its workers need only this package: everything else is sent with each task.

Every flight runs in a child process of a Dask worker, so that crashes and hangs give the same rows as on one machine.
When a Dask worker dies, the scheduler gives its tasks to another.
"""

from __future__ import annotations

import atexit
import hashlib
import itertools
import os
import pickle
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
import zlib
from collections.abc import Generator, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from testbed.aircraft.changes import name_in
from testbed.aircraft.description import load_aircraft
from testbed.inputs.problems import BadInput, Problem
from testbed.scenario.load import placed_name
from testbed.sweeps.drawing.builder import Task
from testbed.sweeps.workers.flying import Flown, Job
from testbed.sweeps.workers.worker import Child

_CONNECT_S = 5
_ANSWER_S = 8
"""Longest time in which a cluster must answer `refuse_dead` [s], with the start of its process."""
_TRY = """
import os, sys
try:
    from distributed import Client
    Client(sys.argv[1], timeout=float(sys.argv[2]), set_as_default=False)
except ImportError:
    os._exit(2)
except BaseException as error:
    print(error, flush=True)
    os._exit(1)
os._exit(0)
"""
_NO_DASK = Problem("--cluster needs dask.distributed", expected="pip install 'testbed[cluster]'")
_AHEAD = 3
"""Tasks sent ahead for each thread of the cluster, so that none waits for work."""
_TRIES = 5
"""How often a flight is sent at most if its Dask workers die."""


_OWN = "own controllers"
"""Folder of the users' controllers among the unpacked files, with a folder for each."""


@dataclass(frozen=True)
class PackedJob:
    """A sweep's job with the files of its aircraft, compressed; `digest` identifies the content."""

    digest: str
    content: bytes


def pack(job: Job) -> PackedJob:
    """Pack a job with every file of its aircraft's folder, and the code of the user's controllers."""
    base = job.builder.base
    folder = load_aircraft(placed_name(name_in(base.tree["aircraft"]), base.file)).folder
    files = sorted(f for f in folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)
    contents = {
        str(Path(_OWN, name, file)): code for name, own in job.builder.own.items() for file, code in own.code
    }
    contents |= {str(file.relative_to(folder.parent)): file.read_bytes() for file in files}
    content = zlib.compress(pickle.dumps((job, folder.name, contents)))
    return PackedJob(hashlib.sha256(content).hexdigest()[:32], content)


def refuse_dead(address: str) -> None:
    """Raise BadInput when no Dask cluster answers at an address; before anything is written, and within _ANSWER_S.

    A process of its own tries it. With some addresses, such as that of a port where no Dask listens, the client waits much
    longer than its timeout, and cannot be told to stop.
    """
    words = f"no answer within {_ANSWER_S} s"
    try:
        done = subprocess.run([sys.executable, "-c", _TRY, address, str(_CONNECT_S)], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False, timeout=_ANSWER_S)  # fmt: skip
        if done.returncode == 0:
            return
        words = " ".join(done.stdout.split()) or f"exit status {done.returncode}"
        if done.returncode == 2:
            raise BadInput([_NO_DASK])
    except subprocess.TimeoutExpired:
        pass
    expected = "the address that `dask scheduler` prints, as tcp://host:8786"
    raise BadInput([Problem(f"no cluster answers at {address}: {words}", "--cluster", expected=expected)])


def fly_on_cluster(
    job: Job, tasks: Iterable[Task], address: str
) -> Generator[tuple[Task, Flown], None, None]:
    """Fly every task on the cluster at this address; yields each as it finishes, in no order.

    Raises BadInput when no cluster answers, the cluster fails, or its workers cannot fly.
    """
    try:
        from distributed import Client, as_completed
    except ImportError:
        raise BadInput([_NO_DASK]) from None
    try:
        client = Client(address, timeout=_CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise BadInput([Problem(f"no cluster answers at {address}: {error}")]) from None
    packed = pack(job)
    feed = iter(tasks)
    with client:
        pending = {_submit(client, packed, task): (task, 1) for task in itertools.islice(feed, _room(client))}
        completed = as_completed(list(pending), loop=client.loop)
        for future in completed:
            task, tries = pending.pop(future)
            if future.status == "finished":
                yield task, future.result()
                following = list(itertools.islice(feed, max(0, _room(client) - len(pending))))
                again = [(_submit(client, packed, t), (t, 1)) for t in following]
            else:
                _raise_unless_worth_retrying(future, tries, address)
                again = [(_submit(client, packed, task), (task, tries + 1))]
            for new, sent_again in again:
                pending[new] = sent_again
                completed.add(new)


def _submit(client: Any, packed: PackedJob, task: Task) -> Any:
    return client.submit(fly_packed, packed, task, pure=False, retries=0)


def _room(client: Any) -> int:
    return _AHEAD * max(1, sum(client.nthreads().values()))


def _raise_unless_worth_retrying(future: Any, tries: int, address: str) -> None:
    """Raise BadInput, unless sending the flight again may help, as when its Dask worker died or its result was lost."""
    if future.status == "error":
        error = future.exception()
        if isinstance(error, BadInput):
            raise error
        words = f"{type(error).__name__}: {error}"
    else:
        words = future.status  # cancelled or lost
    if future.client.status != "running" or tries >= _TRIES:
        raise BadInput([Problem(f"the cluster at {address} failed: {words}")])


def fly_packed(packed: PackedJob, task: Task) -> Flown:
    """On a Dask worker: fly one task in a child process, which then waits for the next task of the same sweep."""
    children = _children(packed)
    child = children.take()
    try:
        return child.fly(task)
    finally:
        children.idle.put(child)


@dataclass
class _Children:
    """The child processes of a Dask worker for one sweep; `idle` are those that are not flying."""

    job: Job
    idle: queue.LifoQueue[Child] = field(default_factory=queue.LifoQueue)

    def take(self) -> Child:
        """An idle process, or a new one."""
        try:
            return self.idle.get_nowait()
        except queue.Empty:
            return Child(self.job)

    def close(self) -> None:
        """End the idle processes."""
        while not self.idle.empty():
            self.idle.get_nowait().close()


_by_digest: dict[str, _Children] = {}
_by_digest_lock = threading.Lock()


def _children(packed: PackedJob) -> _Children:
    with _by_digest_lock:
        if packed.digest not in _by_digest:
            _close_all()  # those of an earlier sweep
            _by_digest[packed.digest] = _Children(_unpack(packed))
        return _by_digest[packed.digest]


def _unpack(packed: PackedJob) -> Job:
    """The job, with its aircraft unpacked into a folder that is named by the digest and shared with other processes."""
    job, name, files = pickle.loads(zlib.decompress(packed.content))
    root = Path(tempfile.gettempdir()) / f"testbed-{os.getuid()}-{packed.digest}"
    if not root.is_dir():
        partial = Path(tempfile.mkdtemp(prefix="testbed-unpacking-"))
        for file, content in files.items():
            (partial / file).parent.mkdir(parents=True, exist_ok=True)
            (partial / file).write_bytes(content)
        try:
            partial.rename(root)
        except OSError:  # another process was first
            if not root.is_dir():
                raise
        finally:
            shutil.rmtree(partial, ignore_errors=True)
    own = {name: each.unpacked(root / _OWN / name) for name, each in job.builder.own.items()}
    return Job(
        builder=job.builder.with_aircraft(str(root / name)).with_own(own),
        fly=job.fly,
        save_logs=job.save_logs,
        time_limit_s=job.time_limit_s,
        search_path=(),
    )


@atexit.register
def _close_all() -> None:
    for children in _by_digest.values():
        children.close()
    _by_digest.clear()
