"""The first load of an aircraft's model happens in a child process, because a mistake in a model can end the process.

What it showed is recorded in the user's cache folder, under the digest of the aircraft's files. So a later process only looks
whether there is such a record, and looks once.
"""

from __future__ import annotations

import re

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.check import model_problems
from testbed.aircraft.model_files.used import ModelFiles
from testbed.common import child
from testbed.common.cache import Cache
from testbed.inputs.problems import BadInput, Problem
from testbed.plant import model_cache

_PROBE = "testbed.plant.probe"
_LIMITS = child.Limits(processor_s=10, writes_files=False)
"""What a first load may use. The shipped aircraft takes half a second; a delay of many millions of steps would take all memory."""
LONGEST = 300
"""Longest text of JSBSim's that is repeated in a message [characters]."""

_records: Cache[model_cache.Record] = Cache(64)
_assured: Cache[bool] = Cache(64)


def assure(aircraft: Aircraft) -> None:
    """Return if the model can be loaded in this process; raises BadInput, with what is wrong, if it cannot.

    Each `Plant` calls it. An aircraft seen before by this process costs its digest alone, 0.1 ms.
    """
    aircraft = aircraft.nominal  # a change of its numbers makes no model unsafe
    digest = aircraft.fingerprint()
    _assured.get(digest, lambda: model_cache.has(digest) or bool(_first_load(aircraft, digest)))


def property_catalog(aircraft: Aircraft) -> dict[str, bool]:
    """Name of each property of the aircraft's model, and whether it can be written; the model is not loaded here.

    Raises BadInput as `assure`.
    """
    aircraft = aircraft.nominal
    digest = aircraft.fingerprint()
    found = _records.get(digest, lambda: model_cache.read(digest) or _first_load(aircraft, digest))
    _assured.get(digest, lambda: True)
    return dict(found["properties"])


def trust(aircraft: Aircraft) -> None:
    """Let this process load an aircraft without a first load elsewhere: it is the process of the first load."""
    _assured.get(aircraft.fingerprint(), lambda: True)


def _first_load(aircraft: Aircraft, digest: str) -> model_cache.Record:
    """Check the files, load the model in a new process, and record what it shows; raises BadInput."""
    problems = model_problems(aircraft)
    if problems:
        raise BadInput(problems)
    found = _answer(aircraft)
    model_cache.write(digest, found)
    return found


def _answer(aircraft: Aircraft) -> model_cache.Record:
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
