"""Join the shards of one study, flown on many machines, into the folder that one machine would have left."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

from testbed.api.load import KEEP_LOGS, kind_of
from testbed.common.arithmetic import differences
from testbed.common.writing import write
from testbed.inputs.input_file import MEGABYTE, read_bytes
from testbed.inputs.problems import BadInput, Problem, collect
from testbed.studies.flying.flight import FLY
from testbed.studies.flying.pool import serial
from testbed.studies.folder import store, table
from testbed.studies.folder.begin import is_new, refuse_changed, refuse_other, write_study
from testbed.studies.folder.store import Store
from testbed.studies.plan import Plan
from testbed.studies.record import Begun, Record, key_of
from testbed.studies.run import Options
from testbed.studies.search.run import unsearched

_STUDY = "shards of one sweep, search, matrix or benchmark"
_LARGEST_LOG = 1000 * MEGABYTE


def merge(
    folders: Sequence[str | Path], out: str | Path, *, figures: bool = True, mixed: bool = False
) -> tuple[dict[str, Any] | None, Sequence[int | str]]:
    """Join shards into a new folder, the same as if one machine had flown all; returns its summary, and the missing runs.

    Of a search, what is missing are searches of variants and options, by their labels. While something is missing there is
    no summary: the folder is that of an unfinished study, and `--resume` flies the rest. Nor is there one of a search with
    controllers of the user's own or another function that flies: `--resume` with these writes what was found.

    Args:
        folders: those that `--shard` made, finished or not.
        out: the folder to make.
        figures: whether to draw figures and write the report.
        mixed: allow shards of another environment than the first's, and mark their flights in the table.

    Raises BadInput, and makes nothing, when the folders are not of one study, or contradict each other.
    """
    paths, out = [Path(folder) for folder in folders], Path(out)
    words = [kind_of(path) for path in paths]
    for word, path in zip(words, paths, strict=True):
        if word in ("run", "log") or word != words[0]:
            raise BadInput([Problem(f"is the folder of a {word}", str(path), expected=_STUDY)])
    kind = import_module(f"testbed.api.{words[0]}")
    plan = kind.plan_of(paths[0])
    if other := [path for path in paths if words[0] == "benchmark" and kind.plan_of(path).size != plan.size]:
        raise BadInput([Problem("has another number of draws", str(path)) for path in other])
    join(plan, paths, out, mixed=mixed)
    searched = words[0] == "search"
    with store.reading(out) as stored:
        missing = unsearched(plan, stored) if searched else unflown(plan, stored)
        # What is found by code of the user's cannot be written without it: a search's flights are flown once more.
        by_own = searched and (plan.builder.own or stored.inputs.get("fly") != FLY)
        if words[0] in KEEP_LOGS and not missing:
            table.write(plan, lambda: table.records(plan, stored), out)
    if missing or by_own:
        return None, missing
    flights = kind.fly(plan, out, Options(workers=serial), resume=True) if searched else None
    return kind.finish(plan, out, flights, figures=figures), missing


def join(plan: Plan, folders: Sequence[Path], out: Path, *, mixed: bool = False) -> None:
    """Make the folder `out` with the flights of all the folders.

    Raises BadInput, and leaves nothing, when they are not of one study that was begun with the same inputs, or when two have
    another result of the same flight. With `mixed` they may be of several environments.
    """
    if not is_new(out):
        raise BadInput([Problem("exists already", str(out), expected="a new folder")])
    with store.reading(folders[0]) as first:
        inputs = first.inputs
    _refuse_strangers(plan, folders, inputs, mixed)
    out.mkdir(parents=True, exist_ok=True)
    try:
        store.create(out, inputs)
        _fill(plan, folders, out)
    except BaseException:
        shutil.rmtree(out, ignore_errors=True)
        raise


def _refuse_strangers(plan: Plan, folders: Sequence[Path], inputs: Begun, mixed: bool) -> None:
    problems: list[Problem] = []
    for folder in folders[1:]:
        with store.reading(folder) as other:
            collect(problems, lambda f=folder: refuse_other(f, plan, resume=True))  # type: ignore[misc]
            collect(problems, lambda f=folder, o=other: refuse_changed(o.inputs, inputs, f, mixed=mixed))  # type: ignore[misc]
    if problems:
        raise BadInput(problems)


def _fill(plan: Plan, folders: Sequence[Path], out: Path) -> None:
    merged = store.opened(out)
    try:
        for folder in folders:
            with store.reading(folder) as shard:
                _add(merged, shard)
            for log in sorted((folder / "logs").glob("*.parquet")):
                write(out / "logs" / log.name, _contents(log), within=out)
        write_study(out, plan)
    finally:
        merged.close()


def unflown(plan: Plan, store: Store) -> list[int]:
    """The runs of which flights are missing."""
    n = len(plan.variants)
    return sorted({k // n for k in range(plan.size) if key_of(k) not in store})


def _contents(log: Path) -> bytes:
    """A kept log; raises BadInput for a link, which may lead out of a folder."""
    if log.is_symlink():
        raise BadInput([Problem("is a link", str(log), expected="a log that a sweep kept")])
    return read_bytes(log, _LARGEST_LOG, "a log that a sweep kept")


def _add(merged: Store, shard: Store) -> None:
    """Add the flights of a shard, marked where it is of another environment; one that is there already must be the same."""
    mark = "; ".join(differences(merged.inputs, shard.inputs))
    for key, record in shard.records():
        if key not in merged:
            environment = "; of a folder with ".join(filter(None, (record.environment, mark)))
            merged.add(key, replace(record, environment=environment), shard.history(key))
        elif _result(merged.record(key)) != _result(record):
            what = f"has another result of run {record.run} than a folder before it"
            raise BadInput([Problem(what, str(shard.folder))])


def _result(record: Record) -> str:
    """Everything but where it was flown, as a text, in which NaN is equal to NaN."""
    return repr(replace(record, environment=""))
