"""What the monitor noticed and gave up, and how true the estimates were, on logs of which the answer is known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import RATE_HZ, at, injection, level_log, lost, readings_of

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


def stepped(gamma: float) -> dict[str, np.ndarray]:
    """The estimate follows a step from 1 to 0.2 as the first-order lag of (22) does."""
    log = level_log()
    after = log["time_s"] >= 5.0
    log["elevon_effectiveness"][after] = 0.2
    decay = np.exp(-gamma * (log["time_s"] - 5.0))
    log["elevon_effectiveness_estimate"] = np.where(after, 0.2 + 0.8 * decay, 1.0)
    return log


@pytest.mark.parametrize("gamma", [2.0, 4.0])
def test_settling_of_a_first_order_lag_is_as_the_paper_says(gamma: float) -> None:
    measured = measure(readings_of(stepped(gamma), gamma={"elevon": gamma}))
    assert measured["estimate_settling_s"] == pytest.approx(math.log(20) / gamma, abs=1 / RATE_HZ)
    assert measured["estimate_settling_ratio"] == pytest.approx(1.0, abs=0.02)
    rms = math.sqrt(0.64 / (2 * gamma) / 10.0)  # of an exponential, over 10 s
    assert measured["estimate_error_rms"] == pytest.approx(rms, rel=0.03)
    assert measured["estimate_error_end"] == pytest.approx(0.8 * math.exp(-gamma * 4.99))


def test_settling_is_nan_if_it_never_settles_or_no_step_was_made() -> None:
    log = stepped(4.0)
    log["elevon_effectiveness_estimate"][-1] = 0.3
    assert math.isnan(TABLE["estimate_settling_s"](readings_of(log)))
    assert math.isnan(TABLE["estimate_settling_s"](readings_of(lost(5.0))))  # a loss is for the monitor
    assert math.isnan(TABLE["estimate_settling_ratio"](readings_of(stepped(4.0), gamma={})))
