"""Probabilities of the classes of effectiveness over a flight, in errors whose colour is learnt on the way.

The errors of both rates are a joint autoregression, which follows the air of the last MEMORY samples: gusts have three times the
errors of calm air, and another colour. Each class foretells them from the errors that its own past leaves, and begins with those of
the classes from which it may come, as in interacting multiple models (Blom and Bar-Shalom, IEEE Trans. Automatic Control 33(8),
1988). With one whitening filter over all columns, what was before a drop would count as if it were weak already.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from testbed.logs.diagnosis import MODEL_SHARE

STEP_S = 0.1
ORDER = 10
"""Of the autoregression: 1 s."""
MEMORY = 900.0
"""Samples over which the autoregression is averaged."""
FREEDOM = 8.0
"""Of Student's distribution, which the errors have: gusts are no Gaussian noise."""
LEVEL_MEMORY = 100.0
"""Samples over which the size of the errors is averaged."""
LEAST = 0.5
"""The errors are never smaller than with this share of the variance that the flight began with: the lower quartile of 21 July.

With ORDER, MEMORY and FREEDOM the likelihood of 21 July, its faults known, is largest. It would be larger still with a LEVEL_MEMORY
of 3 s, which hides faults."""


class Filtered(NamedTuple):
    """At each sample: logarithms of the classes' probabilities [rows, classes], log-likelihoods of the sample under each, and with
    white errors the rates [rows, 2], what each elevon adds to them [rows, 2, 2], and the errors' variance [rows]."""

    log_probability: np.ndarray
    evidence: np.ndarray
    z: np.ndarray
    phi: np.ndarray
    variance: np.ndarray


def lagged(errors: np.ndarray) -> np.ndarray:
    """[rows - ORDER, 2 ORDER + 3] errors [rows, 2], those of the ORDER samples before, and 1."""
    count = len(errors) - ORDER
    return np.hstack([*(errors[ORDER - lag :][:count] for lag in range(ORDER + 1)), np.ones((count, 1))])


def moments_of(errors: np.ndarray) -> np.ndarray:
    """[2 ORDER + 3, 2 ORDER + 3] mean products of `lagged`, all that an autoregression needs."""
    rows = lagged(errors)
    return np.asarray(rows.T @ rows / len(rows))


def predictor(moments: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """([2, 2 ORDER + 1] coefficients on what was before, [2, 2] what makes the rest white) by least squares."""
    before = moments[2:, 2:] + np.diag(1e-4 * np.diag(moments[2:, 2:]))
    coefficients = np.linalg.solve(before, moments[2:, :2]).T
    left = moments[:2, :2] - coefficients @ moments[2:, :2]
    return coefficients, np.linalg.inv(np.linalg.cholesky(left))


def filtered(
    z: np.ndarray, phi: np.ndarray, classes: np.ndarray, change: float, moments: np.ndarray
) -> Filtered:
    """Filter a flight, each class given what was before.

    Args:
        z: [rows, 2] rates.
        phi: [rows, 2, 2] what each elevon adds to them if it works.
        classes: [classes, 2] effectiveness of both elevons; a flight begins in the first.
        change: minus the logarithm of the probability that the class changes in a sample.
        moments: `moments_of` the errors, with which the flight begins.
    """
    rows, count = len(z), len(classes)
    stays = np.full((count, count), np.exp(-change) / (count - 1))
    np.fill_diagonal(stays, 1.0 - np.exp(-change))
    made = Filtered(*map(np.zeros, ((rows, count), (rows, count), (rows, 2), (rows, 2, 2), rows)))
    log, level, power = np.where(np.arange(count) == 0, 0.0, -200.0), 1.0, np.zeros(2)
    errors, columns = np.zeros((count, len(moments) - 2)), np.zeros((3, len(moments) - 2))
    errors[:, -1], columns[0, -1] = 1.0, 1.0
    began = np.diag(predictor(moments)[1]).prod()
    for k in range(rows):
        if k % 10 == 0:
            coefficients, whitening = predictor(moments)
            least = LEAST * np.diag(whitening).prod() / began
        now = np.vstack([z[k], phi[k].T])
        white = (now - columns @ coefficients.T) @ whitening.T
        power += ((white[1:] ** 2).sum(axis=0) - power) * STEP_S  # over 1 s
        spread = level + MODEL_SHARE**2 * power
        shares = np.exp(log)[:, None] * stays
        total = shares.sum(axis=0)
        before = (shares / total).T @ errors
        error = z[k] - classes @ phi[k].T
        left = (error - before @ coefficients.T) @ whitening.T
        distance = (left**2 / spread).sum(axis=1)
        evidence = -0.5 * (FREEDOM + 2.0) * np.log1p(distance / FREEDOM) - 0.5 * np.log(spread).sum()
        log = np.log(total) + evidence
        log -= log.max() + np.log(np.exp(log - log.max()).sum())
        best = log.argmax()
        size = 0.5 * np.maximum(left[best] ** 2 - spread + level, 0.0).sum()
        level = max(level + (min(size, 9.0 * level) - level) / min(LEVEL_MEMORY, k + 20.0), least)
        farther = max(1.0, (FREEDOM + distance[best]) / (FREEDOM + 2.0))  # what is far off counts less
        row = np.concatenate([error[best], before[best]])
        moments = moments + (row[:, None] * row / farther - moments) / MEMORY
        errors, columns = _shifted(before, error), _shifted(columns, now)
        for kept, each in zip(made, (log, evidence, white[0], white[1:].T, level), strict=True):
            kept[k] = each
    return made


def _shifted(before: np.ndarray, now: np.ndarray) -> np.ndarray:
    """What was before the next sample, of each row."""
    return np.hstack([now, before[:, :-3], before[:, -1:]])
