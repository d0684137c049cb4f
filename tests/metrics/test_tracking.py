"""How well references were kept, and how hard the actuators were worked, on logs of which the answer is known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import RATE_HZ, at, injection, level_log, readings_of

from testbed.metrics import TABLE, measure
from testbed.metrics.functions import Readings


@pytest.mark.parametrize(
    ("quantity", "unit"), [("altitude", "m"), ("airspeed", "m_s"), ("heading", "deg")], ids=lambda v: v
)
def test_tracking(quantity: str, unit: str) -> None:
    log = level_log()
    log[f"{quantity}_{unit}"][at(2)] -= 0.25  # healthy
    log[f"{quantity}_{unit}"][at(5) : at(7)] += 8.0  # from 5 s on; beyond each band
    log[f"{quantity}_{unit}"][-1] -= 0.125
    measured = measure(readings_of(log, injection(4.0)))
    assert measured[f"{quantity}_error_max_{unit}"] == 8.0
    assert measured[f"{quantity}_excursion_healthy_{unit}"] == 0.25
    assert measured[f"{quantity}_excursion_failed_{unit}"] == 8.0
    assert measured[f"{quantity}_error_end_{unit}"] == 0.125
    assert measured[f"{quantity}_recovery_s"] == pytest.approx(3.0)
    rms = math.sqrt((200 * 8.0**2 + 0.25**2 + 0.125**2) / 1000)
    assert measured[f"{quantity}_error_rms_{unit}"] == pytest.approx(rms)


def test_heading_error_goes_the_short_way() -> None:
    log = level_log()
    log["heading_deg"][at(3)] = 5.0  # reference 350
    log["heading_command_deg"][at(4)] = 1.0  # heading 350
    assert TABLE["heading_error_max_deg"](readings_of(log)) == 15.0


def test_recovery_counts_from_the_last_failure_and_needs_the_band_kept() -> None:
    log = level_log()
    log["altitude_m"][at(2) : at(3)] += 1.5
    log["altitude_m"][at(6)] += 1.001  # out again, for one row
    of = TABLE["altitude_recovery_s"]
    assert of(readings_of(log, injection(1.0))) == pytest.approx(5.01)
    assert of(readings_of(log, injection(1.0), injection(5.0))) == pytest.approx(1.01)
    assert of(readings_of(log, injection(7.0))) == 0.0
    assert math.isnan(of(readings_of(log, injection(7.0), survived=False)))
    log["altitude_m"][-1] += 2.0
    assert math.isnan(of(readings_of(log, injection(1.0))))


def test_excursions_of_bank_and_sideslip() -> None:
    log = level_log()
    log["roll_deg"][at(1)], log["roll_deg"][at(6)] = 50.0, -30.0
    log["beta_deg"][at(6)] = 4.0
    measured = measure(readings_of(log, injection(5.0)))
    assert (measured["roll_excursion_failed_deg"], measured["beta_excursion_failed_deg"]) == (30.0, 4.0)


def test_lost_aircraft() -> None:
    assert TABLE["survived"](readings_of(level_log(), survived=False)) == 0.0


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
