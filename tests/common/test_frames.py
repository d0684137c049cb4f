"""Rotations between frames, against textbook cases."""

from __future__ import annotations

import math

import numpy as np

from testbed.common.frames import body_from_ned, body_from_wind


def test_frames() -> None:
    turn = body_from_ned(0.3, 0.2, 1.0)
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(body_from_ned(0, 0, math.pi / 2) @ [0, 1, 0], [1, 0, 0], atol=1e-15)
    np.testing.assert_allclose(body_from_ned(0, 0.1, 0) @ [0, 0, 1], [-math.sin(0.1), 0, math.cos(0.1)])
    np.testing.assert_allclose(body_from_ned(0.1, 0, 0) @ [0, 0, 1], [0, math.sin(0.1), math.cos(0.1)])
    a, b = 0.1, 0.2
    along = [math.cos(a) * math.cos(b), math.sin(b), math.sin(a) * math.cos(b)]
    np.testing.assert_allclose(body_from_wind(a, b) @ [1, 0, 0], along)
