"""The first load of an aircraft's model happens in a child process, because a mistake in a model can end the process.

What it showed is recorded in the user's cache folder, in a small file under the digest of the aircraft's files. So a later process
only looks whether there is such a record, and looks once. A record is lost without harm: what it says is then found again, which
takes a second or so.
"""

from __future__ import annotations

import contextlib
import hashlib
import importlib.util
import json
import os
import re
import time
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.check import model_problems
from testbed.aircraft.model_files.used import ModelFiles
from testbed.common import child
from testbed.common.cache import Cache
from testbed.common.private import cache_home, is_private
from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Problem

_PROBE = "testbed.plant.probe"
_LIMITS = child.Limits(processor_s=10, writes_files=False)
"""What a first load may use. The shipped aircraft takes half a second; a delay of many millions of steps would take all memory."""
LONGEST = 300
"""Longest text of JSBSim's that is repeated in a message [characters]."""
Record = Mapping[str, Any]
"""What was found, as JSON can hold it. Of a first load: `properties`, the name of each property of the model, and whether it
can be written."""
_KEPT_DAYS = 30.0
_records: Cache[Record] = Cache(64)
_assured: Cache[bool] = Cache(64)


def assure(aircraft: Aircraft) -> None:
    """Return if the model can be loaded in this process; raises BadInput, with what is wrong, if it cannot.

    Each `Plant` calls it. An aircraft seen before by this process costs its digest alone, 0.1 ms.
    """
    aircraft = aircraft.nominal  # a change of its numbers makes no model unsafe
    digest = aircraft.fingerprint()
    _assured.get(digest, lambda: has_record(digest) or bool(_first_load(aircraft, digest)))


def property_catalog(aircraft: Aircraft) -> dict[str, bool]:
    """Name of each property of the aircraft's model, and whether it can be written; the model is not loaded here.

    Raises BadInput as `assure`.
    """
    aircraft = aircraft.nominal
    digest = aircraft.fingerprint()
    found = _records.get(digest, lambda: read_record(digest) or _first_load(aircraft, digest))
    _assured.get(digest, lambda: True)
    return dict(found["properties"])


def trust(aircraft: Aircraft) -> None:
    """Let this process load an aircraft without a first load elsewhere: it is the process of the first load."""
    _assured.get(aircraft.fingerprint(), lambda: True)


def _first_load(aircraft: Aircraft, digest: str) -> Record:
    """Check the files, load the model in a new process, and record what it shows; raises BadInput."""
    problems = model_problems(aircraft)
    if problems:
        raise BadInput(problems)
    found = _answer(aircraft)
    write_record(digest, found)
    return found


def _answer(aircraft: Aircraft) -> Record:
    """What the process of the first load says."""
    described = aircraft.model_dump(mode="json", exclude_none=True)
    request = {"folder": str(aircraft.folder.resolve()), "aircraft": described}
    try:
        ended = child.ask(_PROBE, request, _LIMITS)
    except OSError as error:  # there may be no folder for temporary files either
        raise BadInput([Problem(f"no process can be started to load the model: {error.strerror}")]) from None
    if ended.status == 0 and "properties" in ended.last:
        return ended.last
    if ended.overtime:
        what = f"JSBSim does not finish loading and starting it within {ended.overtime}"
        raise BadInput([Problem(what, str(aircraft.model_file))])
    said = [Problem(**problem) for problem in ended.last.get("problems", [])]
    raise BadInput(said or _dead(aircraft, _last_words(ended)))


def _dead(aircraft: Aircraft, words: str) -> list[Problem]:
    """What ended the process, at each element that names the property of which JSBSim says that there is none."""
    missing = re.search(r"The property (\S+) does not exist", words)
    elements = ModelFiles(aircraft.folder, aircraft.model).elements()
    named = (element for element in elements if missing and element.text.lstrip("-") == missing[1])
    return [element.problem(words) for element in named] or [Problem(words, str(aircraft.model_file))]


def _last_words(ended: child.Ended) -> str:
    """What JSBSim said last, or the name of the signal that ended it."""
    lines = [line.strip() for line in ended.errors.splitlines() if line.strip()]
    words = (
        " ".join(line for line in lines if not line.startswith("terminate called"))
        .removeprefix("what():")
        .strip()
    )
    if ended.signal:
        what = f"it ended the process ({ended.signal})"
        return f"JSBSim says {words[-LONGEST:]}; {what}" if words else f"JSBSim says nothing; {what}"
    return f"JSBSim says {words[-LONGEST:] or f'nothing; exit status {ended.status}'}"


def has_record(digest: str) -> bool:
    """Whether there is a record of this digest. It was written whole, so it is not read here."""
    file = _file_of(digest)
    return file is not None and file.is_file()


def read_record(digest: str) -> Record | None:
    """The record of a first load, or None if there is none, or if it is not whole."""
    file = _file_of(digest)
    try:
        found = json.loads(file.read_bytes()) if file is not None else None
    except (OSError, ValueError):
        return None
    return found if isinstance(found, dict) and isinstance(found.get("properties"), dict) else None


def write_record(digest: str, found: Record) -> None:
    """Write what was found, whole or not at all; without a folder that can be written, the next process finds it anew."""
    file = _file_of(digest)
    if file is None:
        return
    with contextlib.suppress(OSError):
        file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        _prune(file.parent)
        write(file, json.dumps(found))


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
