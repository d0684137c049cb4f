"""The table: columns in their order, each of one type, cells that read back as the same values."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pandas as pd
import pytest
from sweep_files import SWEEP, written

from testbed.studies.folder import table
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.studies.record import Record

CHOICES = "failures.0.value: {choice: [0, 0.5]}"


@pytest.fixture
def plan(tmp_path: Path) -> Plan:
    return load_sweep(written(tmp_path, SWEEP.replace("failures.0.value: {uniform: [0, 1]}", CHOICES)))


def record(run: int, value: Any, **more: Any) -> Record:
    drawn = {"failures.0.at_s": 0.1 + 0.2, "failures.0.value": value}
    flown = Record(run, run % 2, 7, drawn, "completed", True, end_time_s=1.0, metrics={"error_m": 0.1},
                   requirements=((True, math.nan, math.nan),))  # fmt: skip
    return replace(flown, **more)


def written_table(plan: Plan, records: list[Record], folder: Path) -> tuple[list[str], pd.DataFrame]:
    table.write(plan, lambda: iter(records), folder)
    assert {file.name for file in folder.iterdir()} == {"small.yaml", "results.csv", "results.parquet"}
    return (folder / "results.csv").read_text().splitlines(), pd.read_parquet(folder / "results.parquet")


def test_a_column_has_one_type_and_a_number_its_shortest_text(plan: Plan, tmp_path: Path) -> None:
    lines, frame = written_table(plan, [record(0, 0), record(1, 0.5)], tmp_path)
    assert list(frame.columns) == lines[0].split(",") and lines[0].endswith("requirements.0.value,reason")
    assert lines[1].startswith("0,7,adaptive_inversion,completed,True,0.30000000000000004,0.0,")
    assert list(frame["failures.0.value"]) == [0.0, 0.5] and frame["run"].dtype == "int64"
    assert frame["requirements.0.value"].isna().all() and frame["requirements.0.passed"].all()


def test_robustness_of_the_flight_and_of_each_requirement(plan: Plan, tmp_path: Path) -> None:
    """Where there is none, as after an early end, the cells are empty."""
    new = record(1, 0.5, robustness=-0.25, requirements=((False, 7.0, -0.25),))
    lines, frame = written_table(plan, [record(0, 0), new], tmp_path)
    assert ",end_time_s,robustness," in lines[0]
    for name in ("robustness", "requirements.0.robustness"):
        assert frame[name].isna().tolist() == [True, False] and frame[name][1] == -0.25


def test_flights_without_a_result_and_metrics_of_some_leave_cells_empty(plan: Plan, tmp_path: Path) -> None:
    lost = Record(1, 1, 7, record(1, 0.5).values, "crashed", False, "signal 9, twice")
    records = [record(0, 0.5), lost,
               record(2, 0.5, metrics={"error_m": 0.1, "another_m": 2.0})]  # fmt: skip
    lines, frame = written_table(plan, records, tmp_path)
    assert lines[2].endswith(',"signal 9, twice"') and frame["error_m"].isna().tolist() == [
        False,
        True,
        False,
    ]
    assert frame["another_m"].tolist()[2] == 2.0 and frame["another_m"].isna().sum() == 2


def test_mappings_and_lists_are_json(plan: Plan, tmp_path: Path) -> None:
    drawn = [{"type": "pid", "gains": [1, 2.5]}, None]
    _, frame = written_table(plan, [record(i, value) for i, value in enumerate(drawn)], tmp_path)
    assert json.loads(frame["failures.0.value"][0]) == drawn[0]


def test_a_table_that_cannot_be_finished_leaves_the_old_one(plan: Plan, tmp_path: Path) -> None:
    lines, _ = written_table(plan, [record(0, 0.5)], tmp_path)
    reading = iter([iter([record(0, 0.5)]), iter([record(0, "no number")])])
    with pytest.raises(ValueError):
        table.write(plan, lambda: next(reading), tmp_path)
    assert (tmp_path / "results.csv").read_text().splitlines() == lines
    assert not list(tmp_path.glob(".*"))


def test_texts_that_a_spreadsheet_would_take_for_formulas_are_quoted() -> None:
    """In the CSV table alone; numbers, also negative ones, are as they are."""
    assert [table._cell(value) for value in ("=1+1", "-x", "a", -1.5, True, None)] == [
        "'=1+1",
        "'-x",
        "a",
        "-1.5",
        "True",
        "",
    ]


def test_a_whole_number_of_more_than_64_bits_keeps_its_digits(tmp_path: Path) -> None:
    values = f"{{initial.altitude_m: {{uniform: [300, 301]}}, seed_like: {{choice: [{2**70}, 1]}}}}"
    plan = load_sweep(
        written(tmp_path, SWEEP.replace("compare:", "x:").split("vary:")[0] + f"vary: {values}\n")
    )
    record = Record(0, 0, 2, {"initial.altitude_m": 300.5, "seed_like": 2**70}, "completed", True)
    table.write(plan, lambda: iter([record]), tmp_path)
    assert str(2**70) in (tmp_path / "results.csv").read_text()
