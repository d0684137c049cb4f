"""Shards of a sweep, a matrix or a benchmark joined into one folder."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from testbed.api.load import KEEP_LOGS, SHARDED, kind_of
from testbed.inputs.problems import BadInput, Problem
from testbed.studies import merge as shards


def merge(
    folders: Sequence[str | Path], out: str | Path, *, figures: bool = True, mixed: bool = False
) -> tuple[dict[str, Any] | None, list[int]]:
    """Join shards into a new folder, the same as if one machine had flown all runs; returns its summary, and the missing runs.

    While runs are missing there is no summary: the folder is that of an unfinished study, and `--resume` flies them.

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
        if word not in SHARDED or word != words[0]:
            what = f"is the folder of a {word}"
            raise BadInput([Problem(what, str(path), expected="shards of one sweep, matrix or benchmark")])
    kind = import_module(f"testbed.api.{words[0]}")
    plan = kind.plan_of(paths[0])
    if other := [path for path in paths if words[0] == "benchmark" and kind.plan_of(path).size != plan.size]:
        raise BadInput([Problem("has another number of draws", str(path)) for path in other])
    missing = shards.merge(plan, paths, out, tabled=words[0] in KEEP_LOGS, mixed=mixed)
    return (None if missing else kind.finish(plan, out, figures=figures)), missing
