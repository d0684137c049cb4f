"""Sweeps from Python: its steps, and what they leave in a folder."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import SWEEP, fly_here, written
from sweep_flights import quick

import testbed
from testbed.api import sweep
from testbed.inputs.problems import BadInput
from testbed.studies.load import load_sweep
from testbed.studies.run import Options


def test_a_sweep_leaves_a_whole_folder_and_returns_its_table(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    frame = testbed.sweep(written(tmp_path), set={"runs": 3}, jobs=1, fly=quick)
    assert len(frame) == 6 and frame.attrs["summary"].startswith("small: 3 of 3 runs flown; passed: ")
    names = {path.name for path in (tmp_path / "runs/small").iterdir()}
    assert names >= {"sweep.yaml", "results.csv", "results.parquet", "summary.json", "figures", "report.html"}
    assert not [name for name in names if name.startswith(".")]


@pytest.mark.parametrize(
    ("name", "folder"), [("small", "runs/small"), ("Über: 2 Tails!", "runs/ber-2-tails"), ("!", "runs/sweep")]
)
def test_the_folder_is_named_after_the_sweep(tmp_path: Path, name: str, folder: str) -> None:
    file = written(tmp_path, SWEEP.replace("name: small", f"name: {name!r}"))
    assert sweep.prepare(file)[1] == Path(folder)


def test_resumed_without_a_number_of_runs_it_is_as_long_as_before(tmp_path: Path) -> None:
    file = written(tmp_path)
    fly_here(load_sweep(file, ["runs=20"]), tmp_path / "out")
    assert sweep.prepare(file, tmp_path / "out", resume=True)[0].runs == 20
    assert sweep.prepare(file, tmp_path / "out")[0].runs == 12


def test_all_wrong_options_are_said_together() -> None:
    with pytest.raises(BadInput) as refused:
        Options(0, None, "some")
    assert [str(problem) for problem in refused.value.problems] == [
        "--jobs: is 0, expected at least 1",
        "--save-logs: is 'some', expected none, failed or all",
    ]


def test_one_run_alone_is_that_row_of_the_table(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    whole = fly_here(plan, tmp_path / "whole")
    passed, flights = sweep.fly_run(plan, 7, tmp_path / "one", Options(jobs=2, fly=quick), figures=False)
    assert len(flights) == 2
    lines = (tmp_path / "one/results.csv").read_text().splitlines()
    assert set(lines) <= set((whole / "results.csv").read_text().splitlines()) and len(lines) == 3
    assert passed == all(",completed,True," in line for line in lines[1:])
    for variant in plan.variants:
        flight = testbed.load(tmp_path / f"one/run-000007-{variant.label}")
        assert flight.scenario.seed == plan.task(14).seed
