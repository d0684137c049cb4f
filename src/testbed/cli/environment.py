"""Settings of libraries in the environment at which they fail before a command can say anything: refused at the start."""

from __future__ import annotations

import os

_THREADS = "NUMBA_NUM_THREADS"


def wrong_setting() -> str:
    """What is wrong; empty if nothing is."""
    text = os.environ.get(_THREADS, "1")
    if text.strip().isdecimal() and int(text) > 0:
        return ""
    return f"{_THREADS}: is {text!r}, expected a whole number of 1 or more"
