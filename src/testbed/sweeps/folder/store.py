"""A sweep's folder while it is flown: which sweep it is, and which flights have finished.

sweep.yaml       the resolved sweep with the scenario inside; it can be flown again as it is
cases.csv        the sweep's table of runs, if it has one
journal.jsonl    first line: versions, aircraft and function with which it is flown; then a line for each finished flight
histories.f32    error histories, a record of fixed size for each flight
logs/            whole logs of the flights that --save-logs chooses, such as run-000012-adaptive_inversion.parquet
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from testbed.common.files import replacing
from testbed.inputs import yaml_source as yamlfile
from testbed.sweeps.folder.histories import Histories
from testbed.sweeps.folder.journal import Journal, records
from testbed.sweeps.folder.names import flight_label
from testbed.sweeps.folder.resuming import flown_with, refuse_changed, refuse_other, runs_in
from testbed.sweeps.plan import Plan
from testbed.sweeps.workers.flying import Flown


class Store:
    """The folder, open for this process alone. A flight is identified by its number k (see `Plan.task`)."""

    def __init__(self, folder: Path, plan: Plan, fly: str, *, resume: bool) -> None:
        """Make the folder, or open it to resume. Raises BadInput when it has another sweep, or exists without `resume`."""
        self.folder, self.plan, self._new = folder, plan, not os.path.lexists(folder)
        refuse_other(folder, plan, resume)
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
            if self._new:
                shutil.rmtree(folder, ignore_errors=True)
            raise

    def __contains__(self, k: int) -> bool:
        return bool(self._offsets[k] >= 0)

    def __len__(self) -> int:
        """Number of flights that have finished."""
        return int(np.count_nonzero(self._offsets >= 0))

    def add(self, k: int, flown: Flown) -> None:
        """Store a finished flight. It counts as finished once its journal line, which is written last, is complete.

        Raises OSError when the disk is full.
        """
        if k in self:
            return
        if flown.log:
            write_whole(self.folder / "logs" / f"{flight_label(self.plan, k)}.parquet", flown.log)
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
        """Flush everything to disk and close the folder; another process may then open it."""
        try:
            self._histories.close()
        finally:
            self.journal.close()

    @property
    def is_for_nothing(self) -> bool:
        """Whether the folder was made by this process, and no flight has finished."""
        return self._new and not len(self)

    def remove_if_empty(self) -> None:
        """Remove a closed folder that was made for nothing; one that was there before stays."""
        if self.is_for_nothing:
            shutil.rmtree(self.folder, ignore_errors=True)

    def _index(self, record: Mapping[str, Any]) -> int | None:
        if "run" not in record or record["run"] >= self.plan.runs:
            return None
        return int(record["run"]) * len(self.plan.variants) + int(record["variant"])

    def _begin(self, fly: str) -> None:
        """Write the first line of a new journal, or check that of an existing one; then write sweep.yaml and cases.csv."""
        now = flown_with(self.plan, fly)
        first = next((record for _, record in records(self.journal.file)), None)
        if first is None:
            self.journal.append(now)
        else:
            refuse_changed(first, now, self.folder)
        # Only now, when the folder is known to be of this sweep. sweep.yaml is written again, as `runs` may have grown.
        if self.plan.cases_text is not None:
            write_whole(self.folder / "cases.csv", self.plan.cases_text.encode())
        write_whole(self.folder / "sweep.yaml", yamlfile.dump(self.plan.tree).encode())


def runs_of(folder: Path) -> int | None:
    """Number of runs in the sweep.yaml of a folder; None if there is none. Raises BadInput if the file does not say."""
    file = folder / "sweep.yaml"
    return runs_in(yamlfile.read(file)) if os.path.isfile(file) else None


def write_whole(file: Path, content: bytes) -> None:
    """Write a file completely or not at all, and flush it to disk."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with replacing(file) as partial, partial.open("wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
