"""The catalogue of failures in the documentation is of this code, and of flights of it."""

from __future__ import annotations

from pathlib import Path

import failures_catalogue
from command_line import ROOT

from testbed.failures import TABLE


def test_the_page_and_figures_are_as_the_code_says(tmp_path: Path) -> None:
    assert failures_catalogue.stale(ROOT / "docs" / "reference") == []  # not part of an installed package
    assert len(failures_catalogue.stale(tmp_path)) == 1 + len(TABLE)  # negative control: nothing is there
