"""Jams from stop to stop, flown in calm air: heading is held everywhere, and altitude where there is a level trim with margin."""

from __future__ import annotations

import pytest
from command_line import ROOT
from short_flights import worst_errors

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


@pytest.mark.parametrize("throttle", [0.8, 1.0])
def test_altitude_is_held_with_the_only_propeller_stuck(throttle: float) -> None:
    changes = [
        "aircraft=aerosonde",
        "initial={altitude_m: 200, airspeed_m_s: 25, heading_deg: 0}",
        "commands=[]",
        f"failures=[{{type: stuck_at, actuator: propeller, at_s: 5, value: {throttle}}}]",
        "requirements=[]",
        "duration_s=40",
    ]
    flight = fly(load_scenario(SCENARIO, changes))
    altitude, heading, _ = worst_errors(flight, 5.0)
    assert flight.outcome is Outcome.completed
    assert altitude < 2.0 and heading < 10.0


def test_a_climb_is_flown_where_there_is_no_level_trim_and_the_reason_is_said() -> None:
    flight = flown("left_ruddervator", 25.8)
    (said,) = [e["text"] for e in flight.events if "altitude cannot be held" in e.get("text", "")]
    assert "path angle" in said
    assert flight.log["altitude_m"].iloc[-1] > 350.0


def test_a_healthy_surface_is_never_taken_for_jammed() -> None:
    flight = fly(load_scenario(SCENARIO, ["failures=[]", "requirements=[]", "duration_s=20"]))
    assert not [event for event in flight.events if event["kind"] in ("diagnosis", "false_alarm")]
