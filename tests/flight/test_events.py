"""What the controller did is read from its log: flags of what is broken and what is not, and released axes."""

from __future__ import annotations

import math

import numpy as np
from handmade import at, injection, level_log

from testbed.common.signals import RATES
from testbed.flight.events import controller_events


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
