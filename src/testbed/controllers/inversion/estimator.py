"""Weighted estimation, for weather and real sensors: Kalman filters for effectiveness and the model's error, and for lateness.

The regression (10) is z = Phi lambda + b + noise, four scalar measurements a step. The states are lambda, a random walk,
and b, the model error: what f_m and B_m leave out of each rate. b is a first-order Gauss-Markov process with correlation time
1 / `model_error_rate` and the variance of `update_model_error_variance`. Without b, a model error would be taken for lost
effectiveness, most of all for an actuator that is hardly deflected. The noise is the disturbance of each rate by gusts, so the
rates that gusts disturb most have the least weight. A small position has little weight by itself, so no epsilon is needed.

Lateness is how much later an actuator acts than its model says. One that oscillates and acts late seems to be weak: the part of its
effect that is in phase with its model is smaller (a delay T at the frequency w leaves cos wT). Dividing its reference by so low an
estimate raises the gain of a loop that has lost phase already.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.inversion.evidence import MEAN_S
from testbed.controllers.inversion.law import beyond_tangent, lag_gain, lagged
from testbed.controllers.inversion.offset_detection import expect_offset, is_of_position
from testbed.controllers.inversion.sensor_guard import unseen
from testbed.controllers.records import D_ALPHA, D_BETA, D_P, D_Q, D_R, U_DOT

HEALTHY_VARIANCE = 0.01
"""Initial variance of an effectiveness estimate: 1 with a standard deviation of 0.1."""
UNKNOWN_VARIANCE = 1.0
"""Largest variance of an effectiveness estimate: a standard deviation of 1 means that nothing is known."""
JAM_MOVES_FACTOR = 4.0
"""Factor on the test value of a change of a jammed actuator's position: that a broken actuator moves is likelier than that a
healthy one breaks. Without it, the force of a surface that swings was taken for weakness of both propellers."""
JAM_VARIANCE, JAM_NOISE = 16.0, 0.2
"""Initial and largest variance of a jammed actuator's estimated position [scaled^2], and its process noise [scaled/sqrt(s)]. A
jammed surface stays where it is, and the thrust of a stuck propeller changes with airspeed only. With 1.0, gusts at 25 ft/s moved
the estimated thrust by 2 units within a second."""
CHANGE_TIME_S, CHANGE_SIGMA, CHANGE_LEAD = 0.3, 2.5, 1.3
"""When a change of one effectiveness is expected (`expect_change`): the time over which innovations are averaged [s], the size of
the change in its standard deviations, and how many times better than the next one it explains the average."""
REVERSAL_S = 0.6
"""How long after an actuator was taken for jammed it may turn out to be reversed [s]: it is commanded to where
a reversed one is at its trim position, and the estimate shows where its force goes."""
REVERSAL_NOISE = 5.0
"""Process noise of a surface's position in that time [scaled/sqrt(s)]: what is reversed goes back with its command within 0.1 s.
With the noise of a jam the estimate was 0.2 s late."""

LATENESS_MAX = 8.0
"""Largest lateness [1/w_f], 0.4 s with the default filter: the longest delay that the suite `open` draws."""
LATENESS_MIN = 1e-3
"""Least lateness [1/w_f] for the lags of rho, so that nothing is divided by zero."""
LATENESS_VARIANCE_MAX = 0.05
"""Largest variance of a lateness [1/w_f^2]. Were it larger, a sudden loss would at first be taken for a delay."""


@compiled
def update_model_error_variance(y, pressure_ratio, phi, m, c, s):
    """Variance of the model error b in each rate, if the relative errors of the coefficients are independent, with standard
    deviation `coefficient_error`, and what is `beyond_model`.

    The model is most accurate at its own trim, so each term of f_m and of Phi lambda enters by its difference from the trim.
    The variance is at least `model_error_std`^2, and is averaged over `MEAN_S`. That of `u_dot` rises at once: drag grows
    with a hard pull-up by more than the model says, and healthy engines were flagged before the average knew. In the rates of
    rotation every gust would raise it, and hide losses.
    """
    speed = y.airspeed / m.airspeed
    for i in range(4):
        alpha = pressure_ratio * m.A[i, D_ALPHA] * (y.alpha - m.alpha)
        if i == U_DOT:
            alpha += pressure_ratio * beyond_tangent(y, m)
        beta = pressure_ratio * (m.A[i, D_BETA] * y.beta + m.sideslip[i] * abs(y.beta))
        p, q, r = speed * m.A[i, D_P] * y.p, speed * m.A[i, D_Q] * y.q, speed * m.A[i, D_R] * y.r
        squares = alpha * alpha + beta * beta + p * p + q * q + r * r
        for j in range(len(s.lambda_hat)):
            change = phi[i, j] * s.lambda_hat[j] - pressure_ratio * m.B[i, j] * m.trim_position[j]
            squares += change * change
        floor = c.model_error_std[i] * c.model_error_std[i]
        variance = floor + c.coefficient_error * c.coefficient_error * squares
        if c.coefficient_error > 0.0:  # else the model is taken for exact, as with `model_error` switched off
            beyond = pressure_ratio * beyond_model(i, y, m)
            variance += beyond * beyond + unseen(i, m, s)
        if i == U_DOT and variance > s.model_error_variance[i]:
            s.model_error_variance[i] = variance
        else:
            s.model_error_variance[i] += c.dt / MEAN_S * (variance - s.model_error_variance[i])


@compiled
def beyond_model(row, y, m):
    """What f_m may leave out of a rate where it is no model, at V_0 [x_c]: beyond the stall its slope at the stall, since lift no
    longer grows; in u_dot the side force, which leans forward in a sideslip, or the drag by which some models make up for it."""
    slope, side = m.A[row, D_ALPHA], 0.0
    if row == U_DOT:
        slope += 2.0 * m.forward_curvature * (m.stall_alpha - m.alpha)
        side = m.side_slope * y.beta * y.beta
    stalled = slope * max(y.alpha - m.stall_alpha, 0.0)
    return math.hypot(stalled, side)


@compiled
def expect_change(e, phi, m, c, s, weight):
    """Give the effectiveness that has just changed the variance of that change, so that the filter follows it at once.

    A random walk follows a sudden loss slowly, and spreads it over all actuators meanwhile. So the mean of the innovation e - b
    over the last `CHANGE_TIME_S` T is explained by a change of each effectiveness alone, by weighted least squares. The weight of a
    rate is one over the variance of its mean: gusts of two-sided density S leave S / 2T, and b adds its own. The test value is
    (change / its standard deviation)^2, twice the logarithm of the likelihood ratio, times `JAM_MOVES_FACTOR` for a jammed
    actuator. If the best is above `CHANGE_SIGMA`^2, and `CHANGE_LEAD`^2 times the next best, the variance of that estimate becomes
    at least the square of the change. If the change `is_of_position`, that variance goes to the model error along the
    actuator's column of Phi.

    Args:
        weight: [4] working memory.
    """
    n = len(s.lambda_hat)
    for row in range(4):
        # The mean of the innovation e - b, and one over its variance: S / 2T of gusts, and that of b.
        s.recent[row] += c.dt / CHANGE_TIME_S * (e[row] - s.b[row] - s.recent[row])
        weight[row] = 1.0 / (0.5 * c.noise[row] * c.noise[row] / CHANGE_TIME_S + s.P[n + row, n + row])
    best, first, second, change = -1, 0.0, 0.0, 0.0
    for i in range(len(s.lambda_hat)):
        projection, information = 0.0, 1e-12
        for row in range(4):
            projection += phi[row, i] * weight[row] * s.recent[row]
            information += phi[row, i] * weight[row] * phi[row, i]
        ratio = projection * projection / information
        if s.jammed[i]:
            ratio *= JAM_MOVES_FACTOR
        if ratio > first:
            best, first, second, change = i, ratio, first, projection / information
        elif ratio > second:
            second = ratio
    if first > CHANGE_SIGMA * CHANGE_SIGMA and first > CHANGE_LEAD * CHANGE_LEAD * second:
        if is_of_position(best, s.lambda_hat[best] + change, c, s):
            expect_offset(best, change, phi, m, s)
        else:
            most = JAM_VARIANCE if s.jammed[best] else UNKNOWN_VARIANCE
            s.P[best, best] = max(s.P[best, best], min(change * change, most))


@compiled
def adapt_weighted(z, phi, P_h, m, c, s):
    """One step of the filter, in place of (13): the four rates are used one after the other."""
    predict(m, c, s)
    for row in range(4):  # (10) of one rate each: their noises are independent
        update_by_rate(row, z[row], phi[row], P_h, c, s)
    project(m, c, s)


@compiled
def predict(m, c, s):
    """Time update: P grows by the process noise of lambda, up to a limit, and the model error b decays towards zero."""
    n = len(s.lambda_hat)
    for i in range(n):
        noise = JAM_NOISE if s.jammed[i] else c.process_noise
        if s.jammed[i] and m.servo[i] and s.since_flag[i] < REVERSAL_S:
            noise = REVERSAL_NOISE
        # A limit, because what is not excited would become as uncertain as the time is long.
        most = JAM_VARIANCE if s.jammed[i] else UNKNOWN_VARIANCE
        s.P[i, i] = min(s.P[i, i] + noise * noise * c.dt, most)
    fade = 1.0 - c.model_error_rate * c.dt
    for row in range(4):
        s.b[row] *= fade
        for i in range(n + 4):
            s.P[n + row, i] *= fade
            s.P[i, n + row] *= fade
        # Driven so that b has this variance when it is steady.
        s.P[n + row, n + row] += 2.0 * c.model_error_rate * c.dt * s.model_error_variance[row]


@compiled
def update_by_rate(row, z, h, P_h, c, s):
    """Measurement update by one rate: z = h lambda + b[row] + white noise of two-sided spectral density `c.noise[row]`^2.

    Args:
        z: measured x_c_dot - f_m of this row.
        h: [n] this row of Phi.
        P_h: [n+4] working memory, filled with P (h, e_row), where e_row is the unit vector of b[row].
    """
    n = len(s.lambda_hat)
    error = z - s.b[row]  # the innovation: (10) less the model error
    for i in range(n + 4):
        P_h[i] = s.P[n + row, i]
    for j in range(n):
        for i in range(n + 4):
            P_h[i] += s.P[j, i] * h[j]
    variance = c.noise[row] * c.noise[row] / c.dt + P_h[n + row]
    for i in range(n):
        error -= h[i] * s.lambda_hat[i]
        variance += h[i] * P_h[i]
    share = error / variance
    for i in range(n):  # in place of (13)
        s.lambda_hat[i] += P_h[i] * share
    for i in range(4):
        s.b[i] += P_h[n + i] * share
    for i in range(n + 4):
        gain = P_h[i] / variance
        for j in range(n + 4):
            s.P[i, j] -= gain * P_h[j]


@compiled
def project(m, c, s):
    """Limit estimates to [lambda_min, lambda_max], and the position of a jammed actuator to its stops."""
    for i in range(len(s.lambda_hat)):
        low = m.low[i] if s.jammed[i] else c.lambda_min
        high = m.high[i] if s.jammed[i] else c.lambda_max
        s.lambda_hat[i] = min(max(s.lambda_hat[i], low), high)


@compiled
def reset_covariance(j, variance, s):
    """Give state j of the filter this variance and no correlation with the other states, as at the start."""
    for i in range(len(s.P)):
        s.P[j, i], s.P[i, j] = 0.0, 0.0
    s.P[j, j] = variance


@compiled
def forget_model_error(s):
    """Begin the estimate of the model error b again, at 0."""
    for row in range(4):
        s.b[row] = 0.0
        reset_covariance(len(s.lambda_hat) + row, s.model_error_variance[row], s)


@compiled
def delay_regressor(phi, c, s):
    """Delay the regressor Phi [4, n], the output of the second lag, by the estimated lateness of each actuator.

    Lateness l is one more lag, in time constants 1/w_f of the regression's two equal lags. Of their outputs, phi_1 and phi_2,
    phi_2' = w_f (phi_1 - phi_2), so its rate is known without differentiating. With it

        1 / (1 + l s / w_f) = 1 - l (s / w_f) / (1 + l s / w_f).

    So the effect of a late actuator is phi_2 - l rho, where rho is phi_1 - phi_2 through a lag of l time constants. A slow servo is
    such a lag. A pure delay leaves the size as it is, and so would an all-pass (Pade). But that first goes the wrong way: an f16's
    elevator that was thrown over looked reversed within 0.05 s.
    """
    step = c.filter_rate * c.dt  # of a lag of l time constants, times l
    for j in range(len(s.late)):
        gain = lag_gain(step / max(s.late[j], LATENESS_MIN))
        for i in range(4):
            rate = s.filtered_phi[0, i, j] - s.filtered_phi[1, i, j]
            lagged(rate, s.late_rate[j], i, gain)
            phi[i, j] -= s.late[j] * s.late_rate[j, 0, i]


@compiled
def estimate_lateness(e, c, s):
    """Update lateness and its variance for each actuator that works, by the error e [4] of (10) in this step.

    Each l is a random walk, estimated by a Kalman filter of one state from the innovation e - b of the four rates, one after the
    other. The derivative of the effect by l is minus rho through one more such lag.
    """
    n = len(s.late)
    for j in range(n):
        s.late_variance[j] += c.late_noise * c.late_noise * c.dt
        if s.jammed[j] or s.failed[j]:
            continue
        for i in range(4):
            h = -s.lambda_hat[j] * s.late_rate[j, 1, i]
            noise = c.noise[i] * c.noise[i] / c.dt + s.P[n + i, n + i]
            gain = s.late_variance[j] * h / (h * h * s.late_variance[j] + noise)
            s.late[j] += gain * (e[i] - s.b[i])
            s.late_variance[j] -= gain * h * s.late_variance[j]
        s.late[j] = min(max(s.late[j], 0.0), LATENESS_MAX)
        s.late_variance[j] = min(s.late_variance[j], LATENESS_VARIANCE_MAX)
