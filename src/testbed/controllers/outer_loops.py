"""Outer loops: from references to the virtual control nu = x_dc_dot - f_m, the bracket of (6) and (29).

`pid_loops` is the paper's: airspeed through u_dot, altitude through q_dot, heading through p_dot, sideslip through r_dot.
`regulate` is for modes with released axes. The remaining actuators no longer decouple the axes, so it feeds back all states. Its
gains are designed on the design model by `inversion.regulator`.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common import angles
from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.records import (
    AIRSPEED,
    AIRSPEED_INTEGRAL,
    ALPHA,
    ALTITUDE,
    ALTITUDE_INTEGRAL,
    BETA,
    HEADING,
    HEADING_INTEGRAL,
    P_DOT,
    PITCH,
    Q_DOT,
    R_DOT,
    ROLL,
    U_DOT,
    P,
    Q,
    R,
)
from testbed.controllers.scaling import PATH_LAG_S

STALL_GAIN = 4.0
"""Nose-down acceleration of `regulate` for each radian beyond the stall, in units of the pitch loop's stiffness pitch_kp q_kp."""

TURN_RATE_INTEGRAL_MAX = 0.5
"""Limit of the paper's integrals of heading and of sideslip, each as a turn rate [rad/s]."""

wrap = compiled(angles.wrap)


@compiled
def clip(x, most):
    """x limited to the range from -most to most."""
    return min(max(x, -most), most)


@compiled
def beyond_stall(y, m, c):
    """Nose-down acceleration beyond the stall angle, and nose-up acceleration below that of no lift [rad/s2]: a climb that turns
    into a descent at once pushed an airliner to -15 deg, where its drag was taken for lost thrust."""
    beyond = max(y.alpha - m.stall_alpha, 0.0) + min(y.alpha - m.zero_lift_alpha, 0.0)
    return STALL_GAIN * c.pitch_kp * c.q_kp * beyond


@compiled
def left_to_thrust(e_speed, e_height, y, c):
    """Airspeed error that thrust is to correct [m/s]: `e_speed`, less what altitude is worth, g h / V. That counts of an altitude
    error `e_height` of the other sign what is beyond `altitude_error_max` [m].

    Thrust changes the sum of both energies. An aircraft that is far too high and too slow has enough of it, and one that is far
    too low and too fast has none to lose."""
    beyond = e_height - clip(e_height, c.altitude_error_max)
    worth = GRAVITY_M_S2 * beyond / max(y.airspeed, 1.0)
    if e_speed * worth >= 0.0:
        return e_speed
    return math.copysign(max(abs(e_speed) - abs(worth), 0.0), e_speed)


