"""A sweep's folder while it is flown: one process at a time, logs as asked, nothing held or rewritten."""

from __future__ import annotations

import os
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pandas as pd
import pytest
from sweep_files import fly_here, table, written

from testbed.inputs.problems import BadInput
from testbed.sweeps.folder import results
from testbed.sweeps.folder.store import Store
from testbed.sweeps.load import load_sweep
from testbed.sweeps.plan import Plan
from testbed.sweeps.workers.flying import Job, fly_task


@pytest.mark.parametrize(
    ("which", "keeps"), [("none", lambda p: p & ~p), ("failed", lambda p: ~p), ("all", lambda p: p | ~p)]
)
def test_logs_are_kept_as_asked(tmp_path: Path, which: str, keeps: Callable[[pd.Series], pd.Series]) -> None:
    plan = load_sweep(written(tmp_path), ["runs=6"])
    frame = table(fly_here(plan, tmp_path / "out", save_logs=which))
    chosen = frame[keeps(frame["passed"])]
    names = {
        f"run-{run:06d}-{kind}.parquet"
        for run, kind in zip(chosen["run"], chosen["controller.type"], strict=True)
    }
    assert {f.name for f in (tmp_path / "out").glob("logs/*")} == names
    for name in names:
        assert len(pd.read_parquet(tmp_path / "out/logs" / name)) == 50


def test_two_processes_do_not_fly_one_folder(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    store = Store(tmp_path / "out", plan, "sweep_flights:quick", resume=False)
    with pytest.raises(BadInput, match="is being flown by another process"):
        Store(tmp_path / "out", plan, "sweep_flights:quick", resume=True)
    store.close()
    Store(tmp_path / "out", plan, "sweep_flights:quick", resume=True).close()


@pytest.fixture
def plan(tmp_path: Path) -> Plan:
    return load_sweep(written(tmp_path), ["runs=20000"])


@pytest.mark.nightly
def test_rows_are_neither_held_nor_rewritten(tmp_path: Path, plan: Plan) -> None:
    """The parent's memory for a flight is its offset; the journal grows by each flight's line and by nothing
    else.
    """
    store = Store(tmp_path / "out", plan, "sweep_flights:quick", resume=False)
    flown = fly_task(Job(plan.builder, "sweep_flights:quick", "none"), plan.task(0))
    identity = os.stat(tmp_path / "out/journal.jsonl").st_ino
    tracemalloc.start()
    try:
        held = []
        for k in range(20_000):
            record = {**flown.record, "run": k // 2, "variant": k % 2}
            before = store.journal._end
            store.add(k, replace(flown, record=record))
            assert store.journal._end - before < 1000
            if k in (2_000, 19_999):
                held.append(tracemalloc.get_traced_memory()[0])
        assert held[1] - held[0] < 18_000  # less than a byte a flight: nothing is kept
        tracemalloc.reset_peak()
        results.write(plan, lambda: (record for _, record in store.records(10_000)), tmp_path)
        table = os.stat(tmp_path / "results.csv").st_size
        assert tracemalloc.get_traced_memory()[1] - held[1] < 20_000_000 > 3 * table / 3  # one group of rows
    finally:
        tracemalloc.stop()
        store.close()
    assert os.stat(tmp_path / "out/journal.jsonl").st_ino == identity
    assert sum(1 for _ in (tmp_path / "results.csv").open()) == 20_001
