"""A sweep's folder while it is flown: which sweep it is, and which flights have finished.

sweep.yaml       the resolved sweep with the scenario inside; it flies again as it is
cases.csv        its table of runs, if it has one
journal.jsonl    first line: versions, aircraft and function that it is flown with; then a line a finished flight
histories.f32    error histories, a record of fixed size a flight
logs/            run-000012-adaptive_inversion.parquet: whole logs, as --save-logs says
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.description import load_aircraft
from testbed.common.files import replacing
from testbed.flight.folder import FolderExists
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import describe
from testbed.sweeps.folder.histories import Histories
from testbed.sweeps.folder.journal import Journal, records
from testbed.sweeps.plan import Plan
from testbed.sweeps.workers.flying import Flown

_FREE = ("name", "runs", "stop_when")
"""Keys of sweep.yaml that may change when a sweep is resumed, because no row depends on them."""
_VERSIONS = ("testbed", "jsbsim", "numpy", "scipy", "numba")


class Store:
    """The folder, open for this process alone. Flights go by their number k, see `Plan.task`."""

    def __init__(self, folder: Path, plan: Plan, fly: str, *, resume: bool) -> None:
        """Make the folder or open it again. Raises BadInput when it holds another sweep, or exists without `resume`."""
        self.folder, self.plan = folder, plan
        _refuse_other(folder, plan, resume)
        folder.mkdir(parents=True, exist_ok=True)
        self.journal = Journal(folder / "journal.jsonl")
        try:
            self._begin(fly)
            self._histories = Histories(folder / "histories.f32")
            self._offsets = np.full(plan.size, -1, dtype=np.int64)
            for offset, record in records(self.journal.file):
                k = self._index(record)
                if k is not None:
                    self._offsets[k] = offset
        except BaseException:
            self.journal.close()
            raise

    def __contains__(self, k: int) -> bool:
        return bool(self._offsets[k] >= 0)

    def __len__(self) -> int:
        """Number of flights that have finished."""
        return int(np.count_nonzero(self._offsets >= 0))

    def add(self, k: int, flown: Flown) -> None:
        """Keep a finished flight. It counts from its journal line on, which is written last.

        Raises OSError when the disk is full.
        """
        if k in self:
            return
        if flown.log:
            _write_whole(self.folder / "logs" / f"{flight_label(self.plan, k)}.parquet", flown.log)
        if flown.history:
            self._histories.put(k, flown.history)
        self._offsets[k] = self.journal.append(flown.record)

    def record(self, k: int) -> dict[str, Any]:
        """The journal's record of flight k."""
        return self.journal.read(int(self._offsets[k]))

    def records(self, runs: int) -> Iterator[tuple[int, dict[str, Any]]]:
        """(k, record) of the finished flights of the first `runs` runs, in order, one at a time."""
        for k in range(runs * len(self.plan.variants)):
            if k in self:
                yield k, self.record(k)

    def close(self) -> None:
        """Close the folder, with everything on disk; another process may then open it."""
        try:
            self._histories.close()
        finally:
            self.journal.close()

    def _index(self, record: Mapping[str, Any]) -> int | None:
        if "run" not in record or record["run"] >= self.plan.runs:
            return None
        return int(record["run"]) * len(self.plan.variants) + int(record["variant"])

    def _begin(self, fly: str) -> None:
        """Write the first line of a new journal; of an existing one, check that it was begun with the same versions."""
        header = {
            "journal": 1,
            "fly": fly,
            "aircraft_sha256": aircraft_digest(self.plan),
            "versions": versions(),
        }
        first = next((record for _, record in records(self.journal.file)), None)
        if first is None:
            self.journal.append(header)
        else:
            problems = [
                Problem(f"was begun with {what}", str(self.folder)) for what in _changed(first, header)
            ]
            if problems:
                raise BadInput(problems)
        # Now it is certain that the folder is this sweep's. The sweep may have more runs than before.
        if self.plan.cases_text is not None:
            _write_whole(self.folder / "cases.csv", self.plan.cases_text.encode())
        _write_whole(self.folder / "sweep.yaml", yamlfile.dump(self.plan.tree).encode())


