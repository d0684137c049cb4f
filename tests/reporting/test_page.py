"""What the page of a flight is given: phases, packed columns, panels."""

from __future__ import annotations

import base64
import math
import zlib
from typing import Any

import numpy as np
import pytest
from handmade import at, flight_of, injection, level_log, lost

from testbed.flight.breakage import noticed_s
from testbed.flight.requirements import judge
from testbed.reporting.page import MOST_ROWS, groups, packed, phases
from testbed.reporting.panels import error_columns
from testbed.reporting.run_report import unmet
from testbed.scenario.requirement import Requirement


def unpacked(log: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The columns as the script in the page decodes them."""
    told, text = packed(log)
    data = np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8)
    half = len(data) // 2
    words = (data[:half] + 256 * data[half:].astype(np.uint16)).reshape(-1, told["rows"])
    numbers = np.cumsum(words, axis=1, dtype=np.uint16)
    return {
        column["name"]: np.where(row == 65535, np.nan, column["low"] + column["step"] * row)
        for column, row in zip(told["columns"], numbers, strict=True)
    }


def test_a_short_log_comes_back_to_16_bits() -> None:
    time = np.arange(1000) / 100.0
    log = {"time_s": time, "a": 30.0 * np.sin(time), "flat": np.full(1000, 7.5)}
    found = unpacked(log)
    assert np.abs(found["a"] - log["a"]).max() <= 0.5 * 60.0 / 65534 * 1.001
    assert np.array_equal(found["flat"], log["flat"])
    assert found["time_s"] == pytest.approx(time, abs=1e-4)


def test_what_is_not_a_number_stays_so() -> None:
    values = np.arange(10.0)
    values[3], values[7] = np.nan, np.inf
    found = unpacked({"time_s": np.arange(10.0), "a": values})["a"]
    assert np.isnan(found[[3, 7]]).all() and np.isfinite(np.delete(found, [3, 7])).all()
    assert np.isnan(unpacked({"time_s": np.arange(10.0), "a": np.full(10, np.nan)})["a"]).all()


def test_a_long_log_is_thinned_and_keeps_its_last_row_and_its_envelope() -> None:
    n = 4 * MOST_ROWS + 3
    rng = np.random.default_rng(1)
    log = {"time_s": np.arange(n) / 200.0, "noise": rng.normal(size=n), "slow": np.linspace(0, 1, n)}
    found = unpacked(log)
    assert len(found["slow"]) <= MOST_ROWS + 1
    assert found["slow"][-1] == pytest.approx(1.0)
    inner = log["noise"][: n - 8]
    assert (found["noise"].min(), found["noise"].max()) == pytest.approx((inner.min(), inner.max()), abs=3e-3)


NOTICED = {"time_s": 3.0, "kind": "detection", "actuator": "elevon", "delay_s": 1.0}


def named(*events: dict[str, object], end_s: float = 10.0) -> list[tuple[str, float, float]]:
    noticed_s = [float(str(e["time_s"])) for e in events if e["kind"] == "detection"]
    found = phases(sorted(events, key=lambda e: float(str(e["time_s"]))), end_s, 10.0, noticed_s)
    return [(p["name"], p["from_s"], p["until_s"]) for p in found]


def test_phases_of_a_failure_that_is_noticed_and_recovered_from() -> None:
    recovered = {"time_s": 5.0, "kind": "recovered", "after_s": 3.0}
    assert named(injection(2.0), NOTICED, recovered) == [
        ("healthy", 0.0, 2.0),
        ("unnoticed", 2.0, 3.0),
        ("flagged", 3.0, 5.0),
        ("recovered", 5.0, 10.0),
    ]


def test_what_never_left_its_limits_was_held_and_not_recovered() -> None:
    held = {"time_s": 2.0, "kind": "recovered", "after_s": 0.0}
    assert named(injection(2.0), NOTICED, held)[-2:] == [("unnoticed", 2.0, 3.0), ("held", 3.0, 10.0)]
    assert named(injection(2.0), held) == [("healthy", 0.0, 2.0), ("unseen", 2.0, 10.0)]


def test_a_loss_is_noticed_by_a_flag_or_by_half_of_it_in_the_estimate() -> None:
    log = lost(2.0)
    assert noticed_s(flight_of(log, [injection(2.0)])) == []
    assert noticed_s(flight_of(log, [injection(2.0), NOTICED])) == [3.0]
    log["elevon_effectiveness_estimate"][at(4) :] = 0.6
    assert noticed_s(flight_of(log, [injection(2.0)])) == []
    log["elevon_effectiveness_estimate"][at(5) :] = 0.5
    assert noticed_s(flight_of(log, [injection(2.0)])) == [5.0]


def test_a_lost_flight_is_lost_from_its_end_on() -> None:
    loss = {"time_s": 6.0, "kind": "lost", "limits": [], "at_stop": []}
    assert named(injection(2.0), loss, end_s=6.0) == [
        ("healthy", 0.0, 2.0),
        ("unnoticed", 2.0, 6.0),
        ("lost", 6.0, 10.0),
    ]


def test_what_ended_unnoticed_leaves_what_was_broken_before() -> None:
    second = {"actuator": "fan", "type": "motor_stop", "failure": 1}
    short = (injection(5.0, **second), injection(6.0, **second, active=False))
    assert named(injection(2.0), NOTICED, *short)[-2:] == [("unnoticed", 5.0, 6.0), ("flagged", 6.0, 10.0)]
    assert named(injection(2.0), *short)[-2:] == [("unnoticed", 2.0, 5.0), ("unnoticed", 5.0, 10.0)]
    assert named(*short)[-2:] == [("unnoticed", 5.0, 6.0), ("healthy", 6.0, 10.0)]


def test_nothing_broken_is_healthy_all_the_time() -> None:
    assert named() == [("healthy", 0.0, 10.0)]


def test_no_estimate_is_drawn_where_the_controller_makes_none() -> None:
    without, estimated = lost(2.0), lost(2.0)
    estimated["elevon_effectiveness_estimate"][400:] = 0.5
    for log, count in ((estimated, 2), (without, 1)):
        flight = flight_of(log, [injection(2.0)])
        made = {g["name"]: g["panels"] for g in groups(flight, log | error_columns(log))}
        assert all(len(panel["series"]) == count for panel in made["effectiveness"])


def test_a_rate_of_which_the_log_has_no_desired_value_is_drawn_alone() -> None:
    log = level_log()
    del log["p_dot_desired_deg_s2"]
    made = {g["name"]: g["panels"] for g in groups(flight_of(log), log | error_columns(log))}
    assert {panel["title"]: len(panel["series"]) for panel in made["rates"]} == {
        "p_dot [deg/s^2]": 1,
        "u_dot [m/s^2]": 2,
    }


def test_bands_of_requirements_and_the_stretches_that_miss_them() -> None:
    log = level_log()
    log["altitude_m"][at(5) : at(6)] += 2.0
    within = Requirement(signal="altitude_m", within=1.0, of="altitude_command_m", from_s=4.0, until_s=8.0)
    flight = flight_of(log, requirements=judge([within], log, {}))
    object.__setattr__(flight.scenario, "requirements", (within,))
    panels = {g["name"]: g["panels"] for g in groups(flight, log | error_columns(log))}
    (altitude,) = (p for p in panels["errors"] if p["title"].startswith("altitude"))
    assert altitude["bands"] == [{"from_s": 4.0, "until_s": 8.0, "low": -1.0, "high": 1.0, "passed": False}]
    (missed,) = altitude["missed"]
    assert (missed["from_s"], missed["until_s"]) == pytest.approx((5.0, 5.99))


def test_the_verdict_names_what_was_not_met_and_leads_to_its_worst_moment() -> None:
    log = level_log()
    log["altitude_m"][at(5) : at(6)], log["altitude_m"][at(5.5)] = 102.0, 103.0
    asked = (
        Requirement(name="level", signal="altitude_m", within=1.0, of="altitude_command_m"),
        Requirement(name="found <b>", metric="detection_delay_s", at_most=1.0),
        Requirement(name="straight", signal="heading_deg", within=1.0, of="heading_command_deg"),
    )
    flight = flight_of(log, requirements=judge(asked, log, {"detection_delay_s": math.nan}))
    object.__setattr__(flight.scenario, "requirements", asked)
    assert unmet(flight) == (
        ' Not met: <a href="#requirements" data-go="5.500">level, worst at 5.5 s</a>; '
        '<a href="#requirements">found &lt;b&gt;</a>.'
    )


@pytest.mark.parametrize(
    ("key", "begins_s", "missed_at_s"),
    [
        ({"settles_by_s": 5.5}, 5.5, [5.5, 7.0]),
        ({"never_for_longer_than_s": 0.7}, 0.0, [5.0]),
        ({"eventually": True}, 0.0, []),
    ],
)
def test_stretches_that_a_requirement_allows_are_not_marked(
    key: dict[str, Any], begins_s: float, missed_at_s: list[float]
) -> None:
    log = level_log()
    for begin, end in ((5.0, 6.0), (7.0, 7.5)):
        log["altitude_m"][at(begin) : at(end)] += 2.0
    within = Requirement(signal="altitude_m", within=1.0, of="altitude_command_m", **key)
    flight = flight_of(log, requirements=judge([within], log, {}))
    object.__setattr__(flight.scenario, "requirements", (within,))
    altitude = groups(flight, log | error_columns(log))[0]["panels"][0]
    assert altitude["bands"][0]["from_s"] == begins_s
    assert [missed["from_s"] for missed in altitude["missed"]] == pytest.approx(missed_at_s)
