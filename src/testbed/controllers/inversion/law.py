"""The control law of the paper: inversion (6), adaptation (10), (13), (14), monitor and modified inversion (29).

Plain Python that numba compiles; names are the paper's: x_c the controlled rates, f_m and B_m the design model, r the
reference actuator state, u = r / lambda_hat the commanded one, Lambda_hat = diag(lambda_hat).

Records (see `records`): y measured state, m design model, c settings, k the control mode in force, s memory.
"""

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2


@compiled
def state_function(y, m, f):
    """f_m of (2), rows x_c: p_dot, q_dot, r_dot, u_dot at the measured state."""
    speed = y.airspeed / m.airspeed
    pressure = speed * speed
    for i in range(4):
        angles = m.bias[i] + m.A[i, 0] * (y.alpha - m.alpha) + m.A[i, 1] * y.beta
        rates = m.A[i, 2] * y.p + m.A[i, 3] * y.q + m.A[i, 4] * y.r
        f[i] = pressure * angles + speed * rates
    v = y.airspeed * math.sin(y.beta)
    w = y.airspeed * math.sin(y.alpha) * math.cos(y.beta)
    f[3] += y.r * v - y.q * w - GRAVITY_M_S2 * math.sin(y.pitch)


@compiled
def modified_inverse(alpha, epsilon):
    """g of (14): 1/alpha, bent to zero within epsilon of it."""
    if abs(alpha) > epsilon:
        return 1.0 / alpha
    return alpha / (epsilon * epsilon)


@compiled
def regressor(pressure, m, s, phi):
    """Phi = B_m diag(a): what each modelled actuator position a does to x_c while it is fully effective.

    Surfaces act in proportion to dynamic pressure; propellers by thrust, and by the motor's torque at once. A jammed
    actuator does not act by its command at all: its column is that of one unit, and what is estimated is its position.
    """
    for j in range(len(s.position)):
        q = pressure if m.servo[j] > 0.5 else 1.0
        a, transient = s.position[j], 0.0
        if s.jammed[j] > 0.5:
            a = 1.0
        elif m.servo[j] < 0.5:
            transient = s.torque[j] - m.torque_slope[j] * s.position[j]
        for i in range(4):
            phi[i, j] = m.B[i, j] * q * a + m.B_torque[i, j] * transient


@compiled
def measured_error(z, phi, s, e):
    """(10) with the modelled actuators: e = x_c_dot - f_m(x) - Phi lambda_hat, where z = x_c_dot - f_m(x).

    With ideal actuators it is the paper's (12), e = B_m (Lambda - Lambda_hat) u.
    """
    for i in range(4):
        e[i] = z[i]
        for j in range(len(s.lambda_hat)):
            e[i] -= phi[i, j] * s.lambda_hat[j]


@compiled
def adapt(e, pressure, m, c, s):
    """(13), lambda_hat' = gamma (B_m^-1 e) lambda_hat g(r, epsilon), by the modelled position a instead of r.

    Beyond epsilon lambda_hat g(r) = g(a) for r = lambda_hat a, so it is (13) to the letter; within, kappa of (17) is
    that of a: faster than the paper's by 1 / lambda_hat^2, because what excites an actuator is its deflection.
    Integrated in log lambda_hat, which keeps the estimates positive and unbiased under differentiated noise, and
    projected onto [lambda_min, lambda_max], without which they can diverge however good B_m is.
    """
    for i in range(len(s.lambda_hat)):
        x = 0.0
        for j in range(4):
            x += m.B_inv[i, j] * e[j]
        if m.servo[i] > 0.5:
            x /= pressure
        if s.jammed[i] > 0.5:
            s.lambda_hat[i] = min(max(s.lambda_hat[i] + c.dt * c.gamma[i] * x, m.low[i]), m.high[i])
            continue
        rate = c.gamma[i] * x * modified_inverse(s.position[i], c.epsilon[i])
        estimate = s.lambda_hat[i] * math.exp(c.dt * rate / s.lambda_hat[i])
        s.lambda_hat[i] = min(max(estimate, c.lambda_min), c.lambda_max)


