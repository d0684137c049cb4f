"""Every refusal of a scenario, at its exact place; whatever is not refused flies again as it is."""

from __future__ import annotations

import copy
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scenario_files import GOOD, again_as_it_is, problems_of

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.shipped import data_root, files_in
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import dump as dump_tree
from testbed.inputs.yaml_source import parse
from testbed.scenario.load import load_scenario

# what is written instead of what, and the one problem that follows: line, path, part of the message
REFUSED = [
    ("seed: 1", "sed: 1", 6, "sed", "did you mean seed?"),
    ("gamma: 4.0", "gama: 4.0", 8, "controller.gama", "did you mean gamma?"),
    ("seed: 1", "seed: 1\nseed: 2", 7, "seed", "duplicate key"),
    ("epsilon: 0.05", "epsilon: 1e-3", 8, "controller.epsilon", "write 1.0e-3"),
    ("epsilon: 0.05", "epsilon: .nan", 8, "controller.epsilon", "not a finite number"),
    ("epsilon: 0.05", "epsilon: -1", 8, "controller.epsilon", "expected greater than 0"),
    ("epsilon: 0.05", "epsilon: [1]", 8, "controller.epsilon", "expected a number"),
    ("gamma: 4.0", "gamma: {servo: 4}", 8, "controller.gamma.motor", "is missing"),
    (
        "gamma: 4.0",
        "gamma: {servo: 4, motor: 4, moter: 4}",
        8,
        "controller.gamma.moter",
        "did you mean motor?",
    ),
    ("gamma: 4.0", "lambda_max: 0.01", 8, "controller.lambda_max", "not above lambda_min"),
    ("gamma: 4.0", "lambda_min: 0", 8, "controller.lambda_min", "newton integrates the logarithm"),
    ("gamma: 4.0", "threshold: 2", 8, "controller.threshold", "less than or equal to 1"),
    ("gamma: 4.0", "released: [r_dott]", 8, "controller.released.0", "did you mean r_dot?"),
    ("adaptive_inversion", "adaptive_invertion", 8, "controller.type", "did you mean adaptive_inversion?"),
    ("type: adaptive_inversion, ", "", 8, "controller.type", "is missing"),
    ("aircraft: vtail", "aircraft: vtial", 2, "aircraft", "did you mean vtail?"),
    ("aircraft: vtail", "aircraft: ./no-such-folder", 2, "aircraft", "there is no folder"),
    ("aircraft: vtail", "aircraft: 3", 2, "aircraft", "expected text"),
    ("duration_s: 60", "duration_s: -60", 3, "duration_s", "expected greater than 0"),
    ("duration_s: 60", "duration_s: sixty", 3, "duration_s", "expected a number"),
    ("duration_s: 60", "duration_s: '60'", 3, "duration_s", "expected a number"),
    ("duration_s: 60", "duration_s: yes", 3, "duration_s", "is true"),
    ("duration_s: 60", "duration_s: 60.001", 3, "duration_s", "whole number of control steps"),
    ("duration_s: 60", "duration_s: 1.0e+9", 3, "duration_s", "at most"),
    ("duration_s: 60", "duration_s: 1.0e+308", 3, "duration_s", "at most"),
    ("rate_hz: 200", "rate_hz: 1000000000", 4, "rate_hz", "less than or equal to 10000"),
    ("physics_hz: 400", "physics_hz: 200000000", 5, "physics_hz", "less than or equal to 10000"),
    (
        "at_s: 15, value",
        "at_s: 59.9999, value",
        15,
        "failures.1.at_s",
        "after the last control step, expected at most 59.995",
    ),
    (
        "{fcs/right-ruddervator/command-scale: 0.5}",
        "{simulation/do_simple_trim: 1}",
        16,
        "failures.2.set",
        "steers the simulation",
    ),
    (
        "{fcs/right-ruddervator/command-scale: 0.5}",
        "{propulsion/set-running: 1}",
        16,
        "failures.2.set",
        "steers the simulation",
    ),
    ("name: left tail failure", "name: " + "n" * 300, 1, "name", "expected at most 120 characters"),
    ("duration_s: 60", "duration_s:", 3, "duration_s", "is empty"),
    ("rate_hz: 200", "rate_hz: 0", 4, "rate_hz", "greater than 0"),
    ("physics_hz: 400", "physics_hz: 300", 5, "physics_hz", "such as 200 or 400"),
    ("physics_hz: 400", "physics_hz: 100", 5, "physics_hz", "such as 200 or 400"),
    ("physics_hz: 400", "log_hz: 300", 5, "log_hz", "does not divide"),
    ("seed: 1", "seed: -1", 6, "seed", "greater than or equal to 0"),
    ("seed: 1", "seed: 1.5", 6, "seed", "expected a whole number"),
    (
        "airspeed_m_s: 18, heading_deg: 90}\ncontroller",
        "airspeed_m_s: 0}\ncontroller",
        7,
        "initial.airspeed_m_s",
        "than 0",
    ),
    ("at_s: 40", "at_s: 60", 9, "commands", "less than duration_s 60"),
    ("at_s: 40", "at_s: 0", 9, "commands", "ascending"),
    ("at_s: 40", "at_s: -1", 11, "commands.1.at_s", "greater than or equal to 0"),
    ("heading_deg: 120", "heading_deg: 400", 11, "commands.1.heading_deg", "did you mean 40"),
    ("heading_deg: 120", "hading_deg: 12", 11, "commands.1.hading_deg", "did you mean heading_deg?"),
    ("heading_deg_s: 4", "heading_deg_s: 0", 12, "command_rates.heading_deg_s", "greater than 0"),
    ("type: property", "type: proprty", 16, "failures.2.type", "did you mean property?"),
    (
        "left_ruddervator, at_s: 5",
        "left_rudervator, at_s: 5",
        14,
        "failures.0.actuator",
        "did you mean left_ruddervator?",
    ),
    ("actuator: left_ruddervator, at_s: 5", "at_s: 5", 14, "failures.0.actuator", "is missing"),
    ("at_s: 5, value", "at_s: -5, value", 14, "failures.0.at_s", "greater than or equal to 0"),
    ("at_s: 5, value", "value", 14, "failures.0", "has no start"),
    (
        "at_s: 5, value",
        "at_s: 5, when: {signal: altitude_m, below: 9}, value",
        14,
        "failures.0",
        "two starts",
    ),
    ("at_s: 5, value", "when: {signal: altitude_m}, value", 14, "failures.0.when", "either above or below"),
    ("at_s: 15, value", "at_s: 60, value", 15, "failures.1.at_s", "less than duration_s 60"),
    ("at_s: 15, value", "at_s: 5, value", 15, "failures.1", "overlaps failures.0"),
    ("at_s: 5, value", "at_s: 5, until_s: 16, value", 15, "failures.1", "overlaps failures.0"),
    (
        "at_s: 15, value",
        "when: {signal: altitude_m, below: 9}, value",
        15,
        "failures.1",
        "overlaps failures.0",
    ),
    (
        "fcs/right-ruddervator/command-scale",
        "fcs/left-ruddervator/effectiveness",
        16,
        "failures.2",
        "overlaps",
    ),
    ("value: 0.2", "value: 1.6", 14, "failures.0.value", "less than or equal to 1.5"),
    ("value: 0.2", "vaule: 0.2, value: 0.2", 14, "failures.0.vaule", "did you mean value?"),
    ("until_s: 25", "until_s: 61", 16, "failures.2.until_s", "at most duration_s 60"),
    ("until_s: 25", "until_s: 20", 16, "failures.2.until_s", "not after at_s"),
    (
        "command-scale: 0.5",
        "command-scale: half",
        16,
        "failures.2.set.fcs/right-ruddervator/command-scale",
        "a number",
    ),
    ("{fcs/right-ruddervator/command-scale: 0.5}", "{}", 16, "failures.2.set", "at least 1"),
    ("sensors: ideal", "sensors: ideel", 17, "sensors", "did you mean ideal?"),
    ("wind_m_s: [0, 0, 0]", "wind_m_s: [0, 0]", 18, "atmosphere.wind_m_s.2", "is missing"),
    ("wind_m_s: [0, 0, 0]", "wind_m_s: 3", 18, "atmosphere.wind_m_s", "expected a list"),
    (
        "turbulence_w20_m_s: 0",
        "turbulence_w20_m_s: -1",
        18,
        "atmosphere.turbulence_w20_m_s",
        "greater than or equal",
    ),
    ("at_most: 5", "at_mots: 5, at_most: 5", 20, "requirements.0.at_mots", "did you mean at_most?"),
    (", at_most: 5", "", 20, "requirements.0", "has no limit"),
    ("metric: altitude_error_max_m, ", "", 20, "requirements.0", "has no subject"),
    (", of: heading_command_deg", "", 21, "requirements.1", "only one of within and of"),
    ("until_s: 50", "until_s: 1", 21, "requirements.1.until_s", "not after from_s"),
    ("until_s: 50", "until_s: 70", 21, "requirements.1.until_s", "at most duration_s 60"),
    ("of: heading_command_deg", "of: [1]", 21, "requirements.1.of", "number or the name of a signal"),
]


