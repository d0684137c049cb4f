"""The first control step at or after a time."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from testbed.common.clock import first_step_at


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
