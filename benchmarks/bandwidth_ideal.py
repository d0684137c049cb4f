"""Bandwidth and saturation on the ideal plant, for `section4_bandwidth.py`."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np
from paper.ideal import UNLIMITED, IdealLoop, IdealPlant, Tuning

from paper import bandwidth, rate_limits

REMAINS = 0.2
"""Effectiveness after a loss."""
W, WITHIN = 4.0, 2.0
"""Frequency [rad/s] of the commands that move, and an epsilon within which all of them are."""


def ideal_reading(lag: float, modelled: float, share: float, limit: float = math.inf) -> float:
    """The estimate of r_0 (1 + share sin W t) within epsilon, once it has settled.

    Args:
        modelled: lag of the model; 0 is the plain law.
        limit: rate limit that no law knows, over the fastest r.
    """
    dt = 0.005
    rate = min(limit * 0.25 * share * W, UNLIMITED)
    loop = IdealLoop(IdealPlant(np.eye(4), lag=lag, rate=rate), Tuning(1.0, WITHIN, dt), 1.0)
    loop._models["lag"][0], loop._models["rate"][0] = modelled, UNLIMITED
    r = 0.25 * (1.0 + share * np.sin(W * dt * np.arange(round(600.0 / dt))))
    period = round(2.0 * math.pi / W / dt)
    return float(loop.fly(np.tile(r[:, None], (1, 4)), 1.0).lambda_hat[-8 * period :, 0].mean())


def ideal_extreme(gamma: float, lag: float) -> float:
    """Lowest estimate after a loss to REMAINS, behind an unmodelled lag."""
    loop = IdealLoop(IdealPlant(np.eye(4), lag=lag, modelled=False), Tuning(gamma, 1e-6, 5e-4), 1.0)
    loop.start_at(np.ones(4))
    return float(loop.fly(np.ones((16000, 4)), REMAINS).lambda_hat.min())


def ideal_sampled(gamma_dt: float) -> float:
    """Lowest estimate after a loss to REMAINS, in steps of gamma dt."""
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma_dt / 0.02, 1e-6, 0.02), 1.0)
    return float(loop.fly(np.ones((400, 4)), REMAINS).lambda_hat.min())


def ideal_late(gamma: float, age: float) -> float:
    """Lowest estimate after a loss to REMAINS with rates of this age: what they differ from the present ones is a disturbance."""
    dt, estimate, lowest = 1e-3, 1.0, 1.0
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-6, dt), 1.0)
    effects = [1.0] * round(age / dt)
    for _ in range(round(4.0 / dt)):
        effects.append(REMAINS / estimate)
        late = effects.pop(0) - REMAINS / estimate
        estimate = float(loop.fly(np.ones((1, 4)), REMAINS, np.full(4, late)).lambda_hat[1, 0])
        lowest = min(lowest, estimate)
    return lowest


def limits() -> Iterator[tuple[str, float, float]]:
    """(condition, prediction, measurement) of what the plain law does at stops, rate limits and late errors."""
    for demand in (1.25, 2.0, 4.0):
        predicted = bandwidth.saturated_rate(4.0, demand)
        yield (
            f"stop, r = {demand:g} lambda a_max, gamma 4 /s: rate of log lambda_hat [1/s]",
            predicted,
            at_stop(demand),
        )
    for share in (0.2, 0.35, 0.5):
        what = f"rate limit R = {share:g} A w, within epsilon: reading"
        yield what, rate_limits.rate_limited_reading(share), rate_limited(share)
    for steps in (0, 1, 2, 5):
        what = f"error late by {steps} steps: largest stable gamma kappa dt"
        yield what, bandwidth.delay_limits(steps)[1], largest_stable(steps)


def at_stop(demand: float, gamma: float = 4.0) -> float:
    """Rate of log lambda_hat of the plain law where the real actuator stops short of r."""
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 0.05), 1.0)
    loop._models["high"][1] = 1.0
    log = np.log(loop.fly(np.full((400, 4), demand), 1.0).lambda_hat[:, 0])
    return float((log[-1] - log[0]) / (400 * Tuning.dt_s))


def rate_limited(share: float) -> float:
    """Estimate at which the mean rate of log lambda_hat vanishes for a sine of amplitude 1 behind a rate limit, by bisection."""
    period, dt = 1600, Tuning.dt_s
    w = 2.0 * math.pi / (period * dt)
    sine = np.sin(2.0 * math.pi * (np.arange(20 * period) + 0.5) / period)

    def falls(estimate: float) -> bool:
        plant = IdealPlant(np.eye(4), lag=2.0 / dt, rate=share * w)
        loop = IdealLoop(plant, Tuning(1e-7, 50.0), estimate)
        loop._models["lag"][0], loop._models["rate"][0] = 0.0, UNLIMITED
        log = np.log(loop.fly(np.tile(estimate * sine[:, None], (1, 4)), 1.0).lambda_hat[:, 0])
        return bool(log[-1] < log[10 * period])

    return bisected(falls, 1e-3, 2.0)


def largest_stable(steps: int) -> float:
    """gamma kappa dt at which a small error begins to grow when it is seen late by whole steps, by bisection."""

    def grows(gamma_dt: float) -> bool:
        loop, estimate = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma_dt, 1e-9, 1.0), 1.0 + 1e-9), 1.0 + 1e-9
        past, seen = [1.0] * steps, []
        for _ in range(400):
            past.append(1.0 / estimate)
            late = past.pop(0) - 1.0 / estimate
            estimate = float(loop.fly(np.ones((1, 4)), 1.0, np.full(4, late)).lambda_hat[1, 0])
            seen.append(abs(estimate - 1.0))
        return max(seen[-100:]) > max(seen[:10])

    return bisected(grows, 0.1, 2.5)


def bisected(beyond: Callable[[float], bool], low: float, high: float) -> float:
    for _ in range(12):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if beyond(middle) else (middle, high)
    return 0.5 * (low + high)
