"""The command line, as `python -m testbed`."""

from __future__ import annotations

import atexit
import gc
import os
import sys

TYPE_CHECKING = False  # as `typing` has it, without the time to import it: until Ctrl-C is handled, every millisecond counts
if TYPE_CHECKING:
    from collections.abc import Sequence

NEEDED_MB = 1000
"""Address space with which a flight and a sweep are known to work, figures included [MB]; most of it is never filled."""
_THREADS = "NUMBA_NUM_THREADS"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command, of `sys.argv` if none is given, and return its exit status."""
    from testbed.cli import ending

    # At its end Python would go through all that numba has loaded once more, for half a second.
    atexit.register(gc.freeze)
    atexit.register(ending.end_undisturbed)
    ending.end_at_once()  # before everything else is imported, which takes most of a second
    if words := too_little_memory():
        print(words, file=sys.stderr)
        return ending.ENDED_EARLY
    if words := wrong_setting():
        print(words, file=sys.stderr)
        return ending.BAD_INPUT
    from testbed.cli.commands import end_despite_threads, main

    return end_despite_threads(main(arguments))


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


if __name__ == "__main__":
    sys.exit(main())