def test_the_unchanged_file_is_accepted(file: Path) -> None:
    """The negative control of all refusals below: nothing is wrong before something is made wrong."""
    scenario = load_scenario(file)
    assert (scenario.steps, scenario.physics_steps, scenario.slug) == (12000, 2, "left-tail-failure")


@pytest.mark.parametrize(("old", "new", "line", "path", "text"), REFUSED)
def test_refused_at_its_place(file: Path, old: str, new: str, line: int, path: str, text: str) -> None:
    assert GOOD.count(old) == 1
    file.write_text(GOOD.replace(old, new))
    (problem,) = problems_of(file)
    assert (problem.file, problem.line, problem.path) == (str(file), line, path)
    assert text in str(problem)


def test_all_problems_at_once_whatever_finds_them(file: Path) -> None:
    """YAML's own, the model's, and those that need the aircraft and the whole scenario."""
    text = GOOD.replace("seed: 1", "sed: 1").replace("epsilon: 0.05", "epsilon: 1e-3")
    text = text.replace("duration_s: 60", "duration_s: -1").replace("type: property", "type: proprty")
    text = text.replace("left_ruddervator, at_s: 15", "left_rudervator, at_s: 15")
    file.write_text(text.replace("at_s: 5, value: 0.2", "at_s: 5, value: 2"))
    assert [p.path for p in problems_of(file)] == [
        "duration_s",
        "sed",
        "controller.epsilon",
        "failures.0.value",
        "failures.1.actuator",
        "failures.2.type",
    ]


