"""What is refused before a command begins, because a library would fail there without a word about the cause."""

from __future__ import annotations

import os

NEEDED_MB = 1000
"""Address space with which a flight and a sweep are known to work, figures included [MB]; most of it is never filled."""
_THREADS = "NUMBA_NUM_THREADS"


def too_little_memory() -> str:
    """Why no command can be carried out within this process's limit of address space, as by `ulimit -v`; empty if it can.

    The libraries for linear algebra do not fail cleanly when they get no memory while they are loaded: one tries for ever,
    another aborts the process.
    """
    try:
        import resource
    except ImportError:  # this system has no such limits
        return ""
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit == resource.RLIM_INFINITY or limit >= NEEDED_MB * 1_000_000:
        return ""
    return f"the address space is limited to {limit // 1_000_000} MB, of {NEEDED_MB} needed: raise it by `ulimit -v`"


def wrong_setting() -> str:
    """What is wrong with numba's setting in the environment, with which numba cannot be imported; empty if nothing is."""
    text = os.environ.get(_THREADS, "1")
    if text.strip().isdecimal() and int(text) > 0:
        return ""
    return f"{_THREADS}: is {text!r}, expected a whole number of 1 or more"
