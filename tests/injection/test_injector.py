"""Failures start and end in the control step in which they are due, and each draws from a stream of its own."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from broken_flights import AIRCRAFT, RATES, fly, healthy

from testbed.failures import TABLE, Failure
from testbed.injection.injector import Injector, stream_names
from testbed.injection.receipt import RECEIPT_STEPS
from testbed.plant.jsbsim import Plant


def failure(type: str = "effectiveness", actuator: str = "left_ruddervator", **fields: Any) -> Failure:
    kind = AIRCRAFT.actuators[actuator].kind
    return TABLE[type].model_validate(
        {"type": type, "actuator": actuator, "at_s": 1.0, **TABLE[type].examples[kind], **fields}
    )


def injector(*failures: Failure, rate_hz: float = 100.0) -> Injector:
    return Injector(Plant(AIRCRAFT, round(rate_hz)), AIRCRAFT, failures, rate_hz)


def test_it_is_called_only_when_something_is_due() -> None:
    """At the start, while it watches for the effect, and at the end."""
    held = {"atmosphere/wind-north-fps": 3.0}
    wind = TABLE["property"].model_validate({"type": "property", "at_s": 0.3, "until_s": 2.0, "set": held})
    parts, called = injector(wind), []
    for k in range(220):
        if k >= parts.next_step:
            called.append(k)
            parts.apply(k)
    assert called == [*range(30, 30 + RECEIPT_STEPS + 1), 200]
    assert parts.next_step == injector().next_step == math.inf


def test_commands_are_filtered_only_while_a_delay_is_active() -> None:
    parts = injector(failure("delay", at_s=0.3, until_s=0.5), failure("stuck", "left_propeller", at_s=0.1))
    filters = []
    for k in range(60):
        if k >= parts.next_step:
            parts.apply(k)
        filters.append(len(parts.filters))
    assert filters == [0] * 30 + [1] * 20 + [0] * 10


def test_receipts_are_in_order_of_time_and_ends_come_first() -> None:
    parts = injector(
        failure(at_s=0.2, until_s=0.4),
        failure(at_s=0.1, until_s=0.2),
        failure("stuck", "left_propeller", at_s=0.2),
    )
    for k in range(50):
        if k >= parts.next_step:
            parts.apply(k)
    found = [(r["time_s"], r["failure"], r["active"]) for r in parts.receipts]
    assert found == [(0.1, 1, True), (0.2, 1, False), (0.2, 0, True), (0.2, 2, True), (0.4, 0, False)]


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_windows_may_touch_in_either_order(order: tuple[int, int]) -> None:
    base = {"type": "effectiveness", "actuator": "left_ruddervator"}
    both = [
        {**base, "at_s": 0.5, "until_s": 1.0, "value": 0.5},
        {**base, "at_s": 1.0, "until_s": 1.5, "value": 0.2},
    ]
    effectiveness = fly(*[both[i] for i in order]).column("left_ruddervator_effectiveness")
    assert [effectiveness[k] for k in (99, 100, 199, 200, 299, 300)] == [1.0, 0.5, 0.5, 0.2, 0.2, 1.0]


def test_when_a_signal_crosses() -> None:
    well = healthy()
    limit = 91.0
    row = int(np.argmax(well.column("heading_deg") > limit))
    assert 0 < row < len(well.flight.data) - 2
    when = {"signal": "heading_deg", "above": limit}
    flown = fly({"type": "stuck", "actuator": "left_propeller", "when": when})
    assert flown.event()["time_s"] == (row + 1) / RATES[0][0], "the step after the row that shows it"
    assert np.array_equal(flown.flight.data[: row + 1], well.flight.data[: row + 1], equal_nan=True)
    assert flown.event()["verified"] is True


def test_a_signal_that_never_crosses_says_so() -> None:
    when = {"signal": "altitude_m", "below": 200}
    flown = fly({"type": "stuck", "actuator": "left_propeller", "when": when})
    assert np.array_equal(flown.flight.data, healthy().flight.data, equal_nan=True)
    assert flown.flight.warnings == [
        "failures.0 (stuck, left_propeller) never started: altitude_m below 200 did not happen"
    ]


def test_a_signal_that_crosses_after_until_s_starts_nothing() -> None:
    when = {"signal": "heading_deg", "above": 91.0}
    row = int(np.argmax(healthy().column("heading_deg") > 91.0))
    before_s = (row - 10) / RATES[0][0]
    flown = fly({"type": "stuck", "actuator": "left_propeller", "when": when, "until_s": before_s})
    assert np.array_equal(flown.flight.data, healthy().flight.data, equal_nan=True)
    assert "never started" in flown.flight.warnings[0]


# Chance --------------------------------------------------------------------------------------------

CUTS = {"type": "intermittent", "actuator": "left_propeller", "at_s": 0.5, "off_s": 0.05, "on_s": 0.05}


def test_chance_is_the_runs_own() -> None:
    one, again, other = fly(CUTS), fly(CUTS), fly(CUTS, seed=2)
    assert np.array_equal(one.flight.data, again.flight.data, equal_nan=True)
    assert not np.array_equal(one.flight.data, other.flight.data, equal_nan=True)


@pytest.mark.parametrize(
    "inserted",
    [
        {"type": "bias", "actuator": "left_propeller", "at_s": 1.9, "value": -0.01},
        {**CUTS, "actuator": "right_propeller"},
        {"type": "property", "at_s": 1.0, "set": {"atmosphere/wind-north-fps": 1.0}},
    ],
    ids=["of another type", "of another actuator", "of no actuator"],
)
def test_an_inserted_failure_moves_no_other_ones_chance(inserted: dict[str, Any]) -> None:
    column = "left_propeller_effectiveness"
    alone, second = fly(CUTS).column(column), fly(inserted, CUTS).column(column)
    assert set(alone) == {0.0, 1.0}
    assert second.tobytes() == alone.tobytes()


def test_time_and_severity_move_no_chance() -> None:
    column = "left_propeller_effectiveness"
    alone = fly(CUTS).column(column)
    later = fly({**CUTS, "at_s": 0.55, "value": 0.25}).column(column)
    assert np.array_equal(later[110:] == 0.25, alone[100:-10] == 0.0)


def test_two_alike_draw_differently() -> None:
    alike = [failure("intermittent", "left_propeller"), failure("intermittent", "left_propeller", at_s=2.0)]
    names = list(stream_names([*alike, failure()]))
    assert names == [
        "failure/intermittent/left_propeller/0",
        "failure/intermittent/left_propeller/1",
        "failure/effectiveness/left_ruddervator/0",
    ]
