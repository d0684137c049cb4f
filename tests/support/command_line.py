"""The command line, as a user has it: in a process of its own, or (quicker) in the test's."""

from __future__ import annotations

import contextlib
import io
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from testbed.cli.commands import main

ROOT = Path(__file__).parents[2]
"""The repository."""


Called = Callable[..., tuple[int, str, str]]
"""`called("list", "metrics")`: exit status, stdout and stderr of a command, in the test's own process."""


def interruptible() -> None:
    """`preexec_fn` of a process that gets signals: as a shell's background job it would ignore SIGINT, and under nohup SIGHUP."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def testbed(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "testbed", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


testbed.__test__ = False  # type: ignore[attr-defined]  # its name begins like a test's


def in_this_process(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """The same without a new process, which takes two seconds to import what this one has: for tests of what is done."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.chdir(folder), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main(arguments)
        except SystemExit as end:  # a usage error
            status = int(end.code or 0)
    return subprocess.CompletedProcess(arguments, status, out.getvalue(), err.getvalue())
