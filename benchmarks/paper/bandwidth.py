"""Bandwidth and saturation (the paper's section 5.2): what lag, delay, sampling, rate limit and stops do to (13).

The *plain* law is the paper's: its regressor is the command u. The *compensated* law has the modelled position in its place
(`testbed.controllers.actuator_model`). A *reading* is lambda_hat / lambda once settled, 1 if right. Readings of moving commands
are for slow adaptation: the gain gamma is well below the frequency of the command, so that only the mean rate of (13) counts.

Derived from log lambda_hat' = gamma g(u) (lambda a / lambda_hat - u), which is (13) with (10) for a position a in place of u.
`tests/paper/test_bandwidth.py` checks each function with the flying law on the ideal plant, and
`benchmarks/section4_bandwidth.py` in JSBSim.
"""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

OVERSHOOT_LIMIT = 0.25
"""gamma kappa tau beyond which an estimate overshoots a small change behind an unmodelled lag tau: there `damping` is 1."""


def lag(w: float, tau: float) -> complex:
    """Response of a first-order lag with time constant tau [s] at w [rad/s]."""
    return 1.0 / complex(1.0, w * tau)


def second_order(w: float, natural: float, damping_ratio: float) -> complex:
    """Response of a second-order servo at w, with its natural frequency [rad/s]."""
    return natural**2 / complex(natural**2 - w**2, 2.0 * damping_ratio * natural * w)


def dead_time(w: float, delay: float) -> complex:
    """Response of a delay [s] at w [rad/s]."""
    return cmath.exp(-1j * w * delay)


def moving_reading(actual: complex, modelled: complex = 1.0) -> float:
    """Reading of a command that moves about zero: Re(F / F_m), F the response of the actuator and F_m that of its model.

    The plain law has F_m = 1: behind a lag it reads 1 / (1 + w^2 tau^2). A reading of zero or less drives the estimate to zero.
    """
    return (actual / modelled).real


def offset_reading(actual: complex, share: float) -> float:
    """Reading of r_0 (1 + share sin w t) with share < 1, far beyond epsilon: Re F + (1 - Re F) / sqrt(1 - share^2), above 1."""
    return actual.real + (1.0 - actual.real) / math.sqrt(1.0 - share**2)


def offset_reading_within(actual: complex, share: float) -> float:
    """The same wholly within epsilon, for any share: (1 + Re F share^2 / 2) / (1 + share^2 / 2), below 1."""
    return (1.0 + actual.real * share**2 / 2.0) / (1.0 + share**2 / 2.0)


def waveform_reading(u: np.ndarray, a: np.ndarray, epsilon: float) -> float:
    """Reading of any regressor u [steps] beside the positions a [steps]: E[g(u) a] / E[kappa(u)] of (14) and (17)."""
    within = np.abs(u) <= epsilon
    g = np.where(within, u / epsilon**2, 1.0 / np.where(within, 1.0, u))
    return float((g * a).mean() / (g * u).mean())


def saturated_rate(gamma: float, demand: float) -> float:
    """Rate of log lambda_hat [1/s] of the plain law at a stop: -gamma (1 - 1/demand), demand = |r| / (lambda a_max) > 1.

    No estimate explains that r is not reached, so the estimate falls exponentially: a saturated actuator looks lost.
    """
    return -gamma * (1.0 - 1.0 / demand)


def stop_reading(real: float, known: float) -> float:
    """Where the fall of `saturated_rate` ends with allocation within the stops, which asks for no r beyond lambda_hat times the
    travel that it knows: at lambda real / known. With a stop that is known this is the truth, for the plain law too."""
    return real / known


def damping(gamma_tau: float) -> float:
    """Damping ratio of the estimate behind an unmodelled first-order lag: 1 / (2 sqrt(gamma kappa tau)). It is always stable."""
    return 0.5 / math.sqrt(gamma_tau)


