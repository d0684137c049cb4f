"""A study's folder while it is flown. It must be new or, to resume, have been begun with the same inputs.

sweep.yaml       or the name of another kind: the resolved study with the scenario inside; it can be flown again as it is
cases.csv        a sweep's table of runs, if it has one
flights.sqlite   what the study was begun with, and every flight that has finished (see `store`)
logs/            whole logs of the flights that --save-logs chooses, such as run-000012-adaptive_inversion.parquet
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.aircraft.description import load_aircraft
from testbed.common.arithmetic import differences, environment
from testbed.common.writing import remove_partial, write
from testbed.controllers.user.own import sha256_of
from testbed.flight.folder import FolderExists
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.input_file import read_text
from testbed.inputs.output_file import cannot_write
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import refuse_links
from testbed.inputs.yaml_source import Source, describe
from testbed.parts import digests
from testbed.studies.folder import store
from testbed.studies.folder.logs import runs_in
from testbed.studies.load import LARGEST_TABLE
from testbed.studies.plan import Plan
from testbed.studies.record import MIXED

_FILES = ("results.csv", "results.parquet", "summary.json", "report.html", store.NAME, f"{store.NAME}-wal")
_RESULTS = _FILES[:4]
_FOLDERS = ("logs", "figures", "flights")


def begin(folder: Path, plan: Plan, fly: str, *, resume: bool, mixed: bool = False) -> store.Store:
    """Make the folder of a study, or open it to resume, with `mixed` also in another environment; returns its store.

    Raises BadInput when it has another study, or exists without `resume`, or cannot be written.
    """
    try:
        refuse_other(folder, plan, resume)
        refuse_blocked(folder)
        folder.mkdir(parents=True, exist_ok=True)
        now = begun_with(plan, fly)
        if not store.exists(folder):
            store.create(folder, now)
        stored = store.opened(folder)
        try:
            refuse_changed(stored.inputs, now, folder, mixed=mixed)
            for _ in stored.records():  # each is checked before anything is flown
                pass
            remove_partial(folder)  # while no other process flies into it
            # Only now, when the folder is known to be of this study. The file is written again, as `runs` may have grown.
            write_study(folder, plan)
        except BaseException:
            stored.close()
            raise
        return stored
    except OSError as error:
        raise BadInput([cannot_write(folder, error)]) from None


def write_study(folder: Path, plan: Plan) -> None:
    """Write the resolved study, and its table of runs if it has one."""
    if plan.cases_text is not None:
        write(folder / "cases.csv", plan.cases_text)
    write(folder / f"{plan.study.word}.yaml", yamlfile.dump(plan.tree))


def refuse_blocked(folder: Path) -> None:
    """Raise BadInput where a study's folder has a folder in place of a file that is written, or a file in place of a folder."""
    problems = [
        Problem("is a folder", str(folder / name), expected="a file")
        for name in _FILES
        if os.path.isdir(folder / name)
    ]
    for name in _FOLDERS:
        if os.path.lexists(folder / name) and not os.path.isdir(folder / name):
            problems.append(Problem("is a file", str(folder / name), expected="a folder"))
    if problems:
        raise BadInput(problems)


def remove_results(folder: Path) -> None:
    """Remove what was found in a study's flights, as far as it is there: from now on it has more."""
    for name in _RESULTS:
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(folder / "figures", ignore_errors=True)


def is_new(folder: Path) -> bool:
    """Whether there is no such folder, or an empty one; hidden files are what a killed process had begun to write."""
    if not os.path.lexists(folder):
        return True
    return folder.is_dir() and all(file.name.startswith(".") for file in folder.iterdir())


def begun_with(plan: Plan, fly: str) -> dict[str, Any]:
    """Everything, besides the study itself, that the results of the flights depend on."""
    return {
        "fly": fly,
        "aircraft_sha256": _aircraft_digest(plan),
        **environment(),
        "controllers_sha256": {name: own.digest for name, own in plan.builder.own.items()},
        "parts_sha256": digests(),
    }


def refuse_changed(
    before: Mapping[str, Any], now: Mapping[str, Any], folder: Path, *, mixed: bool = False
) -> None:
    """Raise BadInput when a folder's study was begun with other inputs than those of now, or, unless `mixed`, in another
    environment."""
    problems = [Problem(f"was begun with {what}", str(folder)) for what in _changed(before, now)]
    if not mixed:
        problems += [
            Problem(f"was begun with {what}", str(folder), expected=MIXED)
            for what in differences(before, now)
        ]
    if problems:
        raise BadInput(problems)


