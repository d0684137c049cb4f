"""How often noise alone makes the monitor flag an actuator (section 2.3): exact for the sampled law, as a Markov chain.

A diffusion crosses a level infinitely often or not at all, so "how often" needs the control step and the persistence. The
chain is the law's own step on a logarithmic grid of x = lambda_hat / lambda. The shape nu of white noise is one over the variance
of x, to first order. A step of gamma kappa dt = c adds to log x a normal number with

    mean c (1/x - 1),   standard deviation sqrt(2 c / nu) x^-p,

p = 0 at a constant reference, where the estimate multiplies the noise, and p = 1 at a constant position. A false alarm is the step
in which x has been below the threshold for the whole persistence. Flights lie between the two; that of the position has more
alarms.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from scipy.special import ndtr

REFERENCE, POSITION = 0, 1
"""What is held: the power p above."""
CELL = 0.5
"""Width of a cell, in standard deviations of one step at x = 1."""
_MOST_CELLS = 1200
_TINY = 1e-12
"""Mass that may be left out."""


def false_alarm_rate(
    nu: float, rate: float, dt: float, persistence_s: float, threshold: float, held: int = POSITION
) -> float:
    """False alarms per second of one actuator, while none is raised.

    Args:
        nu: shape of its white noise, above 1.
        rate: gamma kappa [1/s].
        persistence_s: how long the estimate must stay below the threshold.
        threshold: over the true effectiveness, below 1.
        held: `REFERENCE` or `POSITION`.
    """
    if math.exp(-0.5 * nu * (1.0 - threshold) ** 2) < _TINY:  # the normal tail, which is the heavier one
        return 0.0
    chain, low, stationary = _chain(nu, rate * dt, threshold, held)
    flow = (np.where(low, 0.0, stationary) @ chain)[low]
    # The monitor counts k dt with a strict comparison, so that it flags one step after the persistence has passed.
    within = chain[np.ix_(low, low)]
    steps = math.floor(persistence_s / dt + 1e-6)
    return float((flow @ np.linalg.matrix_power(within, steps)).sum() / dt)


@lru_cache(64)
def _chain(nu: float, step: float, threshold: float, held: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Transition probabilities [k, k], which cells are below the threshold [k], and the stationary probabilities [k]."""
    edges = _edges(nu, CELL * math.sqrt(2.0 * step / nu), math.log(threshold), held)
    log_x = 0.5 * (edges[:-1] + edges[1:])
    mean = log_x + step * np.expm1(-log_x)
    std = math.sqrt(2.0 * step / nu) * np.exp(-held * log_x)
    inner = np.concatenate([[-np.inf], edges[1:-1], [np.inf]])
    chain = np.diff(ndtr((inner[None, :] - mean[:, None]) / std[:, None]), axis=1)
    return chain, log_x < math.log(threshold), _stationary(chain)


def _edges(nu: float, width: float, threshold: float, held: int) -> np.ndarray:
    """[k + 1] edges of the cells in log x, with the threshold as one of them, between which is all but `_TINY` of the mass."""
    spread = math.sqrt(-2.0 * math.log(_TINY) / nu)
    high = math.log1p(spread) if held == POSITION else max(spread, -math.log(_TINY) / nu)
    low = threshold - min(3.0, spread + 0.5)
    width = max(width, (high - low) / _MOST_CELLS)
    below, above = math.ceil((threshold - low) / width), math.ceil((high - threshold) / width)
    lower = np.linspace(low, threshold, below, endpoint=False)
    return np.concatenate([lower, np.linspace(threshold, high, above + 1)])


def _stationary(chain: np.ndarray) -> np.ndarray:
    """The left eigenvector of eigenvalue 1, with the sum 1."""
    equations = chain.T - np.eye(len(chain))
    equations[-1] = 1.0
    right = np.zeros(len(chain))
    right[-1] = 1.0
    found: np.ndarray = np.linalg.solve(equations, right)
    return np.maximum(found, 0.0)
