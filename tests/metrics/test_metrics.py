"""Each metric against a log of which the answer is known."""

from __future__ import annotations

import math
import re
import time
from pathlib import Path

import numpy as np
import pytest
from handmade import injection, level_log, readings_of

import testbed
from testbed.metrics import TABLE, measure, readings

RATE_HZ = 100.0


def at(time_s: float) -> int:
    return round(time_s * RATE_HZ)


def test_every_metric_says_what_it_is_and_its_unit() -> None:
    ends = ("_m", "_deg", "_m_s", "_s", "_per_s")
    for name, metric in TABLE.items():
        first = (metric.__doc__ or "").partition("\n")[0]
        unit = re.search(r"\[([^]]+)\]", metric.__doc__ or "")
        assert first and unit, name
        assert name.endswith(ends) == (unit[1] in ("m", "deg", "m/s", "s", "1/s")), name


def test_perfect_healthy_flight() -> None:
    measured = measure(readings_of(level_log()))
    for name, value in measured.items():
        if name == "survived":
            assert value == 1.0
        elif name.endswith(("_failed_m", "_failed_deg", "_failed_m_s", "_recovery_s")):
            assert math.isnan(value), name  # nothing failed
        elif name in ("detection_delay_s", "isolation_fraction") or "settling" in name:
            assert math.isnan(value), name
        else:
            assert value == 0.0, name


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


def lost(from_s: float, to_s: float = 10.0) -> dict[str, np.ndarray]:
    log = level_log()
    log["elevon_effectiveness"][at(from_s) : at(to_s)] = 0.0
    return log


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


def detection(time_s: float, delay_s: float, actuator: str = "elevon") -> dict[str, object]:
    return {"time_s": time_s, "kind": "detection", "actuator": actuator, "delay_s": delay_s}


def test_detection_delay_is_the_longest_of_first_flags() -> None:
    events = [detection(5.3, 0.3), detection(8.0, 3.0), detection(7.5, 0.5, "fan")]  # at 8 s: flagged again
    assert TABLE["detection_delay_s"](readings_of(level_log(), *events)) == 0.5


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


def test_lost_aircraft() -> None:
    assert TABLE["survived"](readings_of(level_log(), survived=False)) == 0.0


def test_one_row_and_nan_do_not_raise() -> None:
    log = {name: column[:1].copy() for name, column in level_log().items()}
    measure(readings_of(log, injection(0.0)))
    log["altitude_m"][:] = math.nan
    assert math.isnan(TABLE["altitude_error_max_m"](readings_of(log)))


def test_all_metrics_of_a_long_log_are_quick() -> None:
    of = readings_of(level_log(seconds=120.0), injection(5.0))
    assert len(of.time_s) == 12000
    best = math.inf
    for _ in range(7):
        start = time.perf_counter()
        measure(of)
        best = min(best, time.perf_counter() - start)
    assert best < 0.015


def test_metrics_of_a_run_folder_agree_with_its_summary(tmp_path: Path) -> None:
    from testbed.flight.folder import write_run_folder
    from testbed.scenario.load import load_scenario

    short = ["duration_s=8", "failures.1.at_s=6.5", "requirements=[]"]
    flown = testbed.fly(load_scenario("scenarios/left_tail_fail.yaml", short))
    loaded = testbed.load(write_run_folder(flown, tmp_path / "run"))
    assert list(loaded.actuators) == list(flown.actuators)
    np.testing.assert_equal(measure(readings(loaded)), dict(flown.metrics))
    np.testing.assert_equal(dict(loaded.metrics), dict(flown.metrics))
    assert flown.metrics["estimate_settling_ratio"] == pytest.approx(1.0, abs=0.15)
