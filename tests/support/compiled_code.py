"""Compiled code for a process whose caches are its own: that of other flights, so that it compiles nothing again."""

from __future__ import annotations

import shutil
from pathlib import Path

from testbed.common import jit


def environment(cache: Path) -> dict[str, str]:
    """Variables for a process that keeps its caches in this folder; in it is a copy of what has been compiled.

    With `NUMBA_CACHE_DIR` the process would look for code by the path of the sources, and compile all of it.
    """
    if not jit._OURS or jit._FOLDER is None:
        return {"XDG_CACHE_HOME": str(cache), "NUMBA_CACHE_DIR": str(jit._FOLDER or cache)}
    copy = cache / jit._FOLDER.parent.name / jit._FOLDER.name
    copy.parent.mkdir(mode=0o700, exist_ok=True)
    shutil.copytree(jit._FOLDER, copy, ignore=shutil.ignore_patterns("*.tmp.*"))  # what others are writing
    copy.chmod(0o700)
    return {"XDG_CACHE_HOME": str(cache)}
