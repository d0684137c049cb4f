"""A search's folder while it is flown: which search it is, and the flights that have finished.

search.yaml      the resolved search with the scenario inside; it can be flown again as it is
journal.jsonl    first line: versions, aircraft and function with which it is flown; then a line for each finished flight
results.csv      at the end, a row for each flight in the order in which the search asked for it; and results.parquet

A search that goes on in a folder is done again from its beginning, with the flights of the journal in place of those that have
been flown. So its answer has the same bytes as that of a search without interruption.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from testbed.flight.folder import FolderExists
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput, Problem
from testbed.searches.plan import Key, Part, SearchPlan, key_of
from testbed.sweeps.folder import results
from testbed.sweeps.folder.journal import Journal, records
from testbed.sweeps.folder.resuming import differences, flown_with, refuse_changed
from testbed.sweeps.folder.store import write_whole

SEARCH, JOURNAL = "search.yaml", "journal.jsonl"
_FREE = ("name", "budget", "cov", "method", "starts")
"""Keys of search.yaml that may change when a search goes on, because no flight depends on them."""


class Store:
    """The folder, open for this process alone."""

    def __init__(self, folder: Path, plan: SearchPlan, fly: str, *, resume: bool) -> None:
        """Make the folder, or open it to go on. Raises BadInput when it has another search, or exists without `resume`."""
        self.folder, self._new = folder, not os.path.lexists(folder)
        _refuse_other(folder, plan, resume)
        folder.mkdir(parents=True, exist_ok=True)
        self._journal = Journal(folder / JOURNAL)
        try:
            self._begin(plan, fly)
            kept = records(self._journal.file)
            self._offsets = {_key(record): offset for offset, record in kept if "part" in record}
        except BaseException:
            self._journal.close()
            raise

    def __contains__(self, key: Key) -> bool:
        return key in self._offsets

    def __len__(self) -> int:
        """Number of flights that have finished."""
        return len(self._offsets)

    def add(self, key: Key, record: Mapping[str, Any]) -> None:
        """Store a finished flight; raises OSError when the disk is full."""
        part, point = key
        self._offsets[key] = self._journal.append({"part": part, "u": list(point), **record})

    def record(self, key: Key) -> dict[str, Any]:
        """The record of a flight (see `sweeps.workers.flying`), with its `part` and its point `u`."""
        return self._journal.read(self._offsets[key])

    def close(self) -> None:
        """Flush everything to disk; another process may then open the folder."""
        self._journal.close()

    def remove(self) -> None:
        """Remove a folder that was made for nothing; one that was there before stays."""
        if self._new:
            for name in (SEARCH, JOURNAL):
                (self.folder / name).unlink(missing_ok=True)
            self.folder.rmdir()

    def _begin(self, plan: SearchPlan, fly: str) -> None:
        now = flown_with(plan.plan, fly)
        first = next((record for _, record in records(self._journal.file)), None)
        if first is None:
            self._journal.append(now)
        else:
            refuse_changed(first, now, self.folder)
        write_whole(self.folder / SEARCH, yamlfile.dump(plan.tree).encode())


def _key(record: Mapping[str, Any]) -> Key:
    return record["part"], tuple(record["u"])


def _refuse_other(folder: Path, plan: SearchPlan, resume: bool) -> None:
    """Raise BadInput unless the folder is new or empty or, with `resume`, has the same search."""
    if not os.path.lexists(folder) or (folder.is_dir() and not any(folder.iterdir())):
        return
    if not resume:
        what = "a new folder, or --resume to go on with this one"
        raise FolderExists([Problem("exists already", str(folder), expected=what)])
    file = folder / SEARCH
    if not file.is_file():
        if not (folder / JOURNAL).is_file() or os.path.lexists(folder / "sweep.yaml"):
            raise BadInput([Problem("is not the folder of a search", str(folder))])
        return  # the process was killed before it wrote search.yaml
    before, now = yamlfile.read(file).tree, yamlfile.parse(yamlfile.dump(plan.tree)).tree
    problems = [
        Problem(what, str(file), None, path, "an unchanged search")
        for path, what in differences(before, now, _FREE)
    ]
    if problems:
        raise BadInput(problems)


def write_table(
    plan: SearchPlan, store: Store, asked: Iterable[tuple[Part, list[tuple[float, ...]]]]
) -> None:
    """Write results.csv and results.parquet: the flights of each part, by the points in the order in which they were asked for."""
    order = [key_of(part, point) for part, points in asked for point in points]
    numbers = [k for _, points in asked for k in range(len(points))]
    results.write(plan.plan, lambda: (_row(plan, store.record(key), k) for key, k in zip(order, numbers, strict=True)),
                  store.folder)  # fmt: skip


def _row(plan: SearchPlan, record: dict[str, Any], number: int) -> dict[str, Any]:
    """The record as the table has it: with its number, its distance, and its coordinates."""
    coordinates = plan.parts[record["part"]].space.coordinates
    named = {f"u.{each.path}": u for each, u in zip(coordinates, record["u"], strict=True)}
    distance = sum(u * u for u in record["u"]) ** 0.5
    return {**record, "run": number, "metrics": {"distance": distance, **named, **record.get("metrics", {})}}
