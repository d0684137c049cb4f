"""Commands that are ended at random moments lose nothing, and a sweep does not grow."""

from __future__ import annotations

from pathlib import Path

import faults
import pytest

pytestmark = [
    pytest.mark.nightly,
    pytest.mark.skipif(not Path("/proc").is_dir(), reason="looks at /proc"),
]


def test_nothing_is_lost_shown_or_left_at_random_moments(tmp_path: Path) -> None:
    assert not list(faults.problems(12, 5, tmp_path))


def test_a_traceback_a_lost_flight_and_another_table_are_seen(tmp_path: Path) -> None:
    """The negative control."""
    struck, whole = (faults.commands(tmp_path / name)["sweep"] for name in ("struck", "whole"))
    for command in (struck, whole):
        command.arguments = (
            "sweep",
            "study.yaml",
            "--runs",
            "4",
            "--set",
            f"seed={len(str(command.folder))}",
        )
        command.ended()
    struck.folder.joinpath(".x.partial").touch()
    found = " ".join(faults._struck(struck, whole, faults.SIGNALS[0], 0.0))
    assert "files left: ['.x.partial']" in found and "another table" in found


def test_neither_parent_nor_workers_grow(tmp_path: Path) -> None:
    """While flights are flown: before, the parent imports, and at last it makes the table."""
    found = [each for each in faults.memory(800, tmp_path, samples=20) if 0 < each[0] < 800]
    assert len(found) >= 3
    assert found[-1][1] - found[0][1] < 10 and found[-1][2] - found[0][2] < 10, found
