"""A limit on the address space, as by `ulimit -v`: refused at the start where it is too low.

The libraries for linear algebra do not fail cleanly when they get no memory while they are loaded: one tries for ever, another
aborts the process.
"""

from __future__ import annotations

NEEDED_MB = 1000
"""Address space with which a flight and a sweep are known to work, figures included [MB]; most of it is never filled."""


def too_little() -> str:
    """Why no command can be carried out within this process's limit; empty if it can."""
    try:
        import resource
    except ImportError:  # this system has no such limits
        return ""
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit == resource.RLIM_INFINITY or limit >= NEEDED_MB * 1_000_000:
        return ""
    return f"the address space is limited to {limit // 1_000_000} MB, of {NEEDED_MB} needed: raise it by `ulimit -v`"
