"""One decorator: the control law's page is plain Python that numba compiles, and caches for the next process.

With `NUMBA_DISABLE_JIT=1` the same page runs uncompiled, line by line, for a debugger or a comparison.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

import numba

F = TypeVar("F", bound=Callable[..., Any])


def _cache_folder() -> Path | None:
    """A folder for compiled code, of its own for each state of the sources; None where nothing can be written.

    numba's cache looks only at the file of the function that is called, not at those of the functions that it calls, so
    an edited law would fly on as it was.
    """
    text = hashlib.sha256()
    package = Path(__file__).parents[1]
    for file in sorted(package.rglob("*.py")):
        text.update(file.read_bytes())
    home = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "testbed"
    ours = Path(tempfile.gettempdir()) / f"testbed-{_user()}"
    for root in (home, ours):
        folder = root / f"numba-{numba.__version__}-{text.hexdigest()[:16]}"
        try:
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            os.utime(folder)  # used today
        except OSError:
            continue
        if os.access(folder, os.W_OK) and folder.stat().st_uid == _user():  # it will be executed
            prune(root)
            return folder
    return None


def _user() -> int:
    return os.getuid() if hasattr(os, "getuid") else 0


def prune(root: Path, days: float = 30.0) -> None:
    """Remove compiled code of sources that nobody has flown for so many days; a process that still does compiles."""
    for folder in root.glob("numba-*"):
        with contextlib.suppress(OSError):
            if folder.stat().st_mtime < time.time() - 86400.0 * days:
                shutil.rmtree(folder, ignore_errors=True)


if not os.environ.get("NUMBA_CACHE_DIR"):
    _FOLDER = _cache_folder()
    numba.config.CACHE_DIR = str(_FOLDER or "")  # type: ignore[attr-defined]
else:
    _FOLDER = Path(os.environ["NUMBA_CACHE_DIR"])


@contextlib.contextmanager
def _one_at_a_time() -> Iterator[None]:
    """Of the processes that find the cache empty one compiles and the others wait for it."""
    try:
        import fcntl

        lock = open(Path(_FOLDER or os.devnull) / "lock", "a")  # noqa: SIM115
        fcntl.flock(lock, fcntl.LOCK_EX)
    except (ImportError, OSError):  # not on this system, or not on this file system: each compiles
        yield
        return
    with lock:  # closing it opens it for the next
        yield


def compiled(function: F) -> F:
    """Compile at first use; no fast-math, so that results agree with the uncompiled page."""
    return numba.njit(cache=_FOLDER is not None, error_model="numpy")(function)  # type: ignore[no-any-return, return-value]


def bound(function: F, *like: Any) -> F:
    """A compiled function as it is for arguments of these types, compiled now if need be.

    A call of it does not look at the types of its arguments again, half of what a call costs otherwise; so it must only
    ever be given such as these: arrays of the same dtypes and layouts.
    """
    if not isinstance(function, numba.core.dispatcher.Dispatcher):
        return function  # NUMBA_DISABLE_JIT: the page itself
    types = tuple(map(numba.typeof, like))
    if types not in function.overloads:
        with _one_at_a_time():
            function.compile(types)
    return function.overloads[types].entry_point  # type: ignore[attr-defined, no-any-return]


def has_compiled() -> bool:
    """Whether compiled code of these sources is kept already; else the first flight compiles for some seconds."""
    if numba.config.DISABLE_JIT:  # type: ignore[attr-defined]
        return True
    return _FOLDER is not None and next(_FOLDER.rglob("*.nbi"), None) is not None
