"""A flight in the hand: whatever is done to it, the scenario that it saves flies to the same bytes."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from broken_flights import AIRCRAFT, scenario

import testbed
from testbed import BadInput, Session
from testbed.failures import TABLE
from testbed.flight.flight import Flight, Outcome
from testbed.inputs import yaml_source
from testbed.scenario.load import Scenario, dump, scenario_from
from testbed.sensors.channels import unit_of
from testbed.sensors.faults import TABLE as FAULTS
from testbed.sensors.faults import value_name
from testbed.sensors.settings import SENSORS

LEFT = "left_ruddervator"
WEAK = {"type": "effectiveness", "actuator": LEFT, "value": 0.4}
HELD = {
    "type": "property",
    "set": {"fcs/left-ruddervator/command-scale": 0.5, "inertia/pointmass-weight-lbs[0]": 0.1},
}
MEMS = {"sensors": "mems", "controller": {"type": "adaptive_inversion"}}
WEATHER = {**MEMS, "atmosphere": {"turbulence_w20_m_s": 7.62}}
OWN_WEATHER = {
    **MEMS,
    "atmosphere": {"model": "dryden_8785c", "turbulence": "light", "noise": {"w": [1.0, -2.0]}},
}
AIRS: dict[str, dict[str, Any]] = {"ideal": {}, "mems": MEMS, "weather": WEATHER, "own": OWN_WEATHER}


def saved(made: Scenario) -> Scenario:
    """The scenario written as YAML and read again, with every check of a scenario file."""
    return scenario_from(yaml_source.parsed(dump(made), "saved"))


def same(one: Flight, other: Flight) -> bool:
    return (one.columns, one.data.tobytes(), one.summary) == (
        other.columns,
        other.data.tobytes(),
        other.summary,
    )


def flies_again(session: Session) -> Flight:
    """The flight so far, which must be that of the scenario that was saved: log, events, verdicts and warnings."""
    flight, again = session.flight(), testbed.fly(saved(session.scenario))
    assert flight.columns == again.columns
    assert flight.data.tobytes() == again.data.tobytes()
    assert flight.summary == again.summary
    return flight


def failure(name: str) -> dict[str, Any]:
    """A failure of a type, on an actuator that can have it."""
    if name == "property":
        return {"type": "property", "set": {"fcs/left-ruddervator/command-scale": 0.5}}
    actuator = LEFT if "servo" in TABLE[name].kinds else "left_propeller"
    return {"type": name, "actuator": actuator, **TABLE[name].examples[AIRCRAFT.actuators[actuator].kind]}


def fault_of(kind: str, sensor: str) -> dict[str, Any]:
    """A fault of a type, on any sensor or channel."""
    type_ = FAULTS[kind]
    value = {value_name(type_.key, unit_of(sensor)): 0.5} if type_.needs_value and type_.key else {}
    return {"type": kind, "sensor": sensor, **value}


# The same bytes --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", TABLE)
def test_every_type_of_failure_flies_again_and_is_mended(name: str) -> None:
    with Session(scenario()) as session:
        session.run_to(0.5)
        session.inject(broken := failure(name))
        session.run_to(0.9)
        if TABLE[name].undone:
            session.mend(LEFT if name == "property" else broken["actuator"])
        else:
            with pytest.raises(BadInput, match="cannot be undone"):
                session.mend(broken["actuator"])
        session.run_to(1.3)
        flight = flies_again(session)
    held = [event for event in flight.events if event["kind"] == "injection"]
    assert [event["active"] for event in held] == [True, False][: 1 + TABLE[name].undone]
    if TABLE[name].undone:
        assert held[1]["verified"], "its properties read back as they were"


def test_a_failure_one_step_later_has_other_bytes() -> None:
    """The negative control."""
    with Session(scenario()) as session:
        session.run_to(0.5)
        session.inject(WEAK)
        session.run_to(1.0)
        made = session.scenario
        flight = session.flight()
    later = made.model_copy(update={"failures": (made.failures[0].model_copy(update={"at_s": 0.505}),)})
    assert not same(flight, testbed.fly(saved(later)))


@pytest.mark.parametrize("air", AIRS)
def test_step_by_step_to_a_time_and_by_fly_are_one_flight(air: str) -> None:
    made = scenario({**WEAK, "at_s": 0.3}, duration_s=0.8, **AIRS[air])
    whole = testbed.fly(made)
    with Session(made) as one_by_one, Session(made) as at_once:
        while one_by_one.step() is None:
            pass
        assert at_once.run_to(0.8) is Outcome.completed
        assert at_once.scenario is made, "with what was planned, where nothing was done to it"
        for session in (one_by_one, at_once):
            assert same(session.flight(), whole)


@pytest.mark.parametrize("air", AIRS)
def test_the_flight_so_far_is_the_beginning_of_the_whole_and_disturbs_nothing(air: str) -> None:
    """Judged in mid-air while a failure is watched for its effect."""
    planned = [{**WEAK, "at_s": 0.3}, {"type": "stuck", "actuator": "left_propeller", "at_s": 0.7}]
    made = scenario(*planned, duration_s=1.0, **AIRS[air])
    whole = testbed.fly(made)
    with Session(made) as session:
        session.run_to(0.305)
        middle = flies_again(session)
        assert middle.data.tobytes() == whole.data[: len(middle.data)].tobytes()
        assert (len(middle.data), len(middle.scenario.failures)) == (61, 1)
        session.run_to(1.0)
        assert same(session.flight(), whole)


@pytest.mark.parametrize("air", AIRS)
def test_all_that_can_be_done_flies_again(air: str) -> None:
    with Session(scenario(**AIRS[air])) as session:
        session.order({"airspeed_m_s": 17.5})
        session.run_to(0.4)
        session.inject(WEAK)
        session.order({"heading_deg": 100, "altitude_m": 302})
        session.run_to(0.7)
        session.blow({"magnitude_m_s": [2, 0, 1], "duration_s": 0.1, "hold_s": 0.2})
        session.inject({"type": "stuck", "actuator": LEFT})
        session.run_to(1.0)
        session.blow({"wind_m_s": [3, -1, 0], "duration_s": 0.3})
        session.mend(LEFT)
        session.run_to(1.1)
        session.blow({"wind_m_s": [0, 0, 0]})
        session.run_to(1.5)
        flies_again(session)


@pytest.mark.parametrize("model", ["mems", "own"])
def test_sensors_that_are_broken_and_mended_fly_again(model: str) -> None:
    with Session(scenario(**AIRS[model])) as session:
        for kind in FAULTS:
            session.inject(fault_of(kind, "alpha"))  # what replaces the reading ends what was before
            session.inject(fault_of(kind, "gyro_q"))
            session.step(20)
        session.inject(fault_of("noise", "airspeed"))
        session.mend("airspeed")  # in the control step in which it began
        session.mend("gyro")
        session.run_to(0.7)
        with pytest.raises(BadInput, match="gyro has no fault now"):
            session.mend("gyro")
        flight = flies_again(session)
        alpha = [
            (each.type, each.at_s, each.until_s)
            for each in session.scenario.sensors.faults
            if each.sensor == "alpha"
        ]
        assert alpha == [
            ("stuck", 0.0, 0.1), ("dropout", 0.1, 0.2), ("bias", 0.2, None), ("drift", 0.3, None), ("noise", 0.4, None)
        ]  # fmt: skip
        ended = [e["sensor"] for e in flight.events if e["kind"] == "sensor_fault" and not e["active"]]
        assert ended == ["alpha", "gyro_q", "alpha", "gyro_q", "gyro_q", "gyro_q", "gyro_q", "airspeed"]


def test_a_fault_ends_where_one_that_is_planned_begins() -> None:
    planned = {**fault_of("stuck", "alpha"), "at_s": 0.5}
    with Session(
        scenario(sensors={"model": "mems", "faults": [planned]}, controller=MEMS["controller"])
    ) as session:
        session.run_to(0.2)
        session.inject(fault_of("bias", "alpha"))
        session.inject({**fault_of("stuck", "alpha"), "value_deg": 1})  # in place of it
        session.run_to(0.7)
        faults = session.scenario.sensors.faults
        assert [(each.type, each.at_s, each.until_s) for each in faults] == [
            ("stuck", 0.5, None),
            ("stuck", 0.2, 0.5),
        ]
        flies_again(session)


def test_turbulence_begins_changes_and_ends_in_flight() -> None:
    with Session(scenario(duration_s=10)) as session:
        session.run_to(1.0)
        session.blow({"w20_m_s": 3})
        session.blow({"w20_m_s": 6})
        session.run_to(5.0)
        session.blow({"w20_m_s": 20})
        session.run_to(9.0)
        session.blow({"w20_m_s": 0})
        session.run_to(9.5)
        log = flies_again(session).log
    calm, light, strong, ended = (
        log.query(f"{a} < time_s < {b}")["wind_down_m_s"] for a, b in ((0, 1), (3, 5), (7, 9), (9.1, 10))
    )
    assert max(calm.abs().max(), ended.abs().max()) < 1e-12
    assert 0.05 < light.std() < 0.7 * strong.std()
    assert log["wind_down_m_s"].diff().abs()[log["time_s"] < 8.9].max() < 0.3  # nothing jumps when it changes


@pytest.mark.parametrize("seed", range(8))
def test_whatever_is_done_at_random_flies_again(seed: int) -> None:
    """Refused or not: what is refused changes nothing."""
    chance = random.Random(seed)
    air = list(AIRS.values())[seed % len(AIRS)]
    planned = {**WEAK, "value": 0.7, "at_s": 0.6, "until_s": 0.9}
    done = 0
    with Session(scenario(planned, **air)) as session:
        while session.time_s < 1.4:
            done += _done_at_random(session, chance)
            if steps := chance.randint(0, 25):
                session.step(steps)
        flies_again(session)
    assert done >= 8


def _done_at_random(session: Session, chance: random.Random) -> bool:
    """Do one thing; returns whether it was not refused."""
    actuator = chance.choice(list(AIRCRAFT.actuators))
    kind = AIRCRAFT.actuators[actuator].kind
    fitting = [name for name, type_ in TABLE.items() if kind in type_.kinds and name != "property"]
    name = chance.choice(fitting)
    broken = {"type": name, "actuator": actuator, **TABLE[name].examples[kind]}
    sensor = chance.choice(list(SENSORS))
    do: list[Callable[[], None]] = [
        lambda: session.inject(broken),
        lambda: session.inject({**broken, "at_s": session.time_s + 0.1}),
        lambda: session.mend(actuator),
        lambda: session.order({"heading_deg": chance.uniform(80, 100)}),
        lambda: session.blow({"magnitude_m_s": [1, chance.uniform(-2, 2), 0], "length_m": 3}),
        lambda: session.blow({"wind_m_s": [chance.uniform(-2, 2), 0, 0]}),
        lambda: session.blow({"w20_m_s": chance.uniform(0, 8)}),
        lambda: session.inject(fault_of(chance.choice(list(FAULTS)), sensor)),
        lambda: session.inject({**fault_of("stuck", sensor), "at_s": session.time_s + 0.1}),
        lambda: session.mend(sensor),
    ]
    try:
        chance.choice(do)()
    except BadInput:
        return False
    return True


# What failures do to each other ------------------------------------------------------------------------------------


def windows(session: Session) -> list[tuple[str, float | None, float | None]]:
    return [(each.type, each.at_s, each.until_s) for each in session.scenario.failures]


def test_the_second_failure_of_a_property_ends_the_first() -> None:
    with Session(scenario()) as session:
        session.run_to(0.5)
        session.inject({"type": "stuck_at", "actuator": LEFT, "value": 3})
        session.run_to(0.7)
        session.inject({"type": "hardover", "actuator": LEFT})
        session.run_to(0.8)
        assert windows(session) == [("stuck_at", 0.5, 0.7), ("hardover", 0.7, None)]
        flies_again(session)


def test_a_failure_that_gets_worse_in_steps_is_mended_whole() -> None:
    """The healthy value is that of before the flight, not that which the first step had left."""
    planned = [{**WEAK, "at_s": 0.2}, {**WEAK, "value": 0.1, "at_s": 0.4}]
    with Session(scenario(*planned)) as session:
        session.run_to(0.6)
        session.inject({**WEAK, "value": 0.0})
        session.run_to(0.7)
        assert session.truth[f"{LEFT}_effectiveness"] == 0.0
        session.mend(LEFT)
        session.run_to(0.8)
        assert session.truth[f"{LEFT}_effectiveness"] == 1.0
        flies_again(session)


def test_one_that_holds_less_does_not_replace_one_of_its_type() -> None:
    """It would leave the other property broken for good."""
    limits = {"type": "position_limit", "actuator": LEFT}
    with Session(scenario()) as session:
        high = "fcs/left-ruddervator/servo-max-rad"
        before = session.parts.plant[high]
        session.run_to(0.3)
        session.inject({**limits, "low": 1.0, "high": 3.0})
        session.step(10)
        assert session.parts.plant[high] < before
        session.inject({**limits, "low": 2.0})
        session.step(10)
        assert windows(session) == [("position_limit", 0.3, 0.35), ("position_limit", 0.35, None)]
        assert session.parts.plant[high] == before
        flies_again(session)


def test_properties_are_those_of_before_the_flight_after_all_was_broken_and_mended() -> None:
    """Injected while others hold the same properties: each is healthy again."""
    kinds = [
        name for name, type_ in TABLE.items() if "servo" in type_.kinds and type_.undone and name != "delay"
    ]
    with Session(scenario()) as session:
        plant = session.parts.plant
        block = [name for name in plant.catalog() if name.startswith("fcs/left-ruddervator/")]
        fixed = [name for name in block if _is_input(name)]
        before = {name: plant[name] for name in fixed}
        for name in kinds:
            session.step(10)
            session.inject(failure(name) if name != "property" else HELD_SCALE)
        session.step(10)
        assert {name: plant[name] for name in fixed} != before
        session.mend(LEFT)
        session.step(10)
        assert {name: plant[name] for name in fixed} == before
        flies_again(session)


HELD_SCALE = {"type": "property", "set": {"fcs/left-ruddervator/command-scale": 0.5}}


def _is_input(name: str) -> bool:
    """Whether a property of the block is a constant that failures hold, not a signal."""
    tails = (
        "scale",
        "bias-rad",
        "active",
        "rad_sec",
        "min-rad",
        "max-rad",
        "fail_stuck",
        "gain",
        "effectiveness",
    )
    return name.endswith(tails)


def test_at_one_instant_the_last_failure_counts() -> None:
    with Session(scenario()) as session:
        session.run_to(0.5)
        session.inject(WEAK)
        session.inject({"type": "surface_lost", "actuator": "right_ruddervator"})
        session.inject({**WEAK, "value": 0.9})
        session.mend("right_ruddervator")
        session.run_to(0.7)
        assert windows(session) == [("effectiveness", 0.5, None)]
        assert session.truth[f"{LEFT}_effectiveness"] == 0.9
        flies_again(session)


def test_what_would_begin_at_the_same_instant_hides_nothing() -> None:
    """A step for the worse that is overtaken before it begins does not end the one before it."""
    with Session(scenario()) as session:
        session.run_to(0.3)
        session.inject(WEAK)
        session.run_to(0.5)
        session.inject({**WEAK, "value": 0.0})
        session.inject({"type": "decay", "actuator": LEFT, "value": 0.1, "over_s": 0.2})
        session.run_to(0.8)
        assert windows(session) == [("effectiveness", 0.3, 0.5), ("decay", 0.5, None)]
        flies_again(session)


def test_what_is_planned_ends_what_was_broken_by_hand() -> None:
    planned = {"type": "stuck_at", "actuator": LEFT, "value": 3, "at_s": 0.8, "until_s": 1.0}
    with Session(scenario(planned)) as session:
        session.run_to(0.5)
        session.inject({"type": "hardover", "actuator": LEFT})
        session.run_to(1.1)
        assert windows(session) == [("stuck_at", 0.8, 1.0), ("hardover", 0.5, 0.8)]
        flies_again(session)


def test_a_failure_that_waits_for_a_signal() -> None:
    when = {"signal": "heading_deg", "above": 91.0}
    with Session(scenario()) as session:
        session.run_to(0.3)
        session.inject({**WEAK, "when": when})
        session.run_to(2.0)
        (start,) = [event for event in flies_again(session).events if event["kind"] == "injection"]
        assert 0.3 < start["time_s"] < 2.0


def test_a_signal_that_was_there_before_is_refused() -> None:
    """In the scenario that is saved, the failure would have started then."""
    with Session(scenario()) as session:
        session.run_to(0.3)
        with pytest.raises(BadInput, match="altitude_m above 299 was so at 0 s already"):
            session.inject({**WEAK, "when": {"signal": "altitude_m", "above": 299}})


# What is left out of a flight that is cut ----------------------------------------------------------------------------


def test_what_was_planned_for_later_is_left_out() -> None:
    planned = {
        "failures": [{**WEAK, "at_s": 1.5}, {**WEAK, "actuator": "right_ruddervator", "at_s": 0.2, "until_s": 1.8}],
        "commands": [{"at_s": 0.2, "heading_deg": 95}, {"at_s": 1.2, "heading_deg": 90}],
        "sensors": {"faults": [
            {"type": "bias", "sensor": "gyro_p", "at_s": 1.5, "value_deg_s": 1},
            {"type": "stuck", "sensor": "alpha", "at_s": 0.3, "until_s": 1.4},
        ]},
        "atmosphere": {"gusts": [{"at_s": 1.6, "magnitude_m_s": [1, 0, 0], "duration_s": 0.1}]},
        "requirements": [
            {"signal": "altitude_m", "within": 5, "of": 300, "from_s": 0.2, "until_s": 1.9},
            {"signal": "altitude_m", "within": 5, "of": 300, "from_s": 1.2},
            {"metric": "altitude_error_max_m", "at_most": 5},
        ],
    }  # fmt: skip
    with Session(scenario(**planned)) as session:
        session.run_to(1.0)
        made = session.scenario
        flight = flies_again(session)
    assert [made.failures[0].at_s, made.failures[0].until_s] == [0.2, None]
    assert (len(made.failures), len(made.commands), len(made.requirements)) == (1, 2, 2)
    assert (len(made.sensors.faults), made.atmosphere.is_calm, made.duration_s) == (1, True, 1.0)
    assert [event["failure"] for event in flight.events if event["kind"] == "injection"] == [0]


def test_sensors_without_their_faults_are_not_ideal() -> None:
    """They find rates by differences, which ideal ones do not."""
    faults = [{"type": "bias", "sensor": "gyro_p", "at_s": 0.9, "value_deg_s": 1}]
    with Session(scenario(sensors={"faults": faults})) as session:
        session.run_to(0.5)
        flies_again(session)


def test_random_numbers_that_depend_on_what_is_left_out() -> None:
    cuts = {"type": "intermittent", "actuator": "left_propeller", "off_s": 0.05, "on_s": 0.05}
    early, late = {**cuts, "at_s": 0.2, "until_s": 0.6}, {**cuts, "at_s": 1.0}
    with Session(scenario(late, early)) as session:
        session.run_to(0.5)
        with pytest.raises(
            BadInput, match=r"random numbers of intermittent at 0\.2 s.*listed in order of time"
        ):
            _ = session.scenario
        session.run_to(1.5)
        flies_again(session)
    with Session(scenario(early, late)) as session:
        session.run_to(0.5)
        flies_again(session)


@pytest.mark.parametrize("air", AIRS)
def test_a_flight_that_is_extended_is_as_if_it_had_been_planned(air: str) -> None:
    with Session(scenario({**WEAK, "at_s": 0.3}, duration_s=0.5, **AIRS[air])) as session:
        session.run_to(0.4)
        session.blow({"wind_m_s": [1, 0, 0]})
        session.extend(1.0)
        session.run_to(0.8)
        session.order({"heading_deg": 80})
        assert session.run_to(1.0) is Outcome.completed
        assert len(flies_again(session).data) == 200


# Looking ------------------------------------------------------------------------------------------------------------


def test_rows_are_those_of_the_log() -> None:
    with Session(scenario({**WEAK, "at_s": 0.1}, **MEMS)) as session:
        session.run_to(0.5)
        last = session.flight().log.iloc[-1]
        for row in (session.truth, session.references, session.belief):
            assert np.array_equal(list(row.values()), [last[name] for name in row], equal_nan=True)
            assert len(row) > 3 and "time_s" in row
        assert session.truth["time_s"] == session.time_s - 1 / 200
        assert session.measured["roll_deg"] == last["roll_measured_deg"] != session.truth["roll_deg"]
        assert session.measured["p_dot_deg_s2"] == last["p_dot_deg_s2"]
        assert f"{LEFT}_effectiveness" not in session.belief, "which is true, not believed"


def test_a_row_stays_what_it_was() -> None:
    with Session(scenario()) as session:
        session.step(3)
        row, values = session.truth, dict(session.truth)
        session.step(50)
        session.extend(3.0)
        assert dict(row) == values != dict(session.truth)


# The end, errors and refusals ------------------------------------------------------------------------------------------


def test_a_lost_aircraft_ends_the_flight() -> None:
    gone = [
        {"type": "hardover", "actuator": f"{side}_ruddervator", "at_s": 0.5} for side in ("left", "right")
    ]
    made = scenario(*gone, duration_s=20, requirements=[{"metric": "altitude_error_max_m", "at_most": 5}])
    with Session(made) as session:
        ended = session.run_to(20)
        assert ended is session.ended is session.step(5) is not Outcome.completed
        assert session.time_s < 20
        flight = flies_again(session)
        assert flight.scenario is made and flight.summary == testbed.fly(made).summary
        with pytest.raises(BadInput, match="the flight is over: the aircraft"):
            session.inject(WEAK)


class Fails:
    """Flies straight on, and fails after a while."""

    def __init__(self, setup: Any) -> None:
        self.trim = setup.trim_commands

    def update(self, time_s: float, *_: Any) -> Any:
        if time_s > 0.2:
            raise ZeroDivisionError("of its own")
        return self.trim


def test_after_an_error_what_was_flown_is_there() -> None:
    with Session(scenario(), Fails) as session:
        with pytest.raises(BadInput, match="ZeroDivisionError"):
            session.run_to(1.0)
        assert session.time_s == pytest.approx(0.205)
        assert len(session.flight().data) == 41
        for again in (session.step, lambda: session.inject(WEAK)):
            with pytest.raises(BadInput, match=r"was stopped at 0\.205 s: .*of its own.*expected a new one"):
                again()


def test_a_controller_of_ones_own_is_flown_by_hand() -> None:
    class Straight(Fails):
        def update(self, *_: Any) -> Any:
            return self.trim

    with Session(scenario(duration_s=0.5), Straight) as session:
        session.run_to(0.2)
        session.inject(WEAK)
        session.run_to(0.5)
        assert same(session.flight(), testbed.fly(saved(session.scenario), Straight))


def test_a_closed_session_says_so() -> None:
    session = Session(scenario())
    session.step()
    row = session.truth
    session.close()
    session.close()
    assert row["altitude_m"] == pytest.approx(300)
    for again in (
        session.step,
        session.flight,
        lambda: session.truth,
        lambda: session.scenario,
        lambda: session.order({"heading_deg": 3}),
    ):
        with pytest.raises(BadInput, match="Session: was closed, expected a new one"):
            again()


def test_before_the_first_step_there_is_nothing_to_show() -> None:
    with Session(scenario()) as session:
        for look in (lambda: session.truth, lambda: session.scenario, session.flight):
            with pytest.raises(BadInput, match="nothing has been flown yet, expected step or run_to before"):
                look()


@pytest.mark.parametrize(
    ("do", "words"),
    [
        (lambda s: s.inject({"type": "stuk", "actuator": LEFT}), "failure.type: .*did you mean stuck"),
        (lambda s: s.inject({**WEAK, "actuator": "left_tail"}), "failure.actuator: vtail has no actuator"),
        (lambda s: s.inject({**WEAK, "valu": 1}), "inject: failure.valu: unknown key.*did you mean value"),
        (lambda s: s.inject({**WEAK, "at_s": 0.1}), "failure.at_s: 0.1 s has passed, expected at least 0.5"),
        (lambda s: s.inject({**WEAK, "at_s": 2}), "failure.at_s: 2 s is after the flight's end"),
        (lambda s: s.inject({**WEAK, "until_s": 3}), "failure.until_s: 3 s is after the flight's end"),
        (lambda s: s.inject({"type": "stuck_at", "actuator": LEFT, "value": 90}), "outside left_ruddervator's range"),
        (lambda s: s.inject({"type": "property", "set": {"fcs/left-rudervator/x": 1}}), "unknown property"),
        (lambda s: s.inject({"type": "property", "set": {"simulation/reset": 1}}), "steers the simulation"),
        (lambda s: s.inject({**WEAK, "when": {"signal": "roll", "above": 1}}), "unknown signal 'roll'"),
        (lambda s: s.inject("stuck"), "inject: failure: is 'stuck', expected a"),
        (lambda s: s.mend("left"), "mend: there is no actuator 'left'"),
        (lambda s: s.mend([LEFT]), "mend: there is no actuator"),
        (lambda s: s.mend(LEFT), "left_ruddervator has no failure now, expected one of right_propeller"),
        (lambda s: s.order({}), "order: command: asks for nothing"),
        (lambda s: s.order({"altitude": 300}), "command.altitude: unknown key.*did you mean altitude_m"),
        (lambda s: s.order({"heading_deg": 400}), "command.heading_deg: is 400"),
        (lambda s: s.blow({"magnitude_m_s": [1, 0, 0]}), "blow: gust: has no size"),
        (lambda s: s.blow({"wind_m_s": [1, 0]}), "blow: wind.wind_m_s"),
        (lambda s: s.blow({"w20_m_s": -1}), "blow: turbulence.w20_m_s: is -1"),
        (lambda s: s.inject({"type": "stuck", "sensor": "alfa"}), "unknown sensor 'alfa', did you mean alpha"),
        (lambda s: s.mend("alpha"), "mend: alpha has no fault now"),
        (lambda s: s.inject({"type": "stuck", "sensor": "alpha"}), "the sensors of this flight are ideal"),
        (lambda s: s.step(0), "step: is 0, expected a whole number"),
        (lambda s: s.run_to(0.2), "run_to: is 0.2, expected a time from 0.5, which is now, to duration_s 2"),
        (lambda s: s.run_to(float("nan")), "run_to: is nan"),
        (lambda s: s.extend(1.0), "extend: is 1.0, expected whole control steps"),
        (lambda s: s.extend(10**400), "extend: is 1000"),
        (lambda s: s.extend(2.001), "extend: is 2.001, expected whole control steps"),
    ],
)  # fmt: skip
def test_what_is_refused_changes_nothing(do: Callable[[Session], object], words: str) -> None:
    planned = {"type": "command_scale", "actuator": "right_propeller", "value": 0.9, "at_s": 0.2}
    with Session(scenario(planned)) as session:
        session.run_to(0.5)
        with pytest.raises(BadInput, match=words):
            do(session)
        session.run_to(0.7)
        assert same(session.flight(), testbed.fly(scenario(planned, duration_s=0.7)))


def test_a_file_and_settings_are_taken_as_by_fly(tmp_path: Path) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text(dump(scenario()))
    with Session(file, set={"duration_s": 0.3, "sensors": "mems"}) as session:
        session.run_to(0.3)
        assert same(session.flight(), testbed.fly(file, set={"duration_s": 0.3, "sensors": "mems"}))


@pytest.mark.parametrize("make", [testbed.fly, Session])
def test_arguments_of_a_wrong_kind_are_refused_in_words(make: Callable[..., Any]) -> None:
    with pytest.raises(
        BadInput, match="scenario: is None, expected the path of a scenario's YAML file, or a Scenario"
    ):
        make(None)
    with pytest.raises(BadInput, match="set: is 3, expected a mapping"):
        make("left_tail_fail.yaml", set=3)
    with pytest.raises(BadInput, match="controller: is 'pid', expected a class"):
        make("left_tail_fail.yaml", "pid")


def test_a_mistyped_signal_is_answered_with_what_was_meant() -> None:
    with Session(scenario()) as session:
        session.step()
        with pytest.raises(KeyError, match=r"no 'altitude', did you mean 'altitude_m'\?"):
            session.truth["altitude"]
        with pytest.raises(KeyError, match="no 'xyzzy', expected one of time_s, north_m"):
            session.truth["xyzzy"]
        assert "altitude" not in session.truth and session.truth.get("altitude") is None
