"""What a search file says becomes parts with coordinates; what it cannot mean is refused with its place."""

from __future__ import annotations

from pathlib import Path

import pytest
from search_files import SEARCH, written
from sweep_files import SWEEP
from sweep_files import written as sweep_written

from testbed.aircraft.shipped import files_in
from testbed.inputs.problems import BadInput
from testbed.studies.checks import check
from testbed.studies.search.plan import load_search


def refused(file: Path, *settings: str) -> str:
    with pytest.raises(BadInput) as error:
        check(load_search(file, settings))
    return str(error.value)


def test_shipped_searches_are_valid() -> None:
    assert {file.stem for file in files_in("scenarios/searches")} == {
        "rare_gust",
        "smallest_gust",
        "smallest_turbulence",
    }
    for file in files_in("scenarios/searches"):
        check(load_search(file))


def test_a_severity_is_measured_from_the_value_without_effect(tmp_path: Path) -> None:
    plan = load_search(written(tmp_path), ["vary.failures.0.value={uniform: [0, 1]}",
                                           "vary.failures.0.at_s={uniform: [0.1, 0.5]}"])  # fmt: skip
    origins = {each.path: each.origin for each in plan.parts[0].space.coordinates}
    assert origins["failures.0.value"] == "high" and origins["failures.0.at_s"] == "median"
    assert {each.path: each.nominal for each in plan.parts[0].space.coordinates}["failures.0.value"] == 1.0


def test_a_nominal_value_is_an_end_of_its_range(tmp_path: Path) -> None:
    varied = "vary.failures.0.at_s={uniform: [0.1, 0.5]}"
    plan = load_search(written(tmp_path), [varied, "nominal={failures.0.at_s: 0.5}"])
    assert plan.parts[0].space.coordinates[-1].origin == "high"
    assert "nominal.failures.0.at_s: is 0.3, which is no end of its range, expected 0.1 or 0.5" in refused(
        written(tmp_path), varied, "nominal={failures.0.at_s: 0.3}"
    )
    assert "has a nominal rate_hz, which does not vary" in refused(
        written(tmp_path), "nominal={rate_hz: 100}"
    )


def test_each_option_and_each_variant_is_a_part(tmp_path: Path) -> None:
    settings = [
        "compare={controller.type: [adaptive_inversion, pid]}",
        "vary.failures.0.actuator={choice: [left_ruddervator, left_propeller, right_propeller], weights: [1, 3, 0]}",
    ]
    plan = load_search(written(tmp_path), settings)
    assert [plan.label(part) for part in plan.parts] == [
        f"{controller}, {actuator}"
        for controller in ("adaptive_inversion", "pid")
        for actuator in ("left_ruddervator", "left_propeller")
    ]
    assert [part.weight for part in plan.parts] == [0.25, 0.75] * 2
    seeds = [plan.seed(part) for part in plan.parts]
    assert seeds[:2] == seeds[2:] and seeds[0] != seeds[1]  # variants meet the same points


def test_seeds_of_flights(tmp_path: Path) -> None:
    import numpy as np

    points = np.array([[0.0, 0.0], [1.0, 0.0]])
    smallest = load_search(written(tmp_path))
    same = [task.seed for task in smallest.tasks(smallest.parts[0], points, 0)]
    assert same[0] == same[1]
    likely = load_search(written(tmp_path), ["goal=probability"])
    drawn = [task.seed for task in likely.tasks(likely.parts[0], points, 0)]
    assert drawn[0] != drawn[1] and drawn == [task.seed for task in likely.tasks(likely.parts[0], points, 7)]


def test_one_requirement_alone_is_searched(tmp_path: Path) -> None:
    settings = [
        "requirements=[{name: held, metric: altitude_error_max_m, at_most: 1}, {metric: heading_error_max_deg, at_most: 1}]"
    ]
    plan = load_search(written(tmp_path), [*settings, "requirement=heading_error_max_deg at most 1"])
    scenario = plan.builder.scenario(plan.task(0))
    assert [requirement.title for requirement in scenario.requirements] == ["heading_error_max_deg at most 1"]
    words = refused(written(tmp_path), *settings, "requirement=hold")
    assert words.endswith("requirement: there is no requirement 'hold', did you mean held?")


