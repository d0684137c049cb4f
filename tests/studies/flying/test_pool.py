"""Processes on this machine: replaced when they die, gone when their parent is."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from sweep_files import finished, flown, fly_here, same_rows, script, written

from testbed.studies.load import load_sweep


@pytest.mark.nightly
def test_a_worker_killed_from_outside_is_replaced(tmp_path: Path) -> None:
    """Its flight is tried once more, and gives the same row."""
    sweep = written(tmp_path)
    flying = "import sweep_flights\n"
    flying += flown(sweep, tmp_path / "out", "runs=60, jobs=2")
    process = subprocess.Popen(script(flying), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for lines in (10, 40):
        while finished(tmp_path / "out") < lines:
            assert process.poll() is None
            time.sleep(0.005)
        os.kill(children(process.pid)[0], signal.SIGKILL)
    _, err = process.communicate()
    assert process.returncode == 0, err
    same_rows(tmp_path / "out", fly_here(load_sweep(sweep, ["runs=60"]), tmp_path / "one"))


def children(pid: int) -> list[int]:
    found = []
    for folder in Path("/proc").iterdir():
        with contextlib.suppress(OSError, ValueError):
            status = (folder / "stat").read_text().rpartition(")")[2].split()
            if int(status[1]) == pid:
                found.append(int(folder.name))
    return found


@pytest.mark.nightly
def test_workers_do_not_outlive_a_killed_parent(tmp_path: Path) -> None:
    flying = flown(written(tmp_path), tmp_path / "out", "runs=900, jobs=2")
    process = subprocess.Popen(script(flying))
    while finished(tmp_path / "out") < 5:
        time.sleep(0.01)
    workers = children(process.pid)
    assert len(workers) == 2
    process.kill()
    process.wait()
    while any(Path(f"/proc/{worker}").exists() and not zombie(worker) for worker in workers):
        time.sleep(0.01)  # hangs here, and so fails, if they stay


@pytest.mark.nightly
def test_a_worker_whose_flight_hangs_ends_with_its_parent(tmp_path: Path) -> None:
    """At once, not after the time limit of the flight, which is minutes."""
    plan = f"testbed.studies.load.load_sweep({str(written(tmp_path))!r}, ['vary.failures.0.value={{choice: [0.2]}}'])"
    code = (
        f"import testbed.studies.load\nfrom testbed.studies.flying.worker import Child, Job\nplan = {plan}\n"
    )
    process = subprocess.Popen(
        script(f"{code}Child(Job(plan.builder, 'sweep_flights:bad')).fly(plan.task(0))")
    )
    while not (workers := children(process.pid)):
        assert process.poll() is None
        time.sleep(0.01)
    time.sleep(1.0)
    process.kill()
    process.wait()
    while any(Path(f"/proc/{worker}").exists() and not zombie(worker) for worker in workers):
        time.sleep(0.01)  # hangs here, and so fails, if they stay


def zombie(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True
