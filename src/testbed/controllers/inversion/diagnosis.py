"""Past the paper, for weather: effectiveness beside the model's own error, and what is no loss of effectiveness at all.

Plain Python that numba compiles, with the names and records of `law`.
"""

from __future__ import annotations

from testbed.common.jit import compiled

HEALTHY_VARIANCE = 0.01  # of an estimate to begin with: whole within a tenth
JAM_VARIANCE = 16.0  # of a jammed actuator's position to begin with, in scaled units
REVERSED = -0.5  # an estimate below this is no loss of effectiveness
JUST_NOW_S = 2.0  # a jam takes about as long to be told from a loss
JAM_MOVED = 0.3  # scaled units that a jammed actuator may move before its mode is designed again


@compiled
def doubt(y, pressure, phi, m, c, s):
    """Variance of what f_m and B_m leave out of each rate, were each of their slopes wrong by `model_doubt` on its own.

    The trim itself is known, so it is what has changed since that counts: a rate is trusted the less the further state
    and actuators' forces are from those of the trim. Averaged over `residual_time`.
    """
    speed = y.airspeed / m.airspeed
    for i in range(4):
        alpha, beta = pressure * m.A[i, 0] * (y.alpha - m.alpha), pressure * m.A[i, 1] * y.beta
        p, q, r = speed * m.A[i, 2] * y.p, speed * m.A[i, 3] * y.q, speed * m.A[i, 4] * y.r
        squares = alpha * alpha + beta * beta + p * p + q * q + r * r
        for j in range(len(s.lambda_hat)):
            change = phi[i, j] * s.lambda_hat[j] - pressure * m.B[i, j] * m.hold[j]
            squares += change * change
        variance = c.doubt[i] * c.doubt[i] + c.model_doubt * c.model_doubt * squares
        s.doubt[i] += c.dt / c.residual_time * (variance - s.doubt[i])


@compiled
def adapt_weighted(z, phi, m, c, s):
    """(13) with its gain Phi^-1 replaced by a Kalman gain, for weather: rows that gusts disturb count for less.

    Each row of z = Phi lambda + b + noise is one scalar measurement. lambda is a random walk; b is what f_m leaves out,
    slow (a first-order Markov process of `doubt_rate` and of the variance that `doubt` gives): without it the error of
    the model reads as lost effectiveness, and surely, of an actuator that hardly acts. The noise has the spectral
    density c.noise^2; epsilon is no longer needed, because small commands carry little weight by themselves.
    P is the covariance of (lambda, b), bounded by that of not knowing lambda at all; estimates are projected as in
    `adapt`.
    """
    n = len(s.lambda_hat)
    for i in range(n):
        walk = c.jam_walk if s.jammed[i] > 0.5 else c.walk
        s.P[i, i] = min(s.P[i, i] + walk * walk * c.dt, JAM_VARIANCE if s.jammed[i] > 0.5 else 1.0)
    fade = 1.0 - c.doubt_rate * c.dt
    for row in range(4):
        s.b[row] *= fade
        for i in range(n + 4):
            s.P[n + row, i] *= fade
            s.P[i, n + row] *= fade
        s.P[n + row, n + row] += 2.0 * c.doubt_rate * c.dt * s.doubt[row]
    for row in range(4):
        h = phi[row]
        error = z[row] - s.b[row]
        for i in range(n + 4):
            s.Ph[i] = s.P[i, n + row]
            for j in range(n):
                s.Ph[i] += s.P[i, j] * h[j]
        variance = c.noise[row] * c.noise[row] / c.dt + s.Ph[n + row]
        for i in range(n):
            error -= h[i] * s.lambda_hat[i]
            variance += h[i] * s.Ph[i]
        for i in range(n):
            s.lambda_hat[i] += s.Ph[i] * error / variance
        for i in range(4):
            s.b[i] += s.Ph[n + i] * error / variance
        for i in range(n + 4):
            for j in range(n + 4):
                s.P[i, j] -= s.Ph[i] * s.Ph[j] / variance
    for i in range(n):
        low = m.low[i] if s.jammed[i] > 0.5 else c.lambda_min
        high = m.high[i] if s.jammed[i] > 0.5 else c.lambda_max
        s.lambda_hat[i] = min(max(s.lambda_hat[i], low), high)


@compiled
def begin_again(j, variance, s):
    """Forget what P has of its row j: this variance, correlated with nothing."""
    for i in range(len(s.Ph)):
        s.P[j, i], s.P[i, j] = 0.0, 0.0
    s.P[j, j] = variance


@compiled
def jam(i, position, m, s):
    """Take actuator i for jammed at about this position, which is estimated from now on.

    What its force did to the estimates of the others was not theirs: those that have not failed, or were called failed
    just now, begin again.
    """
    n = len(s.failed)
    s.jammed[i], s.failed[i], s.suspicion[i], s.reversed[i] = 1.0, 1.0, 0.0, 0.0
    for j in range(n):
        if s.jammed[j] < 0.5 and s.since[j] < JUST_NOW_S:
            s.failed[j] = 0.0
        if s.failed[j] < 0.5:
            s.lambda_hat[j] = 1.0
            begin_again(j, HEALTHY_VARIANCE, s)
    s.lambda_hat[i] = min(max(position, m.low[i]), m.high[i])
    begin_again(i, JAM_VARIANCE, s)
    for row in range(4):
        s.residual[row], s.b[row] = 0.0, 0.0
        begin_again(n + row, s.doubt[row], s)


@compiled
def suspect(e, pressure, m, c, s):
    """Past the paper: what is left of e once the estimates have moved, when no effectiveness explains it.

    An actuator that is jammed, offset or reversed adds a force of its own, B_i b. The generalised likelihood ratio
    of one such b (Willsky and Jones, IEEE TAC 21 (1976) 108) is compared for all actuators, rows weighted by what
    gusts and the model's own error do to them; the best, if it stays beyond `jam_sigma` standard deviations for
    `jam_time`, is called jammed: not a loss of effectiveness; so is one whose estimate is surely negative. From then on
    its position is estimated. Returns 1 when a mode must be designed (again).
    """
    best, most, offset = -1, c.jam_sigma * c.jam_sigma, 0.0
    for row in range(4):
        s.residual[row] += c.dt / c.residual_time * (e[row] - s.residual[row])
    for i in range(len(s.lambda_hat)):
        along, size = 0.0, 0.0
        for row in range(4):
            b = m.B[row, i] * (pressure if m.servo[i] > 0.5 else 1.0)
            weight = 1.0 / (0.5 * c.noise[row] * c.noise[row] / c.residual_time + s.doubt[row])
            along += b * weight * s.residual[row]
            size += b * weight * b
        ratio = along * along / size
        if s.jammed[i] < 0.5 and ratio > most:
            best, most, offset = i, ratio, along / size
    changed = 0
    for i in range(len(s.lambda_hat)):
        against = s.lambda_hat[i] < REVERSED and s.P[i, i] <= c.certain * c.certain and s.jammed[i] < 0.5
        s.reversed[i] = s.reversed[i] + c.dt if against else 0.0
        s.suspicion[i] = max(s.suspicion[i] + (c.dt if i == best else -c.dt), 0.0)
        if s.suspicion[i] > c.jam_time or s.reversed[i] > c.persistence + 1e-9:
            jam(i, s.lambda_hat[i] * s.position[i] + (offset if i == best else 0.0), m, s)
            changed = 1
        if s.jammed[i] > 0.5 and abs(s.lambda_hat[i] - s.designed_for[i]) > JAM_MOVED:
            changed = 1
    return changed
