"""Batches are flown by processes that stay, or by a cluster; a search on a cluster has the same bytes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import search_flights
from dask_cluster import Cluster
from search_files import REAL, written

import testbed
from testbed.studies.flying.pool import workers
from testbed.studies.run import Options
from testbed.studies.search.plan import load_search


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    pytest.importorskip("distributed", reason="the cluster extra")
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    cluster = Cluster(folder)
    yield cluster
    cluster.close()


def test_processes_stay_for_the_next_batch(tmp_path: Path) -> None:
    plan = load_search(written(tmp_path))
    options = Options(jobs=2, save_logs="none", fly=search_flights.in_its_process)
    with workers(options.job(plan), options.jobs) as fly_all:
        seen = set()
        for batch in range(3):
            tasks = plan.tasks(plan.parts[0], np.full((4, 2), 0.1 * batch), 4 * batch)
            done = {flown.record.run: flown for flown in fly_all(tasks)}
            assert sorted(done) == [task.run for task in tasks]
            seen |= {flown.record.metrics["process"] for flown in done.values()}
    assert 1 <= len(seen) <= 2


@pytest.mark.nightly
def test_a_cluster_gives_the_same_bytes(cluster: Cluster, tmp_path: Path) -> None:
    file = written(tmp_path, REAL.replace("at_most: 1", "at_most: 0.38"))
    testbed.search(file, tmp_path / "here", jobs=1, figures=False)
    testbed.search(file, tmp_path / "there", cluster=cluster.address, figures=False)
    for name in ("results.csv", "results.parquet", "summary.json", "found.yaml", "found/log.csv"):
        assert (tmp_path / "here" / name).read_bytes() == (tmp_path / "there" / name).read_bytes(), name
