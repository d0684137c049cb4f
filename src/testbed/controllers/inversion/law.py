"""The control law of the paper: inversion (6), adaptation (10), (13), (14), monitor and modified inversion (29).

Plain Python that numba compiles; names are the paper's: x_c the controlled rates, f_m and B_m the design model, r the
reference actuator position, u = r / lambda_hat the commanded one, Lambda_hat = diag(lambda_hat).

Letters: y measured state, m design model, c settings, k control mode, s memory; f, z, e, nu, phi of the working memory.
Their fields, shapes and units are in `records`. pressure_ratio is (V/V_0)^2, dynamic pressure over that of the reference.
"""

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.records import D_ALPHA, D_BETA, D_P, D_Q, D_R, U_DOT


@compiled
def pressure_ratio_of(y, m):
    """(V/V_0)^2."""
    return (y.airspeed / m.airspeed) * (y.airspeed / m.airspeed)


@compiled
def state_function(y, m, f):
    """f_m of (2) at the measured state, into f [4]."""
    speed = y.airspeed / m.airspeed
    pressure_ratio = speed * speed
    for i in range(4):
        angles = m.bias[i] + m.A[i, D_ALPHA] * (y.alpha - m.alpha) + m.A[i, D_BETA] * y.beta
        rates = m.A[i, D_P] * y.p + m.A[i, D_Q] * y.q + m.A[i, D_R] * y.r
        f[i] = pressure_ratio * angles + speed * rates
    v = y.airspeed * math.sin(y.beta)
    w = y.airspeed * math.sin(y.alpha) * math.cos(y.beta)
    f[U_DOT] += y.r * v - y.q * w - GRAVITY_M_S2 * math.sin(y.pitch)


@compiled
def modified_inverse(alpha, epsilon):
    """g of (14): 1/alpha, bent to zero within epsilon of it."""
    if abs(alpha) > epsilon:
        return 1.0 / alpha
    return alpha / (epsilon * epsilon)


@compiled
def regressor(pressure_ratio, m, s, phi):
    """Phi = B_m diag(a), into phi [4, n]: the effect on x_c of each modelled position a, if its actuator is fully effective.

    Surfaces act in proportion to dynamic pressure; propellers by thrust, and by the motor's torque at once. A jammed
    actuator does not act by its command: its column is that of one scaled unit, and what is estimated is its position.
    """
    for j in range(len(s.position)):
        factor = pressure_ratio if m.servo[j] else 1.0
        a, transient = s.position[j], 0.0
        if s.jammed[j]:
            a = 1.0
        elif not m.servo[j]:
            transient = s.torque[j] - m.torque_slope[j] * s.position[j]
        for i in range(4):
            phi[i, j] = m.B[i, j] * factor * a + m.B_torque[i, j] * transient


@compiled
def low_pass(x, lags, a):
    """Two equal first-order lags in series on each element of x, in place.

    Args:
        x: [k] input, and output.
        lags: [2, k] state of the lags.
        a: corner times step, w dt [1]; 0 for no filter.
    """
    if a > 0.0:
        gain = 1.0 - math.exp(-a)
        for i in range(len(x)):
            lags[0, i] += gain * (x[i] - lags[0, i])
            lags[1, i] += gain * (lags[0, i] - lags[1, i])
            x[i] = lags[1, i]


@compiled
def measured_error(z, phi, s, e):
    """(10) with the modelled actuators, into e [4]: e = x_c_dot - f_m(x) - Phi lambda_hat, where z = x_c_dot - f_m(x).

    With ideal actuators it is the paper's (12), e = B_m (Lambda - Lambda_hat) u.
    """
    for i in range(4):
        e[i] = z[i]
        for j in range(len(s.lambda_hat)):
            e[i] -= phi[i, j] * s.lambda_hat[j]


@compiled
def adapt(e, pressure_ratio, m, c, s):
    """(13), lambda_hat' = gamma (B_m^-1 e) lambda_hat g(r, epsilon), with the modelled position a in place of r.

    Where |a| > epsilon, lambda_hat g(r) = g(a) as r = lambda_hat a, so that it is (13) to the letter. Within epsilon,
    kappa of (17) is taken at a, which adapts faster than the paper by 1 / lambda_hat^2: what excites an actuator is its
    deflection, not what was asked of it. log lambda_hat is integrated, which keeps the estimates positive and unbiased
    under differentiated noise. They are projected onto [lambda_min, lambda_max], without which they can diverge however
    good B_m is. Of a jammed actuator it is the position that is integrated, between its stops.
    """
    for i in range(len(s.lambda_hat)):
        x = 0.0
        for j in range(4):
            x += m.B_inv[i, j] * e[j]
        if m.servo[i]:
            x /= pressure_ratio
        if s.jammed[i]:
            s.lambda_hat[i] = min(max(s.lambda_hat[i] + c.dt * c.gamma[i] * x, m.low[i]), m.high[i])
            continue
        rate = c.gamma[i] * x * modified_inverse(s.position[i], c.epsilon[i])
        estimate = s.lambda_hat[i] * math.exp(c.dt * rate / s.lambda_hat[i])
        s.lambda_hat[i] = min(max(estimate, c.lambda_min), c.lambda_max)


@compiled
def monitor(c, s):
    """Section 2.3: flag an actuator whose estimate stays below the threshold, and take the flag back once it has stayed
    above `recovery`. Returns 1 if a flag changed.

    Only an estimate with a standard deviation of at most `flag_std_max` may flag: an actuator that hardly acts has an
    uncertain estimate, however low, and has not failed.
    """
    changed = 0
    for i in range(len(s.lambda_hat)):
        if s.jammed[i]:
            continue
        if s.failed[i]:
            beyond, time = s.lambda_hat[i] > c.recovery, c.recovery_time
        else:
            certain = s.P[i, i] <= c.flag_std_max * c.flag_std_max
            beyond, time = s.lambda_hat[i] < c.threshold and certain, c.persistence
        s.flag_timer[i] = s.flag_timer[i] + c.dt if beyond else 0.0
        s.since_flag[i] += c.dt
        if s.flag_timer[i] > time + 1e-9:
            s.failed[i] = 0 if s.failed[i] else 1
            s.flag_timer[i], s.since_flag[i] = 0.0, 0.0
            changed = 1
    return changed


@compiled
def invert(nu, pressure_ratio, m, k, s):
    """(29): r = B_hat^-1 nu; (6) while nothing has failed. A regulated mode has r_trim added."""
    for i in range(len(s.r)):
        s.r[i] = k.r_trim[i]
        for j in range(4):
            s.r[i] += k.B_hat_inv[i, j] * nu[j]
        if m.servo[i]:
            s.r[i] /= pressure_ratio


@compiled
def compensate(m, c, k, s):
    """Section 2.2.1: u = Lambda_hat^-1 r, within the stops; a failed actuator is sent to its trim position."""
    for i in range(len(s.u)):
        u = s.r[i] / max(s.lambda_hat[i], c.divisor_min) if k.available[i] else m.trim_position[i]
        s.u[i] = min(max(u, m.low[i]), m.high[i])
