"""What is done for speed changes nothing: compiled against uncompiled, kept against computed; and the guard on it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import ROOT

from testbed import simulation
from testbed.aircraft import description as aircraft
from testbed.common import jit as compiled
from testbed.controllers.inversion import modes
from testbed.flight.flight import Flight
from testbed.plant import jsbsim as plant
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

TAIL = str(ROOT / "scenarios" / "left_tail_fail.yaml")
SHORT = [
    "duration_s=3",
    "requirements=[]",
    "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 0.3, value: 0}]",
    "commands=[{at_s: 0, heading_deg: 100, altitude_m: 305, airspeed_m_s: 19}]",
]
"""A failure, a detection, a mode switch, and references that move, in 3 s."""
CASES = {
    "ideal": [],
    "mems": ["sensors=mems", "controller.filter_rad_s=20"],
    "weighted": ["sensors=mems", "controller.estimation=weighted"],
    "fixed": ["controller.type=fixed_inversion"],
}
_SAVE = """
import json, sys
from testbed.scenario.load import load_scenario
from testbed.simulation import fly
file, cases, folder = json.loads(sys.argv[1])
for name, settings in cases.items():
    with open(f"{folder}/{name}", "wb") as stream:
        stream.write(fly(load_scenario(file, settings)).data.tobytes())
"""


def short(case: str) -> Flight:
    return fly(load_scenario(TAIL, [*SHORT, *CASES[case]]))


@pytest.fixture(scope="session")
def uncompiled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Logs of the short flights, flown by the pages as plain Python."""
    folder = tmp_path_factory.mktemp("uncompiled")
    cases = {name: [*SHORT, *settings] for name, settings in CASES.items()}
    command = [sys.executable, "-c", _SAVE, json.dumps([TAIL, cases, str(folder)])]
    subprocess.run(command, env={**os.environ, "NUMBA_DISABLE_JIT": "1"}, check=True, timeout=300)
    return folder


@pytest.mark.parametrize("case", CASES)
def test_compiled_flies_as_the_page_reads(case: str, uncompiled: Path) -> None:
    """To the last bit, through a failure, its detection and a mode switch. Powers were what differed (numba makes
    products of x**4, Python asks the C library), so the pages write them as products."""
    assert short(case).data.tobytes() == (uncompiled / case).read_bytes()


def test_the_short_flight_has_it_all(uncompiled: Path) -> None:
    """The negative control: the modes are switched, and another flight has other bytes."""
    flight = short("ideal")
    assert {"injection", "detection", "release"} <= {event["kind"] for event in flight.events}
    assert flight.data.tobytes() != (uncompiled / "fixed").read_bytes()


def forget() -> None:
    """Empty everything that is kept from flight to flight."""
    for kept in (aircraft._checked, plant._writable, simulation._start, simulation._design_model):
        kept.cache_clear()
    modes._modes.clear()
    modes._regulators.clear()


@pytest.mark.parametrize("case", ["ideal", "mems"])
def test_what_is_kept_changes_nothing(case: str) -> None:
    """The first flight, the second, and one after another aircraft state has been flown, to the same bytes."""
    forget()
    cold = short(case)
    warm = short(case)
    fly(load_scenario(TAIL, [*SHORT, "controller.model_error={Cm_alpha: 1.3}", "initial.airspeed_m_s=20"]))
    later = short(case)
    assert cold.data.tobytes() == warm.data.tobytes() == later.data.tobytes()
    assert cold.summary == warm.summary == later.summary


def test_an_edited_aircraft_is_read_again(tmp_path: Path) -> None:
    """What is kept of an aircraft is kept under its text."""
    folder = tmp_path / "mine"
    folder.mkdir()
    file, text = folder / "mine.yaml", aircraft.find_aircraft("vtail").read_text()
    file.write_text(text)
    first = aircraft.load_aircraft(str(folder))
    assert aircraft.load_aircraft(str(folder)) is first
    file.write_text(text.replace(f"name: {first.name}", "name: edited", 1))
    assert aircraft.load_aircraft(str(folder)).name == "edited"


def benchmark(*options: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(ROOT / "benchmarks" / "closed_loop.py"), *options]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)


@pytest.mark.parametrize("sensors", ["ideal", "mems"])
def test_a_step_costs_at_most_four_of_jsbsim_alone(sensors: str) -> None:
    """The guard; on a quiet machine it is about half of that (docs/results/performance.md)."""
    done = benchmark("--rounds", "5", "--sensors", sensors, "--guard", "4")
    found = json.loads(done.stdout)
    assert done.returncode == 0, found
    assert found["ratio"] == pytest.approx(found["closed_loop_us"] / found["bare_us"], rel=0.01)
    assert {"steps_per_s", "real_time_factor", "outside_ms"} <= set(found)


def test_the_guard_can_refuse() -> None:
    done = benchmark("--rounds", "1", "--guard", "1")
    assert done.returncode == 1
    assert "is above 1" in done.stderr


def test_old_compiled_code_is_removed(tmp_path: Path) -> None:
    old, new, other = (tmp_path / name for name in ("numba-1-old", "numba-1-new", "something"))
    for folder in (old, new, other):
        folder.mkdir()
        (folder / "code.nbc").write_text("")
    long_ago = time.time() - 31 * 86400
    os.utime(old, (long_ago, long_ago))
    os.utime(other, (long_ago, long_ago))
    compiled.prune(tmp_path)
    assert [folder.exists() for folder in (old, new, other)] == [False, True, True]


def test_flies_where_nothing_can_be_kept(tmp_path: Path) -> None:
    """A home that cannot be written: the next best folder is taken."""
    home = tmp_path / "home"
    home.write_text("a file, so that no folder can be made in it")
    code = "from testbed.common import jit; print(jit._FOLDER)"
    env = {**os.environ, "XDG_CACHE_HOME": str(home), "TMPDIR": str(tmp_path)}
    env.pop("NUMBA_CACHE_DIR", None)
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True)
    assert Path(done.stdout.strip()).is_relative_to(tmp_path / f"testbed-{os.getuid()}")
