"""Searches from Python take settings as flights and sweeps do."""

from __future__ import annotations

from pathlib import Path

import yaml
from search_files import written
from search_flights import gusty

import testbed


def test_settings_as_a_mapping_are_those_of_the_command_line(tmp_path: Path) -> None:
    changes = {"goal": "probability", "method": "plain", "cov": 1, "budget": 60, "duration_s": 3}
    result = testbed.search(
        written(tmp_path), tmp_path / "out", fly=gusty, jobs=1, set=changes, seed=2, figures=False
    )
    assert result.probability is not None
    written_out = yaml.safe_load((tmp_path / "out/search.yaml").read_text())
    assert written_out["scenario"]["duration_s"] == 3
    assert written_out["budget"] == 60 and written_out["method"] == "plain"
