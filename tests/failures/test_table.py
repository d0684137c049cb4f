"""Every type of failure on every actuator that can have it: acts in its window only, is undone, is refused if wrong."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from broken_flights import (
    AIRCRAFT,
    END_S,
    RATES,
    START_S,
    Flown,
    cases,
    example,
    fly,
    healthy,
    scenario,
    without,
)

from testbed import simulation
from testbed.aircraft.description import Servo
from testbed.aircraft.shipped import files_in
from testbed.failures import TABLE
from testbed.flight.flight import Outcome
from testbed.injection.receipt import RECEIPT_STEPS
from testbed.inputs.problems import BadInput
from testbed.scenario.load import dump, load_scenario
from testbed.simulation import assemble


@pytest.mark.parametrize("rates", RATES, ids=str)
@pytest.mark.parametrize(("name", "actuator"), cases())
def test_acts_in_its_window_only(name: str, actuator: str, rates: tuple[int, int]) -> None:
    well, broken = healthy(rates), fly(example(name, actuator), rates=rates)
    start = round(START_S * rates[0])
    assert broken.flight.end_time_s > END_S  # to keep flying after that is the controller's business
    assert np.array_equal(broken.flight.data[:start], well.flight.data[:start], equal_nan=True), (
        "differs before it starts"
    )
    seen = [f"{actuator}_position", f"{actuator}_effectiveness"]
    until = round(END_S * rates[0])
    inside = [(broken.column(c)[start:until] != well.column(c)[start:until]).any() for c in seen]
    assert any(inside), "nothing happened"
    event = broken.event()
    assert (event["time_s"], event["verified"]) == (START_S, True)
    assert 1 <= event["effect"]["after_steps"] <= RECEIPT_STEPS
    assert broken.flight.warnings == []


@pytest.mark.parametrize(("name", "actuator"), [c for c in cases() if TABLE[c[0]].undone])
def test_is_undone(name: str, actuator: str) -> None:
    well, broken = healthy().parts.plant, fly(example(name, actuator))
    assert broken.flight.outcome is Outcome.completed
    event, plant = broken.event(active=False), broken.parts.plant
    assert (event["time_s"], event["verified"]) == (END_S, True)
    for held in event["properties"]:
        if not held.endswith(("command-rad", "command-norm")):  # the controller's
            assert plant[held] == well[held], held
    assert_obeys(broken, actuator)


def assert_obeys(flown: Flown, actuator: str) -> None:
    """After the flight the actuator goes where its last command says, within its stops, and with its whole force."""
    plant, what = flown.parts.plant, AIRCRAFT.actuators[actuator]
    plant.settle(200)
    if isinstance(what, Servo):
        low, high = (f"{what.prefix}/servo-{end}-rad" for end in ("min", "max"))
        assert plant[f"{what.prefix}/demand-rad"] == plant[f"{what.prefix}/command-rad"]
        goal = min(max(plant[f"{what.prefix}/command-rad"], plant[low]), plant[high])
        assert plant[f"{what.prefix}/effective-rad"] == pytest.approx(goal, abs=1e-6)
    else:
        command = plant[f"{what.prefix}/command-norm"]
        assert plant[f"fcs/throttle-pos-norm[{what.engine}]"] == min(max(command, 0.0), 1.0)
        assert plant[f"{what.prefix}/lost-thrust-lbs"] == 0.0


@pytest.mark.parametrize(("name", "actuator"), [c for c in cases() if not TABLE[c[0]].undone])
def test_what_has_fallen_off_does_not_come_back(name: str, actuator: str) -> None:
    with pytest.raises(ValueError, match="cannot be undone"):
        scenario({**example(name, actuator), "until_s": END_S})
    assert fly(example(name, actuator)).column(f"{actuator}_effectiveness")[-1] == 0.0


def neutral_cases() -> list[tuple[str, str]]:
    """The cases that have fields with which nothing changes."""
    return [(n, a) for n, a in cases() if TABLE[n].neutral(AIRCRAFT.actuators[a]) is not None]


@pytest.mark.parametrize(("name", "actuator"), neutral_cases())
def test_what_changes_nothing_leaves_the_flight_bit_identical(name: str, actuator: str) -> None:
    fields = TABLE[name].neutral(AIRCRAFT.actuators[actuator])
    assert fields is not None
    same = fly({"type": name, "actuator": actuator, "at_s": START_S, "until_s": END_S, **fields})
    assert np.array_equal(same.flight.data, healthy().flight.data, equal_nan=True)
    assert same.event()["verified"] is None
    assert "no observable effect" in same.flight.warnings[0]


def test_most_types_have_a_neutral_value() -> None:
    """So that the test above cannot become empty by accident."""
    held = {"stuck", "stuck_at", "hardover", "float", "reversal", "runaway"}
    gone = {"prop_loss", "motor_stop", "surface_lost"}
    assert {n for n, _ in cases()} - {n for n, _ in neutral_cases()} == held | gone


@pytest.mark.parametrize(("name", "actuator"), cases())
def test_yaml_round_trip(tmp_path: Path, name: str, actuator: str) -> None:
    once = scenario(example(name, actuator))
    (tmp_path / "scenario.yaml").write_text(dump(once))
    assert load_scenario(tmp_path / "scenario.yaml") == once


@pytest.mark.parametrize(("name", "actuator"), cases())
def test_a_type_says_whether_its_course_is_random(name: str, actuator: str) -> None:
    """By the random numbers that making the course draws."""
    failure = TABLE[name].model_validate(example(name, actuator))
    stream, untouched = np.random.default_rng(1), np.random.default_rng(1)
    failure.course(AIRCRAFT, stream)
    drew = stream.bit_generator.state != untouched.bit_generator.state
    assert drew == TABLE[name].draws


# Refusals ------------------------------------------------------------------------------------------


def problem_of(tmp_path: Path, *failures: dict[str, Any]) -> tuple[int | None, str, str]:
    """Line, path and text of the one problem with these failures; the first is on line 8, others follow."""
    good = scenario()
    head = f"name: test\naircraft: vtail\nduration_s: 2\nrate_hz: {good.rate_hz}\nseed: 1\n"
    lines = [f"  - {flow(failure)}" for failure in failures]
    file = tmp_path / "scenario.yaml"
    file.write_text(head + "log_hz: 100\nfailures:\n" + "\n".join(lines) + "\n")
    with pytest.raises(BadInput) as caught:
        assemble(load_scenario(file))
    (problem,) = caught.value.problems
    assert problem.file == str(file)
    return problem.line, problem.path, str(problem)


def flow(value: Any) -> str:
    """A value as YAML in one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}: {flow(v)}" for k, v in value.items()) + "}"
    return str(value).lower() if isinstance(value, bool) else str(value)


