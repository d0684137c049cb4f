"""The map of an engine: between its points, beyond them, where it is not monotone, and where it falls off."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from testbed.aircraft.propulsors import ENGINE_SPEEDS, ENGINE_THROTTLES, EngineMap, Propulsor

THROTTLES = tuple(np.linspace(0.0, 1.0, ENGINE_THROTTLES))
SPEEDS = tuple(np.linspace(30.0, 70.0, ENGINE_SPEEDS))


def engine(thrust) -> EngineMap:
    """An engine with this thrust as a function of throttle and airspeed."""
    rows = tuple(tuple(float(thrust(t, v)) for t in THROTTLES) for v in SPEEDS)
    return EngineMap(THROTTLES, SPEEDS, rows, lag_rad_s=2.0, rise_s=0.5, fall_s=1.0)


LINEAR = engine(lambda t, v: 1000.0 * t - 2.0 * v)
WINDMILLING = engine(lambda t, v: -400.0 - 1000.0 * t if t < 0.5 else -300.0 + 2000.0 * (t - 0.5))
"""As that of c310: thrust falls with throttle, jumps at a half, and rises from there."""


@pytest.mark.parametrize("throttle", [0.0, 0.13, 0.5, 0.99, 1.0])
@pytest.mark.parametrize("airspeed", [30.0, 41.7, 70.0])
def test_thrust_and_throttle_are_each_others_inverse(throttle: float, airspeed: float) -> None:
    thrust = LINEAR.thrust_at(throttle, airspeed)
    assert thrust == pytest.approx(1000.0 * throttle - 2.0 * airspeed)
    assert LINEAR.throttle_for(thrust, airspeed) == pytest.approx(throttle)


def test_beyond_the_map_the_nearest_is_taken() -> None:
    assert LINEAR.throttle_for(5000.0, 50.0) == 1.0
    assert LINEAR.throttle_for(-5000.0, 50.0) == 0.0
    assert LINEAR.thrust_at(0.5, 10.0) == LINEAR.thrust_at(0.5, 30.0)


def test_where_thrust_falls_with_throttle_the_rising_part_is_used() -> None:
    assert WINDMILLING.throttle_for(200.0, 50.0) == pytest.approx(0.75)
    assert WINDMILLING.throttle_for(-2000.0, 50.0) >= 7 / 16, "not below the throttle of the least thrust"
    assert WINDMILLING.thrust_at(0.25, 50.0) == pytest.approx(-650.0), "though the map knows it"


def test_the_thrust_below_a_cliff_is_not_useful() -> None:
    assert WINDMILLING.least_useful_n == pytest.approx(-300.0)
    assert LINEAR.least_useful_n == pytest.approx(-100.0), "without a cliff it is the least"


def test_a_curved_map_has_no_cliff() -> None:
    assert engine(lambda t, v: 1000.0 * t * t).least_useful_n == 0.0


def test_the_least_thrust_follows_airspeed() -> None:
    assert LINEAR.least_thrust(np.array([30.0, 50.0]), 1.2) == pytest.approx([-60.0, -100.0])


def test_the_most_thrust_is_that_of_full_throttle() -> None:
    assert LINEAR.most_thrust(np.array([30.0, 50.0]), 1.2) == pytest.approx([940.0, 900.0])


def test_the_most_thrust_of_a_propeller_is_where_the_motor_drives_no_faster() -> None:
    """C_T = 0.1 - 0.1 J and C_Q = 0.01: n^2 rho D^5 C_Q is the motor's torque at its full voltage, quadratic in n."""
    motor = Propulsor((0.0, 1.0), (0.1, 0.0), (0.01, 0.01), 0.5, 1e-4, 20.0, 4.0, 0.04, 0.2, 0.5)
    load, back, stall = 1.2 * 0.5**5 * 0.01, 0.04 / (4.0 * 0.2), 0.04 * (20.0 / 0.2 - 0.5)
    n = (-back + math.sqrt(back * back + 4.0 * load * stall)) / (2.0 * load)
    speeds = np.array([0.0, 0.4 * n * 0.5])
    expected = 1.2 * n * n * 0.5**4 * np.array([0.1, 0.06])
    assert motor.most_thrust(speeds, 1.2) == pytest.approx(expected, rel=1e-9)


def test_a_rate_limit_makes_small_changes_slower() -> None:
    """A twentieth of the range at half the range a second: 63 % in 0.063 s, and the lag's 0.5 s."""
    assert LINEAR.small_lag_rad_s == pytest.approx(1.0 / (0.5 + 0.063))
    assert replace(LINEAR, rise_s=1e9, fall_s=1e9).small_lag_rad_s == pytest.approx(2.0)


def test_a_throttle_that_stays_gives_less_thrust_at_a_higher_airspeed() -> None:
    """Throttle 0.5 of LINEAR, 440 N at 30 m/s; and 100 N more than full throttle gives stay 100 N more."""
    others = np.array([30.0, 40.0, 70.0])
    assert LINEAR.at_same_throttle(440.0, 30.0, others, 1.2) == pytest.approx([440.0, 420.0, 360.0])
    assert LINEAR.at_same_throttle(1040.0, 30.0, others, 1.2) == pytest.approx([1040.0, 1020.0, 960.0])


def test_a_motor_at_full_throttle_stays_at_full_throttle() -> None:
    motor = Propulsor((0.0, 1.0), (0.1, 0.0), (0.01, 0.01), 0.5, 1e-4, 20.0, 4.0, 0.04, 0.2, 0.5)
    others = np.array([4.0, 8.0, 12.0])
    full = motor.most_thrust(others, 1.2)
    assert motor.at_same_throttle(float(full[1]), 8.0, others, 1.2) == pytest.approx(full)
    half = motor.at_same_throttle(0.5 * float(full[1]), 8.0, others, 1.2)
    assert half[1] == pytest.approx(0.5 * full[1]) and half[0] > half[1] > half[2]
    more = motor.at_same_throttle(float(full[1]) + 1.0, 8.0, others, 1.2)
    assert more == pytest.approx(full + 1.0), "what no throttle gives is a constant beside it"
