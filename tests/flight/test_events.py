"""What the controller did is read from its log: flags of what is broken and what is not, and released axes. A flight that ended
early says which limit it passed and what had been asked of the actuators."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import ACTUATORS, at, injection, level_log

from testbed.aircraft.description import Envelope
from testbed.common.signals import RATES
from testbed.flight.events import controller_events, loss_event
from testbed.flight.flight import Outcome

ENVELOPE = Envelope(
    alpha_max_deg=25, beta_max_deg=40, roll_max_deg=110, airspeed_min_m_s=8, airspeed_max_m_s=40
)


def log_with_all_axes() -> dict[str, np.ndarray]:
    log = level_log()
    for axis in RATES:
        log.setdefault(f"{axis}_released", np.zeros_like(log["time_s"]))
    return log


def found(log: dict[str, np.ndarray], *injections: dict[str, object]) -> list[tuple[object, ...]]:
    events = controller_events(log, ("elevon", "fan"), injections)
    return [(e["time_s"], e["kind"], e.get("actuator", e.get("axis")), e.get("delay_s")) for e in events]


def test_each_rise_of_a_flag_is_an_event() -> None:
    log = log_with_all_axes()
    log["elevon_effectiveness"][at(2) :] = 0.0
    log["elevon_failed"][at(3) : at(4)] = 1.0
    log["elevon_failed"][at(5) :] = 1.0
    log["fan_failed"][at(1) : at(6)] = 1.0
    assert found(log) == [
        (1.0, "false_alarm", "fan", None),
        (3.0, "detection", "elevon", 1.0),
        (5.0, "detection", "elevon", 3.0),
    ]


def test_a_flag_of_what_is_no_longer_broken_is_a_false_alarm() -> None:
    log = log_with_all_axes()
    log["elevon_failed"][at(6) :] = 1.0
    stuck, freed = injection(2.0, type="stuck"), injection(6.0, type="stuck", active=False)
    assert found(log, stuck) == [(6.0, "detection", "elevon", 4.0)]
    assert found(log, stuck, freed) == [(6.0, "false_alarm", "elevon", None)]


def test_releases() -> None:
    log = log_with_all_axes()
    log["p_dot_released"][at(2) :] = 1.0
    log["q_dot_released"][at(1) : at(2)] = 1.0
    log["q_dot_released"][at(4) :] = 1.0
    log["u_dot_released"][:] = 1.0  # a setting, not an event
    assert found(log) == [
        (1.0, "release", "q_dot", None),
        (2.0, "release", "p_dot", None),
        (4.0, "release", "q_dot", None),
    ]


def test_what_is_not_a_number_is_no_flag() -> None:
    log = log_with_all_axes()
    log["elevon_failed"][at(9) :] = math.nan
    assert found(log) == []


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
