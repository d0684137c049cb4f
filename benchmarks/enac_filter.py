"""Probabilities of the classes of effectiveness over a flight: one Kalman filter for each, which interact.

Interacting multiple models (Blom and Bar-Shalom, IEEE Trans. Automatic Control 33(8), 1988). Besides the class, constant errors of
roll and pitch wander, the elevons differ by a little, and the size of the errors follows the air: a gusty flight has three times
those of a calm one, and what was learnt in the calm one would call its gusts failures.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

STEP_S = 0.1
FREEDOM = 8.0
"""Of Student's distribution, which the errors have: gusts are no Gaussian noise."""
SHARE = 0.05
"""Error of the elevons' columns [1], which adds to the variance."""
MEMORY = 100.0
"""Samples over which the size of the errors is averaged."""
LEAST = 0.7
"""Variance of the white errors is never below this: their median on 21 July."""
START = np.array([0.05, 0.03, 0.03])
WALK = np.array([0.0, 0.002, 0.001])
HOLDS_S = np.array([1e9, 80.0, 160.0])
"""Of the elevons' difference [1], and constant errors of roll and pitch [rad/s]: standard deviation at first, its growth in 1 s,
and how long each lasts.

With FREEDOM, SHARE and the errors' WALK and HOLDS_S the likelihood of 21 July, its faults known, is largest. It would be larger
still with a difference that wanders, a gain that does, and a MEMORY of 3 s; those hide faults, and were not taken."""


class Filtered(NamedTuple):
    """At each sample: logarithms of the classes' probabilities [rows, classes], log-likelihoods of the sample under each, the state
    [rows, 3] of START, and the variance [rows] of the white errors."""

    log_probability: np.ndarray
    evidence: np.ndarray
    state: np.ndarray
    variance: np.ndarray


def filtered(z: np.ndarray, phi: np.ndarray, one: np.ndarray, classes: np.ndarray, change: float) -> Filtered:
    """Filter a flight, each class given what was before.

    Args:
        z: [rows, 2] white rates.
        phi: [rows, 2, 2] what each elevon adds to them if it works.
        one: [rows, 2, 2] what constant errors add.
        classes: [classes, 2] effectiveness of both elevons; a flight begins in the first.
        change: minus the logarithm of the probability that the class changes in a sample.
    """
    kernel = np.ones(10) / 10.0
    of_columns = SHARE**2 * np.stack(
        [np.convolve(c, kernel)[: len(c)] for c in (phi**2).sum(axis=2).T], axis=1
    )
    rows, count = len(z), len(classes)
    made = Filtered(np.zeros((rows, count)), np.zeros((rows, count)), np.zeros((rows, 3)), np.zeros(rows))
    decay = np.exp(-STEP_S / HOLDS_S)
    _run(z, phi, one, of_columns, classes, np.exp(-change), decay, WALK**2 * STEP_S, START**2, *made)
    return made


@njit(cache=True)
def _run(z, phi, one, of_columns, classes, change, decay, walk, start, out, evidence, state, variance):
    count = len(classes)
    x, P = np.zeros((count, 3)), np.zeros((count, 3, 3))
    before, P_before = np.zeros((count, 3)), np.zeros((count, 3, 3))
    log, H, level = np.full(count, -200.0), np.zeros((2, 3)), 1.0
    log[0] = 0.0
    for j in range(count):
        for a in range(3):
            P[j, a, a] = start[a]
    for k in range(len(z)):
        weight = np.exp(log - log.max())
        weight /= weight.sum()
        _mixed(x, P, weight, change, before, P_before)
        best = 0
        for j in range(count):
            for a in range(3):
                before[j, a] *= decay[a]
                for b in range(3):
                    P_before[j, a, b] *= decay[a] * decay[b]
                P_before[j, a, a] += walk[a]
            right, left = classes[j]
            for r in range(2):
                H[r, 0] = right * phi[k, r, 0] - left * phi[k, r, 1]
                H[r, 1], H[r, 2] = one[k, r, 0], one[k, r, 1]
            error = z[k] - right * phi[k, :, 0] - left * phi[k, :, 1] - H @ before[j]
            evidence[k, j] = _updated(error, H, P_before[j], level + of_columns[k], before[j], x[j], P[j])
            stays = weight[j] * (1.0 - change) + (1.0 - weight[j]) * change / (count - 1)
            log[j] = np.log(stays + 1e-300) + evidence[k, j]
            best = j if log[j] > log[best] else best
        log -= log.max() + np.log(np.sum(np.exp(log - log.max())))
        level = _levelled(level, k, z[k], phi[k], one[k], classes[best], x[best], of_columns[k])
        out[k], variance[k] = log, level
        state[k] = np.exp(log) @ x


@njit(cache=True)
def _mixed(x, P, weight, change, before, P_before):
    """Fill what each class begins a sample with: its own state, and that of the classes from which it may come."""
    count = len(weight)
    for j in range(count):
        before[j], P_before[j] = 0.0, 0.0
        total = weight[j] * (1.0 - change) + (1.0 - weight[j]) * change / (count - 1)
        for i in range(count):
            before[j] += weight[i] * (1.0 - change if i == j else change / (count - 1)) / total * x[i]
        for i in range(count):
            share = weight[i] * (1.0 - change if i == j else change / (count - 1)) / total
            if share > 1e-8:
                for a in range(3):
                    for b in range(3):
                        apart = (x[i, a] - before[j, a]) * (x[i, b] - before[j, b])
                        P_before[j, a, b] += share * (P[i, a, b] + apart)


@njit(cache=True)
def _updated(error, H, P_before, variance, before, x, P):
    """Fill a class's state after a sample; returns its log-likelihood, of Student's distribution of two rates."""
    PH = P_before @ H.T
    S = H @ PH
    distance = _squared(error, S[0, 0] + variance[0], S[1, 1] + variance[1], S[0, 1])
    determinant = (S[0, 0] + variance[0]) * (S[1, 1] + variance[1]) - S[0, 1] ** 2
    farther = max(1.0, (FREEDOM + distance) / (FREEDOM + 2.0))  # what is far off counts less
    a, d = S[0, 0] + variance[0] * farther, S[1, 1] + variance[1] * farther
    inverse = np.array([[d, -S[0, 1]], [-S[0, 1], a]]) / (a * d - S[0, 1] ** 2)
    gain = PH @ inverse
    x[:] = before + gain @ error
    P[:] = P_before - gain @ PH.T
    return -0.5 * np.log(determinant) - 0.5 * (FREEDOM + 2.0) * np.log1p(distance / FREEDOM)


@njit(cache=True)
def _squared(error, a, d, b):
    return (error[0] ** 2 * d - 2.0 * error[0] * error[1] * b + error[1] ** 2 * a) / (a * d - b * b)


@njit(cache=True)
def _levelled(level, k, z, phi, one, elevons, x, of_columns):
    """The variance of the errors after a sample, from what the likeliest class leaves."""
    left = z - (1.0 + x[0]) * elevons[0] * phi[:, 0] - (1.0 - x[0]) * elevons[1] * phi[:, 1] - one @ x[1:]
    size = min(0.5 * np.sum(np.maximum(left**2 - of_columns, 0.0)), 9.0 * level)
    return max(level + (size - level) / min(MEMORY, k + 20.0), LEAST)