def test_a_sweeps_file_is_searched_with_a_goal(tmp_path: Path) -> None:
    plan = load_search(sweep_written(tmp_path), goal="smallest")
    assert plan.name == "small" and len(plan.parts) == 4  # two controllers, two actuators
    assert [each.path for each in plan.parts[0].space.coordinates] == [
        "failures.0.at_s", "failures.0.value", "controller.model_error.Cm_alpha",
    ]  # fmt: skip
    assert "is a sweep, expected a search" in refused(sweep_written(tmp_path))
    with pytest.raises(BadInput, match="is a scenario, expected a search; `testbed run` takes this file"):
        load_search("scenarios/left_tail_fail.yaml", goal="smallest")


@pytest.mark.parametrize(("old", "new", "words"), [
    ("goal: smallest", "goal: small", "goal: 'small' is not known, did you mean smallest?"),
    ("budget: 300", "budget: 3", "budget: is 3, expected greater than or equal to 20"),
    ("budget: 300", "runs: 300", "runs: unknown key"),
    ("  requirements: [{name: held, metric: altitude_error_max_m, at_most: 1}]\n", "  requirements: []\n", "has no requirement"),
    ("normal: [0, 2]", "normla: [0, 2]", "unknown distribution 'normla', did you mean normal?"),
    ("atmosphere.wind_m_s.1:", "seed:", "vary: names seed"),
    ("wind_m_s.1", "wind_m_s.3", "has no entry 3, expected an index from 0 to 2"),
])  # fmt: skip
def test_what_is_refused(tmp_path: Path, old: str, new: str, words: str) -> None:
    assert old in SEARCH
    assert words in refused(written(tmp_path, SEARCH.replace(old, new)))


@pytest.mark.parametrize("varied", [
    "atmosphere.wind_m_s.0: {normal: [0, 2]}",
    "controller.model_error.Cm_alpha: {uniform: [0.8, 1.2]}",
    "atmosphere.turbulence_w20_m_s: {halfnorm: [0, 2]}",
])  # fmt: skip
def test_what_varies_may_be_a_default_of_the_scenario(tmp_path: Path, varied: str) -> None:
    """Without `atmosphere` and `controller` in the file; halfnorm's upper quantile is finite."""
    text = SEARCH.partition("vary:")[0].replace("  atmosphere: {wind_m_s: [0, 0, 0]}\n", "")
    text = text.replace("scenario: scenarios/left_tail_fail.yaml", _PLAIN)
    check(load_search(written(tmp_path, f"{text}vary:\n  {varied}\n")))


_PLAIN = "scenario: {name: plain, aircraft: vtail}"


@pytest.mark.parametrize("path", ["failures.0.at_s", "atmosphere.gusts.0.at_s"])
def test_an_entry_of_a_list_that_is_not_there_is_refused(tmp_path: Path, path: str) -> None:
    text = SEARCH.replace("  failures:", "  rate_hz: 100 #").replace("atmosphere.wind_m_s.1", path)
    parent = path.partition(".0")[0]
    assert f"{parent}: has no entry 0, expected no index, the list is empty" in refused(
        written(tmp_path, text.replace("scenario: scenarios/left_tail_fail.yaml", _PLAIN))
    )


def test_choices_alone_are_no_search(tmp_path: Path) -> None:
    text = SEARCH.replace("{normal: [0, 2]}", "{choice: [0, 2]}")
    assert "vary: has choices only, expected a value with a distribution to search in" in refused(
        written(tmp_path, text)
    )


def test_a_resolved_search_is_a_search(tmp_path: Path) -> None:
    from testbed.inputs import yaml_source

    plan = load_search(
        written(tmp_path), ["goal=probability", "requirement=held", "compare={controller.type: [pid, indi]}"]
    )
    again = load_search(written(tmp_path, yaml_source.dump(plan.tree), "search.yaml"))
    assert again.tree == plan.tree
    assert "runs" not in SWEEP.partition("vary")[2] and "runs" not in plan.tree
