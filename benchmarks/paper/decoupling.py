"""How fast an estimate may follow and how quiet it may be at once (the paper's 5.2): bounds for (13), L1 and any linear estimator.

The measure is T_5% var / (s / r^2): the time [s] after which a small loss is known, or made up for, to 5 %, times the variance
that white noise of intensity s on B_mc^-1 x_c_dot causes. A linear path has an impulse response h from the true effectiveness to
the estimate, or to the effect lambda u. Its measure is T_5% times the integral of h^2: a gain trades one factor for the other.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import brentq

REACHED = 0.95
"""Share of a step that is reached at T_5%."""
PAPER = 0.5 * math.log(1.0 / (1.0 - REACHED))
"""(22), h = gamma exp(-gamma t): T_5% = ln 20 / gamma and int h^2 = gamma / 2, whatever gamma and epsilon are. 1.50."""
LINEAR_BOUND = REACHED**2
"""No linear estimator has less: int_0^T h >= 0.95 gives T int h^2 >= 0.95^2, by Cauchy and Schwarz. 0.90."""
BOXCAR = REACHED
"""The mean over the last T_0: T_5% = 0.95 T_0, int h^2 = 1 / T_0."""


def cascade(gamma: float, k: float) -> float:
    """Measure of an estimator with the gain gamma, and a control channel with the corner k behind it [1/s], as in `l1_inversion`.

    h has the poles -gamma and -k, and int h^2 = gamma k / (2 (gamma + k)). 1.19 where they are equal, PAPER's where far apart.
    """
    return settling(gamma, k) * gamma * k / (2.0 * (gamma + k))


def settling(gamma: float, k: float) -> float:
    """T_5% [s] of the same cascade."""

    def left(t: float) -> float:
        if abs(gamma - k) < 1e-6 * k:
            return (1.0 + k * t) * math.exp(-k * t) - (1.0 - REACHED)
        return (k * math.exp(-gamma * t) - gamma * math.exp(-k * t)) / (k - gamma) - (1.0 - REACHED)

    return float(brentq(left, 0.0, 10.0 / gamma + 10.0 / k))


def second_order(damping: float) -> float:
    """Measure of a path with two complex poles: int h^2 = w / (4 zeta). 1.04 at zeta = 0.7."""
    w_d = math.sqrt(1.0 - damping**2)
    t = np.linspace(0.0, 20.0, 200001)
    step = 1.0 - np.exp(-damping * t) * (np.cos(w_d * t) + damping / w_d * np.sin(w_d * t))
    outside = np.flatnonzero(np.abs(step - 1.0) > 1.0 - REACHED)
    return float(t[outside[-1] + 1]) / (4.0 * damping)


def of_response(h: np.ndarray, dt: float) -> float:
    """Measure of any sampled impulse response h [steps] that sums to 1 / dt."""
    step = np.cumsum(h) * dt
    outside = np.flatnonzero(np.abs(step - 1.0) > 1.0 - REACHED)
    return float((outside[-1] + 1) * dt * np.sum(h**2) * dt)
