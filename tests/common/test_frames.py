"""Rotations between frames, against textbook cases."""

from __future__ import annotations

import math

import numpy as np
import pytest

from testbed.common.frames import body_from_ned, body_from_wind, level_pitch


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
