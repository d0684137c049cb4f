"""The pytest plugin, in a project of its own: scenarios are tests, and failed flights leave their reports."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from shutil import copyfile

from command_line import ROOT

SCENARIO = "name: {name}\naircraft: vtail\nduration_s: 1\nrequirements: [{{metric: altitude_error_max_m, at_most: {most}}}]\n"
TESTS = """
import pytest

def test_passes(testbed):
    assert testbed.passes("scenarios/good.yaml").passed

def test_misses(testbed):
    testbed.passes("scenarios/good.yaml", set={"requirements": [{"metric": "survived", "at_least": 2}]})

def test_fails_by_itself(testbed):
    flight = testbed.fly("scenarios/good.yaml")
    assert flight.end_time_s == 7

def test_nothing_flown(testbed):
    assert 1 == 2
"""
INI = "[pytest]\ntestbed_scenarios = scenarios/*.yaml\n{more}"


def run(folder: Path, *arguments: str, more: str = "") -> str:
    """What pytest prints in a project with these tests, in a process of its own."""
    (folder / "scenarios").mkdir(exist_ok=True)
    for name, most in {"good": 5, "bad": -1}.items():
        (folder / "scenarios" / f"{name}.yaml").write_text(SCENARIO.format(name=name, most=most))
    (folder / "test_flights.py").write_text(TESTS)
    (folder / "pytest.ini").write_text(INI.format(more=more))
    plugins = ("-p", "no:cacheprovider", "-o", "addopts=")
    command = [sys.executable, "-m", "pytest", *plugins, *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False).stdout


def test_scenarios_are_tests_and_failed_flights_leave_their_reports(tmp_path: Path) -> None:
    out = run(tmp_path, "-q", "--testbed-out", "flown")
    assert "4 failed, 2 passed" in out
    assert "NOT MET: altitude_error_max_m at most -1" in out and "scenario: bad" in out
    assert "NOT MET: survived at least 2: 1" in out
    left = sorted(path.name for path in (tmp_path / "flown").iterdir())
    assert left == ["bad", "test-fails-by-itself", "test-misses"]
    for name in left:
        assert str(Path("flown") / name / "report.html") in out
        assert (tmp_path / "flown" / name / "log.csv").is_file()
    again = run(tmp_path, "-q", "--testbed-out", "flown", "-k", "bad")
    assert "flown/bad-2/report.html" in again  # nothing is overwritten


def test_parts_of_ones_own_and_bad_input(tmp_path: Path) -> None:
    copyfile(ROOT / "examples" / "my_parts.py", tmp_path / "my_parts.py")
    (tmp_path / "scenarios").mkdir()
    (tmp_path / "scenarios" / "mine.yaml").write_text(
        "name: own\naircraft: vtail\nduration_s: 1\nrequirements: [{metric: worst_bank_deg, at_most: 5}]\n"
    )
    assert "1 passed" in run(tmp_path, "-q", "-k", "mine", more="testbed_with = my_parts.py\n")
    without = run(tmp_path, "-q", "-k", "mine")
    assert "1 failed" in without and "mine.yaml:4: requirements.0.metric: unknown metric" in without
    assert "Traceback" not in without
