"""The control law of the paper: inversion (6), adaptation (10), (13), (14), monitor (section 2.3), modified inversion (29).

Plain Python that numba compiles; names are the paper's: x_c the controlled rates, f_m and B_m the design model, r the
reference actuator position, u = r / lambda_hat the commanded one, Lambda_hat = diag(lambda_hat).

Letters: y measured state, m design model, c settings, k control mode, s memory; f, z, e, nu, phi of the working memory.
Their fields, shapes and units are in `records`. pressure_ratio is (V/V_0)^2, the dynamic pressure divided by that at the
reference condition.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.records import D_ALPHA, D_BETA, D_P, D_Q, D_R, U_DOT

BEFORE_S = 3.0
"""Time constant of the estimate that an actuator had before [s]: several times the memory of the filter, 0.6 s."""
SUDDENLY = 0.5
"""Effectiveness that is lost at once if an actuator fails: a fall by more than this is no error of its estimate."""
WAIT_S, STILL_LOW = 3.0, 0.15
"""How long the estimate of an actuator must stay below `STILL_LOW` [1] before it is given up if level flight is given up with it
[s]: longer than most pauses of one that fails on and off. What keeps more than `STILL_LOW` is worth using. The estimate of an
engine takes up errors of the drag, so that of a lost one does not stay below `threshold`."""
STEADY_M = 2.0
"""Altitude, or the altitude that missing airspeed is worth, that a level flight loses at most [m]."""
TIMER_ROUNDING = 1e-9
"""Added to a time [s], so that a timer of so many control steps has not passed it by rounding."""


@compiled
def pressure_ratio_of(y, m):
    """(V/V_0)^2 [1], the air's density taken as constant."""
    return (y.airspeed / m.airspeed) * (y.airspeed / m.airspeed)


@compiled
def effect_ratio(i, pressure_ratio, m):
    """Effect of actuator i at this airspeed in units of that at V_0 [1]: a surface's force goes with dynamic pressure, and the
    position of a motor or engine is its thrust."""
    return pressure_ratio if m.servo[i] else 1.0


@compiled
def state_function(y, m, f):
    """f_m of (2) at the measured state, into f [4]."""
    speed, pressure_ratio = y.airspeed / m.airspeed, pressure_ratio_of(y, m)
    for i in range(4):
        angles = m.bias[i] + m.A[i, D_ALPHA] * (y.alpha - m.alpha) + m.A[i, D_BETA] * y.beta
        angles += m.sideslip[i] * abs(y.beta)
        rates = m.A[i, D_P] * y.p + m.A[i, D_Q] * y.q + m.A[i, D_R] * y.r
        f[i] = pressure_ratio * angles + speed * rates
    v = y.airspeed * math.sin(y.beta)
    w = y.airspeed * math.sin(y.alpha) * math.cos(y.beta)
    f[U_DOT] += y.r * v - y.q * w - GRAVITY_M_S2 * math.sin(y.pitch)


@compiled
def assume_ideal_actuators(m, c, k, s):
    """Positions as if nothing lagged or stopped, a = u = r / lambda_hat of the last step. (10) is then x_c_dot - f_m - B_m r, which
    the paper writes x_c_dot - x_dc_dot."""
    for i in range(len(s.position)):
        if k.available[i]:
            s.position[i] = s.r[i] / divisor(i, c, s)
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
        for i in range(4):
            phi[i, j] = m.B[i, j] * ratio * a + m.B_torque[i, j] * transient


