"""Outer loops: from references to desired rates.

`pid` is the paper's: airspeed through u_dot, altitude through q_dot, heading through p_dot, sideslip through r_dot.
`regulate` is for modes in which axes are released: it feeds back all states with gains that `modes` designed on the
design model, because what is left no longer decouples. Both leave the bracket of (29), x_dc_dot - f_m, in `wanted`.
"""

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2


@compiled
def wrap(angle):
    """The same angle between -pi and pi."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


@compiled
def clip(x, most):
    """x within +-most."""
    return min(max(x, -most), most)


@compiled
def pid(y, ref, m, c, k, s, f, wanted):
    """The paper's outer loops, each a cascade of proportional loops under one integrator."""
    dt, v = c.dt, max(y.airspeed, 1.0)
    e_speed = clip(ref.airspeed - y.airspeed, c.airspeed_error_max)
    e_height = clip(ref.altitude - y.altitude, c.altitude_error_max)
    e_heading = clip(wrap(ref.heading - y.heading), c.heading_error_max)

    # airspeed through u_dot
    s.integral[3] = clip(s.integral[3] + c.airspeed_ki * e_speed * dt, c.u_dot_max)
    u_dot = clip(c.airspeed_kp * e_speed + s.integral[3] + ref.airspeed_rate, c.u_dot_max)

    # altitude through q_dot: climb rate, then pitch, then pitch rate
    s.integral[1] += c.altitude_ki * e_height * dt
    climb = clip(c.altitude_kp * e_height + ref.altitude_rate, c.climb_max)
    pitch = s.integral[1] + climb / v
    turn = GRAVITY_M_S2 / v * math.tan(y.roll)
    q = c.pitch_kp * (pitch - y.pitch) + turn * math.sin(y.roll)
    q_dot = c.q_kp * (q - y.q)

    # heading through p_dot: turn rate, then bank, then roll rate
    s.integral[0] = clip(s.integral[0] + c.heading_ki * e_heading * dt, 0.5)
    rate = c.heading_kp * e_heading + ref.heading_rate + s.integral[0]
    bank = clip(math.atan(v / GRAVITY_M_S2 * rate), c.roll_max)
    p_dot = c.p_kp * (c.roll_kp * (bank - y.roll) - y.p)

    # sideslip through r_dot: a coordinated turn, and the nose into the wind
    s.integral[2] = clip(s.integral[2] + c.sideslip_ki * y.beta * dt, 0.5)
    r = GRAVITY_M_S2 / v * math.sin(y.roll) * math.cos(y.pitch) + c.sideslip_kp * y.beta + s.integral[2]
    r_dot = c.r_kp * (r - y.r)

    s.x_dot_desired[0] = p_dot
    s.x_dot_desired[1] = q_dot
    s.x_dot_desired[2] = r_dot
    s.x_dot_desired[3] = u_dot
    for i in range(4):
        wanted[i] = s.x_dot_desired[i] - f[i]


@compiled
def accumulate(integral, error, most, dt):
    """The integral one step later; an error at its limit may only unwind it, so it neither winds up nor latches."""
    if abs(error) < most or error * integral < 0.0:
        return integral + clip(error, most) * dt
    return integral


@compiled
def regulate(y, ref, m, c, k, s, f, wanted):
    """Hold references about the mode's own trim without cancelling what is stable: x_dc_dot = f_m(x) + v.

    v = -K (x - x_trim) - K_a (a - r_trim) - K_i integral, so the bracket of (29) is v itself; the trim enters as
    r_trim.
    """
    e_speed = clip(y.airspeed - ref.airspeed - k.faster, c.airspeed_error_max)
    e_height = clip(y.altitude - ref.altitude, c.altitude_error_max)
    e_heading = clip(wrap(y.heading - ref.heading), c.heading_error_max)
    bank = math.atan(y.airspeed * ref.heading_rate / GRAVITY_M_S2)
    slow = ref.airspeed + k.faster - y.airspeed  # too slow to climb or to turn: height is what can be given
    e_height += k.protect * max(slow - k.protect_from, 0.0)
    s.integral[0] = accumulate(s.integral[0], e_speed, c.airspeed_error_max, c.dt)
    s.integral[1] = accumulate(s.integral[1], e_height, c.altitude_error_max, c.dt)
    s.integral[2] = accumulate(s.integral[2], e_heading, c.heading_error_max, c.dt)
    for i in range(4):
        v = -k.K[i, 0] * e_speed - k.K[i, 1] * (y.alpha - k.x_trim[1]) - k.K[i, 2] * (y.beta - k.x_trim[2])
        v -= k.K[i, 3] * y.p + k.K[i, 4] * (y.q - ref.heading_rate * math.sin(bank))
        v -= k.K[i, 5] * (y.r - ref.heading_rate * math.cos(bank))
        v -= k.K[i, 6] * (y.roll - k.x_trim[6] - bank)
        v -= k.K[i, 7] * (y.pitch - k.x_trim[7] - ref.altitude_rate / max(y.airspeed, 1.0))
        v -= k.K[i, 8] * e_heading + k.K[i, 9] * e_height
        for j in range(len(s.position)):
            v -= k.K_actuator[i, j] * (s.position[j] * s.lambda_hat[j] - k.r_trim[j])
        for j in range(3):
            v -= k.K_integral[i, j] * s.integral[j]
        wanted[i] = v
        s.x_dot_desired[i] = f[i] + v
        for j in range(len(s.position)):
            s.x_dot_desired[i] += m.B[i, j] * k.r_trim[j] * k.alive[j]
