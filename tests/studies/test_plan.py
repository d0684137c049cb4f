"""Run i is a pure function of (sweep, seed, i), and a longer sweep begins with the shorter one."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from command_line import ROOT
from sweep_files import written

from testbed.studies.load import load_sweep


def test_variants_meet_the_same_failures(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    tasks = [plan.task(k) for k in range(plan.size)]
    assert [(task.run, task.variant) for task in tasks] == [(i, j) for i in range(12) for j in range(2)]
    for one, other in zip(tasks[::2], tasks[1::2], strict=True):
        assert (one.seed, one.values) == (other.seed, other.values)
        both = [plan.builder.scenario(task) for task in (one, other)]
        assert both[0].failures == both[1].failures and both[0].controller != both[1].controller
    assert len({task.seed for task in tasks}) == 12 and min(task.seed for task in tasks) > 1


@pytest.mark.parametrize("sampling", ["sobol", "halton", "random"])
def test_a_longer_sweep_begins_with_the_shorter(tmp_path: Path, sampling: str) -> None:
    sweep = written(tmp_path)
    short, long = (load_sweep(sweep, [f"sampling={sampling}", f"runs={n}"]) for n in (1100, 2200))
    assert [short.task(k) for k in range(short.size)] == [long.task(k) for k in range(short.size)]
    assert long.task(4321) == load_sweep(sweep, [f"sampling={sampling}", "runs=3000"]).task(4321)


def test_seed_and_run_change_everything_drawn(tmp_path: Path) -> None:
    one, other = (load_sweep(written(tmp_path), [f"seed={seed}"]) for seed in (3, 4))
    tasks = [plan.task(2 * run) for plan in (one, other) for run in range(12)]
    for path in ("failures.0.at_s", "failures.0.value"):
        assert len({task.values[path] for task in tasks}) == 24
    assert len({task.seed for task in tasks}) == 24


def test_a_grid_has_every_combination(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    settings = ["sampling=grid", "levels=3", "vary={failures.0.value: {uniform: [0, 1]}, "
                "failures.0.actuator: {choice: [left_ruddervator, right_ruddervator]}}"]  # fmt: skip
    plan = load_sweep(sweep, [*settings, "runs=6"])
    drawn = [tuple(plan.draw(i).values()) for i in range(plan.runs)]
    actuators = ["left_ruddervator", "right_ruddervator"]
    assert drawn == [(value, actuator) for value in (0.0, 0.5, 1.0) for actuator in actuators]


def test_an_aircraft_beside_the_scenario_is_found_from_anywhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A sweep in another folder than the scenario, whose aircraft is the folder that the scenario is in."""
    folder = Path(shutil.copytree(ROOT / "examples" / "minimal", tmp_path / "project" / "minimal"))
    (folder / "scenario.yaml").write_text("{name: here, aircraft: ., duration_s: 1}")
    sweep = tmp_path / "sweep.yaml"
    varied = "vary: {aircraft.mass_kg: {uniform: [3.9, 4.1]}}"
    sweep.write_text(f"{{name: a, scenario: project/minimal/scenario.yaml, runs: 1, {varied}}}")
    monkeypatch.chdir(tmp_path)
    plan = load_sweep(sweep)
    assert plan.aircraft_names == [str(folder)]
    assert plan.builder.scenario(plan.task(0)).aircraft.name == str(folder)