@compiled
def monitor(c, s):
    """Section 2.3: an actuator has failed once its estimate stays below the threshold; returns 1 on any change.

    It must be a sure estimate: one that `P` calls uncertain is that of an actuator that hardly acts, not of a lost one.
    """
    changed = 0
    for i in range(len(s.lambda_hat)):
        if s.jammed[i] > 0.5:
            continue
        if s.failed[i] > 0.5:
            against, time = s.lambda_hat[i] > c.recovery, c.recovery_time
        else:
            against, time = (
                s.lambda_hat[i] < c.threshold and s.P[i, i] <= c.certain * c.certain,
                c.persistence,
            )
        s.timer[i] = s.timer[i] + c.dt if against else 0.0
        s.since[i] += c.dt
        if s.timer[i] > time + 1e-9:
            s.failed[i] = 1.0 - s.failed[i]
            s.timer[i], s.since[i] = 0.0, 0.0
            changed = 1
    return changed


@compiled
def invert(wanted, pressure, m, k, s):
    """(29): r = B_hat^-1 [x_dc_dot - f_m], (6) while nothing has failed; `wanted` is the bracket."""
    for i in range(len(s.r)):
        s.r[i] = k.r_trim[i]
        for j in range(4):
            s.r[i] += k.B_hat_inv[i, j] * wanted[j]
        if m.servo[i] > 0.5:
            s.r[i] /= pressure


@compiled
def redistribute(wanted, pressure, m, c, k, s):
    """With an actuator to spare, one that would pass its stop stays there and the others do what it cannot
    (redistributed pseudo-inverse; Bodson, J. Guidance 25 (2002) 703)."""
    worst, excess = -1, 0.0
    for i in range(len(s.r)):
        lam = max(s.lambda_hat[i], c.divisor_min)
        beyond = max(s.r[i] - m.high[i] * lam, m.low[i] * lam - s.r[i])
        if k.alive[i] > 0.5 and beyond > excess:
            worst, excess = i, beyond
    if k.spare < 0.5 or worst < 0:
        return
    lam = max(s.lambda_hat[worst], c.divisor_min)
    held = min(max(s.r[worst], m.low[worst] * lam), m.high[worst] * lam)
    moved = held * (pressure if m.servo[worst] > 0.5 else 1.0) - k.r_trim[worst]
    for j in range(len(s.r)):
        s.r[j] = k.r_trim[j]
        for i in range(4):
            s.r[j] += k.held_inv[worst, j, i] * (wanted[i] - m.B[i, worst] * moved)
        if m.servo[j] > 0.5:
            s.r[j] /= pressure
    s.r[worst] = held


@compiled
def give_up_speed(m, c, k, s):
    """When an actuator would pass its stop, move along the column of u_dot in B_hat^-1 until none does.

    Airspeed is the axis to give: the others keep what they asked for as long as any thrust allows it.
    """
    least, most = -1e9, 1e9
    for i in range(len(s.r)):
        d = k.B_hat_inv[i, 3]
        if k.alive[i] < 0.5 or abs(d) < 1e-6:
            continue
        lam = max(s.lambda_hat[i], c.divisor_min)
        a, b = (m.low[i] * lam - s.r[i]) / d, (m.high[i] * lam - s.r[i]) / d
        least, most = max(least, min(a, b)), min(most, max(a, b))
    shift = 0.5 * (least + most) if least > most else min(max(0.0, least), most)
    if shift != 0.0:
        for i in range(len(s.r)):
            s.r[i] += k.B_hat_inv[i, 3] * shift


@compiled
def compensate(m, c, k, s):
    """Section 2.2.1: u = Lambda_hat^-1 r, within the stops; a failed actuator is held at its trim."""
    for i in range(len(s.u)):
        u = s.r[i] / max(s.lambda_hat[i], c.divisor_min) if k.alive[i] > 0.5 else m.hold[i]
        s.u[i] = min(max(u, m.low[i]), m.high[i])
