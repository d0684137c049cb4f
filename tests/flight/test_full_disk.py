"""A disk that is full at any byte of a run folder: words, and either the whole folder or nothing."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from figure_flights import broken
from full_disk import largest_file
from handmade import make_flight

from testbed.flight.flight import Flight
from testbed.flight.folder import load, refuse_unwritable, write_run_folder
from testbed.inputs.problems import BadInput
from testbed.reporting.attempt import NotShown, add_report

STRIDE = 211
"""Every byte would take a minute; this stride is a prime, so that it meets the middle of lines."""


def largest(folder: Path) -> int:
    return max(file.stat().st_size for file in folder.rglob("*") if file.is_file())


@pytest.mark.nightly
def test_a_run_folder_is_whole_or_not_there(tmp_path: Path) -> None:
    flight = make_flight()
    size = largest(write_run_folder(flight, tmp_path / "whole"))
    for limit in [*range(0, size, STRIDE), size - 1]:
        with largest_file(limit), pytest.raises(OSError, match="File too large") as caught:
            write_run_folder(flight, tmp_path / "run")
        assert caught.value.filename == str(tmp_path / "run")
        assert [path.name for path in tmp_path.iterdir()] == ["whole"]
    with largest_file(size):
        assert load(write_run_folder(flight, tmp_path / "run")).data.tobytes() == flight.data.tobytes()


@pytest.mark.parametrize("lacking", [["the figures", "the report"], ["the report"]], ids=" and ".join)
def test_a_full_disk_never_costs_a_flight_for_its_figures_or_report(
    tmp_path: Path, lacking: list[str]
) -> None:
    """The log fits, the figures or the report do not: they are left out whole, with a warning."""
    flight = broken()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        write_run_folder(
            flight,
            tmp_path / "run",
            lambda folder: add_within(flight, folder, figures="the figures" not in lacking),
        )
    assert [str(w.message) for w in caught if w.category is NotShown] == [
        f"{what} could not be made: File too large" for what in lacking
    ]
    assert load(tmp_path / "run").data.tobytes() == flight.data.tobytes()
    there = {path.name for path in (tmp_path / "run").rglob("*")}
    assert "log.csv" in there and not {name for name in there if "partial" in name}
    assert "report.html" not in there and ("states.png" in there) == ("the figures" not in lacking)


def add_within(flight: Flight, folder: Path, figures: bool) -> None:
    """Add figures and report while no file may be larger than 10 kB; with `figures`, these are there before."""
    if figures:
        add_report(flight, folder)
        (folder / "report.html").unlink()
    with largest_file(10_000):
        assert not add_report(flight, folder, figures=not figures)


def test_a_folder_that_cannot_be_made_is_refused_before_the_flight(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for path, words in [
        (tmp_path / "file" / "run", f"cannot be written: {tmp_path / 'file'} is a file, not a folder"),
        (tmp_path / ("x" * 250), "cannot be written: File name too long"),
        (Path("/proc/run"), "cannot be written: No such file or directory"),
        (tmp_path / "a\0b", "has a NUL character in its name"),
    ]:
        with pytest.raises(BadInput) as caught:
            refuse_unwritable(path)
        assert [problem.what for problem in caught.value.problems] == [words]
    refuse_unwritable(tmp_path / "run")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
