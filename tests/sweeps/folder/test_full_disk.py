"""A disk that is full at any byte of a sweep folder: what has been stored is kept, and resuming gives the same bytes."""

from __future__ import annotations

import contextlib
import itertools
import shutil
from pathlib import Path

import pytest
from full_disk import largest_file
from sweep_files import fly_here, same_rows, written

from testbed.sweeps.folder import results
from testbed.sweeps.folder.store import Store
from testbed.sweeps.load import load_sweep
from testbed.sweeps.plan import Plan
from testbed.sweeps.workers.flying import Job, fly_task

FLY = "sweep_flights:quick"
STRIDE = 8009
"""A prime: the limit meets the middle of lines and records."""


def flown(plan: Plan, folder: Path) -> None:
    """Fly what is missing, as `run.fly_sweep` does, in this process."""
    store = Store(folder, plan, FLY, resume=True)
    try:
        for k in range(plan.size):
            if k not in store:
                store.add(k, fly_task(Job(plan.builder, FLY, "all"), plan.task(k)))
        results.write(plan, lambda: (record for _, record in store.records(plan.runs)), folder)
    finally:
        with contextlib.suppress(OSError):
            store.close()


def test_a_sweep_goes_on_after_a_full_disk(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    whole = fly_here(plan, tmp_path / "whole", FLY, save_logs="all")
    size = max(file.stat().st_size for file in whole.rglob("*") if file.is_file())
    for limit in [*range(0, size, STRIDE), size - 1]:
        goes_on(plan, whole, tmp_path / "out", limit)


@pytest.mark.nightly
def test_a_sweep_goes_on_where_the_disk_was_full_at_the_end_of_a_record(tmp_path: Path) -> None:
    """The last byte of a line of the journal is the one that is lacking, or the first of the next; every third line is tried."""
    plan = load_sweep(written(tmp_path))
    whole = fly_here(plan, tmp_path / "whole", FLY, save_logs="all")
    lines = (whole / "journal.jsonl").read_bytes().splitlines(keepends=True)
    assert len(lines) == 1 + plan.size
    for end in list(itertools.accumulate(map(len, lines)))[::3]:
        for limit in (end - 1, end):
            goes_on(plan, whole, tmp_path / "out", limit)


def goes_on(plan: Plan, whole: Path, folder: Path, limit: int) -> None:
    """The sweep fails when a file has reached the limit [bytes], and is then finished like the whole one."""
    with largest_file(limit), pytest.raises(OSError, match="File too large"):
        flown(plan, folder)
    assert not list(folder.rglob("*.partial")), limit
    flown(plan, folder)
    same_rows(whole, folder)
    shutil.rmtree(folder)
