"""Angles the short way round; rotations between frames, against textbook cases."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from testbed.common.angles import body_from_ned, body_from_wind, level_pitch, wrap, wrap_deg


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


def test_frames() -> None:
    turn = body_from_ned(0.3, 0.2, 1.0)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(body_from_ned(0, 0, math.pi / 2) @ [0, 1, 0], [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(body_from_ned(0, 0.1, 0) @ [0, 0, 1], [-math.sin(0.1), 0, math.cos(0.1)])
    np.testing.assert_allclose(body_from_ned(0.1, 0, 0) @ [0, 0, 1], [0, math.sin(0.1), math.cos(0.1)])
    a, b = 0.1, 0.2
    along = [math.cos(a) * math.cos(b), math.sin(b), math.sin(a) * math.cos(b)]
    np.testing.assert_allclose(body_from_wind(a, b) @ [1, 0, 0], along)


@pytest.mark.parametrize("path_angle", [0.0, 0.1, -0.2])
@pytest.mark.parametrize(("alpha", "beta", "roll"), [(0.05, 0.0, 0.0), (0.1, 0.08, 0.0), (0.06, -0.1, 0.6)])
def test_level_pitch_gives_the_path_angle(alpha: float, beta: float, roll: float, path_angle: float) -> None:
    """Through the rotations themselves: the velocity in north-east-down points down by -sin(path angle)."""
    pitch = level_pitch(alpha, beta, roll, path_angle)
    velocity = body_from_ned(roll, pitch, 1.0).T @ body_from_wind(alpha, beta) @ [1.0, 0.0, 0.0]
    assert -velocity[2] == pytest.approx(np.sin(path_angle), abs=1e-12)


def test_wings_level_pitch_is_alpha_plus_path_angle() -> None:
    assert level_pitch(0.07, 0.0, 0.0) == pytest.approx(0.07)
    assert level_pitch(0.07, 0.0, 0.0, 0.05) == pytest.approx(0.12)
