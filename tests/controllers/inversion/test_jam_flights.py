"""Jams from stop to stop, flown in calm air: heading is held everywhere, and altitude where there is a level trim with margin."""

from __future__ import annotations

import math

import pytest
from command_line import ROOT
from short_flights import worst_errors

import testbed
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

SCENARIO = ROOT / "scenarios" / "jammed_ruddervator.yaml"


def flown(actuator: str, value: float) -> Flight:
    failure = f"failures=[{{type: stuck_at, actuator: {actuator}, at_s: 5, value: {value}}}]"
    controller = "controller={type: adaptive_inversion}"
    return fly(load_scenario(SCENARIO, [failure, controller, "requirements=[]", "duration_s=60"]))


@pytest.mark.parametrize(
    ("actuator", "value"),
    [
        ("left_ruddervator", -25.8),
        ("right_ruddervator", -20.0),
        ("left_ruddervator", -15.0),
        ("right_ruddervator", 15.0),
        ("left_ruddervator", 20.0),
        ("right_ruddervator", 25.8),
        ("left_propeller", 0.2),
        ("right_propeller", 0.8),
        ("left_propeller", 1.0),
    ],
)
def test_heading_is_held_from_40_s_after_a_jam(actuator: str, value: float) -> None:
    flight = flown(actuator, value)
    altitude, heading, _ = worst_errors(flight, 45.0)
    assert flight.outcome is Outcome.completed
    assert heading < 5.0
    if value in (-15.0, 15.0, 0.2, 0.8, 1.0):
        assert altitude < 1.0


def in_turbulence(seed: int, *changes: str, w20_m_s: float = 7.62) -> Flight:
    """A flight with MEMS sensors, whose heading is commanded to 120 deg at 3 s; it must not be lost."""
    weather = ["sensors={model: mems}", f"atmosphere={{turbulence_w20_m_s: {w20_m_s}}}", f"seed={seed}"]
    turn = "commands=[{at_s: 3, heading_deg: 120}]"
    flight = fly(load_scenario(SCENARIO, [*weather, turn, "requirements=[]", *changes]))
    assert flight.outcome is Outcome.completed
    return flight


@pytest.mark.parametrize("seed", [3, 8, 10])
def test_a_weak_tail_is_not_given_up_for_a_propeller_that_sticks(seed: int) -> None:
    """Heading strayed by 16 to 30 deg when it was: yaw was given up with it."""
    flight = in_turbulence(
        seed,
        "controller={type: adaptive_inversion}",
        "commands=[{at_s: 3, heading_deg: 120}, {at_s: 12, altitude_m: 307}]",
        "command_rates={heading_deg_s: 7, altitude_m_s: 1}",
        "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 8, value: 0.2}, "
        "{type: stuck, actuator: left_propeller, at_s: 18}]",
        "duration_s=31",
    )
    altitude, heading, _ = worst_errors(flight, 8.0)
    assert altitude < 4.0 and heading < 8.0
    assert not flight.log["left_ruddervator_failed"].any()


@pytest.mark.parametrize(("actuator", "seed"), [("left_propeller", 54227327), ("right_propeller", 1)])
def test_full_throttle_is_not_taken_for_weak_tails(actuator: str, seed: int) -> None:
    """A tail was given up for it, and heading strayed by 22 deg."""
    flight = in_turbulence(
        seed,
        "initial.airspeed_m_s=15.2",
        "controller={type: adaptive_inversion}",
        "commands=[{at_s: 3, heading_deg: 120, altitude_m: 305}]",
        f"failures=[{{type: hardover, actuator: {actuator}, at_s: 9, to: max}}]",
        "duration_s=20",
        w20_m_s=1.147,
    )
    altitude, heading, _ = worst_errors(flight, 9.0)
    assert altitude < 3.0 and heading < 10.0
    assert not any(flight.log[f"{side}_ruddervator_failed"].any() for side in ("left", "right"))


