"""What must hold between a scenario and its aircraft, and names that mean nothing in a flight."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from scenario_files import GOOD, problems_of

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.shipped import data_root
from testbed.inputs.problems import BadInput, Problem
from testbed.scenario.consistency import unknown_names
from testbed.scenario.load import load_scenario

TEXT = """\
name: names
aircraft: vtail
duration_s: 60
failures:
  - {type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0.2}
  - {type: property, at_s: 20, set: {fcs/right-ruddervator/command-scale: 0.5}}
  - {type: effectiveness, actuator: left_propeller, when: {signal: altitude_m, below: 290}, value: 0}
requirements:
  - {metric: altitude_error_max_m, at_most: 5}
  - {signal: heading_deg, from_s: 2, within: 2, of: heading_command_deg}
"""
SIGNALS = ["altitude_m", "heading_deg", "heading_command_deg"]
METRICS = ["altitude_error_max_m"]
PROPERTIES = {
    "fcs/left-ruddervator/effectiveness": True,
    "fcs/right-ruddervator/command-scale": True,
    "fcs/left-propeller/effectiveness": True,
}


def found(tmp_path: Path, text: str, *known: object) -> list[Problem]:
    file = tmp_path / "names.yaml"
    file.write_text(text)
    signals, metrics, properties = [*known, *(SIGNALS, METRICS, PROPERTIES)[len(known) :]]
    scenario = load_scenario(file)
    return unknown_names(scenario, load_aircraft(scenario.aircraft), signals, metrics, properties, signals)


def test_known_names_are_accepted(tmp_path: Path) -> None:
    assert found(tmp_path, TEXT) == []


def test_unknown_signals_and_metrics(tmp_path: Path) -> None:
    problems = found(tmp_path, TEXT, ["heading_rad"], ["altitude_error_m"])
    assert [(p.line, p.path) for p in problems] == [
        (7, "failures.2.when.signal"),
        (9, "requirements.0.metric"),
        (10, "requirements.1.signal"),
        (10, "requirements.1.of"),
    ]
    assert problems[1].suggestion == "altitude_error_m"


def test_a_property_that_cannot_be_written(tmp_path: Path) -> None:
    readonly = {**PROPERTIES, "fcs/right-ruddervator/command-scale": False}
    (problem,) = found(tmp_path, TEXT, SIGNALS, METRICS, readonly)
    assert (problem.line, problem.path) == (6, "failures.1.set.fcs/right-ruddervator/command-scale")
    assert "read-only" in problem.what


def test_a_property_that_the_model_does_not_have(tmp_path: Path) -> None:
    (problem,) = found(tmp_path, TEXT.replace("command-scale", "comand-scale"))
    assert (problem.line, problem.suggestion) == (6, "fcs/right-ruddervator/command-scale")
    assert "unknown property" in problem.what


def test_a_failure_of_an_actuator_without_its_property_is_the_failure_itself(tmp_path: Path) -> None:
    """Nobody wrote that property: the place is the failure."""
    less = {name: can for name, can in PROPERTIES.items() if "left-ruddervator" not in name}
    (problem,) = found(tmp_path, TEXT, SIGNALS, METRICS, less)
    assert (problem.line, problem.path) == (5, "failures.0")


def test_without_failures_no_property_is_looked_for(tmp_path: Path) -> None:
    healthy = TEXT[: TEXT.index("failures:")] + TEXT[TEXT.index("requirements:") :]
    assert found(tmp_path, healthy, SIGNALS, METRICS, {}) == []


def test_noise_to_the_end_of_an_endless_flight_is_refused(file: Path) -> None:
    noise = "atmosphere={model: dryden_8785c, turbulence_w20_m_s: 5, noise: {w: [1]}}"
    found = problems_of(file, "duration_s=1e300", noise)
    assert "atmosphere.noise.until_s" in [problem.path for problem in found]


def test_envelope_is_the_aircrafts(file: Path, tmp_path: Path) -> None:
    folder = tmp_path / "plane"
    folder.mkdir()
    text = (data_root() / "aircraft/vtail/vtail.yaml").read_text()
    limits = "{airspeed_min_m_s: 20, altitude_min_m: 400, airspeed_max_m_s: 40}"
    text, replaced = re.subn(r"^envelope: .*$", f"envelope: {limits}", text, flags=re.MULTILINE)
    assert replaced == 1
    (folder / "plane.yaml").write_text(text)
    file.write_text(GOOD.replace("aircraft: vtail", "aircraft: ./plane"))
    problems = problems_of(file)
    assert [(p.line, p.path, p.expected) for p in problems] == [
        (7, "initial.airspeed_m_s", "at least 20"),
        (7, "initial.altitude_m", "at least 400"),
    ]
    scenario = load_scenario(file, ["initial.altitude_m=500", "initial.airspeed_m_s=30"])
    assert scenario.aircraft == str(folder), "a relative folder would be lost in the run folder"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("Cm_alfa", "did you mean Cm_alpha?"),
        ("Cm_left_rudervator", "did you mean Cm_left_ruddervator?"),
        ("x", "such as Cl_alpha"),
    ],
)
def test_unknown_coefficients(name: str, words: str) -> None:
    with pytest.raises(BadInput) as caught:
        load_scenario("scenarios/left_tail_fail.yaml", [f"controller.model_error={{{name}: 1.2}}"])
    assert f"controller.model_error.{name}: unknown coefficient" in str(caught.value)
    assert words in str(caught.value)
