"""Angles the short way round."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from testbed.common.angles import wrap, wrap_deg


@pytest.mark.parametrize(
    ("angle", "wrapped"),
    [
        (0.0, 0.0),
        (3.0, 3.0),
        (math.pi, -math.pi),
        (-math.pi, -math.pi),
        (4.0, 4.0 - 2 * math.pi),
        (-7.0, 2 * math.pi - 7.0),
    ],
)
def test_known_angles(angle: float, wrapped: float) -> None:
    assert wrap(angle) == pytest.approx(wrapped, abs=1e-12)


@given(st.floats(-1e4, 1e4))
def test_it_is_the_same_direction_within_half_a_turn(angle: float) -> None:
    found = wrap(angle)
    assert -math.pi <= found < math.pi
    assert math.remainder(found - angle, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


def test_arrays_as_numbers() -> None:
    angles = np.linspace(-20.0, 20.0, 101)
    assert np.array_equal(wrap(angles), [wrap(float(angle)) for angle in angles])


@given(st.floats(-180.0, 180.0))
def test_degrees_within_half_a_turn_keep_every_bit(angle: float) -> None:
    assert wrap_deg(np.array([angle]))[0] == angle


def test_degrees() -> None:
    np.testing.assert_allclose(wrap_deg(np.array([190.0, -190.0, 359.0, 720.5])), [-170.0, 170.0, -1.0, 0.5])
