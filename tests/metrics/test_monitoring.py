"""What the monitor noticed and gave up, on logs of which the answer is known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import at, injection, level_log, lost, readings_of

from testbed.metrics import TABLE, measure, unjudged


def detection(time_s: float, delay_s: float, actuator: str = "elevon") -> dict[str, object]:
    return {"time_s": time_s, "kind": "detection", "actuator": actuator, "delay_s": delay_s}


def test_missed_detections() -> None:
    missed = TABLE["missed_detections"]
    assert missed(readings_of(lost(5.0))) == 1.0
    assert missed(readings_of(lost(5.0, 7.0))) == 0.0  # not longer than 2 s
    assert missed(readings_of(lost(5.0, 7.01))) == 1.0
    log = lost(5.0)
    log["elevon_failed"][at(9) :] = 1.0
    assert missed(readings_of(log)) == 0.0
    log = lost(5.0)
    log["fan_failed"][at(6) :] = 1.0  # the wrong one
    log["elevon_failed"][: at(5)] = 1.0  # before it was lost
    assert missed(readings_of(log)) == 1.0


def test_detection_delay_is_the_longest_of_first_flags() -> None:
    events = [detection(5.3, 0.3), detection(8.0, 3.0), detection(7.5, 0.5, "fan")]  # at 8 s: flagged again
    assert TABLE["detection_delay_s"](readings_of(level_log(), *events)) == 0.5


@pytest.mark.parametrize(
    ("column", "silent"),
    [
        ("failed", {"detection_delay_s", "missed_detections", "false_alarms", "wrong_blames", "isolation_fraction"}),
        ("effectiveness_estimate", {"estimate_error_rms", "estimate_error_end", "estimate_settling_s",
                                    "estimate_settling_ratio"}),
        ("released", {"goal_switches", "released_time_s"}),
    ],
)  # fmt: skip
def test_what_a_controller_does_not_say_is_not_measured(column: str, silent: set[str]) -> None:
    log = lost(5.0)
    before = measure(readings_of(log))
    for name in [name for name in log if name.endswith(f"_{column}")]:
        log[name][:] = math.nan
    after = measure(readings_of(log))
    assert all(math.isnan(after[name]) for name in silent) and silent <= unjudged(log)
    others = [name for name in TABLE if name not in silent]
    assert np.array_equal([after[n] for n in others], [before[n] for n in others], equal_nan=True)


def test_isolation() -> None:
    alarm = {"time_s": 6.0, "kind": "false_alarm", "actuator": "fan"}
    early = {"time_s": 1.0, "kind": "false_alarm", "actuator": "fan"}
    measured = measure(readings_of(lost(5.0), early, detection(5.5, 0.5), alarm))
    assert measured["false_alarms"] == 2.0
    assert measured["wrong_blames"] == 1.0  # nothing was broken at 1 s
    assert measured["isolation_fraction"] == pytest.approx(1 / 3)


def test_wrong_blame_while_a_failure_of_another_kind_lasts() -> None:
    alarm = {"time_s": 6.0, "kind": "false_alarm", "actuator": "fan"}
    stuck, freed = injection(5.0, type="stuck"), injection(5.5, type="stuck", active=False)
    wrong = TABLE["wrong_blames"]
    assert wrong(readings_of(level_log(), stuck, alarm)) == 1.0
    assert wrong(readings_of(level_log(), stuck, freed, alarm)) == 0.0


def test_wrong_blame_in_a_log_that_ends_before_the_event() -> None:
    """A log with few rows may have none at or after the last step."""
    log = {name: column[:901] for name, column in lost(5.0).items()}
    alarm = {"time_s": 9.5, "kind": "false_alarm", "actuator": "fan"}
    assert TABLE["wrong_blames"](readings_of(log, alarm)) == 1.0


def test_released_axes() -> None:
    log = level_log()
    log["p_dot_released"][at(2) : at(3)] = 1.0  # there and back
    log["u_dot_released"][at(8) :] = 1.0
    measured = measure(readings_of(log))
    assert measured["goal_switches"] == 3.0
    assert measured["released_time_s"] == pytest.approx(3.0)