def flight_label(plan: Plan, k: int) -> str:
    """The name of flight k in file names: `run-000012-adaptive_inversion`."""
    run, variant = divmod(k, len(plan.variants))
    label = "".join(c if c.isalnum() or c in "_-." else "-" for c in plan.variants[variant].label)
    return f"run-{run:06d}" + (f"-{label}" if label else "")


def runs_of(folder: Path) -> int | None:
    """Number of runs of the sweep in a folder; None when there is no sweep."""
    file = folder / "sweep.yaml"
    return int(yamlfile.read(file).tree["runs"]) if file.is_file() else None


def versions() -> dict[str, str]:
    """Versions of the packages that the last bit of a flight may depend on."""
    found = {}
    for name in _VERSIONS:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:  # run from the repository, not installed
            found[name] = ""
    return found


def aircraft_digest(plan: Plan) -> str:
    """SHA-256 of the aircraft's files: XML, YAML and design model."""
    folder = load_aircraft(str(plan.builder.base.tree["aircraft"])).folder
    digest = hashlib.sha256()
    for file in sorted(f for f in folder.rglob("*") if f.suffix in (".xml", ".yaml", ".json")):
        digest.update(f"{file.relative_to(folder)}\0".encode() + file.read_bytes() + b"\0")
    return digest.hexdigest()


def _changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> Iterator[str]:
    if before.get("fly") != now["fly"]:
        yield f"the function {before.get('fly')}, this is {now['fly']}"
    if before.get("aircraft_sha256") != now["aircraft_sha256"]:
        yield "other files of the aircraft, which have changed since"
    for name, version in now["versions"].items():
        old = before.get("versions", {}).get(name)
        if old != version:
            yield f"{name} {old or 'not installed'}, this is {version or 'not installed'}"


def _refuse_other(folder: Path, plan: Plan, resume: bool) -> None:
    """Raise BadInput unless the folder is new or empty or, with `resume`, holds this sweep with no more runs."""
    file = folder / "sweep.yaml"
    if not os.path.lexists(folder) or (folder.is_dir() and not any(folder.iterdir())):
        return
    journal = folder / "journal.jsonl"
    if not resume:
        what = "a new folder, or --resume to go on with this one"
        raise FolderExists([Problem("exists already", str(folder), expected=what)])
    if not file.is_file():
        if not journal.is_file():
            raise BadInput([Problem("is not the folder of a sweep", str(folder))])
        return  # it was killed before it could write sweep.yaml
    before = yamlfile.read(file).tree
    now = yamlfile.parse(yamlfile.dump(plan.tree)).tree
    problems = [
        Problem(what, str(file), None, path, "an unchanged sweep") for path, what in _differences(before, now)
    ]
    if plan.runs < before["runs"]:
        problems.append(Problem(f"has {before['runs']} already", str(file), None, "runs", "at least as many"))
    if plan.runs > before["runs"] and not plan.extendable:
        what = f"a latin hypercube of {before['runs']} runs cannot be made longer: its points depend on their number"
        problems.append(Problem(what, str(file), None, "runs", "sobol, halton or random for that"))
    if plan.cases_text is not None and (folder / "cases.csv").read_text(encoding="utf-8") != plan.cases_text:
        problems.append(Problem("the table has changed", str(file), None, "cases", "an unchanged sweep"))
    if problems:
        raise BadInput(problems)


def _differences(before: Any, now: Any, path: str = "") -> Iterator[tuple[str, str]]:
    """(dotted path, what) of every difference that could change a row."""
    if isinstance(before, dict) and isinstance(now, dict):
        for key in [*before, *(key for key in now if key not in before)]:
            if path or key not in _FREE:
                yield from _differences(before.get(key), now.get(key), f"{path}.{key}".lstrip("."))
    elif before != now:
        yield path, f"was {_shown(before)}, is now {_shown(now)}"


def _shown(value: Any) -> str:
    return json.dumps(value)[:80] if isinstance(value, list) else describe(value)


def _write_whole(file: Path, content: bytes) -> None:
    """Write a file whole or not at all."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with replacing(file) as partial, partial.open("wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
