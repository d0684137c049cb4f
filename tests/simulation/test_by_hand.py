"""The example of a flight by hand runs as it is written, and its folder flies again to the same bytes."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest
from command_line import ROOT

import testbed


def test_the_example(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(ROOT / "examples" / "by_hand.py"), run_name="__main__")
    seen, end = capsys.readouterr().out.splitlines()
    assert 0.0 < float(seen.split()[2]) < 2.0
    assert end.startswith("at 30")
    kept = testbed.load(tmp_path / "by hand")
    assert kept.end_time_s == 25.0
    again = testbed.fly(tmp_path / "by hand" / "scenario.yaml")
    again.save(tmp_path / "again", figures=False)
    for name in ("log.csv", "summary.json", "scenario.yaml"):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / "by hand" / name).read_bytes()
