"""Every failure type on every actuator that can have it: nothing before, acts, undone, and can prove it."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any, NamedTuple

import failures_catalogue
import numpy as np
import pytest
from command_line import ROOT

from testbed import simulation
from testbed.aircraft.description import Servo, load_aircraft
from testbed.aircraft.shipped import data_root, scenario_files
from testbed.cli.commands import main
from testbed.failures import TYPES
from testbed.flight.flight import Flight, Outcome
from testbed.flight.folder import load
from testbed.injection.injector import Injector
from testbed.injection.receipt import RECEIPT_STEPS
from testbed.inputs.problems import BadInput
from testbed.plant.jsbsim import Plant
from testbed.scenario.load import Scenario, dump, load_scenario
from testbed.simulation import Assembly, assemble, conclude, lockstep

AIRCRAFT = load_aircraft("vtail")
START_S, END_S = 0.5, 1.2
RATES = [(200, 200), (100, 400)]  # control and physics rate [Hz]; the second steps four times a control step
PROPERTY = {"type": "property", "set": {"fcs/left-ruddervator/command-scale": 0.5}}


def cases() -> list[tuple[str, str]]:
    """(type, actuator) of each failure that an actuator can have."""
    return [
        (name, actuator)
        for name, kind in TYPES.items()
        for actuator, what in AIRCRAFT.actuators.items()
        if name != "property" and what.kind in kind.kinds
    ]


def example(name: str, actuator: str) -> dict[str, Any]:
    """The failure that the type shows itself with, in the test's window."""
    kind = TYPES[name]
    fields = kind.examples[AIRCRAFT.actuators[actuator].kind]
    end = {"until_s": END_S} if kind.undone else {}
    return {"type": name, "actuator": actuator, "at_s": START_S, **end, **fields}


def scenario(*failures: dict[str, Any], rates: tuple[int, int] = RATES[0], **changes: Any) -> Scenario:
    """A short flight in which every actuator has something to do."""
    return Scenario.model_validate(
        {
            "name": "test",
            "aircraft": "vtail",
            "duration_s": 2.0,
            "rate_hz": rates[0],
            "physics_hz": rates[1],
            "initial": {"altitude_m": 300, "airspeed_m_s": 18, "heading_deg": 90},
            "commands": [{"at_s": 0.2, "heading_deg": 95, "altitude_m": 301}],
            "failures": list(failures),
            **changes,
        }
    )


class Flown(NamedTuple):
    flight: Flight
    parts: Assembly

    def column(self, name: str) -> np.ndarray:
        return self.flight.data[:, self.flight.columns.index(name)]

    def event(self, active: bool = True, failure: int = 0) -> dict[str, Any]:
        (event,) = (
            e
            for e in self.flight.events
            if e["kind"] == "injection" and e["active"] == active and e["failure"] == failure
        )
        return dict(event)


def fly(*failures: dict[str, Any], **changes: Any) -> Flown:
    parts = assemble(scenario(*failures, **changes))
    return Flown(conclude(parts, *lockstep(parts)), parts)


@pytest.fixture(scope="module")
def healthy() -> dict[tuple[int, int], Flown]:
    return {rates: fly(rates=rates) for rates in RATES}


@pytest.mark.parametrize("rates", RATES, ids=str)
@pytest.mark.parametrize(("name", "actuator"), cases())
def test_acts_in_its_window_only(
    healthy: dict[tuple[int, int], Flown], name: str, actuator: str, rates: tuple[int, int]
) -> None:
    well, broken = healthy[rates], fly(example(name, actuator), rates=rates)
    start = round(START_S * rates[0])
    assert broken.flight.end_time_s > END_S  # to keep flying after that is the controller's business
    assert np.array_equal(broken.flight.data[:start], well.flight.data[:start]), "differs before it starts"
    seen = [f"{actuator}_position", f"{actuator}_effectiveness"]
    until = round(END_S * rates[0])
    inside = [(broken.column(c)[start:until] != well.column(c)[start:until]).any() for c in seen]
    assert any(inside), "nothing happened"
    event = broken.event()
    assert (event["time_s"], event["verified"]) == (START_S, True)
    assert 1 <= event["effect"]["after_steps"] <= RECEIPT_STEPS
    assert broken.flight.warnings == []


