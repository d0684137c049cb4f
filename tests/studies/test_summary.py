"""summary.json says what the table says."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sweep_files import SWEEP, fly_here, table, written

from testbed.api import sweep
from testbed.studies.load import load_sweep
from testbed.studies.summary import worst


@pytest.fixture(scope="module")
def answered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("answered")
    plan = load_sweep(written(folder), ["runs=150"])
    sweep.finish(plan, fly_here(plan, folder / "out"), figures=False)
    return folder / "out"


def test_the_summary_counts_the_table(answered: Path) -> None:
    summary = json.loads((answered / "summary.json").read_text())
    frame = table(answered)
    for variant in summary["variants"]:
        rows = frame[frame["controller.type"] == variant["label"]]
        share = variant["all_requirements"]
        assert (share["successes"], share["n"]) == (rows["passed"].sum(), len(rows))
        assert share["exact_low"] <= share["low"] <= share["estimate"] <= share["high"] <= share["exact_high"]
        assert variant["requirements"][0]["successes"] == rows["requirements.0.passed"].sum()
        largest = variant["metrics"]["altitude_error_max_m"]
        assert largest["largest"] == rows["altitude_error_max_m"].max()
        assert largest["tolerance_bounds"]["0.95"] == rows["altitude_error_max_m"].nlargest(3).iloc[-1]
        inputs = variant["sensitivity"]["passed"]["inputs"]
        assert max(inputs, key=lambda name: inputs[name]["pawn"]) == "failures.0.value"
    assert summary["pairs"][0]["difference"] == 0 and summary["pairs"][0]["p_value"] == 1
    assert summary["complete"] and summary["probabilistic"]


def test_the_worst_runs_come_first(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("failures.0.value\n0.05\n0.45\n0.1\n0.9\n0.01\n")
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\n"
    plan = load_sweep(written(tmp_path, text))
    frame = table(fly_here(plan, tmp_path / "out", "sweep_flights:bad"))
    assert list(worst(frame)["run"]) == [2, 4, 0, 1]  # no result; then by altitude error; 3 has passed
