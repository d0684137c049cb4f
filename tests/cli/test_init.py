"""`testbed init`: the project that it makes runs as it is, and nothing is overwritten."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
import yaml
from command_line import ROOT, Called, in_this_process


def test_the_project_is_valid(called: Called, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    status, out, _ = called("init", str(tmp_path / "mine"))
    assert (status, out) == (0, f"wrote {tmp_path / 'mine'}: README.md says what to run\n")
    monkeypatch.chdir(tmp_path / "mine")
    assert called("validate", "scenario.yaml", "sweep.yaml")[0] == 0
    for line in (
        Path("scenario.yaml").read_text().splitlines()[:1] + Path("sweep.yaml").read_text().splitlines()[:1]
    ):
        assert Path(line.partition("$schema=")[2]).is_file()


def test_a_project_for_an_aircraft_of_ones_own(
    called: Called, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It breaks the first actuator of that aircraft, and climbs from its own altitude."""
    shutil.copytree(ROOT / "examples" / "minimal", tmp_path / "minimal")
    monkeypatch.chdir(tmp_path)
    assert called("init", "mine", "--aircraft", "./minimal")[0] == 0
    monkeypatch.chdir("mine")
    scenario = yaml.safe_load(Path("scenario.yaml").read_text())
    assert scenario["aircraft"] == str(tmp_path / "minimal")
    assert scenario["failures"][0]["actuator"] == "elevator"
    assert scenario["commands"][0]["altitude_m"] == 310
    assert called("validate", "scenario.yaml", "sweep.yaml")[0] == 0


def test_no_project_for_an_aircraft_that_is_not_there(called: Called, tmp_path: Path) -> None:
    status, _, err = called("init", str(tmp_path / "mine"), "--aircraft", "./nowhere")
    assert status == 2 and "nowhere" in err
    assert not (tmp_path / "mine").exists()


def test_a_folder_with_something_in_it_is_left_alone(called: Called, tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    status, _, err = called("init", str(tmp_path))
    assert (status, err) == (2, f"{tmp_path}: is not empty, expected a new or empty folder\n")
    assert [file.name for file in tmp_path.iterdir()] == ["mine.txt"]


@pytest.mark.nightly
def test_the_project_runs(tmp_path: Path) -> None:
    """Requirements are met by the default controller; the example's own loses altitude once the surface is broken."""
    assert in_this_process(tmp_path, "init", "mine").returncode == 0
    folder = tmp_path / "mine"
    done = in_this_process(folder, "run", "scenario.yaml", "--no-plots")
    assert done.returncode == 0, done.stdout + done.stderr
    own = in_this_process(
        folder,
        "run",
        "scenario.yaml",
        "--no-plots",
        "--out",
        "own",
        "--controller",
        "my_controller.py:MyController",
    )
    assert own.returncode in (0, 1), own.stderr
    swept = in_this_process(folder, "sweep", "sweep.yaml", "--no-plots", "--runs", "2")
    assert swept.returncode in (0, 1), swept.stderr
