"""A worker process: it may crash or hang, and does not grow."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from sweep_files import SWEEP, finished, flown, same_rows, script, table, written
from sweep_flights import bad

import testbed
from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.flying.worker import Child
from testbed.studies.load import load_sweep

MISBEHAVIOURS: list[tuple[float, str, str]] = [
    (0.1, "error", "ValueError: the flight went wrong"),
    (0.2, "timeout", "no result within 2 s"),
    (0.3, "crashed", "the process was ended by signal 9 (SIGKILL)"),
    (0.4, "crashed", "the process was ended by exit status 7"),
    (2.0, "invalid", "failures.0.value: is 2.0, expected less than or equal to 1.5"),
]


@pytest.mark.nightly
def test_what_goes_wrong_is_a_row_with_its_reason(tmp_path: Path) -> None:
    values = [0.6, 0.1, 0.7, 0.2, 0.8, 0.3, 0.9, 0.4, 1.0]
    (tmp_path / "table.csv").write_text("failures.0.value\n" + "".join(f"{v}\n" for v in values))
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\ntime_limit_s: 2\n"
    for jobs in (1, 3):
        frame = testbed.sweep(
            written(tmp_path, text), tmp_path / f"{jobs}", jobs=jobs, fly=bad, figures=jobs == 1
        )
        assert list(frame["failures.0.value"]) == values
        for value, outcome, reason in MISBEHAVIOURS[:-1]:
            row = frame[frame["failures.0.value"] == value].iloc[0]
            assert (row["outcome"], row["reason"], row["passed"]) == (outcome, reason, False)
        assert list(frame[frame["outcome"] == "completed"]["failures.0.value"]) == [0.6, 0.7, 0.8, 0.9, 1.0]
    same_rows(tmp_path / "1", tmp_path / "3")


@pytest.mark.nightly
def test_a_stopped_program_has_not_hung(tmp_path: Path) -> None:
    """As by Ctrl-Z: ten seconds of it are nothing of a flight's two."""
    sweep = written(tmp_path, SWEEP + "time_limit_s: 2\n")
    code = flown(sweep, tmp_path / "out", "runs=100, jobs=2")
    process = subprocess.Popen(script(code), start_new_session=True)
    while finished(tmp_path / "out") < 10:
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGSTOP)
    time.sleep(10.0)
    os.killpg(process.pid, signal.SIGCONT)
    assert process.wait() == 0
    assert set(table(tmp_path / "out")["outcome"]) == {"completed"}


@pytest.mark.nightly
def test_a_worker_does_not_grow(tmp_path: Path) -> None:
    """Real flights, logs kept: no more memory after 300 than after 50, and less than 300 MB."""
    plan = load_sweep(written(tmp_path), ["runs=200", "duration_s=0.5", "failures.0.at_s=0.1",
                                          "vary={failures.0.value: {uniform: [0, 1]}}"])  # fmt: skip
    fly_task(Job(plan.builder), plan.task(0))  # a process that had to compile the control law would be larger
    child = Child(Job(plan.builder, save_logs="all"))
    sizes = []
    for k in range(300):
        assert child.fly(plan.task(k)).record.outcome == "completed"
        if k in (50, 299):
            assert child._process is not None
            status = Path(f"/proc/{child._process.pid}/status").read_text()
            sizes.append(int(status.partition("VmHWM:")[2].split()[0]) / 1024)
    child.close()
    child.kill()
    assert sizes[1] < 300 and sizes[1] - sizes[0] < 5, sizes
