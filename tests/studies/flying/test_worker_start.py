"""A worker process that dies while it starts: replaced when a signal ended it, reported when it cannot start at all."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path

import pytest
from sweep_files import written
from sweep_flights import quick

from testbed.inputs.problems import BadInput
from testbed.studies.flying.flight import Job, fly_reference
from testbed.studies.flying.worker import Child
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan


@pytest.fixture
def plan(tmp_path: Path) -> Plan:
    return load_sweep(written(tmp_path))


def killed_at_start(child: Child, times: int) -> None:
    """Kill the child's process as soon as there is one, this often."""
    killed: set[int] = set()
    while len(killed) < times:
        process = child._process
        if process is not None and process.pid not in killed:
            os.kill(process.pid, signal.SIGKILL)
            killed.add(process.pid)
        time.sleep(0.001)


def test_a_process_killed_while_it_starts_is_replaced(plan: Plan) -> None:
    child = Child(Job(plan.builder, fly_reference(quick)))
    killer = threading.Thread(target=killed_at_start, args=(child, 3))
    killer.start()
    flown = child.fly(plan.task(0))
    killer.join()
    child.kill()
    assert flown.record.outcome == "completed"


def test_a_process_that_is_always_killed_is_reported_with_the_signal(plan: Plan) -> None:
    child = Child(Job(plan.builder, fly_reference(quick)))
    killer = threading.Thread(target=killed_at_start, args=(child, 4))
    killer.start()
    with pytest.raises(BadInput, match=r"does not start: it was ended by signal 9 \(SIGKILL\)"):
        child.fly(plan.task(0))
    killer.join()


def test_a_process_that_cannot_start_is_reported_with_its_last_words(
    plan: Plan, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.executable", "/bin/false")
    with pytest.raises(BadInput, match="does not start: it was ended by exit status 1"):
        Child(Job(plan.builder)).fly(plan.task(0))
    monkeypatch.setattr("sys.executable", "/bin/cat")
    with pytest.raises(BadInput, match=r"does not start: Try '/bin/cat --help'"):
        Child(Job(plan.builder)).fly(plan.task(0))


def test_a_process_starts_without_a_folder_for_temporary_files(
    plan: Plan, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", "/nowhere")
    child = Child(Job(plan.builder, fly_reference(quick)))
    assert child.fly(plan.task(0)).record.outcome == "completed"
    child.kill()