@compiled
def low_pass(x, lags, a):
    """Two equal first-order lags in series on each element of x, in place.

    Args:
        x: [k] input, and output.
        lags: [2, k] state of the lags.
        a: corner frequency times control step, w dt [1]; 0 for no filter.
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
def modified_inverse(alpha, epsilon):
    """g of (14): 1/alpha, but linear through zero where |alpha| <= epsilon."""
    if abs(alpha) > epsilon:
        return 1.0 / alpha
    return alpha / (epsilon * epsilon)


@compiled
def adapt(e, pressure_ratio, m, c, s):
    """(13), lambda_hat' = gamma (B_m^-1 e) lambda_hat g(r, epsilon), with the modelled position a in place of r.

    Where both |r| and |a| are above epsilon this is (13) itself: r = lambda_hat a, so lambda_hat g(r) = 1/a = g(a). Where both
    are within epsilon, kappa of (17) is a^2 / epsilon^2, and the estimate adapts 1 / lambda_hat^2 times as fast as in the paper.
    The reason is that the deflection a excites the rates, not the reference r.

    The logarithm of lambda_hat is integrated, which keeps the estimates positive, and unbiased under differentiated noise. They
    are projected onto [lambda_min, lambda_max], because without bounds they can diverge however good B_m is. For a jammed
    actuator lambda_hat is its position, which is integrated itself and kept within the stops.
    """
    for i in range(len(s.lambda_hat)):
        x = 0.0
        for j in range(4):
            x += m.B_inv[i, j] * e[j]
        x /= effect_ratio(i, pressure_ratio, m)
        if s.jammed[i]:
            s.lambda_hat[i] = min(max(s.lambda_hat[i] + c.dt * c.gamma[i] * x, m.low[i]), m.high[i])
            continue
        rate = c.gamma[i] * x * modified_inverse(s.position[i], c.epsilon[i])
        estimate = s.lambda_hat[i] * math.exp(c.dt * rate / s.lambda_hat[i])
        s.lambda_hat[i] = min(max(estimate, c.lambda_min), c.lambda_max)


@compiled
def is_to_blame(i, c, s):
    """Whether a low estimate of actuator i is its own failure: it fell by more than `SUDDENLY`, or by more than any other estimate
    in use has changed, and none of those is at its upper limit. An estimate with a larger standard deviation says nothing.

    When another actuator fails, all estimates share the explanation of its force at first, and at the limit is one whose force is
    more than effectiveness explains. That of a weak actuator has little way to go until it is below the threshold: a surface that
    had kept 0.1 to 0.25 was given up for a propeller that stuck."""
    fell = s.lambda_before[i] - s.lambda_hat[i]
    if fell > SUDDENLY or not c.weighted:
        return True
    for j in range(len(s.lambda_hat)):
        if j != i and not s.failed[j] and s.P[j, j] < SUDDENLY * SUDDENLY:
            changed = abs(s.lambda_before[j] - s.lambda_hat[j]) > fell
            if changed or s.lambda_hat[j] >= c.lambda_max:
                return False
    return True


@compiled
def is_steady(y, ref):
    """Whether the flight goes on as it should: altitude within `STEADY_M` of its reference, and no more than that stored less as
    airspeed. One that lost its engine keeps altitude until it has lost its airspeed."""
    missing = (ref.airspeed * ref.airspeed - y.airspeed * y.airspeed) / (2.0 * GRAVITY_M_S2)
    return abs(ref.altitude - y.altitude) < STEADY_M and missing < STEADY_M


@compiled
def monitor(steady, c, s):
    """Section 2.3: flag an actuator as failed when its estimate stays below `threshold`, and remove the flag when the estimate
    stays above `recovery`. Returns 1 if a flag changed.

    An actuator is flagged only if its estimate's standard deviation is at most `flag_std_max`. The estimate of an actuator that
    hardly moves is uncertain, so a low value is no evidence of failure. (13) gives no standard deviation: with it the limit is
    infinite. With `weighted` it must also be the one that `is_to_blame`. A flag that `ModeSwitch` has taken back as `early` comes
    again when the estimate has stayed low for `WAIT_S` and the flight is no longer `steady`: one that holds its altitude would lose
    it by giving up what seems lost.
    """
    changed = 0
    for i in range(len(s.lambda_hat)):
        if s.jammed[i]:
            continue  # its estimate is a position; `jam_detection` has its timers
        s.lambda_before[i] += c.dt / BEFORE_S * (s.lambda_hat[i] - s.lambda_before[i])
        if s.failed[i]:
            beyond, time = s.lambda_hat[i] > c.recovery, c.recovery_time
        else:
            certain = s.P[i, i] <= c.flag_std_max * c.flag_std_max
            low = s.lambda_hat[i] < c.threshold + c.threshold_rise[i]
            beyond, time = low and certain and is_to_blame(i, c, s), c.persistence
            if s.early[i]:
                beyond, time = certain and s.lambda_hat[i] < STILL_LOW, math.inf if steady else WAIT_S
        s.flag_timer[i] = s.flag_timer[i] + c.dt if beyond else 0.0
        s.since_flag[i] += c.dt
        if s.flag_timer[i] > time + TIMER_ROUNDING:
            s.early[i] = 1 if c.weighted and not s.failed[i] and not s.early[i] else 0
            s.failed[i] = 0 if s.failed[i] else 1
            s.flag_timer[i], s.since_flag[i] = 0.0, 0.0
            changed = 1
    return changed


@compiled
def invert(nu, pressure_ratio, m, k, s):
    """(29): r = r_trim + B_hat^-1 nu; while nothing has failed this is (6). r_trim is zero unless the mode is regulated.

    A surface keeps the force that it has at the mode's trim, so at another airspeed r_trim changes as 1/V^2.
    """
    for i in range(len(s.r)):
        s.r[i] = k.trim_effect[i]
        for j in range(4):
            s.r[i] += k.B_hat_inv[i, j] * nu[j]
        s.r[i] /= effect_ratio(i, pressure_ratio, m)


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

    `shift` is the offset of a surface that has moved from its command (`offset_detection`), and 0 for all others.
    """
    for i in range(len(s.u)):
        u = (s.r[i] - s.shift[i]) / divisor(i, c, s) if k.available[i] else m.trim_position[i]
        s.u[i] = min(max(u, m.low[i]), m.high[i])