@pytest.mark.parametrize(("name", "actuator"), cases())
def test_each_wrong_field_is_refused_at_its_place(tmp_path: Path, name: str, actuator: str) -> None:
    good = example(name, actuator)
    here = "failures.0"
    assert problem_of(tmp_path, {**good, "actutor": 1})[:2] == (8, f"{here}.actutor")
    assert problem_of(tmp_path, without(good, "actuator"))[:2] == (8, f"{here}.actuator")
    line, path, text = problem_of(tmp_path, {**good, "actuator": actuator[:-1]})
    assert (line, path) == (8, f"{here}.actuator") and f"did you mean {actuator}?" in text
    for key, value in good.items():
        if isinstance(value, int | float):
            assert problem_of(tmp_path, {**good, key: "ten"})[:2] == (8, f"{here}.{key}")
    for field, info in TABLE[name].model_fields.items():
        if info.is_required() and field != "actuator":
            assert problem_of(tmp_path, without(good, field))[:2] == (8, f"{here}.{field}")


@pytest.mark.parametrize("name", sorted({n for n, _ in cases() if len(TABLE[n].kinds) == 1}))
def test_wrong_kind_of_actuator(tmp_path: Path, name: str) -> None:
    right = TABLE[name].kinds[0]
    wrong = next(a for a, what in AIRCRAFT.actuators.items() if what.kind != right)
    named = next(a for n, a in cases() if n == name)
    line, path, text = problem_of(tmp_path, {**example(name, named), "actuator": wrong})
    assert (line, path) == (8, "failures.0.actuator") and f"a {right}" in text


