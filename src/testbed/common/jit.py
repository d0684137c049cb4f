"""Compile plain Python functions with numba, and keep the compiled code on disk for the next process.

With `NUMBA_DISABLE_JIT=1` the same functions run uncompiled, line by line, for a debugger or a comparison.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import os
import pickle
import shutil
import time
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

import numba
import numpy as np
from numba.core.caching import FunctionCache, IndexDataCacheFile

from testbed.common.cache import Cache
from testbed.common.jit_program import Function
from testbed.common.private import is_private, private_folder

F = TypeVar("F", bound=Callable[..., Any])
LONGEST_WAIT_S = 60.0
"""How long a process waits for another one that compiles. A control law takes ten seconds, on a busy machine thirty."""
_CRC_BYTES = 4


def _cache_folder() -> Path | None:
    """A folder for compiled code that belongs to this state of the sources; None where nothing can be written.

    numba's own cache checks only the file of the compiled function. It would not notice an edit of a function that this one
    calls from another file, and would run the old code.
    """
    text = hashlib.sha256()
    package = Path(__file__).parents[1]
    for file in sorted(package.rglob("*.py")):
        text.update(file.read_bytes())
    # The code in the folder will be executed, so nobody else may have put it there.
    folder = private_folder(f"numba-{numba.__version__}-{text.hexdigest()[:16]}")
    if folder is not None:
        os.utime(folder)  # `prune` goes by the time of last use
        prune(folder.parent)
    return folder


def _chosen_folder(folder: Path) -> Path | None:
    """The folder that the user has chosen for compiled code; None where others may have put some there."""
    with contextlib.suppress(OSError):
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    return folder if is_private(folder.resolve()) else None


def prune(root: Path, days: float = 30.0) -> None:
    """Remove folders of compiled code that no process has used for this many days; they can be compiled again."""
    for folder in root.glob("numba-*"):
        with contextlib.suppress(OSError):
            if folder.stat().st_mtime < time.time() - 86400.0 * days:
                shutil.rmtree(folder, ignore_errors=True)


_OURS = not os.environ.get("NUMBA_CACHE_DIR")
"""Whether the cache's folder is that of `_cache_folder`, or one that the user has chosen for all of numba's code."""
if _OURS:
    _FOLDER = _cache_folder()
    numba.config.CACHE_DIR = str(_FOLDER or "")  # type: ignore[attr-defined]
else:
    _FOLDER = _chosen_folder(Path(os.environ["NUMBA_CACHE_DIR"]))


@contextlib.contextmanager
def _one_at_a_time() -> Iterator[None]:
    """Let one process compile and the others wait for its result, when several find the cache empty.

    A process that was stopped while it compiles would keep the others waiting for ever: after `LONGEST_WAIT_S` they compile too.
    """
    with contextlib.ExitStack() as held:
        # Where the file system has no locks, each process compiles. Closing the file releases the lock.
        with contextlib.suppress(OSError):
            lock = held.enter_context(open(Path(_FOLDER or os.devnull) / "lock", "a"))
            end = time.monotonic() + LONGEST_WAIT_S
            while time.monotonic() < end:
                try:
                    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    break
                except BlockingIOError:
                    time.sleep(0.05)
        yield


class _CheckedFiles(IndexDataCacheFile):
    """The files in which numba keeps compiled code, with a CRC-32 at the end of what is pickled, so that damage to them costs time
    and nothing else.

    numba reads a cut or empty file as it is: unpickling fails, in every later process, until somebody removes the file. And code
    that a power cut has replaced by zeros would be executed. Here what cannot be read is thrown away, compiled again and written
    anew; what cannot be written is compiled again in the next process.
    """

    def _dump(self, value: Any) -> bytes:
        data: bytes = super()._dump(value)
        return data + _crc(data)

    def _load_data(self, name: str) -> Any:
        content = Path(self._data_path(name)).read_bytes()
        data, crc = content[:-_CRC_BYTES], content[-_CRC_BYTES:]
        if crc != _crc(data):
            raise ValueError(f"{name} is damaged")
        return pickle.loads(data)


class _CodeCache(FunctionCache):
    """The compiled code of one function, on disk.

    Args:
        folder: one that belongs to the contents of all sources. In it the code is found again whatever the path and the time of
            the source file, as after an installation anew. None: where numba looks for it, by path and time.
    """

    def __init__(self, function: Callable[..., Any], folder: Path | None = None) -> None:
        super().__init__(function)
        stamp = self._cache_file._source_stamp
        if folder is not None:
            self._cache_path, stamp = str(folder / function.__module__), ()
            with contextlib.suppress(OSError):
                Path(self._cache_path).mkdir(exist_ok=True)
        self._cache_file = _CheckedFiles(self._cache_path, self._impl.filename_base, stamp)

    def load_overload(self, signature: Any, target_context: Any) -> Any:
        """The code for a signature; None if there is none, or none that can be read."""
        try:
            return super().load_overload(signature, target_context)
        except Exception:  # of pickle, of numba, or of what was unpickled: a damaged file can raise anything
            with contextlib.suppress(OSError):
                self.flush()
            return None

    def save_overload(self, signature: Any, code: Any) -> None:
        """Keep the code for a signature; without effect where nothing can be written, as on a full disk."""
        with contextlib.suppress(OSError):
            super().save_overload(signature, code)


def _crc(data: bytes) -> bytes:
    return zlib.crc32(data).to_bytes(_CRC_BYTES, "little")


def compiled(function: F) -> F:
    """Compile a function at its first call; without fast-math, so that results agree with the uncompiled function."""
    if numba.config.DISABLE_JIT:  # type: ignore[attr-defined]
        return function
    made = Function(function)
    if _FOLDER is not None:
        ours = _OURS and function.__module__.startswith("testbed.")
        cache = _CodeCache(function, _FOLDER if ours else None)
        made._cache = cache  # type: ignore[attr-defined]  # no public way to give numba another
    return made  # type: ignore[no-any-return, return-value]


def bound(function: F, *like: Any) -> F:
    """The machine code of a compiled function for the types of these example arguments, compiled now if need be.

    numba looks up the types of the arguments in each call, which is half of the cost of a short call. The function returned
    here skips the look-up. It must only be called with arguments of the same types: arrays of the same dtype and memory layout.
    """
    if not isinstance(function, Function):
        return function  # NUMBA_DISABLE_JIT: the plain Python function
    types = tuple(map(_type_of, like))
    if types not in function.overloads:
        with _one_at_a_time():
            function.compile(types)
    return function.overloads[types].entry_point  # type: ignore[attr-defined, no-any-return]


_array_types: Cache[Any] = Cache(256)


def _type_of(value: Any) -> Any:
    """numba's type of an argument. Those of arrays are kept: numba takes 0.1 ms to make the type of a record."""
    if isinstance(value, tuple):
        return numba.types.Tuple([_type_of(item) for item in value])
    if not isinstance(value, np.ndarray):
        return numba.typeof(value)
    flags = value.flags
    key = (value.dtype, value.ndim, flags.c_contiguous, flags.f_contiguous, flags.writeable, flags.aligned)
    return _array_types.get(key, lambda: numba.typeof(value))
