"""`testbed run`, and `testbed report` of a run folder."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import ROOT, Called, in_this_process, testbed
from handmade import make_flight

from testbed.cli.run import write
from testbed.flight.folder import write_run_folder


def test_problems_of_settings_and_of_the_folder_come_together(tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    scenario = "scenarios/left_tail_fail.yaml"
    result = testbed(
        tmp_path, "run", scenario, "--out", "out", "--set", "controller.gama=4", "--set", "seed=-1"
    )
    assert result.returncode == 2
    assert sorted(result.stderr.splitlines(), reverse=True) == [
        "out: exists already, expected a folder that does not exist yet",
        "--set seed=-1: seed: is -1, expected greater than or equal to 0",
        "--set controller.gama=4: controller.gama: unknown key, did you mean gamma?",
    ]
    assert [p.name for p in tmp_path.rglob("*")] == ["out"]


def test_default_folders_are_numbered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    folders = [str(write(make_flight(), None, lambda _: None)) for _ in range(3)]
    assert folders == [f"runs/left-tail-failure{end}" for end in ("", "-2", "-3")]


def test_a_damaged_run_folder_is_reported(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    (folder / "summary.json").unlink()
    result = in_this_process(tmp_path, "report", "run")
    assert result.returncode == 2
    assert result.stderr == "run/summary.json: is missing from the run folder\n"


def test_what_the_controller_says_of_a_failure_is_printed(tmp_path: Path) -> None:
    shipped = (ROOT / "scenarios" / "mems_turbulence.yaml").read_text()
    lost = "{type: effectiveness, actuator: left_ruddervator, at_s: 40, value: 0.0}"
    assert lost in shipped
    (tmp_path / "reversed.yaml").write_text(
        shipped.replace(lost, "{type: reversal, actuator: left_ruddervator, at_s: 40}")
    )
    result = in_this_process(tmp_path, "run", "reversed.yaml", "--no-plots", "--out", "out")
    assert result.returncode == 0, result.stdout + result.stderr
    said = [line for line in result.stdout.splitlines() if line.startswith("  controller at 40.")]
    assert "left_ruddervator: not a loss of effectiveness" in said[0]


@pytest.mark.nightly
def test_a_first_flight_says_that_it_compiles(tmp_path: Path) -> None:
    """With nothing compiled before, one line on stderr says how long; with it, nothing."""
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache")}
    environment.pop("NUMBA_CACHE_DIR", None)
    command = [sys.executable, "-m", "testbed", "run", "scenarios/left_tail_fail.yaml", "--no-plots"]
    settings = ["--set", "controller={type: pid}", "--set", "requirements=[]", "--set", "duration_s=16"]
    said = [
        subprocess.run(
            [*command, *settings], cwd=tmp_path, env=environment, capture_output=True, text=True, check=True
        )
        for _ in range(2)
    ]
    line = r"compiling the control law for the first flight: about [1-9]\d* s, once\n"
    assert re.fullmatch(line, said[0].stderr)
    assert said[1].stderr == ""
    assert sorted(path.name for path in (tmp_path / "runs").iterdir()) == [
        "left-tail-failure",
        "left-tail-failure-2",
    ]


def test_an_origin_without_a_viewer_is_refused(here: Path, called: Called) -> None:
    status, out, err = called("run", "scenarios/left_tail_fail.yaml", "--origin", "1,2")
    assert (status, out) == (2, "")
    assert err == "--origin: is for FlightGear, expected --flightgear HOST:PORT beside it\n"
