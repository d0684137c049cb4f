"""Parquet read back by pandas and pyarrow, MATLAB's format by scipy: every value, every unit, every event."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow.parquet
import pytest
from scipy.io import loadmat

from testbed.flight.flight import Flight
from testbed.reporting.export import export
from testbed.reporting.export.tables import matlab_names


def test_parquet_has_the_log_with_units(flown: Flight, tmp_path: Path) -> None:
    file = export(flown, "parquet", tmp_path / "flight.parquet")
    pd.testing.assert_frame_equal(pd.read_parquet(file), flown.log, check_exact=True)
    schema = pyarrow.parquet.read_schema(file)
    units = {field.name: field.metadata[b"unit"].decode() for field in schema}
    assert (units["time_s"], units["wind_east_m_s"], units["p_dot_deg_s2"]) == ("s", "m/s", "deg/s^2")
    assert (units["left_ruddervator_position"], units["left_propeller_position"]) == ("deg", "N")
    assert units["left_ruddervator_effectiveness"] == "1"
    assert json.loads(schema.metadata[b"testbed"]) == json.loads(json.dumps(flown.summary))


def test_matlab_has_the_log_with_units_and_events(flown: Flight, tmp_path: Path) -> None:
    file = export(flown, "mat", tmp_path / "flight.mat")
    assert file.read_bytes()[:19] == b"MATLAB 5.0 MAT-file"
    read = loadmat(file, simplify_cells=True)
    assert set(read["log"]) == set(flown.columns)
    for name in flown.columns:
        np.testing.assert_array_equal(read["log"][name], flown.log[name])
    assert read["units"]["airspeed_m_s"] == "m/s"
    assert read["flight"]["outcome"] == "completed" and read["flight"]["end_time_s"] == 3.0
    events = np.atleast_1d(read["events"])
    assert [event["time_s"] for event in events] == [event["time_s"] for event in flown.events]
    assert "left ruddervator" in events[0]["words"]


@pytest.mark.parametrize(
    ("column", "name"),
    [("a-b_m", "a_b_m"), ("1st_m", "x_1st_m"), ("é", "x__"), ("a" * 70, "a" * 63)],
)
def test_columns_get_names_that_matlab_takes(column: str, name: str) -> None:
    assert matlab_names([column]) == {column: name}


def test_no_two_columns_get_one_name() -> None:
    assert list(matlab_names(["a.b", "a-b", "a b"]).values()) == ["a_b", "a_b_2", "a_b_3"]
