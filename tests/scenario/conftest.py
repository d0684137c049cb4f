"""A good scenario file of the test's own."""

from __future__ import annotations

from pathlib import Path

import pytest
from scenario_files import GOOD


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "scenario.yaml"
    path.write_text(GOOD)
    return path
