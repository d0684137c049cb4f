"""The aircraft has recovered when altitude and heading stay within 5 m and 15 deg of their references."""

from __future__ import annotations

import numpy as np
import pytest
from handmade import at, injection, level_log

from testbed.flight.breakage import recoveries, recovery_events


def off(first_s: float, end_s: float, column: str = "altitude_m", by: float = 6.0) -> dict[str, np.ndarray]:
    log = level_log(20.0)
    log[column][at(first_s) : at(end_s)] += by
    return log


@pytest.mark.parametrize(("column", "by"), [("altitude_m", 6.0), ("altitude_m", -6.0), ("heading_deg", 16.0)])
def test_from_where_both_stay_within_the_limits(column: str, by: float) -> None:
    assert recoveries(off(5, 8, column, by), [4.0], True) == [(4.0, 8.0)]


def test_an_aircraft_that_never_left_the_limits_has_recovered_at_once() -> None:
    assert recoveries(off(5, 8, by=4.9), [4.0], True) == [(4.0, 4.0)]


def test_each_failure_until_the_next_one() -> None:
    assert recoveries(off(3, 4) | {}, [2.0, 9.5], True) == [(2.0, 4.0), (9.5, 9.5)]
    assert recoveries(off(8, 12), [2.0, 9.5], True) == [(2.0, None), (9.5, 12.0)]


def test_five_seconds_at_least() -> None:
    assert recoveries(off(5, 15.5), [4.0], True) == [(4.0, None)]
    assert recoveries(off(5, 14.5), [4.0], True) == [(4.0, 14.5)]


def test_what_is_lost_or_not_a_number_has_not_recovered() -> None:
    assert recoveries(off(5, 8), [4.0], survived=False) == [(4.0, None)]
    assert recoveries(off(5, 20, by=np.nan), [4.0], True) == [(4.0, None)]
    assert recoveries(off(5, 8), [25.0], True) == [(25.0, None)]


def test_headings_the_short_way_round() -> None:
    log = level_log(20.0)
    log["heading_deg"][:], log["heading_command_deg"][:] = 5.0, 355.0
    assert recoveries(log, [4.0], True) == [(4.0, 4.0)]


def test_the_event_counts_from_the_failure() -> None:
    ends = injection(6.0, active=False)
    assert list(recovery_events(off(5, 8), [injection(4.0), ends], True)) == [
        {"time_s": 8.0, "kind": "recovered", "after_s": 4.0}
    ]
