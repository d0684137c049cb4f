"""Ctrl-C and kill -9 in the middle of a flight: what flies outside of the program ends too, and its ports are free."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from scripts import runnable

SUPPORT = Path(__file__).parents[2] / "support"
PILOT = """
import json, sys, time
trim = [each["trim"] for each in json.loads(sys.stdin.readline())["actuators"]]
print("{}", flush=True)
for line in sys.stdin:
    time.sleep(0.05)
    print(json.dumps({"commands": trim}), flush=True)
"""
KINDS = ["process", "ardupilot", "px4"]


def children(pid):
    """The processes that this one has started, by the kernel."""
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def until(found, within_s=60.0):
    """What a function returns once that is true."""
    end_s = time.monotonic() + within_s
    while not (answer := found()) and time.monotonic() < end_s:
        time.sleep(0.05)
    return answer


@pytest.fixture
def flying(tmp_path, monkeypatch):
    """Starts a flight by a kind of controller; gives its process and the controller's."""
    started = []

    def made(kind):
        pilot = tmp_path / "pilot.txt"
        pilot.write_text(PILOT)
        monkeypatch.setenv("FAKE_FAULT", "slow")
        named = {
            "process": ["--controller", f"{sys.executable} {pilot}"],
            "ardupilot": ["--autopilot", SUPPORT / "fake_ardupilot.py"],
            "px4": ["--controller", f"px4:{runnable('fake_px4.py')}"],
        }[kind]
        command = ["-m", "testbed", "run", "left_tail_fail.yaml", "--no-plots", *named]
        flight = subprocess.Popen(
            [sys.executable, *command, "--out", tmp_path / "run"], stderr=subprocess.DEVNULL
        )
        started.append(flight)
        return flight, until(lambda: children(flight.pid))[0]

    yield made
    for flight in started:
        flight.kill()
        flight.wait()


@pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="there is no /proc")
@pytest.mark.parametrize(
    ("kind", "how", "status"),
    [
        ("process", signal.SIGINT, 130),
        *((kind, signal.SIGKILL, -9) for kind in KINDS),
        *(pytest.param(kind, signal.SIGINT, 130, marks=pytest.mark.nightly) for kind in KINDS[1:]),
    ],
)
def test_nothing_goes_on(flying, kind, how, status):
    flight, controller = flying(kind)
    time.sleep(1.0)
    assert Path(f"/proc/{controller}").exists()
    flight.send_signal(how)
    assert flight.wait(30) == status
    assert until(lambda: not Path(f"/proc/{controller}").exists(), 5.0)
