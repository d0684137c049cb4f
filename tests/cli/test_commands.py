"""The commands as a whole: usage, version, exit status, and readers that go away."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import Called

import testbed as package


@pytest.mark.parametrize(
    "arguments",
    [[], ["fly"], ["run"], ["list", "planes"], ["report", "nothing"], ["validate", "."], ["sweep", "x.yaml"]],
)
def test_usage_errors(here: Path, called: Called, arguments: list[str]) -> None:
    status, _, err = called(*arguments)
    assert status == 2
    assert err
    assert "Traceback" not in err


def test_the_version_is_the_packages(called: Called) -> None:
    assert called("--version") == (0, f"testbed {package.__version__}\n", "")


@pytest.mark.parametrize("command", ["list", "list metrics", "validate scenarios/left_tail_fail.yaml"])
def test_a_reader_that_goes_away_is_no_error(tmp_path: Path, command: str) -> None:
    """As of `testbed list | head -1`: the pipe's reading end is closed before anything is written to it."""
    reading, writing = os.pipe()
    os.close(reading)
    process = subprocess.run([sys.executable, "-m", "testbed", *command.split()], cwd=tmp_path, check=False,
                             stdout=writing, stderr=subprocess.PIPE, text=True)  # fmt: skip
    os.close(writing)
    assert (process.returncode, process.stderr) == (1, "")
