"""Fly on a Dask cluster. Its workers need only this package: everything else is sent with each task.

Every flight runs in a child process of a Dask worker, so that crashes and hangs give the same rows as on one machine.
When a Dask worker dies, the scheduler gives its tasks to another.
"""

from __future__ import annotations

import atexit
import hashlib
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import threading
import zlib
from asyncio import CancelledError
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from testbed.aircraft.changes import name_in
from testbed.aircraft.description import load_aircraft
from testbed.common.private import is_private
from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Problem
from testbed.scenario.load import placed_name
from testbed.studies.drawing.builder import Task
from testbed.studies.flying.children import Children
from testbed.studies.flying.flight import Job
from testbed.studies.record import Flown

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
    """A study's job with the files of its aircraft, compressed; `digest` identifies the content."""

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


class Connection:
    """A job at a cluster, as `Children` are one on this machine; raises BadInput when none answers."""

    most = 1000
    """Most flights that wait for the cluster at a time, each in a thread."""

    def __init__(self, job: Job, address: str) -> None:
        try:
            from distributed import Client
        except ImportError:
            raise BadInput([_NO_DASK]) from None
        try:
            self._client = Client(address, timeout=_CONNECT_S, set_as_default=False)
        except (OSError, ValueError, TimeoutError) as error:
            raise BadInput([Problem(f"no cluster answers at {address}: {error}")]) from None
        self._packed, self._address = pack(job), address

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
                flown: Flown = future.result()
                return flown
            except BadInput:
                raise
            except Exception as error:
                words = f"{type(error).__name__}: {error}"
            except CancelledError:  # of asyncio: no Exception
                words = str(future.status)
            if self._client.status != "running":
                break
        raise BadInput([Problem(f"the cluster at {self._address} failed: {words}")])

    def close(self) -> None:
        """Leave the cluster; what is being flown there is lost."""
        self._client.close()


def fly_packed(packed: PackedJob, task: Task) -> Flown:
    """On a Dask worker: fly one task in a child process, which then waits for the next task of the same study."""
    return _children(packed).fly(task)


_by_digest: dict[str, Children] = {}
_by_digest_lock = threading.Lock()


def _children(packed: PackedJob) -> Children:
    with _by_digest_lock:
        if packed.digest not in _by_digest:
            _close_all()  # those of an earlier study
            _by_digest[packed.digest] = Children(_unpack(packed))
        return _by_digest[packed.digest]


def _unpack(packed: PackedJob) -> Job:
    """The job, with its aircraft unpacked into a folder that is named by the digest and shared with other processes."""
    job, name, files = pickle.loads(zlib.decompress(packed.content))
    root = Path(tempfile.gettempdir()).resolve() / f"testbed-{os.getuid()}-{packed.digest}"
    if not is_private(root):
        partial = Path(tempfile.mkdtemp(prefix="testbed-unpacking-"))
        try:
            for file, content in files.items():
                write(partial / file, content, within=partial)
            with suppress(OSError):  # another process was first, or another user took the name
                partial.rename(root)
            root = root if is_private(root) else partial
        finally:
            if root != partial:
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
