"""Aircraft adopted from JSBSim's, which takes seconds: once for all tests, where benchmarks keep theirs."""

from __future__ import annotations

import shutil
from pathlib import Path

from testbed.studies.benchmark.load import hangar, provide


def adopted(model: str, folder: Path) -> Path:
    """A copy of an adopted model in a folder of its name, which is made in this one."""
    provide(model)
    return Path(shutil.copytree(hangar() / model, folder / model))
