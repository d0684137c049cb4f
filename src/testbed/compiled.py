"""One decorator: the control law's page is plain Python that numba compiles, and caches for the next process.

With `NUMBA_DISABLE_JIT=1` the same page runs uncompiled, line by line, for a debugger or a comparison.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numba

F = TypeVar("F", bound=Callable[..., Any])


def _cache_folder() -> str:
    """A folder for compiled code, of its own for each state of the sources.

    numba's cache looks only at the file of the function that is called, not at those of the functions that it calls, so
    an edited law would fly on as it was.
    """
    text = hashlib.sha256()
    package = Path(__file__).parent
    for file in sorted(package.rglob("*.py")):
        text.update(file.read_bytes())
    home = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    name = Path("testbed") / f"numba-{numba.__version__}-{text.hexdigest()[:16]}"
    for root in (home, Path(tempfile.gettempdir())):
        try:
            (root / name).mkdir(parents=True, exist_ok=True)
            return str(root / name)
        except OSError:
            continue
    return ""


if not os.environ.get("NUMBA_CACHE_DIR"):
    numba.config.CACHE_DIR = _cache_folder()  # type: ignore[attr-defined]


def compiled(function: F) -> F:
    """Compile at first use; no fast-math, so that results agree with the uncompiled page."""
    return numba.njit(cache=True, error_model="numpy")(function)  # type: ignore[no-any-return, return-value]


def bound(function: F, *like: Any) -> F:
    """A compiled function as it is for arguments of these types, compiled now if need be.

    A call of it does not look at the types of its arguments again, half of what a call costs otherwise; so it must only
    ever be given such as these: arrays of the same dtypes and layouts.
    """
    if not isinstance(function, numba.core.dispatcher.Dispatcher):
        return function  # NUMBA_DISABLE_JIT: the page itself
    types = tuple(map(numba.typeof, like))
    function.compile(types)
    return function.overloads[types].entry_point  # type: ignore[no-any-return]