@pytest.mark.parametrize(("name", "actuator"), [c for c in cases() if TYPES[c[0]].undone])
def test_is_undone(healthy: dict[tuple[int, int], Flown], name: str, actuator: str) -> None:
    well, broken = healthy[RATES[0]].parts.plant, fly(example(name, actuator))
    assert broken.flight.outcome is Outcome.completed
    event, plant = broken.event(active=False), broken.parts.plant
    assert (event["time_s"], event["verified"]) == (END_S, True)
    for held in event["properties"]:
        if not held.endswith(("command-rad", "command-norm")):  # the controller's
            assert plant[held] == well[held], held
    assert_obeys(broken, actuator)


def assert_obeys(flown: Flown, actuator: str) -> None:
    """After the flight, the actuator goes where its last command says, within its stops, and all of it acts."""
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


@pytest.mark.parametrize(("name", "actuator"), [c for c in cases() if not TYPES[c[0]].undone])
def test_what_has_fallen_off_does_not_come_back(name: str, actuator: str) -> None:
    with pytest.raises(ValueError, match="cannot be undone"):
        scenario({**example(name, actuator), "until_s": END_S})
    assert fly(example(name, actuator)).column(f"{actuator}_effectiveness")[-1] == 0.0


def neutral_cases() -> list[tuple[str, str]]:
    return [(n, a) for n, a in cases() if TYPES[n].neutral(AIRCRAFT.actuators[a]) is not None]


@pytest.mark.parametrize(("name", "actuator"), neutral_cases())
def test_what_changes_nothing_leaves_the_flight_bit_identical(
    healthy: dict[tuple[int, int], Flown], name: str, actuator: str
) -> None:
    fields = TYPES[name].neutral(AIRCRAFT.actuators[actuator])
    assert fields is not None
    same = fly({"type": name, "actuator": actuator, "at_s": START_S, "until_s": END_S, **fields})
    assert np.array_equal(same.flight.data, healthy[RATES[0]].flight.data)
    assert same.event()["verified"] is None
    assert "no observable effect" in same.flight.warnings[0]


def test_most_types_have_a_neutral_value() -> None:
    """So that the test above cannot become empty by accident."""
    without = {"stuck", "stuck_at", "hardover", "float", "reversal", "runaway"}
    assert {n for n, _ in cases()} - {n for n, _ in neutral_cases()} == without | {
        "prop_loss",
        "motor_stop",
        "surface_lost",
    }


@pytest.mark.parametrize(("name", "actuator"), cases())
def test_yaml_round_trip(tmp_path: Path, name: str, actuator: str) -> None:
    once = scenario(example(name, actuator))
    (tmp_path / "scenario.yaml").write_text(dump(once))
    assert load_scenario(tmp_path / "scenario.yaml") == once


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
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}: {flow(v)}" for k, v in value.items()) + "}"
    return str(value).lower() if isinstance(value, bool) else str(value)


def without(failure: dict[str, Any], key: str) -> dict[str, Any]:
    return {k: v for k, v in failure.items() if k != key}


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
    for field, info in TYPES[name].model_fields.items():
        if info.is_required() and field != "actuator":
            assert problem_of(tmp_path, without(good, field))[:2] == (8, f"{here}.{field}")


@pytest.mark.parametrize("name", sorted({n for n, _ in cases() if len(TYPES[n].kinds) == 1}))
def test_wrong_kind_of_actuator(tmp_path: Path, name: str) -> None:
    right = TYPES[name].kinds[0]
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
    ("intermittent", "left_propeller", {"value": 2}, "value", "less than or equal to 1"),
    ("decay", "left_propeller", {"shape": "exponentail"}, "shape", "did you mean exponential?"),
    ("motor_stop", "left_propeller", {"braked": 1}, "braked", "boolean"),
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