def test_missing_keys(tmp_path: Path) -> None:
    file = tmp_path / "x.yaml"
    file.write_text("seed: 1\n")
    assert [p.path for p in problems_of(file)] == ["name", "aircraft", "duration_s", "initial"]


@pytest.mark.parametrize(
    ("override", "path", "text"),
    [
        ("controller.gama=4", "controller.gama", "did you mean gamma?"),
        ("controller.gamma=1e-3", "controller.gamma", "write 1.0e-3"),
        ("failures.7.value=0.5", "failures", "an index from 0 to 2"),
        ("failures.0.value=2", "failures.0.value", "less than or equal to 1.5"),
        ("commands.1.heading_deg=-90", "commands.1.heading_deg", "did you mean 270?"),
        ("seed.x=2", "seed", "a mapping or a list"),
        ("seed", "", "KEY=VALUE"),
        ("seed=[1", "seed", "not YAML"),
        ("duration_s=.nan", "duration_s", "not a finite number"),
    ],
)
def test_overrides_are_refused_by_name(file: Path, override: str, path: str, text: str) -> None:
    (problem,) = problems_of(file, override)
    assert (problem.file, problem.line, problem.path) == (f"--set {override}", None, path)
    assert text in str(problem)


def test_overrides(file: Path) -> None:
    scenario = load_scenario(
        file,
        ["failures.0.value=0.5", "controller.gamma=2", "controller.model_error.Cm_alpha=1.2", "name=a = b"],
    )
    assert scenario.failures[0].properties(load_aircraft("vtail")) == {
        "fcs/left-ruddervator/effectiveness": 0.5
    }
    assert scenario.controller.model_dump()["gamma"] == {"servo": 2.0, "motor": 2.0}
    assert scenario.controller.model_error == {"Cm_alpha": 1.2}
    assert scenario.name == "a = b"
    assert load_scenario(file, ["failures=[]"]).failures == ()


def test_an_override_mends_the_file(file: Path) -> None:
    file.write_text(GOOD.replace("epsilon: 0.05", "epsilon: 1e-3"))
    assert load_scenario(file, ["controller.epsilon=0.1"])


