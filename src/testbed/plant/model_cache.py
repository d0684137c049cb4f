"""Records of aircraft that were loaded and checked before: a small file for each digest, in the user's cache folder.

A record is lost without harm: what it says is then found again, which takes a second or so.
"""

from __future__ import annotations

import contextlib
import hashlib
import importlib.util
import json
import os
import time
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from testbed.common.private import cache_home, is_private
from testbed.common.writing import write as write_file

Record = Mapping[str, Any]
"""What was found, as JSON can hold it. Of a first load: `properties`, the name of each property of the model, and whether it
can be written."""
_KEPT_DAYS = 30.0


def has(digest: str) -> bool:
    """Whether there is a record of this digest. It was written whole, so it is not read here."""
    file = _file_of(digest)
    return file is not None and file.is_file()


def read(digest: str) -> Record | None:
    """The record of a first load, or None if there is none, or if it is not whole."""
    file = _file_of(digest)
    try:
        found = json.loads(file.read_bytes()) if file is not None else None
    except (OSError, ValueError):
        return None
    return found if isinstance(found, dict) and isinstance(found.get("properties"), dict) else None


def write(digest: str, found: Record) -> None:
    """Write what was found, whole or not at all; without a folder that can be written, the next process finds it anew."""
    file = _file_of(digest)
    if file is None:
        return
    with contextlib.suppress(OSError):
        file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        _prune(file.parent)
        write_file(file, json.dumps(found))


def _prune(folder: Path) -> None:
    """Remove records that were written long ago."""
    for file in folder.iterdir():
        if file.stat().st_mtime < time.time() - 86400.0 * _KEPT_DAYS:
            file.unlink(missing_ok=True)


def _file_of(digest: str) -> Path | None:
    """The file of a record; None where there is no home folder, or where others can write into its folder."""
    if (home := cache_home()) is None:
        return None
    folder = (home / "testbed" / "models").resolve()
    if os.path.lexists(folder) and not is_private(folder):
        return None
    return folder / f"{digest}-{_rules()}.json"


@lru_cache(1)
def _rules() -> str:
    """Digest of what a first load depends on besides the aircraft: JSBSim, and the modules that check and load.

    A module is taken to be as it was while its time and size are, as Python itself does to know whether compiled code is stale.
    """
    found = importlib.util.find_spec("jsbsim")  # its version would take longer to find than all else here
    installed = Path(found.origin).parent.stat().st_mtime_ns if found and found.origin else 0
    text = hashlib.sha256(str(installed).encode())
    plant = Path(__file__).parent
    checks = plant.parent / "aircraft" / "model_files"
    for folder in (checks, plant):
        with os.scandir(folder) as entries:
            seen = [(each.name, each.stat()) for each in entries if each.name.endswith(".py")]
        text.update(repr(sorted((name, at.st_mtime_ns, at.st_size) for name, at in seen)).encode())
    return text.hexdigest()[:16]
