"""Progress is shown on a terminal, and nowhere else."""

from __future__ import annotations

import contextlib
import os
import pty
import subprocess
from pathlib import Path

import pytest
from sweep_files import flown, script, written


@pytest.mark.slow
@pytest.mark.parametrize("terminal", [True, False])
def test_progress_on_a_terminal_only(tmp_path: Path, terminal: bool) -> None:
    flying = flown(written(tmp_path), tmp_path / "out", "runs=60")
    ours, theirs = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "150"}
    errors = theirs if terminal else subprocess.PIPE
    process = subprocess.Popen(script(flying), stdout=subprocess.PIPE, stderr=errors, env=environment)
    os.close(theirs)
    shown = b""
    if terminal:
        with contextlib.suppress(OSError):  # the other side is closed
            while block := os.read(ours, 4096):
                shown += block
    out, err = process.communicate()
    os.close(ours)
    assert process.returncode == 0 and out == b"" and not err
    assert terminal == (b"flights/s" in shown) == (b"adaptive_inversion" in shown) == (b"%" in shown)
