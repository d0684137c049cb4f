"""The command line as a user has it: a process of its own."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
"""The repository."""


def testbed(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "testbed", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


testbed.__test__ = False  # type: ignore[attr-defined]  # its name begins like a test's
