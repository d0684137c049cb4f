"""A log that was edited or cut is refused with line and column; a flight that diverged may have no numbers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

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
    "log.csv:10: time_s: is 7, expected times that increase": _twice,
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
