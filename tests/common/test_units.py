"""The unit of a column, from the end of its name."""

from __future__ import annotations

import pytest

from testbed.common.units import unit


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        ("control_effort_per_s", "1/s"),
        ("recovery_s", "s"),
        ("u_dot_desired_m_s2", "m/s^2"),
        ("failures.0.at_s", "s"),
        ("survived", ""),
    ],
)
def test_unit(column: str, expected: str) -> None:
    assert unit(column) == expected
