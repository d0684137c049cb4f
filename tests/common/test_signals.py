"""Rows of numbers, read by name: the same memory."""

from __future__ import annotations

import numpy as np

from testbed.common.signals import (
    RATES,
    SETPOINT,
    STATE,
    TELEMETRY,
    as_records,
    record_dtype,
    telemetry_width,
)


def test_a_record_is_a_view_of_its_row() -> None:
    rows = np.arange(2.0 * len(STATE)).reshape(2, -1)
    records = as_records(rows, STATE)
    assert [records[1][name] for name in STATE] == list(rows[1])
    rows[0, STATE.index("alpha")] = -1.0
    assert records[0].alpha == -1.0
    records[1].u_dot = -2.0
    assert rows[1, STATE.index("u_dot")] == -2.0


def test_a_dtype_is_made_once() -> None:
    """numba knows it again by its identity."""
    assert record_dtype(SETPOINT) is record_dtype(SETPOINT)
    assert record_dtype(SETPOINT) is not record_dtype(STATE)


def test_names_are_distinct_and_rates_are_part_of_the_state() -> None:
    for names in (STATE, RATES, SETPOINT, TELEMETRY):
        assert len(set(names)) == len(names)
    assert set(RATES) <= set(STATE)
    assert telemetry_width(4) == 4 * len(TELEMETRY) + 2 * len(RATES)
