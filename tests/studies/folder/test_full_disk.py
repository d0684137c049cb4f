"""A disk that is full at any byte of a sweep folder: what has been stored is kept, and resuming gives the same bytes."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from full_disk import largest_file
from sweep_files import fly_here, here, same_rows, written

from testbed.inputs.problems import BadInput
from testbed.studies.flying.pool import serial
from testbed.studies.folder.begin import begin
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.studies.run import Flights, Stopped, fly_missing, fly_sweep

FLY = "sweep_flights:quick"
STRIDE = 50_021
"""A prime: the limit meets the middle of pages and records."""


@pytest.mark.nightly
def test_a_sweep_goes_on_after_a_full_disk(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    whole = fly_here(plan, tmp_path / "whole", FLY, save_logs="all")
    size = written_in_all(plan, tmp_path / "counted")
    for limit in [*range(0, size, STRIDE), size - 1]:
        goes_on(plan, whole, tmp_path / "out", limit)


@pytest.mark.nightly
def test_a_sweep_goes_on_where_the_disk_was_full_within_a_page(tmp_path: Path) -> None:
    """Pages have 4096 bytes, and 24 more each in the log: limits about the ends of some."""
    plan = load_sweep(written(tmp_path))
    whole = fly_here(plan, tmp_path / "whole", FLY, save_logs="all")
    size = written_in_all(plan, tmp_path / "counted")
    for page in range(1, size // 4120, 13):
        for limit in (page * 4096, 32 + page * 4120, 33 + page * 4120):
            goes_on(plan, whole, tmp_path / "out", limit)


def written_in_all(plan: Plan, folder: Path) -> int:
    """Size of the largest file while all are flown, that of the log of the database [bytes]."""
    flights = begin(folder, plan, FLY, resume=False)
    job = here(FLY).job(plan)
    with serial(job) as fly_all:
        fly_missing(Flights(plan, job, flights, fly_all))
    size = max(file.stat().st_size for file in folder.rglob("*") if file.is_file())
    flights.close()
    return size


def goes_on(plan: Plan, whole: Path, folder: Path, limit: int) -> None:
    """The sweep stops when a file has reached the limit [bytes], and is then finished like the whole one."""
    with largest_file(limit), pytest.raises((Stopped, BadInput), match=r"cannot write|cannot be written"):
        fly_sweep(plan, folder, here(FLY, "all"), resume=True)
    assert not list(folder.rglob("*.partial")), limit
    fly_sweep(plan, folder, here(FLY, "all"), resume=True)
    same_rows(whole, folder)
    shutil.rmtree(folder)