@compiled
def pid_loops(y, ref, m, c, k, s, f, nu):
    """The paper's outer loops (section 3): each is a cascade of proportional loops, with an integrator in the outermost.

    Not of the paper, and not in its preset, which has no `give_up_time`: altitude is given up for airspeed (`traded`), or a weak
    engine ends in a stall; airspeed is left to altitude where that has its energy (`left_to_thrust`); an aircraft that is so
    slow that it gives up altitude asks for more than `u_dot_max`, which is as little as 0.15 m/s2 where thrust is scarce; the
    integral of altitude does not wind up; and pitch leads a flight path that follows it late, by `climb_kp` times the climb rate
    that is missing. Fills nu [4] and `s.x_dc_dot` [4].
    """
    dt, v = c.dt, max(y.airspeed, 1.0)
    fast, high, too_slow = y.airspeed - ref.airspeed, y.altitude - ref.altitude, 0.0
    e_height = -clip(high, c.altitude_error_max)
    if c.give_up_time > 0.0:
        fast = left_to_thrust(fast, high, y, c)
        e_height = -traded(-e_height, ref.airspeed, y, m, c, k, s)
        too_slow = max(-fast - k.slow_descent_from, 0.0)
    e_speed = -clip(fast, c.airspeed_error_max)
    e_heading = clip(wrap(ref.heading - y.heading), c.heading_error_max)

    # airspeed through u_dot
    s.airspeed_integral = clip(s.airspeed_integral + c.airspeed_ki * e_speed * dt, c.u_dot_max)
    u_dot = clip(c.airspeed_kp * e_speed + s.airspeed_integral + ref.airspeed_rate, c.u_dot_max)
    s.x_dc_dot[U_DOT] = u_dot + c.airspeed_kp * too_slow

    # altitude through q_dot: climb rate, then pitch, then pitch rate
    # Beyond the climb limit the error says how far it is, not what pitch is missing. Nor does it where the elevator is at its stop.
    change = c.altitude_ki * clip(e_height, c.climb_max / max(c.altitude_kp, 1e-9)) * dt
    if c.give_up_time == 0.0 or change * s.pitch_beyond_stop <= 0.0:
        s.pitch_integral += change
    # A path that follows pitch late cannot take up a new rate of the reference at once: that is no climb rate that is missing.
    s.climb_wanted += dt / PATH_LAG_S * (ref.altitude_rate - s.climb_wanted)
    climb = clip(c.altitude_kp * e_height, c.climb_max)
    missing = climb + s.climb_wanted - y.climb_rate
    pitch = s.pitch_integral + (climb + ref.altitude_rate + c.climb_kp * missing) / v
    turn = GRAVITY_M_S2 / v * math.tan(y.roll)
    q = c.pitch_kp * (pitch - y.pitch) + turn * math.sin(y.roll)
    s.x_dc_dot[Q_DOT] = c.q_kp * (q - y.q) - beyond_stall(y, m, c)

    # heading through p_dot: turn rate, then bank, then roll rate
    s.heading_integral = clip(s.heading_integral + c.heading_ki * e_heading * dt, TURN_RATE_INTEGRAL_MAX)
    turn_rate = c.heading_kp * e_heading + ref.heading_rate + s.heading_integral
    bank = clip(math.atan(v / GRAVITY_M_S2 * turn_rate), c.roll_max)
    s.x_dc_dot[P_DOT] = c.p_kp * (c.roll_kp * (bank - y.roll) - y.p)

    # sideslip through r_dot: the yaw rate of a coordinated turn, and a yaw rate towards the relative wind
    s.sideslip_integral = clip(s.sideslip_integral + c.sideslip_ki * y.beta * dt, TURN_RATE_INTEGRAL_MAX)
    coordinated = GRAVITY_M_S2 / v * math.sin(y.roll) * math.cos(y.pitch)
    r = coordinated + c.sideslip_kp * y.beta + s.sideslip_integral
    s.x_dc_dot[R_DOT] = c.r_kp * (r - y.r)

    for i in range(4):  # the bracket of (6) and (29)
        nu[i] = s.x_dc_dot[i] - f[i]


@compiled
def accumulate(integral, error, most, dt, free=False):
    """Integral of an error one control step of `dt` [s] later, with anti-windup: an error at its limit `most` (either sign)
    may reduce the integral, but increase it only if what acts on it is `free` of its stops."""
    if free or abs(error) < most or error * integral < 0.0:
        return integral + clip(error, most) * dt
    return integral


@compiled
def given_up(altitude, c, s):
    """Altitude [m] that is given up in this step, where `altitude` [m] is to be given up: that through a first-order lag of
    `give_up_time`, at most half of `altitude_error_max` behind it, so that an aircraft that is very slow gains airspeed at once.

    Without the lag each m/s of a gust is a step of altitude. So is the loss of a propeller: the nose went down by ten degrees
    within half a second of it, and most of the altitude that was lost was lost then.
    """
    share = c.dt / c.give_up_time if c.give_up_time > 0.0 else 1.0
    lagged = altitude if share >= 1.0 else s.given_up + share * (altitude - s.given_up)
    s.given_up = max(lagged, altitude - 0.5 * c.altitude_error_max)
    return s.given_up


