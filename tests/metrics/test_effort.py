"""How hard the actuators were worked, on logs of which the answer is known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import RATE_HZ, at, level_log, readings_of

from testbed.metrics import TABLE
from testbed.metrics.flight_view import Readings


def test_control_effort() -> None:
    log = level_log()
    log["elevon_command"] += np.where(log["time_s"] < 4.0, 5.0 * log["time_s"], 20.0)  # 0.5 scales/s for 4 s
    log["fan_command"][at(6) :] += 2.0  # one scale in one row
    expected = 0.5**2 * 4.0 + 1.0**2 * RATE_HZ
    assert TABLE["control_effort_per_s"](readings_of(log)) == pytest.approx(expected, rel=1e-3)


def test_saturated_time() -> None:
    log = level_log()
    log["elevon_command"][at(1) : at(2)] = 20.0
    log["fan_command"][at(1.5) : at(3)] = 0.0  # overlaps by 0.5 s
    log["fan_command"][at(6) : at(9)] = 8.0
    log["fan_failed"][at(7) :] = 1.0  # not counted once flagged
    assert TABLE["saturated_time_s"](readings_of(log)) == pytest.approx(3.0)


def test_without_scale_or_stops_there_is_no_number() -> None:
    """As of a run folder whose summary does not say them."""
    bare = Readings(level_log(), (), {"elevon": {"kind": "servo"}})
    assert math.isnan(TABLE["control_effort_per_s"](bare))
    assert math.isnan(TABLE["saturated_time_s"](bare))
