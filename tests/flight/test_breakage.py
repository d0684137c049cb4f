"""Is an actuator broken, and since when: one answer for events and metrics."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from handmade import at, injection, level_log, readings_of

from testbed.failures import TABLE as FAILURES
from testbed.flight.breakage import LOST, broken, broken_since, failure_times_s, failures_of, response
from testbed.flight.columns import stretches
from testbed.flight.events import controller_events
from testbed.metrics import measure

BIAS = [injection(1.0, type="bias", failure=0)]
LAG = [injection(2.0, type="lag", failure=1), injection(5.0, type="lag", failure=1, active=False)]
BIAS_AND_LAG = sorted(BIAS + LAG, key=lambda event: event["time_s"])


def lost(first_s: float, end_s: float, effectiveness: float = 0.0) -> dict[str, np.ndarray]:
    log = level_log()
    log["elevon_effectiveness"][at(first_s) : at(end_s)] = effectiveness
    return log


def since(log: dict[str, np.ndarray], time_s: float, *events: Any) -> float | None:
    """Since when the elevon is broken at a time; None if it is not."""
    found = float(broken_since(log, "elevon", events)[at(time_s)])
    return None if math.isnan(found) else found


def test_overlapping_failures_count_each() -> None:
    """A bias from 1 s on, and a lag from 2 to 5 s: the bias lasts when the lag has ended."""
    assert since(level_log(), 8.0, *BIAS_AND_LAG) == 1.0
    assert since(level_log(), 3.0, *BIAS_AND_LAG) == 1.0
    assert since(level_log(), 0.99, *BIAS_AND_LAG) is None
    assert since(level_log(), 4.0, *LAG) == 2.0
    assert since(level_log(), 5.0, *LAG) is None, "not broken in the row in which it ends"


def test_events_and_metrics_agree_on_it() -> None:
    """The elevon has a bias from 1 s and a lag from 2 to 5 s, and is flagged at 8 s; so is the fan, which is well."""
    log = level_log()
    for actuator in ("elevon", "fan"):
        log[f"{actuator}_failed"][at(8.0) :] = 1.0
    for axis in ("q_dot", "r_dot"):
        log[f"{axis}_released"] = np.zeros_like(log["time_s"])
    found = controller_events(log, ("elevon", "fan"), BIAS_AND_LAG)
    assert [(e["kind"], e["actuator"], e.get("delay_s")) for e in found] == [
        ("detection", "elevon", 7.0),
        ("false_alarm", "fan", None),
    ]
    measured = measure(readings_of(log, *BIAS_AND_LAG, *found))
    assert (measured["false_alarms"], measured["wrong_blames"]) == (1.0, 1.0)
    assert (measured["isolation_fraction"], measured["detection_delay_s"]) == (0.5, 7.0)


def test_reduced_effectiveness_is_broken_only_when_it_is_lost() -> None:
    event = injection(2.0, type="effectiveness")
    assert since(lost(2.0, 10.0, LOST + 0.01), 5.0, event) is None
    assert since(lost(2.0, 10.0, LOST), 5.0, event) == 2.0
    assert since(lost(2.0, 10.0), 5.0) == 2.0, "whatever the cause"


def test_a_stretch_is_unbroken_whatever_breaks_it() -> None:
    """Lost from 3 to 6 s, with a lag from 2 to 5 s: broken from 2 to 6 s without a break."""
    log = lost(3.0, 6.0)
    assert stretches(broken(log, "elevon", LAG)) == [(at(2.0), at(6.0))]
    assert since(log, 2.5, *LAG) == 2.0
    assert since(log, 5.5, *LAG) == 3.0, "a loss counts from itself"
    assert since(lost(5.1, 6.0), 5.5, *LAG) == 5.1


def test_lost_from_the_first_row() -> None:
    assert since(lost(0.0, 10.0), 5.0) == 0.0


@pytest.mark.parametrize(
    "event",
    [injection(1.0, "fan", type="stuck"), injection(1.0, None, type="property")],
    ids=["of another actuator", "of no actuator"],
)
def test_other_failures_break_other_things(event: dict[str, Any]) -> None:
    assert since(level_log(), 5.0, event) is None


def test_a_property_failure_breaks_the_actuator_that_its_receipt_names() -> None:
    assert since(level_log(), 5.0, injection(1.0, type="property")) == 1.0


def test_a_log_with_fewer_rows_than_steps() -> None:
    """Rows at 10 Hz of a flight at 100 Hz: broken from the first row after the start."""
    log = {name: column[::10] for name, column in level_log().items()}
    found = broken_since(log, "elevon", [injection(1.04, type="stuck")])
    assert np.isnan(found[:11]).all() and set(found[11:]) == {log["time_s"][11]}


def test_failures_are_active_from_their_start_to_their_end() -> None:
    fan = {"actuator": "fan", "type": "motor_stop", "failure": 1}
    events = [injection(2.0), injection(3.0, **fan), injection(5.0, **fan, active=False)]
    first, second = failures_of([*events, {"time_s": 6.0, "kind": "release", "axis": "p_dot"}])
    assert (first.number, first.actuator, first.from_s, first.until_s) == (0, "elevon", 2.0, math.inf)
    assert (second.number, second.type, second.from_s, second.until_s) == (1, "motor_stop", 3.0, 5.0)
    assert failure_times_s(events) == [2.0, 3.0]


@pytest.mark.parametrize(
    ("asked", "does"),
    [
        ({"type": "reversal"}, -1.0),
        ({"type": "stuck"}, math.nan),
        ({"type": "hardover", "to": "max"}, math.nan),
        ({"type": "command_scale", "value": 0.5}, 0.5),
        ({"type": "bias", "value": 3.0}, 1.0),
        ({"type": "lag", "lag_rad_s": 3.0}, 1.0),
    ],
)
def test_what_an_actuator_does_for_its_command(asked: dict[str, Any], does: float) -> None:
    """While it lasts, and times the effect that is left; the other actuator does what it is told."""
    failure = FAILURES[asked["type"]].model_validate(
        {"actuator": "elevon", "at_s": 2.0, "until_s": 5.0, **asked}
    )
    events = [injection(2.0, type=asked["type"]), injection(5.0, type=asked["type"], active=False)]
    log = lost(4.0, 10.0, 0.25)
    found = response(log, "elevon", failures_of(events), [failure])
    for time_s, expected in ((1.0, 1.0), (3.0, does), (4.5, 0.25 * does), (6.0, 0.25)):
        assert found[at(time_s)] == pytest.approx(expected, nan_ok=True)
    assert (response(log, "fan", failures_of(events), [failure]) == 1.0).all()
