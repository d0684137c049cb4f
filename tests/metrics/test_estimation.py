"""How true the estimates were, on logs of which the answer is known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import RATE_HZ, level_log, lost, readings_of

from testbed.metrics import TABLE, measure


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
