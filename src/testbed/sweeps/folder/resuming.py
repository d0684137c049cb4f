"""Whether a sweep may be flown into a folder: the folder must be new or, to resume, have been begun with the same inputs.

sweep.yaml shows whether the sweep is the same. The journal's first line shows whether the aircraft, the versions and the
function that flies are the same.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import os
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.aircraft.description import load_aircraft
from testbed.flight.folder import FolderExists
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.input_file import read_text
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import Source, describe
from testbed.sweeps.drawing.cases import LARGEST_TABLE
from testbed.sweeps.plan import Plan

_FREE = ("name", "runs", "stop_when")
"""Keys of sweep.yaml that may change when a sweep is resumed, because no row depends on them."""
_VERSIONS = ("testbed", "jsbsim", "numpy", "scipy", "numba")


def flown_with(plan: Plan, fly: str) -> dict[str, Any]:
    """The journal's first line: everything, besides the sweep itself, that the results of the flights depend on."""
    return {
        "journal": 1,
        "fly": fly,
        "aircraft_sha256": _aircraft_digest(plan),
        "versions": _versions(),
        **_controllers(plan),
    }


def refuse_changed(before: Mapping[str, Any], now: Mapping[str, Any], folder: Path) -> None:
    """Raise BadInput when the first line of a folder's journal differs from that of now."""
    problems = [Problem(f"was begun with {what}", str(folder)) for what in _changed(before, now)]
    if problems:
        raise BadInput(problems)


def refuse_other(folder: Path, plan: Plan, resume: bool) -> None:
    """Raise BadInput unless the folder is new or empty or, with `resume`, has the same sweep with as many runs or fewer."""
    file = folder / "sweep.yaml"
    if not os.path.lexists(folder) or (folder.is_dir() and not any(folder.iterdir())):
        return
    journal = folder / "journal.jsonl"
    if not resume:
        what = "a new folder, or --resume to go on with this one"
        raise FolderExists([Problem("exists already", str(folder), expected=what)])
    if not file.is_file():
        if not journal.is_file() or os.path.lexists(folder / "search.yaml"):
            raise BadInput([Problem("is not the folder of a sweep", str(folder))])
        return  # the process was killed before it wrote sweep.yaml
    source = yamlfile.read(file)
    before, runs = source.tree, runs_in(source)
    now = yamlfile.parse(yamlfile.dump(plan.tree)).tree
    problems = [
        Problem(what, str(file), None, path, "an unchanged sweep")
        for path, what in differences(before, now, _FREE)
    ]
    if plan.runs < runs:
        problems.append(Problem(f"has {runs} already", str(file), None, "runs", "at least as many"))
    if plan.runs > runs and not plan.extendable:
        what = f"a latin hypercube of {runs} runs cannot be made longer: its points depend on their number"
        problems.append(Problem(what, str(file), None, "runs", "sobol, halton or random for that"))
    if plan.cases_text is not None and _cases(folder) != plan.cases_text:
        problems.append(Problem("the table has changed", str(file), None, "cases", "an unchanged sweep"))
    if problems:
        raise BadInput(problems)


def runs_in(source: Source) -> int:
    """The number of runs that a folder's sweep.yaml says; raises BadInput if it does not say one."""
    runs = source.tree.get("runs")
    if not isinstance(runs, int) or isinstance(runs, bool) or runs < 1:
        raise BadInput([source.problem(("runs",), f"is {describe(runs)}", "the number of runs, at least 1")])
    return runs


def _cases(folder: Path) -> str | None:
    """The text of a folder's table of cases; None if it has none."""
    file = folder / "cases.csv"
    return read_text(file, LARGEST_TABLE, "a CSV table") if os.path.isfile(file) else None


def differences(
    before: Any, now: Any, free: Collection[str] = (), path: str = ""
) -> Iterator[tuple[str, str]]:
    """(dotted path, what) of every difference between two trees; `free` are keys at their top that may differ."""
    if isinstance(before, dict) and isinstance(now, dict):
        for key in [*before, *(key for key in now if key not in before)]:
            if path or key not in free:
                yield from differences(before.get(key), now.get(key), free, f"{path}.{key}".lstrip("."))
    elif before != now:
        yield path, f"was {_shown(before)}, is now {_shown(now)}"


def _shown(value: Any) -> str:
    return json.dumps(value)[:80] if isinstance(value, list) else describe(value)


def _changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> Iterator[str]:
    if before.get("fly") != now["fly"]:
        yield f"the function {before.get('fly')}, this is {now['fly']}"
    if before.get("aircraft_sha256") != now["aircraft_sha256"]:
        yield "other files of the aircraft, which have changed since"
    for name, digest in now.get("controllers_sha256", {}).items():
        if before.get("controllers_sha256", {}).get(name) != digest:
            yield f"other code of {name}, which has changed since"
    for name, version in now["versions"].items():
        old = before.get("versions", {}).get(name)
        if old != version:
            yield f"{name} {old or 'not installed'}, this is {version or 'not installed'}"


def _controllers(plan: Plan) -> dict[str, Any]:
    """Digest of each controller of the user's own, if there are any."""
    own = plan.builder.own
    return {"controllers_sha256": {name: each.digest for name, each in own.items()}} if own else {}


def _versions() -> dict[str, str]:
    """Versions of the packages on which the last digits of a flight may depend."""
    found = {}
    for name in _VERSIONS:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:  # run from the repository, not installed
            found[name] = ""
    return found


def _aircraft_digest(plan: Plan) -> str:
    """SHA-256 of the files of every aircraft that is flown: XML, YAML and design model."""
    digest = hashlib.sha256()
    for name in plan.aircraft_names:
        folder = load_aircraft(name).folder
        for file in sorted(f for f in folder.rglob("*") if f.suffix in (".xml", ".yaml", ".json")):
            digest.update(f"{file.relative_to(folder)}\0".encode() + file.read_bytes() + b"\0")
    return digest.hexdigest()