@compiled
def traded(e_height, airspeed, y, m, c, k, s):
    """Altitude error [m] to be regulated in place of `e_height`, for the sake of airspeed.

    A slow aircraft can neither climb nor turn. Once airspeed is more than `slow_descent_from` below what is wanted, or below that
    of the design if that is less, it is treated as too high, so that it descends to regain airspeed. Where a jam needs a slow trim,
    the propellers that balance its yawing moment cannot slow the aircraft down. So above the airspeeds at which it can fly level it
    climbs, and does not descend to its reference; as if it were too low by `altitude_error_max` at most.

    Args:
        e_height: altitude less its reference, limited [m].
        airspeed: the wanted one: the reference plus the mode's offset, at most the mode's highest [m/s]. Where the mode's lowest
            is above that, no altitude is given up to reach it: there is thrust enough.
    """
    needed = min(airspeed, m.airspeed + k.airspeed_offset)
    e_height += given_up(k.slow_descent * max(needed - y.airspeed - k.slow_descent_from, 0.0), c, s)
    fast = y.airspeed - k.airspeed_too_fast
    if k.fast_climb > 0.0 and fast > 0.0:
        share = max(1.0 - 2.0 * fast / c.airspeed_error_max, 0.0)  # of being too high that still counts
        e_height = min(e_height, 0.0) + share * max(e_height, 0.0) - k.fast_climb * fast
        # Without a limit, one that is far too fast would pull up into the stall.
        e_height = max(e_height, -c.altitude_error_max)
    return e_height


@compiled
def airspeed_at(altitude, y):
    """Airspeed that the present energy is at another altitude [m/s]. A glide that is held to it, where that is more than its own,
    stays at the altitude: one that slowed down at once would climb, 300 m from 110 m/s."""
    return math.sqrt(max(y.airspeed * y.airspeed + 2.0 * GRAVITY_M_S2 * (y.altitude - altitude), 0.0))


@compiled
def sinking(y, m, c, k, s):
    """Rate at which the air sinks [m/s], through a lag of `sink_time`, at most a quarter of airspeed: climb rate through the air
    less that over the ground. 0 once a motor has failed: there is no thrust to climb with against it, and airspeed is what must
    not be lost."""
    if c.sink_time <= 0.0:
        return 0.0
    for j in range(len(s.position)):
        if not (k.available[j] or m.servo[j]):
            s.sink = 0.0
            return 0.0
    forward = math.cos(y.alpha) * math.cos(y.beta) * math.sin(y.pitch)
    across = math.sin(y.beta) * math.sin(y.roll) + math.sin(y.alpha) * math.cos(y.beta) * math.cos(y.roll)
    climb = y.airspeed * (forward - across * math.cos(y.pitch))
    if s.stuck[0]:  # the angle of attack is computed with this sink
        return s.sink
    s.sink += c.dt / c.sink_time * (clip(climb - y.climb_rate, 0.25 * y.airspeed) - s.sink)
    return s.sink


