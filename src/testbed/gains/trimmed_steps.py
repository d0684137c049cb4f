"""Loops of the flying estimators in a flight whose forces are held, for `trimmed_law`: plain Python that numba compiles.

Letters: m design model, c settings, s memory, w working memory; their fields are in `testbed.controllers.records`. e [steps, 4]
is a change of the measured error, z [4] and phi [4, n] are the two sides of the regression (10).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import adapt_weighted, expect_change, update_model_error_variance
from testbed.controllers.inversion.law import adapt, divisor, low_pass, measured_error, monitor


@compiled
def filter_error(e, lags, a):
    """The two lags of the regression on each row of e [steps, 4], in place."""
    for k in range(len(e)):
        low_pass(e[k], lags, a)


@compiled
def settle(steps, y, pressure_ratio, z, phi, P_h, m, c, s):
    """Run the weighted estimator on the same measurement until its covariance is steady."""
    for _ in range(steps):
        update_model_error_variance(y, pressure_ratio, phi, m, c, s)
        adapt_weighted(z, phi, P_h, m, c, s)


@compiled
def follow(e, z, phi, P_h, m, c, s, out):
    """Feed z + e [steps, 4] to the weighted estimator; its estimates into out [steps, n]."""
    for k in range(len(e)):
        for i in range(4):
            e[k, i] += z[i]
        adapt_weighted(e[k], phi, P_h, m, c, s)
        for j in range(len(s.lambda_hat)):
            out[k, j] = s.lambda_hat[j]


@compiled
def follow_moving(e, phi, P_h, m, c, s, out):
    """`follow` with actuators that move: phi [steps, 4, n], of which z is the sum while all is healthy."""
    n = len(s.lambda_hat)
    for k in range(len(e)):
        for i in range(4):
            for j in range(n):
                e[k, i] += phi[k, i, j]
        adapt_weighted(e[k], phi[k], P_h, m, c, s)
        for j in range(n):
            out[k, j] = s.lambda_hat[j]


@compiled
def follow_newton(x, transition, out):
    """out[k] = transition out[k-1] + x[k], from zero; all [steps, n], transition [n, n]."""
    for k in range(len(x)):
        for i in range(x.shape[1]):
            out[k, i] = x[k, i]
            if k > 0:
                for j in range(x.shape[1]):
                    out[k, i] += transition[i, j] * out[k - 1, j]


@compiled
def follow_loss(truth, ratio, phi_0, force, w, m, c, s, out, flagged):
    """Estimates [steps, n] and flags [steps, n] while references hold the forces of the trimmed flight.

    Args:
        truth: [n] effectiveness from the first step on.
        phi_0: [4, n] regressor of the trimmed flight, behind the lags.
        force: [n] reference of each actuator, its position in that flight [scaled].
    """
    n = len(truth)
    for k in range(len(out)):
        for i in range(4):
            w.z[i] = 0.0
            for j in range(n):
                s.position[j] = min(max(force[j] / divisor(j, c, s), m.low[j]), m.high[j])
                w.phi[i, j] = phi_0[i, j] * s.position[j] / force[j]
                w.z[i] += w.phi[i, j] * truth[j]
            low_pass(w.phi[i], s.filtered_phi[:, i], c.filter_rate * c.dt)
        low_pass(w.z, s.filtered, c.filter_rate * c.dt)
        measured_error(w.z, w.phi, s, w.e)
        if c.weighted:
            expect_change(w.e, w.phi, m, c, s)
            adapt_weighted(w.z, w.phi, w.P_h, m, c, s)
        else:
            adapt(w.e, ratio, m, c, s)
        monitor(False, c, s)
        for j in range(n):
            out[k, j], flagged[k, j] = s.lambda_hat[j], s.failed[j]
