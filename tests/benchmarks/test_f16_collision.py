"""The F-16's recovery: what it survives, what it does not, and that it is a function of its start."""

from __future__ import annotations

import f16_collision
import numpy as np
import pytest

GENTLE, STEEP = np.array([[-8.0, 8.0, 0.0]]), np.array([[8.0, -8.0, 0.0]])


def test_attitudes_fill_their_ranges() -> None:
    corners = f16_collision.attitudes(np.array([[-9.0] * 3, [9.0] * 3]))
    assert corners == pytest.approx(np.array(f16_collision.RANGES).T)


def test_a_gentle_dive_is_recovered_and_a_steep_one_is_not() -> None:
    assert f16_collision.limit_state(2338.0, GENTLE)[0] > 200
    collided = f16_collision.limit_state(2338.0, STEEP)[0]
    assert -1 < collided < 0


def test_flights_do_not_depend_on_those_before() -> None:
    both = f16_collision.limit_state(2600.0, np.vstack([STEEP, GENTLE]))
    again = f16_collision.limit_state(2600.0, np.vstack([GENTLE, STEEP]))
    assert np.array_equal(both, again[::-1])


def test_there_is_no_ground_to_bounce_from() -> None:
    """A collision from 2520 ft, from where only the corner of the ranges fails: wheels on a ground would hold it above 0."""
    assert f16_collision.limit_state(2520.0, STEEP)[0] < 0 < f16_collision.limit_state(2550.0, STEEP)[0]
