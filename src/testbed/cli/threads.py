"""A thread that a user's controller leaves running does not keep the command from ending."""

from __future__ import annotations

import os
import sys
import threading
import time

from testbed.cli.terminal import give_up_stdout

_WAIT_S = 3.0


def end_despite_threads(status: int) -> int:
    """The exit status, if the process can end by itself; else it says so and ends the process with this status.

    Threads that are not daemons have some seconds to end: Python would wait for them for ever.
    """
    until = time.monotonic() + _WAIT_S
    for thread in _left():
        thread.join(max(0.0, until - time.monotonic()))
    if left := _left():
        names = ", ".join(thread.name for thread in left)
        print(f"WARNING: a thread was left running, and is ended: {names}", file=sys.stderr, flush=True)
        try:
            sys.stdout.flush()
        except OSError:  # as `commands.main` has said already
            give_up_stdout()
        os._exit(status)
    return status


def _left() -> list[threading.Thread]:
    ours = threading.current_thread()
    return [thread for thread in threading.enumerate() if not thread.daemon and thread is not ours]
