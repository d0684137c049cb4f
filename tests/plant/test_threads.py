"""Flights in threads of one process."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

PROGRAM = """
from concurrent.futures import ThreadPoolExecutor
import testbed
SET = {"duration_s": 1, "failures": [], "requirements": []}
fly = lambda _: testbed.fly("left_tail_fail.yaml", set=SET).data.tobytes()
alone = fly(0)
for threads in (2, 4):  # which end with their pool
    with ThreadPoolExecutor(threads) as pool:
        print(*(each == alone for each in pool.map(fly, range(6))))
"""


def test_threads_fly_the_same_and_end(tmp_path: Path) -> None:
    """In a process of its own, which JSBSim would end."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout.split()) == (0, ["True"] * 12), done.stderr
