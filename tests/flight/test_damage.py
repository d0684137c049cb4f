"""A log that was edited or cut is refused with line and column; a flight that diverged may have no numbers."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from handmade import make_flight

from testbed.flight.flight import Outcome
from testbed.flight.folder import load, write_run_folder
from testbed.inputs.problems import BadInput

Rows = list[list[str]]


def _set(rows: Rows, line: int, cell: str) -> None:
    rows[line - 1][3] = cell


def _without_a_column(rows: Rows) -> None:
    for row in rows:
        del row[3]


def _without_rows(rows: Rows) -> None:
    del rows[1:]


def _twice(rows: Rows) -> None:
    rows.insert(9, rows[8])


DAMAGES: dict[str, Callable[[Rows], None]] = {
    "log.csv:7: altitude_m: is nan, expected a finite number": lambda rows: _set(rows, 7, "nan"),
    "log.csv:101: altitude_m: is -inf, expected a finite number": lambda rows: _set(rows, 101, "-inf"),
    "log.csv:2: altitude_m: is nan, expected a finite number": lambda rows: _set(rows, 2, ""),
    "log.csv:1: has no column altitude_m": _without_a_column,
    "log.csv: has no rows, expected the log of a flight": _without_rows,
    "log.csv:10: time_s: is 59.535, expected times that increase": _twice,
}


@pytest.mark.parametrize("said", DAMAGES)
def test_a_damaged_log_is_refused_with_its_place(tmp_path: Path, said: str) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    rows = [line.split(",") for line in (folder / "log.csv").read_text().splitlines()]
    DAMAGES[said](rows)
    (folder / "log.csv").write_text("\n".join(map(",".join, rows)) + "\n")
    with pytest.raises(BadInput) as refused:
        load(folder)
    assert [str(each) for each in refused.value.problems] == [f"{folder}/{said}"]


def test_no_more_than_three_cells_are_named(tmp_path: Path) -> None:
    data = make_flight().data
    data[:, 3] = np.nan
    folder = write_run_folder(make_flight(data=data), tmp_path / "run")
    with pytest.raises(BadInput) as refused:
        load(folder)
    assert len(refused.value.problems) == 3


def test_a_flight_that_diverged_is_read(tmp_path: Path) -> None:
    data = make_flight().data
    data[-1, 3] = np.nan
    folder = write_run_folder(make_flight(data=data, outcome=Outcome.diverged), tmp_path / "run")
    assert np.isnan(load(folder).data[-1, 3])


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"end_time_s": 1e308}, "end_time_s: is 1e+308, expected at most 60, as the scenario says"),
        ({"end_time_s": 30.0, "outcome": "ground_contact"}, "time_s: ends at 59.995 s, expected the flight's end, 30 s"),
        ({"events": [{"time_s": 61, "kind": "diagnosis", "text": ""}]}, "events.0.time_s: is 61, expected at most the flight"),
    ],
)  # fmt: skip
def test_what_ends_after_the_flight_is_refused(tmp_path: Path, change: dict[str, Any], said: str) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    summary = json.loads((folder / "summary.json").read_text())
    (folder / "summary.json").write_text(json.dumps(summary | change))
    with pytest.raises(BadInput, match=re.escape(said)):
        load(folder)


def test_a_log_that_was_cut_is_refused(tmp_path: Path) -> None:
    """Else a flight could be shown without how it ended."""
    folder = write_run_folder(make_flight(), tmp_path / "run")
    lines = (folder / "log.csv").read_text().splitlines(keepends=True)
    (folder / "log.csv").write_text("".join(lines[:50]))
    with pytest.raises(
        BadInput, match=r"log\.csv:50: time_s: ends at 59\.74 s, expected the flight's end, 60 s"
    ):
        load(folder)


def test_a_log_of_a_terabyte_of_nothing_is_refused(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    (folder / "log.csv").write_bytes(b"")
    os.truncate(folder / "log.csv", 10**12)
    with pytest.raises(BadInput, match="its first line has 1000000 characters or more"):
        load(folder)
