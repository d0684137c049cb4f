"""Flights of several environments: refused in a sentence, or, where that is asked for, marked in the table.

The other environment is a real one: workers with other kernels of BLAS, of which this process has none.
"""

from __future__ import annotations

import platform
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest
from command_line import in_this_process
from dask_cluster import Cluster
from sweep_files import fly_here, here, written
from sweep_flights import quick

import testbed
from testbed.api.sweep import fly_run, plan_of
from testbed.common.arithmetic import arithmetic
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store
from testbed.studies.load import load_sweep
from testbed.studies.run import Options, Stopped, fly_sweep

pytestmark = pytest.mark.skipif(platform.machine() != "x86_64", reason="names of kernels of other processors")
OTHER = "Nehalem" if arithmetic()["kernel"] != "Nehalem" else "Haswell"
WORDS = f"other last digits of matrices, which depend on the BLAS kernel: {arithmetic()['kernel']}, this is {OTHER}"


@pytest.fixture
def elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    """Processes that start from now on calculate with another kernel."""
    monkeypatch.setenv("OPENBLAS_CORETYPE", OTHER)


def begun_elsewhere(folder: Path, mark: str = "") -> Path:
    """The folder of a whole sweep, as one that was begun with another kernel; with this mark on each flight."""
    fly_here(load_sweep(written(folder.parent)), folder)
    with store.reading(folder) as flights:
        marked = [(k, replace(r, environment=mark)) for k, r in flights.records()]
        inputs, done = flights.inputs, [(k, r, flights.history(k)) for k, r in marked]
    (folder / store.NAME).unlink()
    store.create(
        folder, {**inputs, "arithmetic": {**inputs["arithmetic"], "matrices": "0", "kernel": "Other"}}
    )
    with closing(store.opened(folder)) as flights:
        for each in done:
            flights.add(*each)
    return folder


@pytest.mark.nightly
@pytest.mark.usefixtures("elsewhere")
def test_a_worker_of_another_environment_is_refused_or_its_flights_are_marked(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    with pytest.raises(Stopped, match=f"a worker on .* is unlike where the study was begun, with {WORDS}"):
        testbed.sweep(sweep, tmp_path / "out", runs=1, jobs=1, fly=quick)
    assert not (tmp_path / "out").exists()
    table = testbed.sweep(sweep, tmp_path / "out", runs=2, jobs=1, fly=quick, mixed=True)
    assert set(table["environment"]) == {WORDS} and len(table) == 4
    assert WORDS in (tmp_path / "out/results.csv").read_text()
    assert (tmp_path / "out/report.html").is_file()


def test_flights_of_one_environment_have_no_mark(tmp_path: Path) -> None:
    table = testbed.sweep(written(tmp_path), tmp_path / "out", runs=1, jobs=1, fly=quick, mixed=True)
    assert "environment" not in table


@pytest.mark.nightly
def test_a_folder_of_another_environment_is_resumed_when_asked(tmp_path: Path) -> None:
    folder = begun_elsewhere(tmp_path / "out")
    more = {"runs": 13, "jobs": 1, "fly": quick, "figures": False, "resume": True}
    with pytest.raises(BadInput, match=r"was begun with other last digits of matrices.*or --mixed"):
        testbed.sweep(tmp_path / "small.yaml", folder, **more)
    table = testbed.sweep(tmp_path / "small.yaml", folder, **more, mixed=True)
    assert table["environment"].notna().tolist() == [False] * 24 + [True] * 2


def test_one_run_of_a_folder_of_another_environment_is_refused(tmp_path: Path) -> None:
    folder = begun_elsewhere(tmp_path / "out")
    alone = ("sweep", "out/sweep.yaml", "--only", "3", "--no-plots", "--out", "alone")
    result = in_this_process(tmp_path, *alone)
    assert result.returncode == 2 and "was begun with other last digits of matrices" in result.stderr
    assert "was begun with the function sweep_flights:quick, this is" in result.stderr
    assert not (tmp_path / "alone").exists()
    fly_run(plan_of(folder), 3, tmp_path / "alone", Options(jobs=1, fly=quick, mixed=True), figures=False)
    assert "kernel: Other, this is" in (tmp_path / "alone/results.csv").read_text()


def test_shards_of_several_environments_are_merged_when_asked(tmp_path: Path) -> None:
    one, two = tmp_path / "one", begun_elsewhere(tmp_path / "two")
    fly_sweep(load_sweep(tmp_path / "small.yaml"), one, replace(here(), shard="1/2"))
    with pytest.raises(BadInput, match="was begun with other last digits of matrices"):
        testbed.merge([one, two], tmp_path / "out", figures=False)
    assert not (tmp_path / "out").exists()
    in_this_process(tmp_path, "merge", "one", "two", "--out", "out", "--no-plots", "--mixed")
    table = testbed.load(tmp_path / "out")
    assert table["environment"].notna().tolist() == [run % 2 == 1 for run in table["run"]]
    assert table["environment"].iloc[2].endswith("this is Other")


def test_a_flight_of_a_mixed_shard_is_marked_by_what_is_known_of_both(tmp_path: Path) -> None:
    """Its mark says how it is unlike its folder, and the merged folder how that one is unlike it."""
    one, two = tmp_path / "one", begun_elsewhere(tmp_path / "two", "kernel: Third, this is Other")
    fly_sweep(load_sweep(tmp_path / "small.yaml"), one, replace(here(), shard="1/2"))
    testbed.merge([one, two], tmp_path / "out", figures=False, mixed=True)
    (mark,) = set(testbed.load(tmp_path / "out")["environment"].dropna())
    assert mark.startswith("kernel: Third, this is Other; of a folder with ") and mark.endswith(
        "this is Other"
    )


@pytest.mark.nightly
@pytest.mark.usefixtures("elsewhere")
def test_workers_of_a_cluster_in_another_environment_are_refused(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="the cluster extra")
    cluster = Cluster(tmp_path)
    try:
        with pytest.raises(Stopped, match=f"is unlike where the study was begun, with {WORDS}"):
            testbed.sweep(written(tmp_path), tmp_path / "out", runs=2, cluster=cluster.address)
        assert not (tmp_path / "out").exists()
        there = {"runs": 2, "cluster": cluster.address, "figures": False}
        table = testbed.sweep(written(tmp_path), tmp_path / "out", **there, mixed=True)
        assert set(table["environment"]) == {WORDS}
    finally:
        cluster.close()
