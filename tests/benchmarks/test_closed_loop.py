"""The benchmark of the loop runs and says what its docstring promises; nothing here judges how fast it is."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from command_line import ROOT


def benchmark(*options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(ROOT / "benchmarks" / "closed_loop.py"), "--rounds", "1", *options]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)


@pytest.mark.nightly
def test_it_prints_its_numbers() -> None:
    done = benchmark("--sensors", "mems")
    found = json.loads(done.stdout)
    assert done.returncode == 0, found
    assert found["ratio"] == pytest.approx(found["closed_loop_us"] / found["bare_us"], rel=0.01)
    assert {"steps_per_s", "real_time_factor", "outside_ms"} <= set(found)


@pytest.mark.nightly
def test_a_guard_that_nothing_meets_refuses() -> None:
    done = benchmark("--guard", "0.001")
    assert done.returncode == 1
    assert "is above 0.001" in done.stderr
