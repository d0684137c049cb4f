"""`testbed.load`: either kind of folder, and words for what is neither."""

from __future__ import annotations

from pathlib import Path

import pandas as pd
import pytest
from handmade import make_flight
from sweep_files import fly_here, written

import testbed
from testbed.api.load import load_flight
from testbed.flight.flight import Flight
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput
from testbed.studies.load import load_sweep


def test_either_kind_of_folder(tmp_path: Path) -> None:
    run = testbed.load(write_run_folder(make_flight(), tmp_path / "run"))
    sweep = testbed.load(fly_here(load_sweep(written(tmp_path), ["runs=2"]), tmp_path / "sweep"))
    assert isinstance(run, Flight) and isinstance(sweep, pd.DataFrame)
    assert len(sweep) == 4 and set(sweep.attrs) == {"name", "folder", "summary", "units"}


def test_what_is_neither_is_refused_in_words(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for name, words in (
        ("none", "there is no such folder, expected the folder of a run, a sweep or a search"),
        ("file", "is a file, expected the folder of a run, a sweep or a search"),
        (".", "is the folder neither of a run nor of a sweep or a search, expected scenario.yaml"),
    ):
        with pytest.raises(BadInput) as refused:
            testbed.load(tmp_path / name)
        assert len(refused.value.problems) == 1 and words in str(refused.value)


def test_a_run_folder_with_a_file_missing_says_which(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    (folder / "summary.json").unlink()
    with pytest.raises(BadInput, match=r"summary\.json: is missing from the run folder"):
        testbed.load(folder)


def test_a_search_is_no_flight(tmp_path: Path) -> None:
    (tmp_path / "search.yaml").touch()
    with pytest.raises(
        BadInput, match="is a search folder, expected the folder of a flight in it, such as SEARCH/found"
    ):
        load_flight(tmp_path)