def test_overlaps_are_refused_on_one_property_only(tmp_path: Path) -> None:
    one, other = example("effectiveness", "left_ruddervator"), example("decay", "left_ruddervator")
    line, path, message = problem_of(tmp_path, one, other)
    assert (line, path) == (9, "failures.1") and "overlaps failures.0" in message
    both = fly(one, example("bias", "left_ruddervator"), example("effectiveness", "right_ruddervator"))
    assert [both.event(failure=i)["verified"] for i in range(3)] == [True] * 3


# Injection -----------------------------------------------------------------------------------------


def test_property_by_name(healthy: dict[tuple[int, int], Flown]) -> None:
    """The same as the type that holds that property, receipt and all."""
    by_name = fly({**PROPERTY, "at_s": START_S, "until_s": END_S})
    by_type = fly(example("command_scale", "left_ruddervator"))
    assert np.array_equal(by_name.flight.data, by_type.flight.data)
    assert by_name.event()["effect"] == by_type.event()["effect"]


def test_a_property_outside_all_actuators_is_verified_by_reading_it_back() -> None:
    flown = fly({"type": "property", "at_s": START_S, "set": {"atmosphere/wind-north-fps": 3.0}})
    assert (flown.event()["verified"], flown.event()["effect"]) == (True, None)


def test_an_overwritten_property_is_not_verified() -> None:
    """Negative control: the model computes this one anew in every step."""
    flown = fly({"type": "property", "at_s": START_S, "set": {"fcs/left-ruddervator/servo-rad": 0.1}})
    assert flown.event()["verified"] is False
    assert "did NOT take effect" in flown.flight.summary["warnings"][0]


def test_an_unconnected_property_is_not_verified(tmp_path: Path) -> None:
    """Negative control: an aircraft that declares the properties and forgets to use them."""
    folder = tmp_path / "aircraft" / "vtail"
    shutil.copytree(data_root() / "aircraft" / "vtail", folder)
    model = folder / "vtail.xml"
    text = model.read_text()
    used = "<product><property>fcs/left-ruddervator/effectiveness</property>"
    assert text.count(used) == 1
    model.write_text(text.replace(used, "<product><value>1</value>"))
    flown = fly(example("effectiveness", "left_ruddervator"), aircraft=str(folder))
    event = flown.event()
    assert event["verified"] is False
    assert event["effect"]["observed"] == pytest.approx(event["effect"]["healthy"])
    assert str(RECEIPT_STEPS) in flown.flight.warnings[0]


def test_when_a_signal_crosses(healthy: dict[tuple[int, int], Flown]) -> None:
    well = healthy[RATES[0]]
    limit = 91.0
    row = int(np.argmax(well.column("heading_deg") > limit))
    assert 0 < row < len(well.flight.data) - 2
    when = {"signal": "heading_deg", "above": limit}
    flown = fly({"type": "stuck", "actuator": "left_propeller", "when": when})
    assert flown.event()["time_s"] == (row + 1) / RATES[0][0], "the step after the row that shows it"
    assert np.array_equal(flown.flight.data[: row + 1], well.flight.data[: row + 1])
    assert flown.event()["verified"] is True


def test_a_trigger_that_never_comes_says_so(healthy: dict[tuple[int, int], Flown]) -> None:
    when = {"signal": "altitude_m", "below": 200}
    flown = fly({"type": "stuck", "actuator": "left_propeller", "when": when})
    assert np.array_equal(flown.flight.data, healthy[RATES[0]].flight.data)
    assert flown.flight.warnings == [
        "failures.0 (stuck, left_propeller) never started: altitude_m below 200 did not happen"
    ]


def test_the_later_of_one_type_takes_over() -> None:
    at = {"type": "intermittent", "actuator": "left_propeller", "off_s": 0.05, "on_s": 0.05}
    flown = fly({**at, "at_s": 0.4, "value": 0.5}, {**at, "at_s": 0.8, "value": 0.25})
    effectiveness = flown.column("left_propeller_effectiveness")
    assert set(effectiveness[80:160]) == {0.5, 1.0}
    assert set(effectiveness[160:]) == {0.25, 1.0}


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_windows_may_touch_in_either_order(order: tuple[int, int]) -> None:
    base = {"type": "effectiveness", "actuator": "left_ruddervator"}
    both = [
        {**base, "at_s": 0.5, "until_s": 1.0, "value": 0.5},
        {**base, "at_s": 1.0, "until_s": 1.5, "value": 0.2},
    ]
    effectiveness = fly(*[both[i] for i in order]).column("left_ruddervator_effectiveness")
    assert [effectiveness[k] for k in (99, 100, 199, 200, 299, 300)] == [1.0, 0.5, 0.5, 0.2, 0.2, 1.0]


