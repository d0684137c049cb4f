"""The first load of an aircraft's model happens in a process of its own, because what is wrong with a model can end the process.

An aircraft is known by the digest of its files. What the first load showed is recorded in the user's cache folder, so that a
known aircraft costs one look for a file in a new process, and nothing but its digest in a process that has seen it.
"""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import tempfile
from typing import Any

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.check import model_files, model_problems
from testbed.aircraft.model_files.used import model_file
from testbed.common.cache import Cache
from testbed.common.processes import answers, environment, signal_name
from testbed.inputs.problems import BadInput, Problem
from testbed.plant import known

LONGEST_S = 10
"""Most processor time of a first load [s]; the shipped aircraft takes half a second. Time on the clock would depend on what else
the machine does."""
_WAIT_S = 120.0
"""Longest time that a first load is waited for [s]: for one that waits itself. One that computes is ended by its own limit."""
_OUT_OF_TIME = -getattr(signal, "SIGXCPU", 0)
"""Exit status of a process that has used up its processor time."""
_WORDS = 300
"""Longest text of JSBSim's that is repeated in a message [characters]."""

_records: Cache[known.Record] = Cache(64)
_assured: Cache[bool] = Cache(64)


def assure(aircraft: Aircraft) -> None:
    """Return if the model can be loaded in this process; raises BadInput, with what is wrong, if it cannot.

    Each `Plant` calls it. An aircraft seen before by this process costs its digest alone, 0.1 ms.
    """
    aircraft = aircraft.nominal  # a change of its numbers makes no model unsafe
    digest = aircraft.fingerprint()
    _assured.get(digest, lambda: known.holds(digest) or bool(_first_load(aircraft, digest)))


def property_catalog(aircraft: Aircraft) -> dict[str, bool]:
    """Name of each property of the aircraft's model, and whether it can be written; the model is not loaded here.

    Raises BadInput as `assure`.
    """
    aircraft = aircraft.nominal
    digest = aircraft.fingerprint()
    found = _records.get(digest, lambda: known.read(digest) or _first_load(aircraft, digest))
    _assured.get(digest, lambda: True)
    return dict(found["properties"])


def trust(aircraft: Aircraft) -> None:
    """Let this process load an aircraft without a first load elsewhere: it is the process of the first load."""
    _assured.get(aircraft.fingerprint(), lambda: True)


def _first_load(aircraft: Aircraft, digest: str) -> known.Record:
    """Check the files, load the model in a new process, and record what it shows; raises BadInput."""
    problems = model_problems(aircraft)
    if problems:
        raise BadInput(problems)
    found = _answer(aircraft)
    known.keep(digest, found)
    return found


def _answer(aircraft: Aircraft) -> known.Record:
    """What the process of the first load says."""
    described = aircraft.model_dump(mode="json", exclude_none=True)
    request = {"folder": str(aircraft.folder.resolve()), "aircraft": described}
    command = [sys.executable, "-B", "-m", "testbed.plant.probe"]
    try:
        with tempfile.TemporaryDirectory() as empty:
            done = subprocess.run(
                command, input=json.dumps(request), capture_output=True, text=True, errors="replace",
                timeout=_WAIT_S, cwd=empty, env=environment(), check=False,
            )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise BadInput([_unfinished(aircraft, f"{_WAIT_S:g} s")]) from None
    except OSError as error:  # there may be no folder for temporary files either
        raise BadInput([Problem(f"no process can be started to load the model: {error.strerror}")]) from None
    found = answers(done.stdout)
    if done.returncode == 0 and found and "properties" in found[-1]:
        return found[-1]
    if _OUT_OF_TIME and done.returncode == _OUT_OF_TIME:
        raise BadInput([_unfinished(aircraft, f"{LONGEST_S:g} s of processor time")])
    raise BadInput(_said(found) or _dead(aircraft, _last_words(done)))


def _dead(aircraft: Aircraft, words: str) -> list[Problem]:
    """What ended the process, at each element that names the property of which JSBSim says that there is none."""
    missing = re.search(r"The property (\S+) does not exist", words)
    elements = model_files(aircraft).elements() if missing else ()
    named = [element for element in elements if missing and element.text.lstrip("-") == missing[1]]
    return [element.problem(words) for element in named] or [_of_model(aircraft, words)]


def _said(found: list[dict[str, Any]]) -> list[Problem]:
    """The problems that the process found itself, those of its last answer."""
    return [Problem(**problem) for problem in found[-1].get("problems", [])] if found else []


def _last_words(done: subprocess.CompletedProcess[str]) -> str:
    """What JSBSim said last, or the name of the signal that ended it."""
    lines = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    words = (
        " ".join(line for line in lines if not line.startswith("terminate called"))
        .removeprefix("what():")
        .strip()
    )
    if done.returncode < 0:
        ended = f"it ended the process ({signal_name(-done.returncode)})"
        return f"JSBSim says {words[-_WORDS:]}; {ended}" if words else f"JSBSim says nothing; {ended}"
    return f"JSBSim says {words[-_WORDS:] or f'nothing; exit status {done.returncode}'}"


def _unfinished(aircraft: Aircraft, within: str) -> Problem:
    return _of_model(aircraft, f"JSBSim does not finish loading and starting it within {within}")


def _of_model(aircraft: Aircraft, what: str) -> Problem:
    return Problem(what, str(model_file(aircraft.folder, aircraft.model)))
