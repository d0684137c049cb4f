"""Verdicts on logs of which the answer is known; each check is also shown to fail."""

from __future__ import annotations

import math
from typing import Any

import pytest
from handmade import flight_of, level_log

from testbed.flight.flight import Outcome
from testbed.flight.requirements import judge
from testbed.scenario.requirement import Requirement


def verdict(
    log: dict[str, Any], metrics: dict[str, float] | None = None, **requirement: Any
) -> dict[str, Any]:
    return judge([Requirement(**requirement)], log, metrics or {})[0]


@pytest.mark.parametrize(
    ("limits", "value", "margin"),
    [
        ({"at_most": 103}, 102.0, 1.0),
        ({"at_most": 101}, 102.0, -1.0),
        ({"at_least": 97}, 98.0, 1.0),
        ({"at_least": 99.5}, 98.0, -1.5),
        ({"within": 2, "of": 100}, 2.0, 0.0),  # on the limit is met
        ({"within": 1.75, "of": "altitude_command_m"}, 2.0, -0.25),
        ({"at_least": 97, "at_most": 102.5}, 102.0, 0.5),  # the nearer of two limits
    ],
)
def test_signal(limits: dict[str, Any], value: float, margin: float) -> None:
    log = level_log()
    log["altitude_m"][500], log["altitude_m"][600] = 102.0, 98.0
    found = verdict(log, signal="altitude_m", **limits)
    assert (found["value"], found["margin"], found["passed"]) == (value, margin, margin >= 0)
    assert found["reason"] == ""


@pytest.mark.parametrize(
    ("row", "seen"),
    [(199, False), (200, True), (299, True), (300, False)],
    ids=["before", "first", "last", "after"],
)
def test_window_has_its_start_and_not_its_end(row: int, seen: bool) -> None:
    log = level_log()
    log["altitude_m"][row] += 50.0
    found = verdict(log, signal="altitude_m", from_s=2, until_s=3, within=1, of=100)
    assert found["passed"] is not seen


@pytest.mark.parametrize(
    ("window", "passed"),
    [
        ({"from_s": 12, "until_s": 15}, False),  # not reached
        ({"from_s": 8, "until_s": 12}, False),  # reached in part
        ({"from_s": 10}, False),  # begins where the flight ends
        ({"from_s": 9, "until_s": 10}, True),  # to the last row, which is one step before
        ({"until_s": 10.02}, False),
        ({"from_s": 9}, True),  # to the end, whenever that is
        ({"from_s": 5.001, "until_s": 5.002}, False),  # between two rows: nothing was seen
    ],
)
def test_window_that_was_not_flown_is_not_met(window: dict[str, float], passed: bool) -> None:
    found = verdict(level_log(), signal="altitude_m", within=1, of=100, **window)
    assert found["passed"] is passed
    if not passed:
        assert found["reason"] and math.isnan(found["value"]) and found["margin"] == -math.inf


def test_not_a_number_is_not_met() -> None:
    log = level_log()
    log["altitude_m"][-1] = math.nan
    found = verdict(log, signal="altitude_m", at_most=1e9)
    assert not found["passed"] and found["reason"]
    assert verdict(log, signal="altitude_m", until_s=9, at_most=1e9)["passed"]


def test_metric() -> None:
    asked = {"metric": "detection_delay_s", "at_most": 0.5}
    assert verdict({}, {"detection_delay_s": 0.4}, **asked)["margin"] == pytest.approx(0.1)
    assert not verdict({}, {"detection_delay_s": 0.6}, **asked)["passed"]
    assert not verdict({}, {"detection_delay_s": math.nan}, **asked)["passed"]


def test_heading_goes_the_short_way() -> None:
    log = level_log()
    log["heading_deg"][500] = 2.0  # the reference is 350
    found = verdict(log, signal="heading_deg", within=12.5, of="heading_command_deg")
    assert found["value"] == pytest.approx(12.0) and found["passed"]


def test_a_lost_aircraft_has_not_passed_whatever_it_met() -> None:
    met = judge([Requirement(signal="altitude_m", at_most=200)], level_log(), {})
    assert flight_of(level_log(), requirements=met).passed
    assert not flight_of(level_log(), requirements=met, outcome=Outcome.ground_contact).passed
