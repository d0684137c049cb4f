"""Drawn values in the base scenario: set where they belong, with the place of the sweep file in every problem."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import SWEEP, written

from testbed.inputs.problems import BadInput
from testbed.studies.drawing.builder import Builder, Task
from testbed.studies.load import load_sweep

VALUE = "failures.0.value"


@pytest.fixture
def builder(tmp_path: Path) -> Builder:
    return load_sweep(written(tmp_path)).builder


def test_values_and_seed_are_set_and_the_base_stays(builder: Builder) -> None:
    before = repr(builder.base.tree)
    scenario = builder.scenario(Task(0, 1, 77, {VALUE: 0.25, "failures.0.actuator": "right_ruddervator"}))
    assert (scenario.seed, scenario.controller.type) == (77, "fixed_inversion")
    (failure,) = scenario.failures
    assert failure.model_dump()["value"] == 0.25 and failure.model_dump()["actuator"] == "right_ruddervator"
    assert repr(builder.base.tree) == before


def test_a_problem_has_the_line_of_the_sweep_file(builder: Builder) -> None:
    with pytest.raises(BadInput) as refused:
        builder.scenario(Task(0, 0, 1, {VALUE: 7.0}))
    assert (
        str(refused.value).partition("small.yaml:")[2].startswith(f"11: {VALUE}: is 7.0, expected less than")
    )


def test_a_setting_of_one_controller_is_left_out_for_another(tmp_path: Path) -> None:
    """`gamma` is the adaptive law's: `pid` flies without it, and a word that neither knows is still refused."""
    text = SWEEP.replace("fixed_inversion]", "pid]").replace(
        "controller.model_error.Cm_alpha", "controller.gamma"
    )
    builder = load_sweep(written(tmp_path, text)).builder
    adaptive, pid = (builder.scenario(Task(0, variant, 1, {"controller.gamma": 2.0})) for variant in (0, 1))
    assert "gamma" in adaptive.controller.model_dump() and "gamma" not in pid.controller.model_dump()
    for variant in (0, 1):
        with pytest.raises(BadInput, match=r"controller\.gama: unknown key"):
            builder.scenario(Task(0, variant, 1, {"controller.gama": 2.0}))


def test_another_aircraft_folder_changes_nothing_else(builder: Builder, tmp_path: Path) -> None:
    moved = builder.with_aircraft(str(tmp_path))
    assert moved.base.tree == {**builder.base.tree, "aircraft": str(tmp_path)}
    assert builder.base.tree["aircraft"] == "vtail"
