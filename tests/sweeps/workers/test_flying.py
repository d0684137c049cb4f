"""What one flight leaves: a record, whatever goes wrong in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import SWEEP, written
from sweep_flights import quick

import testbed
from testbed.inputs.problems import BadInput


def test_a_rare_invalid_draw_is_a_row_with_its_reason(tmp_path: Path) -> None:
    """The normal's tail leaves the range in a few runs; the others fly."""
    text = SWEEP.replace("{uniform: [0, 1]}", "{normal: [1.2, 0.13]}")
    frame = testbed.sweep(written(tmp_path, text), tmp_path / "out", runs=120, fly=quick, figures=False)
    invalid = frame[frame["outcome"] == "invalid"]
    assert set(invalid["run"]) == set(frame[frame["failures.0.value"] > 1.5]["run"]) and len(invalid) > 0
    assert invalid["reason"].str.contains("failures.0.value: is .* expected less than or equal to 1.5").all()


def test_a_function_that_workers_cannot_import_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="cannot be imported by a worker"):
        testbed.sweep(written(tmp_path), tmp_path / "out", fly=lambda scenario: quick(scenario))
