"""Settings in the environment at which a library would end in a traceback are refused in words."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from testbed.cli import environment, status


@pytest.mark.parametrize("text", ["0", "-3", "abc", "1.5", ""])
def test_a_wrong_number_of_threads_is_refused(text: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "testbed", "list"], env={**os.environ, "NUMBA_NUM_THREADS": text},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == status.BAD_INPUT
    assert done.stderr == f"NUMBA_NUM_THREADS: is {text!r}, expected a whole number of 1 or more\n"


@pytest.mark.parametrize("text", ["1", " 2 ", None])
def test_numbers_that_numba_takes_are_taken(text: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NUMBA_NUM_THREADS", raising=False)
    if text is not None:
        monkeypatch.setenv("NUMBA_NUM_THREADS", text)
    assert environment.wrong_setting() == ""