@pytest.mark.parametrize("controller", ["{type: adaptive_inversion}", "{type: indi, monitor: true}"])
@pytest.mark.parametrize("seed", [3, 8])
def test_a_propeller_that_fails_on_and_off_after_a_tail_is_used_on(controller: str, seed: int) -> None:
    """Given up, with level flight, it left the aircraft 23 to 32 m too low."""
    flight = in_turbulence(
        seed,
        f"controller={controller}",
        "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0}, "
        "{type: intermittent, actuator: right_propeller, at_s: 12, off_s: 0.5, on_s: 1.0}]",
        "duration_s=30",
    )
    altitude, heading, _ = worst_errors(flight, 12.0)
    assert altitude < 4.0 and heading < 14.0
    assert not flight.log["right_propeller_failed"].any()


@pytest.mark.parametrize(
    ("controller", "seed"),
    [
        ("adaptive_inversion", 6),
        ("adaptive_inversion", 11),
        ("indi, monitor: true", 8),
    ],
)
def test_a_tail_that_fails_on_and_off_after_a_propeller_is_used_on(controller: str, seed: int) -> None:
    """Given up after it had seemed lost for 3 s in all, it left the aircraft 8 to 25 m too low."""
    flight = in_turbulence(
        seed,
        f"controller={{type: {controller}}}",
        "failures=[{type: effectiveness, actuator: left_propeller, at_s: 5, value: 0}, "
        "{type: intermittent, actuator: left_ruddervator, at_s: 12, off_s: 0.5, on_s: 1.0}]",
        "duration_s=30",
    )
    altitude, heading, _ = worst_errors(flight, 12.0)
    assert altitude < 4.0 and heading < 14.0


def flown_by_aerosonde(failure: str, duration_s: float, actuator: str = "propeller") -> Flight:
    changes = [
        "aircraft=aerosonde",
        "initial={altitude_m: 200, airspeed_m_s: 25, heading_deg: 0}",
        "commands=[]",
        f"failures=[{{actuator: {actuator}, at_s: 5, {failure}}}]",
        "requirements=[]",
        f"duration_s={duration_s}",
    ]
    return fly(load_scenario(SCENARIO, changes))


@pytest.mark.parametrize("throttle", [0.8, 1.0])
def test_altitude_is_held_with_the_only_propeller_stuck(throttle: float) -> None:
    flight = flown_by_aerosonde(f"type: stuck_at, value: {throttle}", 40.0)
    altitude, heading, _ = worst_errors(flight, 5.0)
    assert flight.outcome is Outcome.completed
    assert altitude < 2.0 and heading < 10.0


def test_altitude_comes_back_where_a_stuck_throttle_is_enough_only_when_slow() -> None:
    """Thrust grows as the aircraft slows down: at the airspeed of the failure it is a fifth of the drag."""
    flight = flown_by_aerosonde("type: stuck_at, value: 0.6", 60.0)
    altitude, _, _ = worst_errors(flight, 5.0)
    assert flight.outcome is Outcome.completed
    assert altitude < 12.5 and worst_errors(flight, 55.0)[0] < 1.0 and flight.log.airspeed_m_s.iloc[-1] < 21.0


def test_a_propeller_that_balances_no_moment_slows_the_aircraft_down() -> None:
    """A rudder jammed at -20 deg needs 19 to 20 m/s. At 21 m/s the regulator kept climbing, 130 m in 100 s."""
    flight = flown_by_aerosonde("type: stuck_at, value: -20", 60.0, "rudder")
    assert worst_errors(flight, 5.0)[0] < 15.0 and worst_errors(flight, 40.0)[0] < 5.0


def test_without_thrust_the_path_is_the_one_designed() -> None:
    """As steep as the diagnosis says, and slower than the airspeed of the linear model's shallowest glide, 22 m/s."""
    flight = flown_by_aerosonde("type: effectiveness, value: 0", 60.0)
    late = flight.log[flight.log.time_s >= 45.0]
    lost_m = float(late.altitude_m.iloc[0] - late.altitude_m.iloc[-1])
    slope_deg = math.degrees(lost_m / float(late.airspeed_m_s.mean()) / 15.0)
    said = next(e["text"] for e in flight.events if "path angle" in e.get("text", ""))
    assert float(said.rsplit("about", 1)[1].split()[0]) == pytest.approx(-slope_deg, abs=0.4)
    assert 17.0 < late.airspeed_m_s.mean() < 19.5


