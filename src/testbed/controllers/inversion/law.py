"""The control law of the paper: inversion (6), adaptation (10), (13), (14), modified inversion (29).

Plain Python that numba compiles; names are the paper's: x_c the controlled rates, f_m and B_m the design model, r the
reference actuator position, u = r / lambda_hat the commanded one, Lambda_hat = diag(lambda_hat).

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.records import D_ALPHA, D_BETA, D_P, D_Q, D_R, U_DOT

LEAST_SPEED = 0.1
"""V/V_0 below which no aircraft flies, so that effects can be divided by [1]."""
TIMER_ROUNDING = 1e-9
"""Added to a time [s], so that a timer of so many control steps has not passed it by rounding."""


@compiled
def pressure_ratio_of(y, m):
    """(V/V_0)^2 [1], the air's density taken as constant; of a pitot tube that reads nothing that of `LEAST_SPEED`."""
    speed = max(y.airspeed / m.airspeed, LEAST_SPEED)
    return speed * speed


@compiled
def effect_ratio(i, pressure_ratio, m):
    """Effect of actuator i at this airspeed in units of that at V_0 [1]: a surface's force goes with dynamic pressure, and the
    position of a motor or engine is its thrust."""
    return pressure_ratio if m.servo[i] else 1.0


@compiled
def beyond_tangent(y, m):
    """What u_dot has beyond its tangent at the trim, at the airspeed V_0 [m/s2] (`degraded_aircraft.forward_curvature`)."""
    change = min(y.alpha, m.stall_alpha) - m.alpha  # beyond the stall lift no longer grows
    return m.forward_curvature * change * change


@compiled
def state_function(y, m, f):
    """f_m of (2) at the measured state, into f [4]."""
    speed, pressure_ratio = y.airspeed / m.airspeed, pressure_ratio_of(y, m)
    for i in range(4):  # (2): aerodynamic forces go with V^2, damping with V
        angles = m.bias[i] + m.A[i, D_ALPHA] * (y.alpha - m.alpha) + m.A[i, D_BETA] * y.beta
        angles += m.sideslip[i] * abs(y.beta)
        rates = m.A[i, D_P] * y.p + m.A[i, D_Q] * y.q + m.A[i, D_R] * y.r
        f[i] = pressure_ratio * angles + speed * rates
    f[U_DOT] += pressure_ratio * beyond_tangent(y, m)
    for i in range(3):  # Euler's -J^-1 (w x J w)
        g = m.gyroscopic[i]
        f[i] += g[0] * y.p * y.p + g[1] * y.q * y.q + g[2] * y.r * y.r
        f[i] += g[3] * y.p * y.q + g[4] * y.p * y.r + g[5] * y.q * y.r
    v = y.airspeed * math.sin(y.beta)
    w = y.airspeed * math.sin(y.alpha) * math.cos(y.beta)
    f[U_DOT] += y.r * v - y.q * w - GRAVITY_M_S2 * math.sin(y.pitch)  # of rotating axes, and of gravity


@compiled
def assume_ideal_actuators(m, c, k, s):
    """Positions as if nothing lagged or stopped, a = u = r / lambda_hat of the last step. (10) is then x_c_dot - f_m - B_m r, which
    the paper writes x_c_dot - x_dc_dot."""
    for i in range(len(s.position)):
        if k.available[i]:
            s.position[i] = s.r[i] / divisor(i, c, s)  # a = u: then e is the paper's (10)
        s.torque[i] = m.torque_slope[i] * s.position[i]


@compiled
def regressor(pressure_ratio, m, s, phi):
    """Phi = B_m diag(a), into phi [4, n]: what each actuator adds to the rates at its modelled position a, if fully effective.

    A propeller acts by its thrust, which lags, and by the motor's torque, which does not. The position of a jammed actuator does
    not follow from its command: its column is the effect of one scaled unit, so that its "effectiveness" estimate is its position.
    """
    for j in range(len(s.position)):
        a, transient, ratio = s.position[j], 0.0, effect_ratio(j, pressure_ratio, m)
        if s.jammed[j]:
            a = 1.0
        elif not m.servo[j]:
            transient = s.torque[j] - m.torque_slope[j] * s.position[j]
        for i in range(4):  # B_m diag(u) of (7), with a in place of u
            phi[i, j] = m.B[i, j] * ratio * a + m.B_torque[i, j] * transient


@compiled
def lag_gain(a):
    """Share of the way to its input that a first-order lag goes in one step [1], by its corner frequency times the step, w dt [1];
    all of it where that is 0, which means no lag."""
    return 1.0 - math.exp(-a) if a > 0.0 else 1.0


@compiled
def lagged(x, lags, i, gain):
    """x after two equal first-order lags in series, with column i of `lags` [2, k] as their state and this `lag_gain`."""
    lags[0, i] += gain * (x - lags[0, i])
    lags[1, i] += gain * (lags[0, i] - lags[1, i])
    return lags[1, i]


