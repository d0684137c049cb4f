"""Late actuators: how much later each acts than its model says, so that delay is not taken for lost effectiveness.

An actuator that oscillates and acts late seems to be weak: the part of its effect that is in phase with its model is smaller
(a delay T at the frequency w leaves cos wT). Dividing its reference by so low an estimate raises the gain of a loop that has lost
phase already.

Lateness l is the delay in time constants 1/w_f of the regression's two equal lags, whose outputs are phi_1 and phi_2. Because
phi_2' = w_f (phi_1 - phi_2), the rate of phi_2 is known without differentiating. A delay l / w_f is approximated by the all-pass
with the same delay (Pade's approximation of first order),

    (1 - l s / 2 w_f) / (1 + l s / 2 w_f) = 1 - l (s / w_f) / (1 + l s / 2 w_f).

So the effect of a late actuator is phi_2 - l rho, where rho is phi_1 - phi_2 through a lag of l/2 time constants. An all-pass
leaves its size as it is at every frequency. The first term of the series alone, phi_2 - l (phi_1 - phi_2), grows with frequency,
and a late surface that oscillated seemed weak all the same.

Each l is a random walk, estimated by a Kalman filter of one state from the innovation e - b of the four rates, one after the other.
The derivative of the effect by l is minus rho through one more such lag.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.law import low_pass

LATENESS_MAX = 5.0
"""Largest lateness [1/w_f], 0.25 s with the default filter: the largest that was flown. There the all-pass already lacks phase at
the frequency of the oscillations that a delay causes."""
LATENESS_MIN = 1e-3
"""Least lateness [1/w_f] for the lags of rho, so that nothing is divided by zero."""
VARIANCE_MAX = 0.05
"""Largest variance of a lateness [1/w_f^2]. Were it larger, a sudden loss would at first be taken for a delay."""


@compiled
def delay_regressor(phi, c, s, w):
    """Delay the regressor Phi [4, n], the output of the second lag, by the estimated lateness of each actuator."""
    step = 2.0 * c.filter_rate * c.dt  # of a lag of l/2 time constants, times l
    for j in range(len(s.late)):
        for i in range(4):
            w.rate[i] = s.filtered_phi[0, i, j] - s.filtered_phi[1, i, j]
        low_pass(w.rate, s.late_rate[j], step / max(s.late[j], LATENESS_MIN))
        for i in range(4):
            phi[i, j] -= s.late[j] * s.late_rate[j, 0, i]


@compiled
def estimate_lateness(e, c, s):
    """Update lateness and its variance for each actuator that works, by the error e [4] of (10) in this step."""
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
        s.late_variance[j] = min(s.late_variance[j], VARIANCE_MAX)
