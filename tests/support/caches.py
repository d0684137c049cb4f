"""The caches of this process, emptied: the next flight computes everything anew, as in a new process."""

from __future__ import annotations

import sys

from testbed.common.cache import Cache


def forget() -> None:
    """Forget the results of every cache of a module."""
    ours = [module for name, module in sys.modules.items() if name.startswith("testbed.")]
    for each in [value for module in ours for value in vars(module).values()]:
        if isinstance(each, Cache):
            each._results.clear()