def test_chance_is_the_runs_own() -> None:
    failure = example("intermittent", "left_propeller")
    one, again, other = fly(failure), fly(failure), fly(failure, seed=2)
    assert np.array_equal(one.flight.data, again.flight.data)
    assert not np.array_equal(one.flight.data, other.flight.data)


# What each type does, in numbers -------------------------------------------------------------------

WINDOW = slice(100, 240)
T = np.arange(0, 140) / 200.0


def servo(name: str, **fields: Any) -> tuple[Flown, np.ndarray]:
    flown = fly({**example(name, "left_ruddervator"), **fields})
    return flown, flown.column("left_ruddervator_position")


def test_stuck_does_not_move() -> None:
    assert len(set(servo("stuck")[1][WINDOW])) == 1


def test_hardover_reaches_the_stop_at_the_servos_rate() -> None:
    position = servo("hardover", to="min")[1]
    assert position[239] == pytest.approx(-25.8, abs=1e-4)
    assert np.max(np.abs(np.diff(position[101:240]))) <= 401.07 / 200 * 1.0001


def test_runaway_ramps() -> None:
    position = servo("runaway", rate=10.0)[1][WINDOW]
    assert np.diff(position)[60:].mean() == pytest.approx(10.0 / 200, rel=1e-3)


def test_rate_limit() -> None:
    position = servo("rate_limit", value=2.0)[1][WINDOW]
    assert np.max(np.abs(np.diff(position))) == pytest.approx(2.0 / 200, rel=1e-6)


def test_position_limit() -> None:
    position = servo("position_limit", low=-1.0, high=1.0)[1][101:240]
    assert np.max(np.abs(position)) == pytest.approx(1.0, abs=1e-9)


def test_delay_by_whole_steps() -> None:
    """Two steps late from step 3 to step 8; the last command before is held until the first late one arrives."""
    plant, actuator = Plant(AIRCRAFT, 100), {"actuator": "left_propeller", "at_s": 0.03, "until_s": 0.08}
    failure = TYPES["delay"].model_validate({"type": "delay", **actuator, "delay_s": 0.02})
    injector = Injector(plant, AIRCRAFT, [failure], 100)
    arrived = []
    for k in range(10):
        if k >= injector.next_step:
            injector.apply(k)
        plant.command([0.0, 0.0, k / 10, 0.0])
        for delay in injector.filters:
            delay()
        plant.settle(1)
        arrived.append(round(10 * plant["fcs/throttle-pos-norm"]))
    assert arrived == [0, 1, 2, 2, 2, 3, 4, 5, 8, 9]
    assert [failure.delay_steps(rate) for rate in (200, 100, 10)] == [4, 2, 0]


def test_decay_in_numbers() -> None:
    linear = servo("decay", value=0.2, over_s=0.5)[0].column("left_ruddervator_effectiveness")[WINDOW]
    assert linear == pytest.approx(np.maximum(1.0 - 0.8 * T / 0.5, 0.2))
    slow = servo("decay", value=0.2, over_s=0.5, shape="exponential")[0]
    exponential = slow.column("left_ruddervator_effectiveness")[WINDOW]
    assert exponential == pytest.approx(0.2 + 0.8 * np.exp(-T / 0.5))


def test_intermittent_spells_have_their_means() -> None:
    failure = TYPES["intermittent"].model_validate(
        {"type": "intermittent", "actuator": "left_propeller", "at_s": 0, "off_s": 0.2, "on_s": 0.6}
    )
    course = failure.course(AIRCRAFT, np.random.default_rng(1))
    assert course is not None
    broken = [course[1](t, 0.0) == 0.0 for t in np.arange(0.0, 2000.0, 0.01)]
    assert np.mean(broken) == pytest.approx(0.25, abs=0.02)  # 2500 cycles: standard error 0.005
    assert np.sum(np.diff(broken)) / 2 == pytest.approx(2500, rel=0.08)


