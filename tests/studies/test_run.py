"""However and in how many pieces a sweep is flown, its bytes are the same."""

from __future__ import annotations

import os
import random
import resource
import subprocess
import time
from pathlib import Path

import pytest
from sweep_files import (
    SWEEP,
    finished,
    flown,
    fly_here,
    same_rows,
    script,
    sorted_files,
    stored,
    swept,
    table,
    written,
)
from sweep_flights import quick

import testbed
from testbed.studies.folder import store
from testbed.studies.load import load_sweep
from testbed.studies.run import Options, fly_sweep


def test_any_number_of_workers_gives_the_same_bytes(tmp_path: Path) -> None:
    """More workers than cores, and only one."""
    sweep, one = written(tmp_path), tmp_path / "one"
    testbed.sweep(sweep, one, jobs=1, figures=False)
    testbed.sweep(sweep, tmp_path / "out", jobs=3, figures=False)
    same_rows(one, tmp_path / "out")
    assert sorted_files(one) == sorted_files(tmp_path / "out")
    assert (one / "summary.json").read_bytes() == (tmp_path / "out/summary.json").read_bytes()


@pytest.mark.nightly
def test_killed_at_random_instants_and_resumed(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    whole = fly_here(load_sweep(sweep), tmp_path / "whole", "sweep_flights:slow")
    arguments = script(flown(sweep, tmp_path / "out", "jobs=2, resume=True, save_logs='none'"))
    instants = random.Random(5)
    kept: list[int] = []
    for _ in range(4):
        process = subprocess.Popen(arguments, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        began = len(kept)
        while process.poll() is None and finished(tmp_path / "out") == (kept[-1] if kept else 0):
            time.sleep(0.01)  # let each attempt get somewhere, then pick an instant
        time.sleep(instants.uniform(0.0, 0.1))
        process.kill()
        process.communicate()
        kept.append(finished(tmp_path / "out"))
        assert len(table(tmp_path / "out")) <= 24 and len(kept) == began + 1  # readable as it is
    assert kept == sorted(kept)
    done = subprocess.run(arguments, cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    same_rows(whole, tmp_path / "out")
    assert not list((tmp_path / "out").rglob(".*partial"))


def test_what_a_killed_process_had_begun_to_write_is_removed(tmp_path: Path) -> None:
    """Killed in the very moment in which the table was written, or a flight's folder."""
    sweep, out = written(tmp_path), tmp_path / "out"
    swept(sweep, out, runs=2)
    (out / ".0123456789abcdef.partial").write_text("run,see")
    (out / "logs").mkdir(exist_ok=True)
    (out / "logs/.0123456789abcdef.partial").write_text("PAR1")
    (out / ".found.x.partial").mkdir()
    (out / ".found.x.partial/log.csv").write_text("time_s")
    swept(sweep, out, runs=2, resume=True)
    assert not list(out.rglob(".*"))


def test_resuming_flies_only_the_rest(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    swept(sweep, tmp_path / "out", runs=5)
    before = stored(tmp_path / "out")
    swept(sweep, tmp_path / "out", runs=9, resume=True)
    after = stored(tmp_path / "out")
    assert after[:10] == before and len(after) == 9 * 2
    same_rows(fly_here(load_sweep(sweep, ["runs=9"]), tmp_path / "whole"), tmp_path / "out")


@pytest.mark.nightly
def test_a_full_disk_keeps_what_had_finished(tmp_path: Path) -> None:
    """Files that may not grow beyond 60 kB stand for the disk: the next flight does not fit."""
    sweep = written(tmp_path)
    limited = f"""
import resource
from pathlib import Path
from testbed.api import sweep
from testbed.studies.run import Options, Stopped
from testbed.studies.run import fly_sweep
plan, folder = sweep.prepare({str(sweep)!r}, {str(tmp_path / "out")!r}, runs=50)
resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, 60_000))
try:
    fly_sweep(plan, folder, Options(jobs=2, save_logs="none", fly=sweep_flights.quick))
except Stopped as stopped:
    print(stopped)
"""
    without_bytecode = {
        **os.environ,
        "PYTHONDONTWRITEBYTECODE": "1",
    }  # Python would not notice files cut short
    result = subprocess.run(
        script(limited), capture_output=True, text=True, check=False, env=without_bytecode
    )
    assert "cannot write: disk I/O error;" in result.stdout, result.stderr
    assert "of 100 flights are kept, --resume flies the rest" in result.stdout
    kept = len(table(tmp_path / "out"))
    assert 0 < kept < 100
    testbed.sweep(sweep, tmp_path / "out", runs=50, resume=True, fly=quick, figures=False, save_logs="none")
    same_rows(tmp_path / "out", fly_here(load_sweep(sweep, ["runs=50"]), tmp_path / "whole"))


def test_a_sweep_without_a_flight_leaves_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plan, out = load_sweep(written(tmp_path)), tmp_path / "out"
    quick_ones = Options(jobs=1, fly=quick)
    monkeypatch.setattr("sys.executable", "/bin/false")
    with pytest.raises(
        testbed.Stopped, match=r"does not start: .*; no flight had finished, and nothing is kept"
    ):
        fly_sweep(plan, out, quick_ones)
    assert not out.exists()
    out.mkdir()
    with pytest.raises(testbed.Stopped, match="0 of 24 flights are kept, --resume flies the rest"):
        fly_sweep(plan, out, quick_ones)
    assert store.exists(out), "a folder that was there before stays"


def test_limits_are_still_those_of_the_system() -> None:
    """A check on these tests: the full disk was another process's."""
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] == resource.RLIM_INFINITY
    assert "scenario" in SWEEP
