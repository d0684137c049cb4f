"""A sweep's folder as a DataFrame."""

from __future__ import annotations

import csv
import shutil
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from sweep_files import SWEEP, fly_here, here, swept, written
from sweep_files import table as table_of

import testbed
from testbed.common.units import unit
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store, table
from testbed.studies.folder.table import groups_of, load
from testbed.studies.load import load_sweep
from testbed.studies.run import fly_sweep


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    where = tmp_path_factory.mktemp("reading")
    return fly_here(load_sweep(written(where)), where / "out")


def test_the_table_loads_with_dtypes_and_units(folder: Path) -> None:
    frame = table_of(folder)
    assert str(frame["outcome"].dtype) == str(frame["controller.type"].dtype) == "category"
    assert frame["passed"].dtype == bool and frame["run"].dtype == np.int64
    assert frame.attrs["units"]["altitude_error_max_m"] == "m"
    assert frame.attrs["units"]["failures.0.at_s"] == "s" and frame.attrs["units"]["passed"] == ""
    text, binary = pd.read_csv(folder / "results.csv"), pd.read_parquet(folder / "results.parquet")
    assert list(text.columns) == list(binary.columns) == list(frame.columns)
    assert (text["altitude_error_max_m"] == binary["altitude_error_max_m"]).all()
    with (folder / "results.csv").open() as stream:
        assert all(row["reason"] == "" for row in csv.DictReader(stream))


def test_the_table_says_what_it_is_of(folder: Path) -> None:
    frame = table_of(folder)
    assert (frame.attrs["name"], frame.attrs["folder"]) == ("small", str(folder))
    passed = [int(rows["passed"].sum()) for _, rows in groups_of(load_sweep(folder / "sweep.yaml"), frame)]
    assert frame.attrs["summary"] == (
        f"small: 12 of 12 runs flown; passed: adaptive_inversion {passed[0]} of 12, "
        f"fixed_inversion {passed[1]} of 12"
    )
    assert frame.query("passed").attrs == frame.attrs  # pandas keeps them


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        ("airspeed_error_max_m_s", "m/s"),
        ("rate_deg_s2", "deg/s^2"),
        ("failures.0.over_s", "s"),
        ("passed", ""),
    ],
)
def test_a_column_has_the_unit_that_its_name_ends_in(column: str, expected: str) -> None:
    assert unit(column) == expected


@pytest.mark.parametrize("finished", [0, 5])
def test_an_unfinished_sweep_has_the_flights_that_finished(
    folder: Path, tmp_path: Path, finished: int
) -> None:
    (tmp_path / "sweep.yaml").write_bytes((folder / "sweep.yaml").read_bytes())
    with store.reading(folder) as whole_store:
        store.create(tmp_path, whole_store.inputs)
        flights = store.opened(tmp_path)
        for key, record in islice(whole_store.records(), finished):
            flights.add(key, record)
    frame = table_of(tmp_path)  # while it is open, as when it is being flown
    flights.close()
    assert table_of(tmp_path).equals(frame)
    assert len(frame) == finished and list(frame.columns[:2]) == ["run", "seed"]
    assert f"{-(-finished // 2)} of 12 runs flown" in frame.attrs["summary"]
    whole = table_of(folder)
    for name in ("run", "seed", "passed", "altitude_error_max_m"):
        if finished:
            assert list(frame[name]) == list(whole[name][:finished])


def test_a_folder_that_is_no_sweep_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=r"sweep\.yaml: is missing from the sweep folder"):
        load(tmp_path)


@pytest.mark.parametrize("rule", ["", "stop_when: {half_width: 0.2}\n"])
def test_results_of_fewer_flights_do_not_stay(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, rule: str
) -> None:
    """As after an interruption in the middle of a resume: the table of before, and what was made of it, are gone."""
    file = written(tmp_path, SWEEP + rule)
    swept(file, tmp_path / "out", runs=3, figures=True)
    assert len(load(tmp_path / "out")) == 6
    with monkeypatch.context() as patched, pytest.raises(testbed.Stopped):
        patched.setattr(table, "write", interrupted)
        fly_sweep(load_sweep(file, ["runs=5"]), tmp_path / "out", here(), resume=True)
    assert load(tmp_path / "out")["run"].tolist() == [0, 0, 1, 1, 2, 2, 3, 3, 4, 4]
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert not names & {"results.csv", "results.parquet", "summary.json", "report.html", "figures"}


def interrupted(*_: object) -> None:
    raise KeyboardInterrupt


def test_a_resume_without_figures_leaves_none_of_before(tmp_path: Path) -> None:
    file = written(tmp_path)
    swept(file, tmp_path / "out", runs=3, figures=True)
    swept(file, tmp_path / "out", runs=3, resume=True)
    assert (tmp_path / "out/figures").is_dir(), "which are still those of these flights"
    swept(file, tmp_path / "out", runs=4, resume=True)
    assert not (tmp_path / "out/figures").exists() and not (tmp_path / "out/report.html").exists()


OTHERS: dict[str, tuple[Callable[[pd.DataFrame], pd.DataFrame], str]] = {
    "a flight twice": (lambda t: t.iloc[[0] * len(t)], "has a flight twice"),
    "an outcome of its own": (lambda t: t.assign(outcome="\x1b[2J<svg onload=1>"), "has outcomes other than"),
    "other runs": (lambda t: t.assign(run=t["run"] + 10**6), "has runs other than 0 to 11"),
    "more flights": (lambda t: pd.concat([t, t]), "rows for 24 flights"),
    "verdicts in words": (lambda t: t.assign(passed="yes"), "does not say of each flight whether it passed"),
}


@pytest.mark.parametrize("what", OTHERS)
def test_a_table_of_other_flights_is_refused(folder: Path, tmp_path: Path, what: str) -> None:
    change, words = OTHERS[what]
    shutil.copytree(folder, tmp_path / "out")
    changed = pa.Table.from_pandas(change(pd.read_parquet(folder / "results.parquet")), preserve_index=False)
    texts = [f.with_type(pa.string()) if pa.types.is_large_string(f.type) else f for f in changed.schema]
    pq.write_table(changed.cast(pa.schema(texts)), tmp_path / "out/results.parquet")
    with pytest.raises(BadInput, match=words):
        load(tmp_path / "out")
