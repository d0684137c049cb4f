"""Servos, motors and engines as the controller models them: the positions to which the commands so far have moved the actuators.

The regressor of the adaptive law uses these positions, so that lag, rate limits and stops are not mistaken for lost
effectiveness: with them, (18) holds for any command.

Letters: those of `records`. Propeller: T = rho n^2 D^4 C_T(J) and Q = rho n^2 D^5 C_Q(J) with J = axial / (n D), rotor
speed n in rev/s. Motor: current I = (voltage - n/K_v)/R, torque K_t (I - i_0). Engine: thrust from a table over throttle and
airspeed, for the throttle that the engine has followed so far.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled

NEWTON_STEPS = 4
"""Steps of `throttle_for`. Few are enough, because it begins at the rotor's present speed."""
STILL = 0.1
"""Rotor speed that is as good as none, and by which can be divided [rev/s]."""


@compiled
def axial_speed(y):
    """Component of airspeed along the body's x axis [m/s]."""
    return y.airspeed * math.cos(y.alpha) * math.cos(y.beta)


@compiled
def advance_actuators(dt, axial, m, s):
    """Advance the model of each actuator by one control step with its command in `s.command`."""
    for i in range(len(s.command)):
        if m.servo[i]:
            advance_servo(i, dt, m, s)
        elif m.engine[i]:
            advance_engine(i, dt, axial, m, s)
        else:
            advance_motor(i, dt, axial, m, s)


@compiled
def advance_servo(i, dt, m, s):
    """Advance the position [scaled] of servo i by one step: first-order lag (bilinear), then rate limit, then stops."""
    x = s.command[i] / m.scale[i]
    a = m.lag[i] * dt
    lagged = (a * (x + s.servo_input[i]) + (2.0 - a) * s.servo_lagged[i]) / (2.0 + a)
    s.servo_input[i] = x
    s.servo_lagged[i] = lagged
    most = m.rate[i] * dt
    step = min(max(lagged - s.position[i], -most), most)
    s.position[i] = min(max(s.position[i] + step, m.low[i]), m.high[i])


@compiled
def advance_motor(i, dt, axial, m, s):
    """Advance thrust [scaled], motor torque [N m] and rotor speed [rev/s] of motor i by one step with its throttle.

    The airframe feels the torque of the motor at once, and the thrust with the rotor's lag.
    """
    n = s.rotor[i]
    diameter = m.diameter[i]
    unit_thrust = m.density * n * n * fourth(diameter)
    advance_ratio = axial / max(n * diameter, 1e-3)
    current = (s.command[i] * m.max_volts[i] - n / m.k_v[i]) / m.resistance[i]
    torque = m.k_t[i] * (current - m.no_load_current[i])
    load = unit_thrust * diameter * coefficient(i, m.c_torque, advance_ratio, m)
    s.position[i] = unit_thrust * coefficient(i, m.c_thrust, advance_ratio, m) / m.scale[i]
    s.torque[i] = torque
    s.rotor[i] = max(n + dt * (torque - load) / (2.0 * math.pi * m.rotor_inertia[i]), 0.0)


@compiled
def advance_engine(i, dt, axial, m, s):
    """Advance thrust [scaled] and followed throttle of engine i by one step: the throttle is followed with a lag, at limited
    rates."""
    row, part = row_of(axial, m.speeds[i])
    last = m.throttles.shape[1] - 1
    x, column = min(max(s.followed[i], m.throttles[i, 0]), m.throttles[i, last]), 0
    while column < last - 1 and m.throttles[i, column + 1] < x:
        column += 1
    below, above = (
        between(i, row, part, column, m.thrust_map),
        between(i, row, part, column + 1, m.thrust_map),
    )
    share = (x - m.throttles[i, column]) / (m.throttles[i, column + 1] - m.throttles[i, column])
    s.position[i] = below + share * (above - below)
    change = (1.0 - math.exp(-m.engine_lag[i] * dt)) * (s.command[i] - s.followed[i])
    s.followed[i] += min(max(change, -m.fall[i] * dt), m.rise[i] * dt)


@compiled
def engine_throttle_for(i, thrust, axial, m):
    """Lowest throttle of engine i with a steady thrust [scaled] at an airspeed; the nearest where there is none."""
    row, part = row_of(axial, m.speeds[i])
    last = m.throttles.shape[1] - 1
    below = between(i, row, part, 0, m.rising_map)
    throttle = m.throttles[i, last]
    for k in range(last):
        above = between(i, row, part, k + 1, m.rising_map)
        if thrust <= above and above > below:
            share = max((thrust - below) / (above - below), 0.0)
            throttle = m.throttles[i, k] + share * (m.throttles[i, k + 1] - m.throttles[i, k])
            break
        below = above
    return throttle


@compiled
def row_of(axial, speeds):
    """Row of an engine's tables at or below an airspeed, and how far the airspeed is to the next; within the tables."""
    last = len(speeds) - 1
    x = min(max(axial, speeds[0]), speeds[last])
    row = 0
    while row < last - 1 and speeds[row + 1] < x:
        row += 1
    return row, (x - speeds[row]) / (speeds[row + 1] - speeds[row])


@compiled
def between(i, row, part, column, table):
    """Value of an engine's table in a column, between two rows."""
    return table[i, row, column] + part * (table[i, row + 1, column] - table[i, row, column])


@compiled
def throttle_for(i, thrust, axial, m, s):
    """Throttle, 0 to 1, that gives a thrust [N] of motor i once the rotor is steady: Newton's method on the rotor speed.

    The search stays at or above `slowest`, the rotor speed at the last advance ratio of the tables, or `STILL` where the air comes
    from behind or is said not to move.
    """
    diameter = m.diameter[i]
    last_ratio = m.advance_min[i] + m.advance_step[i] * (m.c_thrust.shape[1] - 1)
    slowest = max(axial / (last_ratio * diameter), STILL)
    n = max(s.rotor[i], slowest)
    for _ in range(NEWTON_STEPS):
        t, slope = thrust_and_slope(i, n, axial, m)
        n = max(n - (t - thrust) / slope, slowest)
    advance_ratio = axial / (n * diameter)
    unit_thrust = m.density * n * n * fourth(diameter)
    load = unit_thrust * diameter * coefficient(i, m.c_torque, advance_ratio, m)
    volts = n / m.k_v[i] + m.resistance[i] * (load / m.k_t[i] + m.no_load_current[i])
    return min(max(volts / m.max_volts[i], 0.0), 1.0)


@compiled
def thrust_and_slope(i, n, axial, m):
    """Thrust [N] at rotor speed n [rev/s], and its derivative with n [N s], at least 1e-3 so that Newton's step is finite."""
    diameter = m.diameter[i]
    step = 1e-3 * n
    unit = m.density * fourth(diameter)
    t = unit * n * n * coefficient(i, m.c_thrust, axial / (n * diameter), m)
    faster = n + step
    t2 = unit * faster * faster * coefficient(i, m.c_thrust, axial / (faster * diameter), m)
    return t, max((t2 - t) / step, 1e-3)


@compiled
def coefficient(i, table, advance_ratio, m):
    """C_T or C_Q of propeller i at an advance ratio: linear between the table's points, constant beyond them."""
    last = table.shape[1] - 1
    x = min(max((advance_ratio - m.advance_min[i]) / m.advance_step[i], 0.0), float(last))
    column = min(int(x), last - 1)
    return table[i, column] + (x - column) * (table[i, column + 1] - table[i, column])


@compiled
def fourth(x):
    """x^4 by products: compiled and uncompiled powers differ in the last bit."""
    return (x * x) * (x * x)
