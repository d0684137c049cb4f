"""One decorator: the control law's page is plain Python that numba compiles, and caches for the next process.

With `NUMBA_DISABLE_JIT=1` the same page runs uncompiled, line by line, for a debugger or a comparison.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from numba import njit

F = TypeVar("F", bound=Callable[..., Any])


def compiled(function: F) -> F:
    """Compile at first use; no fast-math, so that results agree with the uncompiled page."""
    return njit(cache=True, error_model="numpy")(function)  # type: ignore[no-any-return, return-value]