@compiled
def low_pass(x, lags, gain):
    """Two equal first-order lags in series on each element of x, in place.

    Args:
        x: [k] input, and output.
        lags: [2, k] state of the lags.
        gain: their `lag_gain`.
    """
    if gain < 1.0:
        for i in range(len(x)):
            x[i] = lagged(x[i], lags, i, gain)


@compiled
def measured_error(z, phi, s, e):
    """(10) with the modelled actuators, into e [4]: e = x_c_dot - f_m(x) - Phi lambda_hat, where z = x_c_dot - f_m(x).

    With ideal actuators it is the paper's (12), e = B_m (Lambda - Lambda_hat) u.
    """
    for i in range(4):
        e[i] = z[i]  # x_c_dot of (10), less f_m
        for j in range(len(s.lambda_hat)):
            e[i] -= phi[i, j] * s.lambda_hat[j]  # x_dc_dot of (5), less f_m: B_m r with r = Lambda_hat a


@compiled
def modified_inverse(alpha, epsilon):
    """g of (14): 1/alpha, but linear through zero where |alpha| <= epsilon."""
    if abs(alpha) > epsilon:
        return 1.0 / alpha  # (14), first case
    return alpha / (epsilon * epsilon)  # (14), second case


@compiled
def adapt(e, pressure_ratio, m, c, s):
    """(13), lambda_hat' = gamma (B_m^-1 e) lambda_hat g(r, epsilon), with the modelled position a in place of r.

    Where both |r| and |a| are above epsilon this is (13) itself: r = lambda_hat a, so lambda_hat g(r) = 1/a = g(a). Where both
    are within epsilon, kappa of (17) is a^2 / epsilon^2, and the estimate adapts 1 / lambda_hat^2 times as fast as in the paper.
    The reason is that the deflection a excites the rates, not the reference r.

    The logarithm of lambda_hat is integrated, which keeps the estimates positive, and unbiased under differentiated noise. They
    are projected onto [lambda_min, lambda_max], because without bounds they can diverge however good B_m is.
    """
    for i in range(len(s.lambda_hat)):
        x = 0.0
        for j in range(4):
            x += m.B_inv[i, j] * e[j]  # B_m^-1 e of (13)
        x /= effect_ratio(i, pressure_ratio, m)  # B_m at this airspeed
        rate = c.gamma[i] * x * modified_inverse(s.position[i], c.epsilon[i])  # (13): lambda_hat' = rate
        # (log lambda_hat)' = lambda_hat' / lambda_hat, integrated
        estimate = s.lambda_hat[i] * math.exp(c.dt * rate / s.lambda_hat[i])
        s.lambda_hat[i] = min(max(estimate, c.lambda_min), c.lambda_max)


@compiled
def invert(nu, pressure_ratio, m, k, s):
    """(29): r = r_trim + B_hat^-1 nu; while nothing has failed this is (6). r_trim is zero unless the mode is regulated.

    A surface keeps the force that it has at the mode's trim, so at another airspeed r_trim changes as 1/V^2.
    """
    for i in range(len(s.r)):
        s.r[i] = k.trim_effect[i]
        for j in range(4):
            s.r[i] += k.B_hat_inv[i, j] * nu[j]  # (29), or (6): r = B_hat^-1 [x_dc_dot - f_m]
        s.r[i] /= effect_ratio(i, pressure_ratio, m)  # B_m at this airspeed


@compiled
def divisor(i, c, s):
    """What the reference of actuator i is divided by [1]: its estimate, at least `divisor_min`, or 1 if references are not
    compensated. For a reversed actuator it is negative: at most -`divisor_min`, or -1."""
    if s.reversed[i]:
        return -1.0 if c.uncompensated else min(s.lambda_hat[i], -c.divisor_min)
    return 1.0 if c.uncompensated else max(s.lambda_hat[i], c.divisor_min)


@compiled
def reach(i, m, c, s):
    """Lowest and highest reference r of actuator i that `compensate` can turn into a position within its stops [scaled]."""
    lam = divisor(i, c, s)
    if lam < 0.0:
        return m.high[i] * lam + s.shift[i], m.low[i] * lam + s.shift[i]
    return m.low[i] * lam + s.shift[i], m.high[i] * lam + s.shift[i]


@compiled
def compensate(m, c, k, s):
    """Section 2.2.1: u = Lambda_hat^-1 (r - shift), within the stops; a failed actuator is sent to its trim position.

    `shift` is the offset of an actuator that has moved from its command (`offset_detection`), and 0 for all others.
    """
    for i in range(len(s.u)):
        # section 2.2.1, in (8): u = Lambda_hat^-1 r
        u = (s.r[i] - s.shift[i]) / divisor(i, c, s) if k.available[i] else m.trim_position[i] + s.probe[i]
        s.u[i] = min(max(u, m.low[i]), m.high[i])