@compiled
def regulate(y, ref, m, c, k, s, f, nu):
    """Follow the references about the mode's own trim: x_dc_dot = f_m(x) + B_m trim_effect + nu.

    f_m is kept and not cancelled, so natural stability and damping remain. `law.invert` adds trim_effect, the effect of the
    actuators at the trim, that of a jammed one included. So nu is only

        nu = -K (x - x_trim) - K_actuator (a lambda_hat + shift - r_trim) - K_integral integral

    where x_trim has the airspeed, altitude, heading, climb rate and turn rate of the references. In a glide that is
    faster than it need be, airspeed is held at `airspeed_at` the reference altitude. Beyond the stall angle a nose-down
    acceleration is added. Fills nu [4] and `s.x_dc_dot` [4].
    """
    wanted = min(ref.airspeed + k.airspeed_offset, k.airspeed_high)
    e_speed = y.airspeed - max(wanted, k.airspeed_low)
    if k.glides:
        e_speed = min(e_speed, y.airspeed - min(ref.airspeed, airspeed_at(ref.altitude, y)))
    else:
        e_speed = left_to_thrust(e_speed, y.altitude - ref.altitude, y, c)
    e_speed = clip(e_speed, c.airspeed_error_max)
    e_heading = clip(wrap(y.heading - ref.heading), c.heading_error_max)
    e_height = traded(clip(y.altitude - ref.altitude, c.altitude_error_max), wanted, y, m, c, k, s)
    integrate_errors(e_speed, e_height, e_heading, c, k, s)
    slope = (ref.altitude_rate + sinking(y, m, c, k, s)) / max(y.airspeed, 1.0)  # of the path through the air
    bank = math.atan(y.airspeed * ref.heading_rate / GRAVITY_M_S2)  # of a coordinated turn
    for i in range(4):
        v = state_feedback(i, e_speed, e_height, e_heading, bank, slope, y, ref, k)
        for j in range(len(s.position)):
            sign = -1.0 if s.reversed[j] else 1.0  # in place of estimates that are not used
            effective = s.position[j] * (sign if c.uncompensated else s.lambda_hat[j]) + s.shift[j]
            v -= k.K_actuator[i, j] * (effective - k.r_trim[j])
        for j in range(len(s.integral)):
            v -= k.K_integral[i, j] * s.integral[j]
        if i == U_DOT and c.sink_time > 0.0:
            v += (
                GRAVITY_M_S2 * slope
            )  # thrust for the slope at once: the integral of airspeed would find it too late
        if i == Q_DOT:
            v -= beyond_stall(y, m, c)
        nu[i] = v
        s.x_dc_dot[i] = f[i] + v  # what (29) makes of nu, for the log
        for j in range(len(s.position)):
            if k.available[j] or s.jammed[j]:
                s.x_dc_dot[i] += m.B[i, j] * k.trim_effect[j]


@compiled
def integrate_errors(e_speed, e_height, e_heading, c, k, s):
    """Advance the regulator's integrals of airspeed [m], altitude [m s] and heading [rad s] by one control step."""
    integral = s.integral
    # An aircraft that is held too fast by its jam cannot slow down by winding up the integral: it would only be slow to open the
    # throttle in sinking air.
    if k.fast_climb == 0.0 or e_speed < 0.0 or integral[AIRSPEED_INTEGRAL] < 0.0:
        integral[AIRSPEED_INTEGRAL] = accumulate(
            integral[AIRSPEED_INTEGRAL], e_speed, c.airspeed_error_max, c.dt, not s.saturated
        )
    integral[ALTITUDE_INTEGRAL] = accumulate(
        integral[ALTITUDE_INTEGRAL], e_height, c.altitude_error_max, c.dt
    )
    integral[HEADING_INTEGRAL] = accumulate(integral[HEADING_INTEGRAL], e_heading, c.heading_error_max, c.dt)


@compiled
def state_feedback(i, e_speed, e_height, e_heading, bank, slope, y, ref, k):
    """-K (x - x_trim) of `regulate` for one rate i of `signals.RATES`.

    Args:
        e_speed, e_height, e_heading: limited errors, state less reference [m/s, m, rad].
        bank: of a coordinated turn at the heading rate of the reference [rad].
        slope: of the path through the air that holds the climb rate of the reference [rad].
    """
    v = -k.K[i, AIRSPEED] * e_speed
    v -= k.K[i, ALPHA] * (y.alpha - k.x_trim[ALPHA])
    v -= k.K[i, BETA] * (y.beta - k.x_trim[BETA])
    v -= k.K[i, P] * y.p + k.K[i, Q] * (y.q - ref.heading_rate * math.sin(bank))
    v -= k.K[i, R] * (y.r - ref.heading_rate * math.cos(bank))
    v -= k.K[i, ROLL] * (y.roll - k.x_trim[ROLL] - bank)
    v -= k.K[i, PITCH] * (y.pitch - k.x_trim[PITCH] - slope)
    return v - (k.K[i, HEADING] * e_heading + k.K[i, ALTITUDE] * e_height)


@compiled
def virtual_control(y, ref, m, c, k, s, w):
    """Fill the virtual control w.nu [4] by the outer loop of the mode in force; w.f is f_m at the measured state."""
    if k.regulated:
        regulate(y, ref, m, c, k, s, w.f, w.nu)
    else:
        pid_loops(y, ref, m, c, k, s, w.f, w.nu)
