"""Progress is shown on a terminal, and nowhere else."""

from __future__ import annotations

import contextlib
import io
import os
import pty
import subprocess
from pathlib import Path

import pytest
from sweep_files import SWEEP, flown, script, written

from testbed.studies.load import load_sweep
from testbed.studies.run import Passed, bar


@pytest.mark.nightly
@pytest.mark.parametrize("terminal", [True, False])
def test_progress_on_a_terminal_only(tmp_path: Path, terminal: bool) -> None:
    flying = flown(written(tmp_path), tmp_path / "out", "runs=20")
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


def test_nothing_is_cut_at_80_columns(tmp_path: Path) -> None:
    """A long name gives way; the counts, the rate, the time left and every variant's share are whole."""
    from rich.console import Console

    text = SWEEP.replace("name: small", f"name: {'a long name ' * 8}").replace(
        "[adaptive_inversion, fixed_inversion]", "[adaptive_inversion, fixed_inversion, indi, pid, oracle]"
    )
    plan = load_sweep(written(tmp_path, text))
    passed = Passed(plan)
    for variant in range(5):
        passed.add(variant, variant % 2 == 0)
    console = Console(width=80, force_terminal=True, record=True, file=io.StringIO())
    shown_bar = bar(console, passed.words)
    shown_bar.add_task(plan.name, total=12345, completed=1234, rate="10.1 flights/s")
    for drawn in shown_bar.get_renderables():
        console.print(drawn)
    shown = console.export_text()
    assert all(len(line) <= 80 for line in shown.splitlines())
    assert (
        "1234/12345" in shown and "10.1 flights/s" in shown and "-:--:--" in shown and "a long name" in shown
    )
    joined = " ".join(shown.split())
    for share in ("adaptive_inversion 100 %", "fixed_inversion 0 %", "indi 100 %", "pid 0 %", "oracle 100 %"):
        assert share in joined