def test_float_trails_and_reversal_reverses() -> None:
    flown, position = servo("float")
    gain = flown.parts.plant["fcs/left-ruddervator/float-gain"]
    assert np.std(position[WINDOW]) > 0 and 0 < gain <= 1
    plant = servo("reversal", at_s=1.0, until_s=2.0)[0].parts.plant
    assert plant["fcs/left-ruddervator/demand-rad"] == -plant["fcs/left-ruddervator/command-rad"]


def test_surface_lost_takes_mass_and_centre_of_gravity_along() -> None:
    well, lost = fly().parts.plant, servo("surface_lost")[0].parts.plant
    gone = well["inertia/pointmass-weight-lbs"]
    assert gone > 0
    assert well["inertia/weight-lbs"] - lost["inertia/weight-lbs"] == pytest.approx(gone)
    assert lost["inertia/cg-x-in"] < well["inertia/cg-x-in"]  # the tail is behind
    assert lost["inertia/cg-y-in"] > well["inertia/cg-y-in"]  # and the lost surface was on the left
    assert lost["inertia/iyy-slugs_ft2"] < well["inertia/iyy-slugs_ft2"]


def test_motor_stop_windmills_and_brakes() -> None:
    well, free = fly(), fly(without(example("motor_stop", "left_propeller"), "until_s"))
    stopped = fly({**without(example("motor_stop", "left_propeller"), "until_s"), "braked": True})
    speeds = [f.parts.plant["propulsion/engine/propeller-rpm"] for f in (well, free, stopped)]
    assert speeds[0] > speeds[1] > speeds[2]
    assert free.parts.plant["propulsion/engine/current-amperes"] == pytest.approx(0.0, abs=0.6)
    assert free.column("left_propeller_position")[-1] < 0.5 * well.column("left_propeller_position")[-1]


def test_prop_loss_motor_still_tracks() -> None:
    flown = fly(example("prop_loss", "left_propeller"))
    plant = flown.parts.plant
    assert plant["fcs/throttle-pos-norm"] == pytest.approx(
        min(max(plant["fcs/left-propeller/command-norm"], 0), 1)
    )
    assert plant["propulsion/engine/thrust-lbs"] + plant["fcs/left-propeller/lost-thrust-lbs"] == 0.0


# Catalogue and shipped scenarios ---------------------------------------------------------------------


def test_the_catalogue_is_of_this_code(tmp_path: Path) -> None:
    assert failures_catalogue.stale(ROOT / "docs" / "reference") == []  # not part of an installed package
    assert len(failures_catalogue.stale(tmp_path)) == 1 + len(TYPES)  # negative control: nothing is there


def test_the_command_line_is_loud(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "scenario.yaml"
    file.write_text(dump(scenario({**example("effectiveness", "left_ruddervator"), "value": 1.0})))
    main(["run", str(file), "--out", str(tmp_path / "run"), "--no-plots"])
    warning = "failures.0 (effectiveness, left_ruddervator) at 0.5 s had no observable effect"
    assert f"WARNING: {warning}" in capfd.readouterr().err
    assert warning in load(tmp_path / "run").warnings[0]


def shipped() -> list[Path]:
    """Scenarios with failures, but not the paper's, which have tests of their own."""
    return [
        file for file in scenario_files() if "failures:" in file.read_text() and "_fail.yaml" not in file.name
    ]


def test_a_family_of_failures_is_shipped_for_each_type() -> None:
    flown = {failure.type for file in scenario_files() for failure in load_scenario(file).failures}
    assert set(TYPES) - flown == {"command_scale", "hardover", "bias", "position_limit"}


@pytest.mark.parametrize("file", shipped(), ids=lambda file: file.stem)
def test_shipped_scenarios_are_flown_to_their_requirements(file: Path) -> None:
    flight = simulation.fly(file)
    assert [r["name"] for r in flight.requirements if not r["passed"]] == []
    assert flight.passed and flight.warnings == []