def extreme(start: float, truth: float, gamma_tau: float) -> float:
    """First extreme of the plain law's estimate after a step of effectiveness, at constant r behind a first-order lag.

    Integrates tau xi'' + xi' = gamma (lambda exp(-xi) - 1) for xi = log lambda_hat, with time in units of tau. Without overshoot it
    is the truth. A large recovery overshoots at a gamma tau below OVERSHOOT_LIMIT already, which is for small changes.

    Args:
        start, truth: effectiveness before and after the step; the estimate begins at `start`.
        gamma_tau: gamma kappa tau.
    """

    def slope(_: float, state: np.ndarray) -> list[float]:
        xi, rate = state
        return [rate, gamma_tau * (truth * math.exp(-xi) - 1.0) - rate]

    def turns(_: float, state: np.ndarray) -> float:
        return float(state[1])

    turns.terminal = True  # type: ignore[attr-defined]
    turns.direction = math.copysign(1.0, start - truth)  # type: ignore[attr-defined]
    begin = [math.log(start), gamma_tau * (truth / start - 1.0)]
    end = 200.0 * max(1.0, abs(math.log(start / truth)) / gamma_tau)
    found = solve_ivp(slope, (0.0, end), begin, events=turns, rtol=1e-9, atol=1e-12)
    turned: Any = found.y_events[0] if found.y_events else []
    return math.exp(turned[0][0]) if len(turned) else truth


def sampled_extreme(start: float, truth: float, gamma_dt: float) -> float:
    """Lowest estimate after a loss of effectiveness at constant r, by the law's recursion of log lambda_hat.

    It is below the truth from gamma kappa dt = 1 on, and the estimate swings without end from 2 on.
    """
    xi, lowest = math.log(start / truth), 0.0
    for _ in range(1000):
        xi += gamma_dt * math.expm1(-xi)
        lowest = min(lowest, xi)
    return truth * math.exp(lowest)


def late_extreme(start: float, truth: float, gamma_delay: float, steps: int = 400) -> float:
    """First extreme of the estimate after a step of effectiveness at constant r, with the error late by a dead time.

    log lambda_hat' = gamma (lambda / lambda_hat(t - T) - 1) in explicit steps of T / `steps`; the truth if it does not overshoot.

    Args:
        gamma_delay: gamma kappa T.
    """
    xi = [math.log(start)] * (steps + 1)
    for _ in range(20 * steps + round(20 * steps / gamma_delay)):
        change = gamma_delay / steps * (truth * math.exp(-xi[-1 - steps]) - 1.0)
        if change * (truth - start) < 0.0:
            return math.exp(xi[-1])
        xi.append(xi[-1] + change)
    return truth


def dead_time_limits(gamma: float) -> tuple[float, float]:
    """Delays [s] between a command and the error that it caused: without overshoot up to 1/(e gamma), stable below pi/(2 gamma)."""
    return 1.0 / (math.e * gamma), math.pi / (2.0 * gamma)


def delay_limits(steps: int) -> tuple[float, float]:
    """Largest gamma kappa dt with the error late by whole steps d: without overshoot d^d / (d+1)^(d+1), stable below
    2 sin(pi / (2 (2 d + 1)))."""
    return steps**steps / (steps + 1) ** (steps + 1), 2.0 * math.sin(math.pi / (2.0 * (2 * steps + 1)))


def second_order_limit(natural: float, damping_ratio: float) -> float:
    """gamma kappa [1/s] below which the estimate is stable behind an unmodelled second-order servo: 2 zeta w_n."""
    return 2.0 * damping_ratio * natural


def sampled_lag_limit(tau_over_dt: float) -> float:
    """gamma kappa dt below which the estimate is stable behind a sampled first-order lag: 2 / tanh(dt / (2 tau)).

    The command is held for each step, and the error is that of the position at its end. Sampling alone destabilises, and the slower
    the lag the later. (The testbed's servo is bilinear: behind it the limit is 2, whatever tau.)
    """
    return 2.0 / math.tanh(0.5 / tau_over_dt)


def slowest_servo(w: float, deviation: float) -> float:
    """Largest unmodelled time constant [s] with which commands that move at w read at least 1 - deviation."""
    return math.sqrt(deviation / (1.0 - deviation)) / w


def latest_sensor(gamma: float, w: float, deviation: float) -> float:
    """Largest age of the rates [s], unknown to the law, with which commands that move at w read at least 1 - deviation, cos(w T),
    and a step of effectiveness is estimated without overshoot."""
    return min(dead_time_limits(gamma)[0], math.acos(1.0 - deviation) / w)
