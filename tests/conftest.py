"""The v-tail as it is shipped, and a copy of it to be edited."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from testbed.aircraft.description import Aircraft, load_aircraft


@pytest.fixture(scope="session")
def vtail() -> Aircraft:
    return load_aircraft("vtail")


@pytest.fixture
def vtail_copy(vtail: Aircraft, tmp_path: Path) -> Path:
    """The v-tail in a folder of the test's own."""
    return Path(shutil.copytree(vtail.folder, tmp_path / "aircraft" / "vtail"))
