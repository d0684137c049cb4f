"""Shards of a study joined into one folder."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from testbed.api.load import KEEP_LOGS, kind_of
from testbed.inputs.problems import BadInput, Problem
from testbed.studies import merge as shards
from testbed.studies.flying.flight import FLY
from testbed.studies.flying.pool import serial
from testbed.studies.folder import reading, store, table
from testbed.studies.run import Options
from testbed.studies.search.run import unsearched

_STUDY = "shards of one sweep, search, matrix or benchmark"


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
    shards.merge(plan, paths, out, mixed=mixed)
    searched = words[0] == "search"
    with store.reading(out) as stored:
        missing = unsearched(plan, stored) if searched else shards.unflown(plan, stored)
        # What is found by code of the user's cannot be written without it: a search's flights are flown once more.
        by_own = searched and (plan.builder.own or stored.inputs.get("fly") != FLY)
        if words[0] in KEEP_LOGS and not missing:
            table.write(plan, lambda: reading.records(plan, stored), out)
    if missing or by_own:
        return None, missing
    flights = kind.fly(plan, out, Options(workers=serial), resume=True) if searched else None
    return kind.finish(plan, out, flights, figures=figures), missing
