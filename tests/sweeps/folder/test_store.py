"""A sweep's folder: whose it is, what may go on in it, and what it keeps."""

from __future__ import annotations

import os
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pandas as pd
import pytest
from sweep_files import fly_here, table, written
from sweep_flights import quick

import testbed
from testbed.inputs.problems import BadInput
from testbed.sweeps.folder import results
from testbed.sweeps.folder.store import Store
from testbed.sweeps.plan import Plan, load_sweep
from testbed.sweeps.workers.flying import Job, fly_task

CHANGES: list[tuple[list[str], str]] = [
    (["seed=4"], "sweep.yaml: seed: was 3, is now 4, expected an unchanged sweep"),
    (["sampling=halton"], "sweep.yaml: sampling: was 'sobol', is now 'halton', expected an unchanged sweep"),
    (["duration_s=2"], "sweep.yaml: scenario.duration_s: was 1, is now 2, expected an unchanged sweep"),
]


@pytest.mark.parametrize(("change", "words"), CHANGES)
def test_a_changed_sweep_is_not_resumed(tmp_path: Path, change: list[str], words: str) -> None:
    sweep = written(tmp_path)
    fly_here(load_sweep(sweep, ["runs=4"]), tmp_path / "out")
    before = {f: f.read_bytes() for f in (tmp_path / "out").rglob("*") if f.is_file()}
    with pytest.raises(BadInput) as refused:
        testbed.sweep(sweep, tmp_path / "out", settings=["runs=4", *change], resume=True, fly=quick)
    assert str(refused.value).endswith(words)
    with pytest.raises(BadInput, match=r"sweep\.yaml: runs: has 4 already, expected at least as many"):
        testbed.sweep(sweep, tmp_path / "out", runs=3, resume=True, fly=quick)
    assert before == {f: f.read_bytes() for f in (tmp_path / "out").rglob("*") if f.is_file()}


def test_what_it_was_flown_with_must_be_the_same(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    fly_here(load_sweep(sweep), tmp_path / "out")
    with pytest.raises(BadInput, match="was begun with the function sweep_flights:quick"):
        testbed.sweep(sweep, tmp_path / "out", resume=True)
    with pytest.raises(BadInput, match="exists already, expected a new folder, or --resume"):
        testbed.sweep(sweep, tmp_path / "out", fly=quick)


def test_a_latin_hypercube_cannot_be_made_longer(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    settings = ["sampling=latin_hypercube"]
    fly_here(load_sweep(sweep, [*settings, "runs=6"]), tmp_path / "out")
    values = table(tmp_path / "out")["failures.0.value"].to_numpy()[::2]
    assert sorted((values * 6).astype(int)) == list(range(6))  # one in each stratum
    with pytest.raises(BadInput, match="a latin hypercube of 6 runs cannot be made longer"):
        testbed.sweep(sweep, tmp_path / "out", runs=8, settings=settings, fly=quick, resume=True)


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


@pytest.mark.slow
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
