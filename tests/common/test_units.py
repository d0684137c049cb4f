"""The unit of a column, from the end of its name."""

from __future__ import annotations

import pytest

from testbed.common.units import unit, worded


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        ("control_effort_per_s", "1/s"),
        ("recovery_s", "s"),
        ("u_dot_desired_m_s2", "m/s^2"),
        ("failures.0.at_s", "s"),
        ("survived", ""),
        ("noise_deg_s_rthz", "deg/s/sqrt(Hz)"),
    ],
)
def test_unit(column: str, expected: str) -> None:
    assert unit(column) == expected


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("value_deg_s", "value [deg/s]"),
        ("noise_m_rthz", "noise [m/sqrt(Hz)]"),
        ("natural_frequency", "natural frequency"),
    ],
)
def test_words(name: str, words: str) -> None:
    assert worded(name) == words
