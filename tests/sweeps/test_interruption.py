"""What can happen to a sweep from outside: Ctrl-C, a full disk, a second process, dead workers, many runs."""

from __future__ import annotations

import contextlib
import os
import pty
import resource
import signal
import subprocess
import sys
import time
import tracemalloc
from dataclasses import replace
from pathlib import Path

import pytest
from sweep_files import SWEEP, TESTS, command, journal_lines, run, same_rows, table, written
from sweep_flights import quick

import testbed
from testbed.inputs.problems import BadInput
from testbed.sweeps.folder import results
from testbed.sweeps.folder.store import Store
from testbed.sweeps.plan import Plan, load_sweep
from testbed.sweeps.workers.child import Child
from testbed.sweeps.workers.flying import Job, fly_task


def script(text: str) -> list[str]:
    """A Python program that flies, with the functions of sweep_flights."""
    return [
        sys.executable,
        "-c",
        f"import sys; sys.path.insert(0, {str(TESTS)!r})\nimport sweep_flights, testbed\n{text}",
    ]


def flown(sweep: Path, out: Path, options: str) -> str:
    """The line of a program that flies a sweep of slow made-up flights."""
    return f"testbed.sweep({str(sweep)!r}, {str(out)!r}, {options}, fly=sweep_flights.slow, figures=False)"


def test_ctrl_c_keeps_what_had_finished(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    arguments = command("sweep", sweep, "--out", "out", "--runs", 400, "--jobs", 2, "--no-plots")
    process = subprocess.Popen(
        arguments,
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while journal_lines(tmp_path / "out") < 10:
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to every process of the group
    out, err = process.communicate()
    assert process.returncode == 130
    assert "interrupted" in err and "of 800 flights are kept, --resume flies the rest" in err
    assert "Traceback" not in err and out == ""
    kept = journal_lines(tmp_path / "out") - 1
    assert 9 <= kept == len(table(tmp_path / "out"))
    report = run(tmp_path, "report", "out")  # of what there is
    assert report.returncode == 1 and "adaptive_inversion" in report.stdout


def test_a_full_disk_keeps_what_had_finished(tmp_path: Path) -> None:
    """Files that may not grow beyond 40 kB stand for the disk: the journal's next line does not fit."""
    sweep = written(tmp_path)
    limited = f"""
import resource
from pathlib import Path
from testbed import monte_carlo
from testbed.sweeps.run import Options, Stopped, fly_sweep
plan, folder = monte_carlo.prepare({str(sweep)!r}, {str(tmp_path / "out")!r}, runs=100)
resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, 40_000))
try:
    fly_sweep(plan, folder, Options(jobs=2, save_logs="none", fly=sweep_flights.quick))
except Stopped as stopped:
    print(stopped)
"""
    result = subprocess.run(script(limited), capture_output=True, text=True, check=False)
    assert "cannot write: File too large;" in result.stdout, result.stderr
    assert "of 200 flights are kept, --resume flies the rest" in result.stdout
    assert (tmp_path / "out/journal.jsonl").read_bytes().endswith(b"}\n")  # no half line
    kept = len(table(tmp_path / "out"))
    assert 0 < kept < 200
    testbed.sweep(sweep, tmp_path / "out", runs=100, resume=True, fly=quick, figures=False, save_logs="none")
    testbed.sweep(sweep, tmp_path / "whole", runs=100, fly=quick, figures=False, save_logs="none")
    same_rows(tmp_path / "out", tmp_path / "whole")


def test_two_processes_do_not_fly_one_folder(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    store = Store(tmp_path / "out", plan, "sweep_flights:quick", resume=False)
    with pytest.raises(BadInput, match="is being flown by another process"):
        Store(tmp_path / "out", plan, "sweep_flights:quick", resume=True)
    store.close()
    Store(tmp_path / "out", plan, "sweep_flights:quick", resume=True).close()


def test_a_worker_killed_from_outside_is_replaced(tmp_path: Path) -> None:
    """Its flight is tried once more, and gives the same row."""
    sweep = written(tmp_path)
    flying = "import sweep_flights\n"
    flying += flown(sweep, tmp_path / "out", "runs=60, jobs=2")
    process = subprocess.Popen(script(flying), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for lines in (10, 40):
        while journal_lines(tmp_path / "out") < lines:
            assert process.poll() is None
            time.sleep(0.005)
        os.kill(children(process.pid)[0], signal.SIGKILL)
    _, err = process.communicate()
    assert process.returncode == 0, err
    one = flown(sweep, tmp_path / "one", "runs=60, jobs=1")
    subprocess.run(script(one), check=True)
    same_rows(tmp_path / "out", tmp_path / "one")


def children(pid: int) -> list[int]:
    found = []
    for folder in Path("/proc").iterdir():
        with contextlib.suppress(OSError, ValueError):
            status = (folder / "stat").read_text().rpartition(")")[2].split()
            if int(status[1]) == pid:
                found.append(int(folder.name))
    return found


def test_workers_do_not_outlive_a_killed_parent(tmp_path: Path) -> None:
    flying = flown(written(tmp_path), tmp_path / "out", "runs=900, jobs=2")
    process = subprocess.Popen(script(flying))
    while journal_lines(tmp_path / "out") < 5:
        time.sleep(0.01)
    workers = children(process.pid)
    assert len(workers) == 2
    process.kill()
    process.wait()
    while any(Path(f"/proc/{worker}").exists() and not zombie(worker) for worker in workers):
        time.sleep(0.01)  # hangs here, and so fails, if they stay


def zombie(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


@pytest.fixture
def plan(tmp_path: Path) -> Plan:
    return load_sweep(written(tmp_path), ["runs=20000"])


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


def test_a_worker_does_not_grow(tmp_path: Path) -> None:
    """Real flights, logs kept: no more memory after 300 than after 50, and less than 300 MB."""
    plan = load_sweep(written(tmp_path), ["runs=200", "duration_s=0.5", "failures.0.at_s=0.1",
                                          "vary={failures.0.value: {uniform: [0, 1]}}"])  # fmt: skip
    child = Child(Job(plan.builder, save_logs="all"))
    sizes = []
    for k in range(300):
        assert child.fly(plan.task(k)).record["outcome"] == "completed"
        if k in (50, 299):
            assert child._process is not None
            status = Path(f"/proc/{child._process.pid}/status").read_text()
            sizes.append(int(status.partition("VmHWM:")[2].split()[0]) / 1024)
    child.close()
    child.kill()
    assert sizes[1] < 300 and sizes[1] - sizes[0] < 5, sizes


@pytest.mark.parametrize("terminal", [True, False])
def test_progress_on_a_terminal_only(tmp_path: Path, terminal: bool) -> None:
    flying = flown(written(tmp_path), tmp_path / "out", "runs=60")
    ours, theirs = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "150"}
    errors = theirs if terminal else subprocess.PIPE
    process = subprocess.Popen(script(flying), stdout=subprocess.PIPE, stderr=errors, env=environment)
    os.close(theirs)
    shown = b""
    if terminal:
        with contextlib.suppress(OSError):  # the other side is closed
            while block := os.read(ours, 4096):
                shown += block
    out, err = process.communicate()
    os.close(ours)
    assert process.returncode == 0 and out == b"" and not err
    assert terminal == (b"flights/s" in shown) == (b"adaptive_inversion" in shown) == (b"%" in shown)


def test_limits_are_still_those_of_the_system() -> None:
    """A check on these tests: the full disk was another process's."""
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] == resource.RLIM_INFINITY
    assert "scenario" in SWEEP
