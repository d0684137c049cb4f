"""Late actuators: how much later each acts than its model says, so that delay is not taken for lost effectiveness.

An actuator that is moved to and fro and acts late seems to be weak: the part of its effect that is in phase with its model is
smaller (a delay T at the frequency w leaves cos wT). To divide its reference by so low an estimate raises the gain of a loop
that has lost phase already. The two lags of the regression give what a delay changes: the first is ahead of the second by the
time constant 1/w_f, so a position that is late by l time constants has the effect

    phi_2 - l (phi_1 - phi_2)

to first order. l is a random walk for each actuator, updated by the innovation e - b of the four rates one after the other, as
a Kalman filter of one state.

Letters: c settings, s memory, e and phi of the working memory; their fields, shapes and units are in `records`.
"""

from __future__ import annotations

from testbed.common.jit import compiled

LATEST = 3.0
"""Largest lateness [1/w_f]: beyond it the first-order correction is no better than none."""
MOST_VARIANCE = 0.05
"""Largest variance of a lateness. Were it larger, a sudden loss would at first be taken for a delay."""


@compiled
def act_late(phi, s):
    """Delay the regressor Phi [4, n], the output of the second lag, by the estimated lateness of each actuator."""
    for i in range(4):
        for j in range(len(s.late)):
            phi[i, j] -= s.late[j] * (s.filtered_phi[0, i, j] - s.filtered_phi[1, i, j])


@compiled
def estimate_lateness(e, c, s):
    """Update the lateness of each actuator by the error e [4] of this step."""
    n = len(s.late)
    for j in range(n):
        s.late_variance[j] += c.late_noise * c.late_noise * c.dt
        if s.jammed[j] or s.failed[j]:
            continue
        for i in range(4):
            h = -s.lambda_hat[j] * (s.filtered_phi[0, i, j] - s.filtered_phi[1, i, j])
            noise = c.noise[i] * c.noise[i] / c.dt + s.P[n + i, n + i]
            gain = s.late_variance[j] * h / (h * h * s.late_variance[j] + noise)
            s.late[j] += gain * (e[i] - s.b[i])
            s.late_variance[j] -= gain * h * s.late_variance[j]
        s.late[j] = min(max(s.late[j], 0.0), LATEST)
        s.late_variance[j] = min(s.late_variance[j], MOST_VARIANCE)
