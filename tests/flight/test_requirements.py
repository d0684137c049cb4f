"""Verdicts on logs of which the answer is known; each check is also shown to fail."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from handmade import at, flight_of, level_log
from hypothesis import given, settings
from hypothesis import strategies as st

from testbed.flight.flight import Outcome
from testbed.flight.requirements import judge
from testbed.scenario.requirement import Requirement


def verdict(
    log: dict[str, Any], metrics: dict[str, float] | None = None, **requirement: Any
) -> dict[str, Any]:
    return judge([Requirement(**requirement)], log, metrics or {})[0]


@pytest.mark.parametrize("of", [{"signal": "a_failed"}, {"metric": "false_alarms"},
                                {"signal": "altitude_m", "within": 1, "of": "a_failed"}])  # fmt: skip
def test_what_the_controller_does_not_say_is_not_judged(of: dict[str, Any]) -> None:
    log = level_log() | {"a_failed": np.full(1000, math.nan)}
    asked = Requirement(**({"at_most": 1} if "within" not in of else {}), **of)
    (found,) = judge([asked], log, {"false_alarms": math.nan}, unjudged={"a_failed", "false_alarms"})
    assert found["passed"] is None and "does not say" in found["reason"]
    assert all(math.isnan(found[name]) for name in ("value", "margin", "robustness"))
    (missed,) = judge([asked], log, {"false_alarms": math.nan})  # said, and no number
    assert missed["passed"] is False


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


def outside(*stretches: tuple[float, float]) -> dict[str, Any]:
    """A log of which the altitude is 3 m too high in these stretches of time [s], and 1 m else."""
    log = level_log()
    log["altitude_m"] += 1.0
    for begin, end in stretches:
        log["altitude_m"][at(begin) : at(end)] += 2.0
    return log


NEAR = {"signal": "altitude_m", "within": 2, "of": 100}


def test_robustness_is_the_margin_in_units_of_the_scale() -> None:
    assert verdict(outside(), **NEAR)["robustness"] == 0.5
    assert verdict(outside((2, 3)), **NEAR)["robustness"] == -0.5
    assert verdict(outside((2, 3)), **NEAR, scale=10)["robustness"] == -0.1
    metric = {"metric": "detection_delay_s", "at_most": 0.5}
    assert verdict({}, {"detection_delay_s": 0.4}, **metric)["robustness"] == pytest.approx(0.2)
    assert verdict({}, {"detection_delay_s": math.nan}, **metric)["robustness"] == -1.0


def test_eventually_asks_for_one_instant() -> None:
    log = outside((0, 6), (7, 10))
    found = verdict(log, **NEAR, eventually=True)
    assert (found["passed"], found["value"], found["margin"], found["robustness"]) == (True, 1.0, 1.0, 0.5)
    found = verdict(log, **NEAR, eventually=True, until_s=6)
    assert (found["passed"], found["value"], found["margin"], found["robustness"]) == (False, 3.0, -1.0, -0.5)


@pytest.mark.parametrize(("by_s", "passed"), [(2.9, False), (3.0, True), (2.995, True), (8.0, True)])
def test_settling_gives_its_time(by_s: float, passed: bool) -> None:
    """Settled in the row of 3 s; a time between two rows is that of the next one."""
    found = verdict(outside((1, 2), (2.5, 3)), **NEAR, settles_by_s=by_s)
    assert (found["passed"], found["value"]) == (passed, 3.0)
    assert found["margin"] == pytest.approx(max(by_s, 3.0) - 3.0 if passed else by_s - 3.0)
    assert found["robustness"] == (0.5 if passed else -0.5)


def test_settling_that_does_not_happen_has_no_time() -> None:
    found = verdict(outside((9.5, 10)), **NEAR, settles_by_s=3)
    assert not found["passed"] and math.isnan(found["value"]) and found["robustness"] == -0.5
    assert found["reason"] == "it was outside at the end of the window"
    assert verdict(outside((9.5, 10)), **NEAR, settles_by_s=3, until_s=9)["value"] == 0.0


@pytest.mark.parametrize(("longest", "passed"), [(0.99, False), (1.0, True), (1.001, True), (1.5, True)])
def test_a_shorter_time_outside_is_allowed(longest: float, passed: bool) -> None:
    found = verdict(outside((1, 1.5), (3, 4), (6, 6.7)), **NEAR, never_for_longer_than_s=longest)
    assert (found["passed"], found["value"]) == (passed, pytest.approx(1.0))
    assert found["margin"] == pytest.approx(longest - 1.0, abs=1e-9)
    assert found["robustness"] == (0.5 if passed else -0.5)


VERBS = ({}, {"eventually": True}, {"settles_by_s": 0.07}, {"never_for_longer_than_s": 0.03})
LIMITS = ({"at_most": 1}, {"at_least": -1, "at_most": 1.5, "scale": 3}, {"within": 1, "of": 0.2})


@settings(deadline=None)
@given(st.lists(st.floats(-3, 3), min_size=12, max_size=30), st.sampled_from(VERBS), st.sampled_from(LIMITS))
def test_robustness_is_negative_just_where_a_requirement_is_missed(
    values: list[float], verb: dict[str, Any], limits: dict[str, Any]
) -> None:
    log = {"time_s": np.arange(len(values)) / 100.0, "roll_deg": np.array(values)}
    found = verdict(log, signal="roll_deg", **limits, **verb)
    assert found["passed"] == (found["robustness"] >= 0.0) and math.isfinite(found["robustness"])
    assert found["passed"] or not found["margin"] >= 0.0


def test_what_was_not_flown_counts_below_what_was() -> None:
    """Lost at 10 s: the later the end of the window, the worse; a broken limit before the loss is worse still."""
    asked = {**NEAR, "from_s": 1}

    def robustness(log: dict[str, Any], **window: float) -> float:
        return float(judge([Requirement(**asked, **window)], log, {}, 40.0)[0]["robustness"])

    assert robustness(outside(), until_s=20) == pytest.approx(-0.5, abs=1e-3)
    assert robustness(outside(), until_s=40) == pytest.approx(-0.75, abs=1e-3)
    assert robustness(outside((2, 3)), until_s=20) == pytest.approx(-1.0, abs=1e-3)
    later = judge([Requirement(signal="altitude_m", from_s=30, within=2, of=100)], outside(), {}, 40.0)
    assert later[0]["robustness"] == pytest.approx(-0.75, abs=1e-3)
    assert robustness(outside()) == 0.5  # it asks for no more than was flown


def test_rows_without_a_number_count_as_if_not_flown() -> None:
    log = outside()
    log["altitude_m"][750:] = math.nan
    assert verdict(log, **NEAR)["robustness"] == pytest.approx(-0.25)


def test_robustness_of_a_flight_is_the_least() -> None:
    met = judge([Requirement(**NEAR), Requirement(signal="roll_deg", at_most=4)], outside(), {})
    assert flight_of(outside(), requirements=met).robustness == 0.5
    assert flight_of(outside()).robustness == math.inf
    lost = flight_of(level_log(4.0), requirements=met, outcome=Outcome.ground_contact)
    assert lost.robustness == pytest.approx(-0.601)  # 3.99 of 10 s
    at_the_end = flight_of(level_log(), requirements=met, outcome=Outcome.ground_contact)
    assert at_the_end.robustness == pytest.approx(-0.001)


def test_a_lost_aircraft_has_not_passed_whatever_it_met() -> None:
    met = judge([Requirement(signal="altitude_m", at_most=200)], level_log(), {})
    assert flight_of(level_log(), requirements=met).passed
    assert not flight_of(level_log(), requirements=met, outcome=Outcome.ground_contact).passed
