"""The command line, as a user has it: in a process of its own, or (quicker) in the test's."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).parents[2]
"""The repository."""


Called = Callable[..., tuple[int, str, str]]
"""`called("list", "metrics")`: exit status, stdout and stderr of a command, in the test's own process."""


def testbed(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "testbed", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


testbed.__test__ = False  # type: ignore[attr-defined]  # its name begins like a test's