def test_an_aircraft_climbs_where_there_is_no_level_trim_and_the_reason_is_said() -> None:
    flight = flown("left_ruddervator", 25.8)
    assert any("no level trim balances the jam" in e.get("text", "") for e in flight.events)
    assert flight.log["altitude_m"].iloc[-1] > 350.0


def test_a_healthy_surface_is_never_taken_for_jammed() -> None:
    flight = fly(load_scenario(SCENARIO, ["failures=[]", "requirements=[]", "duration_s=20"]))
    assert not [event for event in flight.events if event["kind"] in ("diagnosis", "false_alarm")]


@pytest.mark.parametrize(("to", "seed"), [("max", 1), ("min", 2)])
def test_a_rudder_that_runs_to_its_stop_turns_nobody_round(to: str, seed: int) -> None:
    """Inversion held the sideslip, commanded the rudder to where it was and took it for working until 55 s. At its
    stop no trim balances it within those of the others: a regulator about a trim without it lost heading, and the aircraft."""
    at = {"altitude_m": 300.0, "airspeed_m_s": 26.0, "heading_deg": 90.0}
    changes = {
        "aircraft": "aerosonde", "initial": at, "commands": [{"at_s": 0, **at}], "requirements": [],
        "failures": [{"type": "runaway", "actuator": "rudder", "at_s": 5, "to": to, "rate": 1.1}],
        "controller": {"type": "adaptive_inversion"}, "sensors": {"model": "mems"}, "duration_s": 60,
        "atmosphere": {"turbulence_w20_m_s": 3.0}, "seed": seed,
    }  # fmt: skip
    flight = testbed.fly(SCENARIO, set=changes)
    log = flight.log
    missed = (log.heading_deg - log.heading_command_deg + 180.0) % 360.0 - 180.0
    assert log.time_s.iloc[-1] == pytest.approx(60.0, abs=0.1)
    assert missed.abs().max() < 25.0
    assert (log.altitude_m - log.altitude_command_m).abs().max() < 20.0
    assert log.time_s[log.rudder_failed > 0].iloc[0] < 20.0
    said = [event.get("text", "") for event in flight.summary["events"]]
    assert to == "min" or any(
        "no level trim balances the jam; flies by that of 90 % of its force" in text for text in said
    )


@pytest.mark.parametrize(("value", "seed"), [(-25, 1), (-25, 2), (25, 2)])
def test_with_the_rudder_at_its_stop_the_propeller_is_not_blamed_and_altitude_is_held(
    value: int, seed: int
) -> None:
    """In 27 deg of sideslip the side force leans forward by 2 m/s2. It was taken for a stuck propeller, and heading was lost by
    40 to 140 deg. Of the whole jam the only trims climb: 120 m in 35 s."""
    at = {"altitude_m": 300.0, "airspeed_m_s": 25.0, "heading_deg": 90.0}
    changes = {
        "aircraft": "aerosonde", "initial": at, "commands": [{"at_s": 0, **at}], "requirements": [],
        "failures": [{"type": "stuck_at", "actuator": "rudder", "at_s": 5, "value": value}],
        "controller": {"type": "adaptive_inversion"}, "sensors": {"model": "mems"}, "duration_s": 40,
        "atmosphere": {"turbulence_w20_m_s": 3.0}, "seed": seed,
    }  # fmt: skip
    log = testbed.fly(SCENARIO, set=changes).log
    missed = (log.heading_deg - log.heading_command_deg + 180.0) % 360.0 - 180.0
    assert log.time_s.iloc[-1] == pytest.approx(40.0, abs=0.1)
    assert log.propeller_failed.max() == 0.0
    assert (log.altitude_m - log.altitude_command_m).abs().max() < 10.0
    assert missed[log.time_s > 30.0].abs().max() < 25.0
