"""Reading a sweep file and its --set settings."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from sweep_files import SWEEP, written

from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import dump
from testbed.studies.load import load_sweep


@pytest.mark.parametrize(
    ("setting", "words"),
    [
        ("controller.type=pid", "compare sets controller.type in every flight"),
        ("failures.0.value=0.5", "vary sets failures.0.value in every flight"),
    ],
)
def test_a_setting_without_effect_is_refused(tmp_path: Path, setting: str, words: str) -> None:
    """It would be overwritten by every flight's own value, and ignored without a word."""
    with pytest.raises(BadInput) as refused:
        load_sweep(written(tmp_path), [setting])
    key = setting.partition("=")[0]
    assert str(refused.value) == (
        f"--set {setting}: set.{key}: has no effect: {words}, expected no {key} in set"
    )
    other = load_sweep(written(tmp_path), ["failures.0.until_s=0.8"]).builder.base.tree
    assert other["failures"][0]["until_s"] == 0.8


def test_settings_are_of_the_sweep_or_of_its_scenario(tmp_path: Path) -> None:
    settings = [
        "runs=5",
        "vary.failures.0.value={choice: [0.25]}",
        "duration_s=2",
        "stop_when={half_width: 0.1}",
    ]
    plan = load_sweep(written(tmp_path), settings)
    assert (plan.runs, plan.draw(0)["failures.0.value"]) == (5, 0.25)
    assert plan.builder.scenario(plan.task(0)).duration_s == 2
    assert plan.stop_when is not None and plan.stop_when.confidence == 0.95


def test_the_resolved_sweep_draws_the_same(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    (tmp_path / "resolved.yaml").write_text(dump(plan.tree))
    again = load_sweep(tmp_path / "resolved.yaml")
    assert [again.task(k) for k in range(again.size)] == [plan.task(k) for k in range(plan.size)]
    assert again.tree == plan.tree


@pytest.mark.parametrize(
    ("path", "kept"),
    [("initial.airspeed_m_s: {uniform: [17, 19]}", 0), ("commands.0.at_s: {uniform: [1, 2]}", 1)],
)
def test_the_file_of_a_shorter_sweep_has_the_commands_that_are_flown(
    tmp_path: Path, path: str, kept: int
) -> None:
    """All but those after the new end, whose times are not varied."""
    scenario = "{name: a, aircraft: vtail, duration_s: 40, commands: [{at_s: 15, heading_deg: 30}]}"
    file = tmp_path / "late.yaml"
    file.write_text(f"scenario: {scenario}\nvary: {{{path}}}\nruns: 1\n")
    plan = load_sweep(file, ["duration_s=10"])
    assert len(plan.tree["scenario"]["commands"]) == kept
    assert len(plan.builder.scenario(plan.task(0)).commands) == 1 + kept  # and that of the start


def test_without_a_name_it_is_named_after_its_file(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path, SWEEP.replace("name: small\n", ""), "left_tail.yaml"))
    assert plan.name == "left tail"


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (["runs=1000000000000"], "runs: is 1000000000000, expected less than or equal to 10000000"),
        (
            ["sampling=grid", "levels=1000000000000"],
            "levels: is 1000000000000, expected less than or equal to",
        ),
        (["sampling=grid", "levels=90000"], "sampling: a grid of 1.46e+15 runs, expected at most 10000000"),
        (["runs=6000000"], "runs: is 6000000, which is 12000000 flights with what is compared"),
        (
            ["sampling=grid", "vary={seed_x: {integers: [0, 9000000]}}", "runs=5"],
            "sampling: a grid of 9e+06 runs",
        ),
    ],
)
def test_a_sweep_that_no_memory_could_hold_is_refused(
    tmp_path: Path, settings: list[str], words: str
) -> None:
    with pytest.raises(BadInput, match=re.escape(words)):
        load_sweep(written(tmp_path), settings)


def test_a_compared_mapping_is_labelled_as_json(tmp_path: Path) -> None:
    plan = load_sweep(
        written(tmp_path),
        [
            "compare={controller: [{type: pid}, {type: indi}]}",
            "vary={initial.altitude_m: {uniform: [300, 301]}}",
        ],
    )
    assert [variant.label for variant in plan.variants] == [
        'controller {"type": "pid"}',
        'controller {"type": "indi"}',
    ]
