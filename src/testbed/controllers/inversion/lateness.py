"""Late actuators: how much later each acts than its model says, so that delay is not taken for lost effectiveness.

An actuator that is moved to and fro and acts late seems to be weak: the part of its effect that is in phase with its model is
smaller (a delay T at the frequency w leaves cos wT). To divide its reference by so low an estimate raises the gain of a loop
that has lost phase already.

The first lag of the regression is ahead of the second by its time constant 1/w_f, so phi_1 - phi_2 is the rate of phi_2 over w_f. A
delay of l time constants is taken for the all-pass with the same delay (Pade's approximation of first order),

    (1 - l s / 2 w_f) / (1 + l s / 2 w_f) = 1 - l (s / w_f) / (1 + l s / 2 w_f),

so a position that is late has the effect phi_2 - l rho, where rho is phi_1 - phi_2 through a lag of l/2 time constants. It is as
large as phi_2 at each frequency, as the effect of a late actuator is. With the first term of the series alone,
phi_2 - l (phi_1 - phi_2), it grows with the frequency: a surface that swung late seemed weak all the same. The derivative with l is
minus rho through one more such lag. l is a random walk for each actuator, updated by the innovation e - b of the four rates one
after the other, as a Kalman filter of one state.

Letters: c settings, s memory, w, e and phi the working memory; their fields, shapes and units are in `records`.
"""

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.law import low_pass

LATEST = 5.0
"""Largest lateness [1/w_f], .25 s: the latest that was flown. By then the all-pass lacks phase at the rate of the swings."""
SHORTEST = 1e-3
"""Least lateness that the lags of rho are given, so that nothing is divided by zero."""
MOST_VARIANCE = 0.05
"""Largest variance of a lateness. Were it larger, a sudden loss would at first be taken for a delay."""


@compiled
def act_late(phi, c, s, w):
    """Delay the regressor Phi [4, n], the output of the second lag, by the estimated lateness of each actuator."""
    twice = 2.0 * c.filter_rate * c.dt
    for j in range(len(s.late)):
        for i in range(4):
            w.rate[i] = s.filtered_phi[0, i, j] - s.filtered_phi[1, i, j]
        low_pass(w.rate, s.late_rate[j], twice / max(s.late[j], SHORTEST))
        for i in range(4):
            phi[i, j] -= s.late[j] * s.late_rate[j, 0, i]


@compiled
def estimate_lateness(e, c, s):
    """Update the lateness of each actuator by the error e [4] of this step."""
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
        s.late[j] = min(max(s.late[j], 0.0), LATEST)
        s.late_variance[j] = min(s.late_variance[j], MOST_VARIANCE)
