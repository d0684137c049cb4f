"""A thread that a controller of one's own has left behind does not hold the command."""

from __future__ import annotations

import subprocess
import sys

import pytest

LEFT = """\
import threading, time
from testbed.cli import commands
commands._WAIT_S = 0.2
threading.Thread(target=time.sleep, args=({seconds},), name="theirs").start()
print("flown")
raise SystemExit(commands.end_despite_threads(1))
"""


@pytest.mark.parametrize(
    ("seconds", "said"), [(600, "WARNING: a thread was left running, and is ended: theirs\n"), (0.05, "")]
)
def test_it_is_given_some_time_and_then_ended(seconds: float, said: str) -> None:
    command = [sys.executable, "-c", LEFT.format(seconds=seconds)]
    ended = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert (ended.returncode, ended.stdout, ended.stderr) == (1, "flown\n", said)
