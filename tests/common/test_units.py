"""The unit of a name, from its end, and the name in words."""

from __future__ import annotations

import pytest

from testbed.common.units import unit, worded


@pytest.mark.parametrize(
    ("name", "expected", "words"),
    [
        ("control_effort_per_s", "1/s", "control effort [1/s]"),
        ("recovery_s", "s", "recovery [s]"),
        ("u_dot_desired_m_s2", "m/s^2", "u dot desired [m/s^2]"),
        ("noise_deg_s_rthz", "deg/s/sqrt(Hz)", "noise [deg/s/sqrt(Hz)]"),
        ("survived", "", "survived"),
    ],
)
def test_unit_and_words(name: str, expected: str, words: str) -> None:
    assert (unit(name), worded(name)) == (expected, words)
    assert unit(f"failures.0.{name}") == expected
