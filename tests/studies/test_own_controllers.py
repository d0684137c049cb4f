"""Controllers of the user's in a sweep: compared, given their parameters, resumed with the same code only, or refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest
import sweep_files
from own_controllers import SWEEP, own_controller

import testbed
from testbed.api.sweep import prepare
from testbed.controllers.user.own import own_controllers
from testbed.inputs.problems import BadInput
from testbed.simulation import fly
from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.load import load_sweep


def swept(folder: Path, own: str, **more: object) -> object:
    return sweep_files.swept(folder / "own.yaml", folder / "out", None, controllers=[own], **more)


def test_it_is_compared_with_the_shipped_ones_on_the_same_draws(tmp_path: Path) -> None:
    own = own_controller(tmp_path)
    frame = testbed.sweep(tmp_path / "own.yaml", tmp_path / "out", controllers=[own], jobs=1, figures=False)
    assert sorted(frame["controller.type"].unique()) == ["adaptive_inversion", "mine", "pid"]
    assert (frame["outcome"] == "completed").all()
    drawn = frame.groupby("run")["controller.parameters.gain"].nunique()
    assert (drawn == 1).all()
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert {(p["first"], p["second"]) for p in summary["pairs"]} >= {("pid", "mine")}
    assert testbed.load(tmp_path / "out").shape == frame.shape  # read without the class

    class Direct:
        """The same law without files: the row of the sweep must be its flight."""

        parameters: ClassVar = {"gain": 0.0, "unused": 7}

        def __init__(self, setup):  # type: ignore[no-untyped-def]
            self.trim, self.gain = list(setup.trim_commands), 0.5 * setup.parameters["gain"]

        def update(self, time_s, state, reference):  # type: ignore[no-untyped-def]
            elevator = self.gain * (state.pitch - 0.02)
            return [self.trim[0] + elevator, self.trim[1] + elevator, *self.trim[2:]]

    plan = load_sweep(tmp_path / "own.yaml", (), own_controllers([own]))
    row = frame[(frame["run"] == 1) & (frame["controller.type"] == "mine")].iloc[0]
    alone = fly(plan.builder.scenario(plan.task(1 * 3 + 2)), Direct)
    assert alone.metrics["altitude_error_max_m"] == row["altitude_error_max_m"]


def test_it_is_resumed_with_the_same_code_only(tmp_path: Path) -> None:
    own = own_controller(tmp_path)
    swept(tmp_path, own)
    swept(tmp_path, own, resume=True, runs=4)
    beside = tmp_path / "beside_mine.py"
    beside.write_text("HALF = 0.25\n")
    with pytest.raises(BadInput, match="other code of mine"):
        swept(tmp_path, own, resume=True, runs=5)


def test_what_cannot_be_honoured_is_refused(tmp_path: Path) -> None:
    own = own_controller(tmp_path)
    file = tmp_path / "own.yaml"
    with pytest.raises(BadInput, match=r"are for a controller of one's own, and adaptive_inversion flies"):
        prepare(file)  # parameters, and no class that takes them
    with pytest.raises(BadInput, match=r"declares no parameter gian.*did you mean gain"):
        prepare(file, settings=["vary.controller.parameters.gian={uniform: [0, 1]}"], controllers=[own])
    whole = SWEEP.replace("{controller.type: [adaptive_inversion, pid]}", "{controller: [{type: pid}]}")
    whole = whole.replace(
        "controller.parameters.gain: {uniform: [0.5, 1.5]}", "initial.altitude_m: {uniform: [250, 300]}"
    )
    file.write_text(whole.replace("  controller.gamma: {uniform: [2, 4]}\n", ""))
    with pytest.raises(BadInput, match="--controller has no place"):
        prepare(file, controllers=[own])
    file.write_text(SWEEP + "controllers: {mine: mine_flies.py:Mine}\n")
    with pytest.raises(BadInput, match=r"expected --controller mine=FILE\.py:CLASS"):
        prepare(file)  # a sweep file runs no code
    with pytest.raises(BadInput, match="flies the scenario in its own way"):
        testbed.sweep(file, tmp_path / "out", controllers=[own], fly=fly)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("mine", "expected NAME=FILE.py:CLASS"),
        ("no name=mine_flies.py:Mine", "expected NAME=FILE.py:CLASS"),
        ("pid={file}:Mine", "pid is the name of a shipped controller"),
        ("mine={file}:Main", "did you mean Mine"),
        ("mine={file}", "expected FILE.py:CLASS"),
    ],
)
def test_a_wrong_reference_is_refused(tmp_path: Path, given: str, words: str) -> None:
    own_controller(tmp_path)
    with pytest.raises(BadInput, match=words):
        own_controllers([given.format(file=tmp_path / "mine_flies.py")])


def test_its_code_is_its_file_and_what_it_imports_beside_it(tmp_path: Path) -> None:
    (tmp_path / "stranger.py").write_text("")
    own = own_controllers([own_controller(tmp_path)])["mine"]
    assert [name for name, _ in own.code] == ["beside_mine.py", "mine_flies.py"]
    other = replace(own, code=(own.code[0], (own.code[1][0], own.code[1][1] + b"#")))
    assert other.digest != own.digest
    assert own.reference == "mine_flies.py:Mine"


def test_an_error_in_the_class_is_the_reason_of_its_row(tmp_path: Path) -> None:
    own = own_controller(tmp_path)
    file = tmp_path / "mine_flies.py"
    file.write_text(
        file.read_text().replace("        elevator =", "        1 / (time_s < 0.5)\n        elevator =")
    )
    plan = load_sweep(tmp_path / "own.yaml", (), own_controllers([own]))
    record = fly_task(Job(plan.builder, save_logs="none"), plan.task(2)).record
    assert record.outcome == "invalid"
    assert "at 0.500 s: ZeroDivisionError" in record.reason
    assert np.isnan(record.end_time_s)
