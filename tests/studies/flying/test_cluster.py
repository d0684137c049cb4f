"""A Dask scheduler and two workers, real processes on 127.0.0.1 that have the package and nothing else."""

from __future__ import annotations

import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from dask_cluster import Cluster
from own_controllers import own_controller
from sweep_files import SWEEP, command, finished, fly_here, same_rows, sorted_files, written

import testbed
from testbed.aircraft.shipped import find_aircraft
from testbed.controllers.user.own import own_controllers
from testbed.inputs.problems import BadInput
from testbed.studies.flying import pool as flying_pool
from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.flying.pool import fly_packed, pack, refuse_dead
from testbed.studies.load import load_sweep
from testbed.studies.run import Options

pytest.importorskip("distributed", reason="the cluster extra")


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    cluster = Cluster(folder)
    yield cluster
    cluster.close()


@pytest.mark.nightly
def test_a_cluster_gives_the_same_bytes_though_a_worker_dies(cluster: Cluster, tmp_path: Path) -> None:
    sweep = written(tmp_path)
    plan = load_sweep(sweep, ["runs=30"])
    fly_here(plan, tmp_path / "here", "testbed.simulation:fly", save_logs="failed")

    def kill_midway() -> None:
        while finished(tmp_path / "there") < 10:
            time.sleep(0.005)
        cluster.kill_worker()

    killer = threading.Thread(target=kill_midway, daemon=True)
    killer.start()
    there = testbed.sweep(sweep, tmp_path / "there", runs=30, cluster=cluster.address, figures=False)
    killer.join()
    assert cluster.processes[-1].wait() == -signal.SIGKILL
    assert len(there) == 60
    same_rows(tmp_path / "here", tmp_path / "there")
    assert sorted_files(tmp_path / "here") == sorted_files(tmp_path / "there")
    assert list(cluster._folder.glob("testbed-*/vtail/vtail.yaml"))  # the aircraft had travelled


@pytest.mark.nightly
@pytest.mark.parametrize("flights", [0, 10])
def test_a_killed_scheduler_is_one_line(cluster: Cluster, tmp_path: Path, flights: int) -> None:
    """Before the first flight, or after some: Dask's own tracebacks are not shown, and what has finished is kept."""
    arguments = ("sweep", written(tmp_path), "--runs", 300, "--out", "out", "--cluster", cluster.address)
    process = subprocess.Popen(command(*arguments), cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    while finished(tmp_path / "out") < flights or not (tmp_path / "out").exists():
        assert process.poll() is None
        time.sleep(0.01)
    cluster.processes[0].kill()
    _, err = process.communicate()
    assert process.returncode == 3 and err.startswith("out: ") and err.count("\n") == 1, err
    assert finished(tmp_path / "out") >= flights


@pytest.mark.nightly
def test_a_cluster_whose_workers_are_gone_is_not_waited_for(
    cluster: Cluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(flying_pool, "_WITHOUT_S", 2.0)
    monkeypatch.setattr(flying_pool, "_LOOK_S", 0.5)

    def kill_midway() -> None:
        while finished(tmp_path / "out") < 5:
            time.sleep(0.005)
        for worker in cluster.processes[1:]:
            worker.kill()

    threading.Thread(target=kill_midway, daemon=True).start()
    with pytest.raises(testbed.Stopped, match=r"has had no worker for 2 s; \d+ of 200 flights are kept"):
        testbed.sweep(written(tmp_path), tmp_path / "out", runs=100, cluster=cluster.address, figures=False)


@pytest.mark.nightly
def test_a_wrong_or_dead_address_is_refused_before_a_folder_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Text that is no address, a closed port, a port that never says a word."""
    monkeypatch.setattr("testbed.studies.flying.pool._ANSWER_S", 1)
    monkeypatch.setattr("testbed.studies.flying.pool._ANSWER_S", 1)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        listening = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        for address in ("nonsense", "tcp://127.0.0.1:9", listening):
            with pytest.raises(BadInput, match=rf"--cluster: no cluster answers at {re.escape(address)}: \w"):
                testbed.sweep(written(tmp_path), tmp_path / "out", cluster=address)
    assert not (tmp_path / "out").exists()


def test_workers_need_only_the_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The aircraft's folder, gone after packing, is flown from what was packed; the row is the same."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    folder = tmp_path / "mine" / "vtail"
    shutil.copytree(find_aircraft("vtail").parent, folder)
    plan = load_sweep(written(tmp_path, SWEEP.replace("set:", f"set:\n  aircraft: {folder}")))
    job = Job(plan.builder, save_logs="none")
    expected = fly_task(job, plan.task(4))
    packed = pack(job)
    shutil.rmtree(folder)
    flown = fly_packed(packed, plan.task(4))
    assert flown.record.outcome == "completed"
    assert (repr(flown.record), flown.history) == (repr(expected.record), expected.history)


@pytest.mark.nightly
def test_the_code_of_ones_own_controller_travels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Class, and the module beside it: both gone after packing, and the row is the same."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    own = own_controllers([own_controller(tmp_path / "mine")])
    plan = load_sweep(tmp_path / "mine" / "own.yaml", (), own)
    job = Job(plan.builder, save_logs="none")
    expected = fly_task(job, plan.task(2))
    packed = pack(job)
    shutil.rmtree(tmp_path / "mine")
    flown = fly_packed(packed, plan.task(2))
    assert flown.record.outcome == "completed"
    assert (repr(flown.record), flown.history) == (repr(expected.record), expected.history)


def test_the_aircraft_must_be_there_to_be_packed(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    with pytest.raises(BadInput, match="there is no folder"):
        pack(Job(plan.builder.with_aircraft(str(tmp_path / "none"))))


@pytest.mark.nightly
def test_a_cluster_that_starts_slowly_is_waited_for() -> None:
    """A port at which a scheduler answers only later; and one at which none ever does, after the time that was asked for."""
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
    starting = threading.Timer(2.0, lambda: schedulers.append(scheduler_at(port)))
    schedulers: list[subprocess.Popen[bytes]] = []
    with pytest.raises(BadInput, match="no cluster answers"):
        refuse_dead(f"tcp://127.0.0.1:{port}", 0.5)
    starting.start()
    try:
        refuse_dead(f"tcp://127.0.0.1:{port}", 60.0)
    finally:
        starting.join()
        for scheduler in schedulers:
            scheduler.kill()
            scheduler.wait()


def scheduler_at(port: int) -> subprocess.Popen[bytes]:
    arguments = ("--host", "127.0.0.1", "--port", str(port), "--no-dashboard")
    words = [sys.executable, "-m", "distributed.cli.dask_scheduler", *arguments]
    return subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def test_a_wait_needs_a_cluster() -> None:
    with pytest.raises(BadInput, match="--cluster-wait: is 5, expected above 0 to 86400 s, beside --cluster"):
        Options(cluster_wait_s=5.0)
