"""Jams: an actuator that is jammed, offset or reversed adds a force of its own, which no loss of effectiveness explains.

The test is a generalised likelihood ratio (GLR; Willsky and Jones, IEEE TAC 21 (1976) 108) on the mean of the residual e.
An actuator that it finds is flagged as failed and jammed, and from then on its position is estimated in place of its
effectiveness (`law.regressor` has one scaled unit in its column).

Letters: m design model, c settings, s memory, e of the working memory; their fields, shapes and units are in `records`.
pressure_ratio is (V/V_0)^2.
"""

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, JAM_VARIANCE, reset_covariance

REVERSED_BELOW = -0.5
"""An estimate below this, with a small standard deviation, is no loss of effectiveness: the actuator is reversed."""
RECENT_FLAG_S = 2.0
"""A flag of another actuator that is younger than this may be due to the jam, which takes about as long to detect."""
REDESIGN_AFTER = 0.3
"""Scaled units by which a jammed actuator's estimated position may move before its mode is designed again."""


@compiled
def detect_jam(e, pressure_ratio, m, c, s):
    """Look for jammed actuators in e [4]; returns 1 when the mode must be designed, or designed again.

    An actuator is taken for jammed when the residual points to it for `jam_time`, or when its estimate has been below
    `REVERSED_BELOW` for `persistence` with a standard deviation of at most `flag_std_max`.
    """
    for row in range(4):
        s.residual[row] += c.dt / c.residual_time * (e[row] - s.residual[row])
    likeliest, offset = likeliest_jam(pressure_ratio, m, c, s)
    changed = 0
    for i in range(len(s.lambda_hat)):
        certain = s.P[i, i] <= c.flag_std_max * c.flag_std_max
        acts_reversed = s.lambda_hat[i] < REVERSED_BELOW and certain and not s.jammed[i]
        s.reversal_timer[i] = s.reversal_timer[i] + c.dt if acts_reversed else 0.0
        s.jam_timer[i] = max(s.jam_timer[i] + (c.dt if i == likeliest else -c.dt), 0.0)
        if s.jam_timer[i] > c.jam_time or s.reversal_timer[i] > c.persistence + 1e-9:
            position = s.lambda_hat[i] * s.position[i] + (offset if i == likeliest else 0.0)
            take_for_jammed(i, position, m, s)
            changed = 1
        if s.jammed[i] and abs(s.lambda_hat[i] - s.designed_position[i]) > REDESIGN_AFTER:
            changed = 1
    return changed


@compiled
def likeliest_jam(pressure_ratio, m, c, s):
    """The actuator whose extra force explains the residual best, and the size of that force.

    For each actuator i the residual is fitted by B_i offset, with rows weighted by one over the variance that gusts and
    the model's error give them. The likelihood ratio is the square of the fitted offset in its standard deviations.

    Returns:
        Index of the actuator with the largest ratio beyond `jam_sigma`^2, or -1; and its offset [scaled].
    """
    likeliest, largest, offset = -1, c.jam_sigma * c.jam_sigma, 0.0
    for i in range(len(s.lambda_hat)):
        projection, information = 0.0, 0.0
        for row in range(4):
            b = m.B[row, i] * (pressure_ratio if m.servo[i] else 1.0)
            gusts = 0.5 * c.noise[row] * c.noise[row] / c.residual_time
            weight = 1.0 / (gusts + s.model_error_variance[row])
            projection += b * weight * s.residual[row]
            information += b * weight * b
        ratio = projection * projection / information
        if not s.jammed[i] and ratio > largest:
            likeliest, largest, offset = i, ratio, projection / information
    return likeliest, offset


@compiled
def take_for_jammed(i, position, m, s):
    """Flag actuator i as jammed at about this position [scaled], which is estimated from now on.

    Until now its force has falsified the estimates of the others. So those that are not flagged start again at 1, and
    so do those that were flagged less than `RECENT_FLAG_S` ago.
    """
    n = len(s.failed)
    s.jammed[i], s.failed[i] = 1, 1
    s.jam_timer[i], s.reversal_timer[i] = 0.0, 0.0
    for j in range(n):
        if not s.jammed[j] and s.since_flag[j] < RECENT_FLAG_S:
            s.failed[j] = 0
        if not s.failed[j]:
            s.lambda_hat[j] = 1.0
            reset_covariance(j, HEALTHY_VARIANCE, s)
    s.lambda_hat[i] = min(max(position, m.low[i]), m.high[i])
    reset_covariance(i, JAM_VARIANCE, s)
    for row in range(4):
        s.residual[row], s.b[row] = 0.0, 0.0
        reset_covariance(n + row, s.model_error_variance[row], s)