def refuse_other(folder: Path, plan: Plan, resume: bool) -> None:
    """Raise BadInput unless the folder is new or empty or, with `resume`, has the same study with as many runs or fewer."""
    if is_new(folder):
        return
    if not resume:
        what = "a new folder, or --resume to go on with this one"
        raise FolderExists([Problem("exists already", str(folder), expected=what)])
    refuse_links(folder)
    word = plan.study.word
    file = folder / f"{word}.yaml"
    if not file.is_file():
        if not store.exists(folder) or any(folder.glob("*.yaml")):
            raise BadInput([Problem(f"is not the folder of a {word}", str(folder))])
        return  # the process was killed before it wrote the file
    if (folder / "journal.jsonl").is_file() and not store.exists(folder):
        what = "was begun by an earlier version of testbed, and cannot be resumed"
        raise BadInput([Problem(what, str(folder), expected="a new folder")])
    source = yamlfile.read(file)
    now = yamlfile.parse(yamlfile.dump(plan.tree)).tree
    differences = [*_differences(source.tree, now, plan.study.free)]
    if plan.cases_text is not None and _cases(folder) != plan.cases_text:
        differences.append(("cases", "the table has changed"))
    problems = [Problem(what, str(file), None, path, f"an unchanged {word}") for path, what in differences]
    problems += _refused_runs(plan, source) if "runs" in now else ()
    if problems:
        raise BadInput(problems)


def _refused_runs(plan: Plan, source: Source) -> Iterator[Problem]:
    """Why the sweep of a folder cannot go on with the number of runs of the plan."""
    runs = runs_in(source)
    if plan.runs < runs:
        yield Problem(f"has {runs} already", source.file, None, "runs", "at least as many")
    if plan.runs > runs and plan.tree.get("sampling") == "latin_hypercube":
        what = f"a latin hypercube of {runs} runs cannot be made longer: its points depend on their number"
        yield Problem(what, source.file, None, "runs", "sobol, halton or random for that")


def _cases(folder: Path) -> str | None:
    """The text of a folder's table of cases; None if it has none."""
    file = folder / "cases.csv"
    return read_text(file, LARGEST_TABLE, "a CSV table") if os.path.isfile(file) else None


def _differences(
    before: Any, now: Any, free: tuple[str, ...] = (), path: str = ""
) -> Iterator[tuple[str, str]]:
    """(dotted path, what) of every difference between two trees; `free` are keys at their top that may differ."""
    if isinstance(before, dict) and isinstance(now, dict):
        for key in [*before, *(key for key in now if key not in before)]:
            if path or key not in free:
                yield from _differences(before.get(key), now.get(key), free, f"{path}.{key}".lstrip("."))
    elif before != now:
        yield path, f"was {_said(before)}, is now {_said(now)}"


def _said(value: Any) -> str:
    return json.dumps(value)[:80] if isinstance(value, list) else describe(value)


def _changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> Iterator[str]:
    if before.get("fly") != now.get("fly"):
        yield f"the function {before.get('fly')}, this is {now.get('fly')}"
    if before.get("aircraft_sha256") != now.get("aircraft_sha256"):
        yield "other files of the aircraft, which have changed since"
    known = before.get("controllers_sha256", {})
    for name, digest in now.get("controllers_sha256", {}).items():
        if known.get(name) != digest:
            yield f"other code of {name}, which has changed since"
    # A folder of an earlier version has none.
    parts, used = (each.get("parts_sha256", {}) for each in (before, now))
    for name in sorted({*parts, *used}):
        if name not in parts:
            yield f"no parts {name}, which are used now"
        elif name not in used:
            yield f"the parts {name}, which --with has to give"
        elif parts[name] != used[name]:
            yield f"other code of {name}, which has changed since"


def _aircraft_digest(plan: Plan) -> str:
    """SHA-256 of the files of every aircraft that is flown: XML, YAML and design model."""
    folders = (load_aircraft(name).folder for name in plan.aircraft_names)
    files = ((folder, file) for folder in folders for file in sorted(folder.rglob("*")))
    return sha256_of(
        (str(file.relative_to(folder)), file.read_bytes())
        for folder, file in files
        if file.suffix in (".xml", ".yaml", ".json")
    )