OUT_OF_RANGE = [
    ("effectiveness", "left_propeller", {"value": 1.6}, "value", "less than or equal to 1.5"),
    ("command_scale", "left_propeller", {"value": -0.1}, "value", "greater than or equal to 0"),
    ("stuck_at", "left_ruddervator", {"value": 26}, "value", "-25.8 to 25.8"),
    ("stuck_at", "left_propeller", {"value": 8}, "value", "throttle is outside"),
    ("hardover", "left_ruddervator", {"to": "up"}, "to", "one of max, min"),
    ("float", "left_ruddervator", {"gain": 2}, "gain", "less than or equal to 1"),
    ("bias", "left_ruddervator", {"value": -60}, "value", "-51.6 to 51.6"),
    ("position_limit", "left_ruddervator", {"low": -30}, "low", "-25.8 to 25.8"),
    ("position_limit", "left_ruddervator", {"low": 5, "high": -5}, "", "leaves no travel"),
    ("rate_limit", "left_ruddervator", {"value": 500}, "value", "deg/s is outside"),
    ("rate_limit", "left_ruddervator", {"value": 0}, "value", "greater than 0"),
    ("lag", "left_ruddervator", {"lag_rad_s": 31}, "lag_rad_s", "at most 30"),
    ("delay", "left_ruddervator", {"delay_s": 0.002}, "delay_s", "0 or at least 0.0025"),
    ("delay", "left_ruddervator", {"delay_s": 50}, "delay_s", "less than or equal to 5"),
    ("oscillation", "left_ruddervator", {"frequency_hz": 60}, "frequency_hz", "a quarter of rate_hz, 50"),
    ("oscillation", "left_propeller", {"amplitude": 4}, "amplitude", "0 to 1"),
    ("runaway", "left_ruddervator", {"rate": -5}, "rate", "greater than 0"),
    ("runaway", "left_ruddervator", {"rate": 600}, "rate", "deg/s is outside"),
    ("intermittent", "left_propeller", {"off_s": 0.004}, "off_s", "shorter than a control step"),
    ("intermittent", "left_propeller", {"on_s": 0.001}, "on_s", "shorter than a control step"),
    ("intermittent", "left_propeller", {"value": 2}, "value", "less than or equal to 1"),
    ("decay", "left_propeller", {"shape": "exponentail"}, "shape", "did you mean exponential?"),
    ("motor_stop", "left_propeller", {"braked": 1}, "braked", "true or false"),
    ("surface_lost", "left_ruddervator", {"until_s": 1.0}, "until_s", "cannot be undone"),
]


@pytest.mark.parametrize(("name", "actuator", "fields", "field", "text"), OUT_OF_RANGE)
def test_values_out_of_range(
    tmp_path: Path, name: str, actuator: str, fields: dict[str, Any], field: str, text: str
) -> None:
    line, path, message = problem_of(tmp_path, {**example(name, actuator), **fields})
    assert (line, path) == (8, f"failures.0.{field}".rstrip("."))
    assert text in message


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("fcs/left-ruddervator/effectivness", "did you mean fcs/left-ruddervator/effectiveness?"),
        ("fcs/left-propeller/lost-thrust-lbs", "read-only"),
    ],
)
def test_a_property_must_exist_and_be_writable(tmp_path: Path, name: str, text: str) -> None:
    line, path, message = problem_of(tmp_path, {"type": "property", "at_s": 1, "set": {name: 0.5}})
    assert (line, path) == (8, f"failures.0.set.{name}") and text in message


def test_an_unknown_signal_is_refused(tmp_path: Path) -> None:
    when = {"signal": "altitude", "below": 100}
    failure = {"type": "stuck", "actuator": "left_ruddervator", "when": when}
    line, path, message = problem_of(tmp_path, failure)
    assert (line, path) == (8, "failures.0.when.signal") and "did you mean altitude_m?" in message


def test_an_overlap_is_refused_at_the_later_of_the_two(tmp_path: Path) -> None:
    one, other = example("effectiveness", "left_ruddervator"), example("decay", "left_ruddervator")
    line, path, message = problem_of(tmp_path, one, other)
    assert (line, path) == (9, "failures.1") and "overlaps failures.0" in message


# Shipped scenarios ---------------------------------------------------------------------------------


def shipped() -> list[Path]:
    """Scenarios with failures, but not the paper's, which have tests of their own."""
    return [
        file
        for file in files_in("scenarios")
        if "failures:" in file.read_text() and "_fail.yaml" not in file.name
    ]


def test_a_family_of_failures_is_shipped_for_each_type() -> None:
    flown = {failure.type for file in files_in("scenarios") for failure in load_scenario(file).failures}
    assert set(TABLE) - flown == {"command_scale", "hardover", "bias", "position_limit"}


@pytest.mark.parametrize("file", shipped(), ids=lambda file: file.stem)
def test_shipped_scenarios_are_flown_to_their_requirements(file: Path) -> None:
    flight = simulation.fly(file)
    assert [r["name"] for r in flight.requirements if not r["passed"]] == []
    assert flight.passed and flight.warnings == []
