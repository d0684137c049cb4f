"""`testbed init`: the project that it makes runs as it is, and nothing is overwritten."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from command_line import ROOT, Called, in_this_process

QUICK = """\
name: quick
aircraft: vtail
duration_s: 1
failures: [{type: effectiveness, actuator: left_ruddervator, at_s: 0.5, value: 0.2}]
requirements: [{metric: altitude_error_max_m, at_most: 0.02}]
"""


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
    subprocess.run(["cc", "-shared", "-fPIC", "-o", "pilot.so", "pilot.c", "-lm"], cwd=folder, check=True)
    for other in ("./pilot.so", "perl pilot.pl"):
        flown = in_this_process(folder, "run", "scenario.yaml", "--no-plots", "--controller", other)
        assert flown.returncode in (0, 1), flown.stderr
    swept = in_this_process(folder, "sweep", "sweep.yaml", "--no-plots", "--runs", "2")
    assert swept.returncode in (0, 1), swept.stderr


@pytest.mark.nightly
def test_the_nightly_workflow_runs(tmp_path: Path) -> None:
    """Each `run` of it by bash, as the server does, in one folder, which stands for what is passed on between its machines."""
    assert in_this_process(tmp_path, "init", "mine").returncode == 0
    folder, shims = tmp_path / "mine", tmp_path / "bin"
    (folder / "scenario.yaml").write_text(QUICK)
    (folder / "sweep.yaml").write_text(
        "name: quick\nscenario: scenario.yaml\nruns: 8\nvary: {failures.0.value: {uniform: [0, 1]}}\n"
    )
    shims.mkdir()
    few = '[ "$1" != matrix ] || set -- "$@" --failures stuck hardover --severities 1'
    shard = '[ "$1" != sweep ] || set -- "$@" --jobs 1 --no-plots'  # a shard's own page is tested elsewhere
    (shims / "testbed").write_text(f'#!/bin/sh\n{few}\n{shard}\nexec "{sys.executable}" -m testbed "$@"\n')
    (shims / "testbed").chmod(0o755)
    steps = steps_of(folder / ".github/workflows/nightly.yml")
    path = f"{shims}:{os.environ['PATH']}"
    for night, status in enumerate((1, 0)):  # the second night expects what the first has found
        done = [
            subprocess.run(
                ["bash", "-e", "-c", step], cwd=folder, env={**os.environ, "PATH": path}, check=False
            )
            for step in steps
        ]
        assert [each.returncode for each in done] == [status, *[0] * (len(steps) - 1)], night
        assert (folder / "comparison.html").is_file() == bool(night)
        shutil.copy(folder / "runs/matrix/matrix.csv", folder / "expected.csv")
        shutil.rmtree(folder / "runs/matrix")
        steps = [step for step in steps if "--shard" not in step]  # what they fly again is the same


def steps_of(workflow: Path) -> list[str]:
    """What the jobs of a workflow run, in their order, each as often as its matrix says."""
    found = []
    for job in yaml.safe_load(workflow.read_text())["jobs"].values():
        for k in job.get("strategy", {}).get("matrix", {}).get("k", [0]):
            runs = [step["run"] for step in job["steps"] if "run" in step]
            found += [run.replace("${{ matrix.k }}", str(k)) for run in runs]
    assert not [run for run in found if "${{" in run]
    return found
