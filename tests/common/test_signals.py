"""Rows of numbers, read by name: the same memory."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from testbed.common.signals import (
    BELIEFS,
    GUARDED,
    RATES,
    SETPOINT,
    STATE,
    TELEMETRY,
    Belief,
    as_records,
    first_step_at,
    record_dtype,
    telemetry_rows,
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
    assert telemetry_width(4) == 4 * len(TELEMETRY) + 2 * len(RATES) + 4 * len(BELIEFS) + len(GUARDED)


def test_what_a_controller_does_not_fill_is_not_said() -> None:
    rows = telemetry_rows(3, 4)
    assert rows.shape == (3, telemetry_width(4))
    assert np.isnan(rows).all()


def test_every_belief_is_explained() -> None:
    assert len({belief.meaning for belief in Belief}) == len(Belief)


@pytest.mark.parametrize(
    ("time_s", "rate_hz", "step"),
    [(0.0, 200, 0), (0.3, 200, 60), (0.301, 200, 61), (5.005, 200, 1001), (1e-12, 200, 0)],
)
def test_known_times(time_s: float, rate_hz: float, step: int) -> None:
    assert first_step_at(time_s, rate_hz) == step


@given(st.integers(0, 10**6), st.integers(1, 2000))
def test_the_time_of_a_step_is_that_step(step: int, rate_hz: int) -> None:
    """Whatever rounding k / rate does."""
    assert first_step_at(step / rate_hz, rate_hz) == step


@given(st.floats(0.0, 1e4), st.integers(1, 1000))
def test_it_is_the_first_that_is_not_before(time_s: float, rate_hz: int) -> None:
    step = first_step_at(time_s, rate_hz)
    assert step >= time_s * rate_hz - 1e-6
    assert step - 1 < time_s * rate_hz
