"""A flight that ended early says which limit it passed and what had been asked of the actuators."""

from __future__ import annotations

import pytest
from handmade import ACTUATORS, at, level_log

from testbed.aircraft.description import Envelope
from testbed.flight.flight import Outcome
from testbed.flight.loss import loss_event

ENVELOPE = Envelope(
    alpha_max_deg=25, beta_max_deg=40, roll_max_deg=110, airspeed_min_m_s=8, airspeed_max_m_s=40
)


@pytest.mark.parametrize(
    ("column", "value", "limit"),
    [
        ("alpha_deg", -25.5, "alpha_max_deg"),
        ("beta_deg", 41.0, "beta_max_deg"),
        ("roll_deg", -111.0, "roll_max_deg"),
        ("airspeed_m_s", 7.5, "airspeed_min_m_s"),
        ("airspeed_m_s", 40.5, "airspeed_max_m_s"),
    ],
)
def test_the_limit_that_was_passed(column: str, value: float, limit: str) -> None:
    log = level_log()
    log[column][-1] = value
    event = loss_event(log, Outcome.envelope_exceeded, ENVELOPE, ACTUATORS)
    assert [(m["limit"], m["value"], m["allowed"]) for m in event["limits"]] == [
        (limit, value, getattr(ENVELOPE, limit))
    ]
    assert (event["time_s"], event["kind"]) == (9.99, "lost")


def test_a_limit_that_the_aircraft_does_not_have_is_not_passed() -> None:
    log = level_log()
    log["alpha_deg"][-1] = 80.0
    assert loss_event(log, Outcome.envelope_exceeded, Envelope(), ACTUATORS)["limits"] == []


def test_on_the_ground_no_limit_was_passed() -> None:
    log = level_log()
    log["alpha_deg"][-1] = 80.0
    assert loss_event(log, Outcome.ground_contact, ENVELOPE, ACTUATORS)["limits"] == []


def test_commands_at_a_stop_for_most_of_the_last_second() -> None:
    log = level_log()
    log["elevon_command"][at(9.3) :] = -20.0
    log["fan_command"][at(9.7) :] = 8.0  # less than half of it
    (asked,) = loss_event(log, Outcome.diverged, ENVELOPE, ACTUATORS)["at_stop"]
    assert (asked["actuator"], asked["stop"]) == ("elevon", "low")
    assert asked["share"] == pytest.approx(0.7, abs=0.01)