def test_a_flight_made_shorter_has_no_later_commands(file: Path) -> None:
    """What is not flown is left out; a failure or a requirement after the end is still refused, and so is a command set anew."""
    scenario = load_scenario(file, ["duration_s=30", "requirements=[]"])
    assert [command.at_s for command in scenario.commands] == [0.0]
    short = ["duration_s=12", "requirements=[]"]
    assert {p.path.split(".")[0] for p in problems_of(file, *short)} == {"failures"}
    again = ["duration_s=30", "requirements=[]", "commands.1.at_s=35"]
    assert [p.path for p in problems_of(file, *again)] == ["commands"]


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_any_controller_can_be_put_into_any_file(file: Path, controller: str) -> None:
    assert load_scenario(file, [f"controller.type={controller}"]).controller.type == controller


def test_settings_of_another_controller_are_refused_in_a_file(file: Path) -> None:
    file.write_text(GOOD.replace("adaptive_inversion", "fixed_inversion"))
    assert [p.path for p in problems_of(file)] == ["controller.gamma", "controller.epsilon"]


def test_problems_of_an_aircraft_are_in_its_file(tmp_path: Path, file: Path) -> None:
    folder = tmp_path / "plane"
    folder.mkdir()
    text = (data_root() / "aircraft/vtail/vtail.yaml").read_text()
    (folder / "plane.yaml").write_text(
        text.replace("kind: servo", "kind: servoo", 1).replace("model: v", "modle: v")
    )
    file.write_text(GOOD.replace("aircraft: vtail", f"aircraft: {folder}"))
    problems = problems_of(file)
    assert {p.file for p in problems} == {str(folder / "plane.yaml")}
    assert {"actuators.left_ruddervator.kind", "modle", "model"} <= {p.path for p in problems}


@pytest.mark.parametrize("path", files_in("scenarios"), ids=lambda p: p.stem)
def test_shipped_scenarios_are_valid_and_fly_again(path: Path, tmp_path: Path) -> None:
    again_as_it_is(load_scenario(path), tmp_path)


junk = (
    st.none()
    | st.booleans()
    | st.integers(-9, 9)
    | st.sampled_from(["", "x", "vtail", [], {}, [1], {"a": 1}, -0.5, [{}]])
)


@st.composite
def spoiled_trees(draw: st.DrawFn) -> dict[str, object]:
    """The good scenario with some values replaced, removed, or under a mistyped key."""
    tree = parse(GOOD).tree
    for _ in range(draw(st.integers(1, 5))):
        node = tree
        while True:
            keys = list(node) if isinstance(node, dict) else list(range(len(node)))
            if not keys:
                break
            key = draw(st.sampled_from(keys))
            if isinstance(node[key], dict | list) and draw(st.booleans()):
                node = node[key]
                continue
            how = draw(st.sampled_from(["replace", "remove", "rename"]))
            value = node.pop(key)
            if how == "replace":
                value = copy.deepcopy(draw(junk))  # a later change must not reach into the junk itself
            if how == "remove":
                break
            if isinstance(node, list):
                node.insert(key, value)
            else:
                node[f"{key}x" if how == "rename" else key] = value
            break
    return tree  # type: ignore[no-any-return]


@pytest.mark.nightly
@settings(max_examples=400, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(spoiled_trees())
def test_any_spoiled_scenario_is_refused_in_words_or_flies(tmp_path: Path, tree: dict[str, object]) -> None:
    """Never another exception; every problem has a place, and no path is complained about twice."""
    file = tmp_path / "spoiled.yaml"
    file.write_text(dump_tree(tree), encoding="utf-8")
    try:
        scenario = load_scenario(file)
    except BadInput as error:
        paths = [p.path for p in error.problems]
        assert all(p.what and p.file == str(file) for p in error.problems)
        assert paths and len(set(paths)) == len(paths)
    else:
        again_as_it_is(scenario, tmp_path)


def test_a_problem_with_the_aircraft_is_the_only_one(tmp_path: Path) -> None:
    """Where the flight begins would follow from the aircraft; that it is missing is not a second mistake."""
    file = tmp_path / "x.yaml"
    file.write_text("{name: a, aircraft: {name: vtail, coefficients: {CL_alhpa: 1.1}}, duration_s: 1}")
    assert [p.path for p in problems_of(file)] == ["aircraft.coefficients.CL_alhpa"]
