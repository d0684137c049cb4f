"""The campaigns of flights that pages of the documentation are written from."""

from __future__ import annotations

import sys
from pathlib import Path

import hold_it
import leaderboard
import pytest
from hold_it import LONG, LOST, Cell, Result


@pytest.mark.nightly
def test_the_campaigns_fly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Few cells of each, written where asked."""
    monkeypatch.setattr(sys, "argv", ["test"])
    out = tmp_path / "hold.md"
    few = ["--seeds", "1", "--first-seed", "1", "--w20", "25", "--group", "none", "--jobs", "1", "--out"]
    hold_it.main([*few, str(out)])
    assert "| none | 25 | 4 m, 6 deg |" in out.read_text()
    out = tmp_path / "board.md"
    leaderboard.main(["--quick", "--only", "reversal", "--w20", "0", "--jobs", "1", "--out", str(out)])
    assert "reversal, left_ruddervator | " in out.read_text()
    titles = [cell.group for cell in hold_it.cells([25.0, 50.0])]
    assert len(titles) == 2 * (1 + 12 + 4 + 12 + 4 + 2 + 1) + 18


def test_a_cell_that_does_not_hold_is_said() -> None:
    """Negative control: a lost flight, one beyond its limits and a false detection are each not held."""

    def record(
        altitude: float, heading: float, outcome: str = "completed", alarms: float = 0.0
    ) -> dict[str, object]:
        metrics = {"altitude_error_max_m": altitude, "heading_error_max_deg": heading, "false_alarms": alarms}
        checks = [[True, altitude], [True, heading]]
        return {
            "outcome": outcome,
            "metrics": metrics,
            "requirements": checks,
            "seed": 7,
            "end_time_s": 110.0,
        }

    cell = Cell(LOST, (("left_propeller", 0.0),), 25, 5, 10)
    assert not Result(cell, (record(4.9, 9.9),)).failed
    assert Result(cell, (record(5.1, 0.0),)).failed
    assert Result(cell, (record(0.0, 10.1),)).failed
    assert Result(cell, (record(0.0, 0.0, "envelope_exceeded"),)).failed
    assert Result(Cell(LONG, (), 25, long=True, from_start=True), (record(1.0, 1.0, alarms=1.0),)).failed
