"""Modelled servos and motors against the closed form, the design model's propeller, and numpy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter
from vtail_setup import DT, axial, records_of, state, vtail_setup

from testbed.controllers.actuator_model import (
    advance_actuators,
    advance_motor,
    advance_servo,
    axial_speed,
    coefficient,
    fourth,
    throttle_for,
    thrust_and_slope,
)

SETUP = vtail_setup()
MODEL = SETUP.model
AXIAL = axial(MODEL)
LEFT_TAIL, LEFT_PROPELLER = 0, 2


def test_axial_speed_is_the_component_along_the_body_axis() -> None:
    y = state(airspeed=20.0, alpha=0.1, beta=-0.2)
    assert axial_speed(y) == pytest.approx(20.0 * np.cos(0.1) * np.cos(0.2))


def test_a_slow_servo_is_a_bilinear_first_order_lag() -> None:
    m, _, _, s, _ = records_of(SETUP)
    s.position[:] = s.servo_input[:] = s.servo_lagged[:] = 0.0
    commands = 0.02 * np.random.default_rng(0).normal(size=200)  # rad; too small for the rate limit
    positions = []
    for command in commands:
        s.command[LEFT_TAIL] = command
        advance_servo(LEFT_TAIL, DT, m, s)
        positions.append(s.position[LEFT_TAIL])
    w = m.lag[LEFT_TAIL] * DT
    inputs = commands / m.scale[LEFT_TAIL]
    assert positions == pytest.approx(lfilter([w, w], [2.0 + w, w - 2.0], inputs), abs=1e-12)


def test_rate_limit_and_stops() -> None:
    m, _, _, s, _ = records_of(SETUP)
    m.rate[LEFT_TAIL] = 2.0
    s.position[LEFT_TAIL] = s.servo_input[LEFT_TAIL] = s.servo_lagged[LEFT_TAIL] = 0.0
    s.command[LEFT_TAIL] = 10.0
    for step in range(1, 101):
        advance_servo(LEFT_TAIL, DT, m, s)
        limited = min(step * 2.0 * DT, m.high[LEFT_TAIL])
        assert s.position[LEFT_TAIL] <= limited + 1e-12
    assert s.position[LEFT_TAIL] == pytest.approx(100 * 2.0 * DT, abs=0.02)
    for _ in range(1000):
        advance_servo(LEFT_TAIL, DT, m, s)
    assert s.position[LEFT_TAIL] == m.high[LEFT_TAIL]


def test_coefficients_are_interpolated_and_constant_beyond_the_table() -> None:
    m = records_of(SETUP).m
    propulsor = MODEL.propulsors[LEFT_PROPELLER]
    assert propulsor is not None
    grid = np.linspace(*propulsor.advance, len(propulsor.thrust))
    for ratio in np.linspace(propulsor.advance[0] - 0.2, propulsor.advance[1] + 0.2, 57):
        value = coefficient(LEFT_PROPELLER, m.c_thrust, ratio, m)
        assert value == pytest.approx(np.interp(ratio, grid, propulsor.thrust), abs=1e-12)


@pytest.mark.parametrize("thrust", [-1.0, 0.5, 3.0, 8.0, 12.0])
def test_the_throttle_for_a_thrust_gives_that_thrust(thrust: float) -> None:
    """Newton's answer flown until the rotor is steady, and its rotor speed by bisection."""
    m, _, _, s, _ = records_of(SETUP)
    s.command[LEFT_PROPELLER] = throttle_for(LEFT_PROPELLER, thrust, AXIAL, m, s)
    assert 0.0 < s.command[LEFT_PROPELLER] < 1.0
    for _ in range(2000):
        advance_motor(LEFT_PROPELLER, DT, AXIAL, m, s)
    propulsor = MODEL.propulsors[LEFT_PROPELLER]
    assert propulsor is not None
    assert s.position[LEFT_PROPELLER] * m.scale[LEFT_PROPELLER] == pytest.approx(thrust, abs=2e-3)
    wanted = propulsor.speed_at(thrust, AXIAL, MODEL.density_kg_m3)
    assert s.rotor[LEFT_PROPELLER] == pytest.approx(wanted, rel=1e-4)
    torque, _ = propulsor.torque_at(thrust, AXIAL, MODEL.density_kg_m3)
    assert s.torque[LEFT_PROPELLER] == pytest.approx(torque, rel=1e-3, abs=1e-5)


def test_beyond_what_the_tables_have_the_throttle_stays_at_their_ends() -> None:
    """More than full throttle gives is full throttle; less than a windmilling propeller gives is that of windmilling."""
    m, _, _, s, _ = records_of(SETUP)
    assert throttle_for(LEFT_PROPELLER, 100.0, AXIAL, m, s) == 1.0
    propulsor = MODEL.propulsors[LEFT_PROPELLER]
    assert propulsor is not None
    slowest = AXIAL / (propulsor.diameter_m * propulsor.advance[1])
    windmilling, _ = thrust_and_slope(LEFT_PROPELLER, slowest, AXIAL, m)
    least = throttle_for(LEFT_PROPELLER, -100.0, AXIAL, m, s)
    assert least == pytest.approx(throttle_for(LEFT_PROPELLER, windmilling, AXIAL, m, s), rel=1e-6)


def test_thrust_and_its_slope() -> None:
    m = records_of(SETUP).m
    propulsor = MODEL.propulsors[LEFT_PROPELLER]
    assert propulsor is not None
    for thrust in (1.0, 4.0, 9.0):
        n = propulsor.speed_at(thrust, AXIAL, MODEL.density_kg_m3)
        value, slope = thrust_and_slope(LEFT_PROPELLER, n, AXIAL, m)
        assert value == pytest.approx(thrust, rel=1e-9)
        faster = propulsor.speed_at(thrust + 1e-3, AXIAL, MODEL.density_kg_m3)
        assert slope == pytest.approx(1e-3 / (faster - n), rel=0.02)


def test_a_trimmed_flight_stays_trimmed() -> None:
    """The memory that a flight begins with is steady: a second of trim commands moves nothing."""
    m, c, _, s, _ = records_of(SETUP)
    before = s.position.copy()
    for _ in range(200):
        advance_actuators(c.dt, AXIAL, m, s)
    assert s.position == pytest.approx(before, abs=2e-4)


def test_fourth_power() -> None:
    assert fourth(3.0) == 81.0
