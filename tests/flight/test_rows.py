"""Rows of a log by time, and stretches of a flag."""

from __future__ import annotations

import numpy as np
import pytest

from testbed.flight.rows import row_at, row_spacing_s, stretches

TIME = np.arange(100) / 200.0


@pytest.mark.parametrize(
    ("instant_s", "row"), [(0.0, 0), (0.3, 60), (0.3001, 61), (0.2999, 60), (-1.0, 0), (9.0, 100)]
)
def test_first_row_at_or_after_an_instant(instant_s: float, row: int) -> None:
    assert row_at(TIME, instant_s) == row


def test_every_step_has_its_own_row_at_any_rate() -> None:
    """Times that decimal numbers and quotients write differently are one."""
    for rate in (50, 120, 200, 1000):
        time_s = np.arange(2000) / rate
        assert [row_at(time_s, k * (1.0 / rate)) for k in range(2000)] == list(range(2000))


def test_spacing() -> None:
    assert row_spacing_s(TIME) == 0.005
    assert row_spacing_s(TIME[:1]) == 0.0


@pytest.mark.parametrize(
    ("flag", "found"),
    [
        ([], []),
        ([0, 0], []),
        ([1, 1], [(0, 2)]),
        ([0, 1, 1, 0, 1], [(1, 3), (4, 5)]),
        ([1, 0, 1, 0], [(0, 1), (2, 3)]),
    ],
)
def test_stretches(flag: list[int], found: list[tuple[int, int]]) -> None:
    assert stretches(np.array(flag, dtype=bool)) == found
