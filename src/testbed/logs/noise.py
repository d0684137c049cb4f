"""The errors of a log's regression as coloured noise: an autoregression of each rate makes them white.

The regression is that of the law, (10): z = the actuators' columns + error. The error has gusts, noise of sensors that was
differentiated, and what the design model leaves out. The same filter goes over every column, so that a constant error of the model
has little weight, and a sudden change has all of it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_toeplitz
from scipy.signal import lfilter

ORDER = 20
"""Of the autoregression: 2 s."""
QUIET_SHARE, QUIET_S = 0.4, 5.0
"""The first fit is of the quietest windows, because a failure may fill most of a log: their share, and the length of one [s]."""


@dataclass(frozen=True)
class Noise:
    """An autoregression of each rate, and the covariance of its innovations.

    Attributes:
        filters: [rates, ORDER + 1] coefficients, the first is 1.
        mixing: [rates, rates] inverse of the Cholesky factor of the innovations' covariance.
    """

    filters: np.ndarray
    mixing: np.ndarray

    def white(self, columns: np.ndarray) -> np.ndarray:
        """[bins, rates, ...] in which the error has unit variance, of columns of this shape."""
        parts = [lfilter(each, [1.0], columns[:, row], axis=0) for row, each in enumerate(self.filters)]
        return np.einsum("ij,tj...->ti...", self.mixing, np.stack(parts, axis=1))


def noise_of(
    errors: np.ndarray, known: np.ndarray, model_std: np.ndarray, model_time_s: float, bin_s: float
) -> Noise:
    """Fit the noise by the Yule-Walker equations.

    Args:
        errors: [bins, rates] of the regression; those that are not `known` [bins] are left out.
        model_std: [rates] standard deviation of the design model's error. It is in the noise whether the errors show it or not,
            as in the law's `estimator`, with the correlation time `model_time_s`.
    """
    clean = np.where(known[:, None], errors, 0.0)
    lags = np.arange(ORDER + 1)
    pairs = np.array([max(int(np.sum(known[lag:] & known[: len(known) - lag])), 1) for lag in lags])
    filters = np.eye(1, ORDER + 1).repeat(clean.shape[1], axis=0)
    for row, x in enumerate(clean.T):
        covariance = np.array([x[lag:] @ x[: len(x) - lag] for lag in lags]) / pairs
        covariance += model_std[row] ** 2 * np.exp(-lags * bin_s / model_time_s)
        covariance[0] *= 1.0001  # where hardly anything is random the equations stay well conditioned
        filters[row, 1:] = -solve_toeplitz(covariance[:-1], covariance[1:])
    innovations = np.stack([lfilter(f, [1.0], x) for f, x in zip(filters, clean.T, strict=True)], axis=1)
    of_model = np.diag(model_std**2 * 2.0 * bin_s / model_time_s)  # the innovation of the model's error
    spread = np.atleast_2d(np.cov(innovations[settled(known)].T)) + of_model
    return Noise(filters, np.linalg.inv(np.linalg.cholesky(spread)))


def settled(known: np.ndarray) -> np.ndarray:
    """[bins] whether a bin and the ORDER before it are known, so that the filter has forgotten a gap."""
    count = np.convolve(known.astype(float), np.ones(ORDER + 1))[: len(known)]
    return np.asarray(count > ORDER + 0.5)


def quiet(errors: np.ndarray, known: np.ndarray, bin_s: float) -> np.ndarray:
    """[bins] those in the quietest windows, by the size of the errors relative to their medians."""
    width = max(int(QUIET_S / bin_s), 2 * ORDER)
    count = max(len(errors) // width, 1)
    size = np.median(np.abs(errors[known]), axis=0) + 1e-9
    energy = np.where(known, np.sum((errors / size) ** 2, axis=1), np.inf)
    means = [float(np.mean(energy[i * width : (i + 1) * width])) for i in range(count)]
    chosen = np.argsort(means)[: max(round(QUIET_SHARE * count), 1)]
    mask = np.isin(np.arange(len(errors)) // width, chosen) & known
    return mask if np.sum(settled(mask)) > 2 * ORDER else known
