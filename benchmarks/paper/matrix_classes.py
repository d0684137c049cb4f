"""More of `testbed.margins.matrix_classes`: P-matrices, weights that prove H+, scalings that disprove D-stability."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from scipy.optimize import minimize

from testbed.margins.matrix_classes import comparison, jacobi_radius

_STARTS = 24
_SPREAD = 6.0
"""Scalings are searched between exp(-6) and exp(6)."""


def column_weights(m: np.ndarray) -> np.ndarray:
    """[n] c > 0 such that c_j M_jj - sum_{i != j} c_i |M_ij| is 1 for each j, for an H+ matrix.

    |x|_c = sum_i c_i |x_i| then never increases along x' = -M D(t) x, whatever D(t) >= 0 does.

    Raises:
        ValueError: M is not H+.
    """
    if not jacobi_radius(m) < 1.0:
        raise ValueError("the matrix is not H+")
    return np.asarray(np.linalg.solve(comparison(m).T, np.ones(len(m))))


def is_p_matrix(m: np.ndarray) -> bool:
    """Whether all principal minors are positive. Equivalent: each linear complementarity problem with M has one solution."""
    indices = range(len(m))
    subsets = (s for size in indices for s in combinations(indices, size + 1))
    return all(float(np.linalg.det(m[np.ix_(s, s)])) > 0.0 for s in subsets)


def least_real_part(m: np.ndarray, d: np.ndarray) -> float:
    """Least real part of the eigenvalues of M diag(d); x' = -M diag(d) x is unstable exactly if it is negative."""
    return float(np.min(np.linalg.eigvals(m * d).real))


def destabilising_scaling(m: np.ndarray, seed: int = 0) -> np.ndarray | None:
    """[n] d > 0 such that M diag(d) has an eigenvalue with a negative real part, or None if none was found.

    A scaling that is found disproves D-stability. None proves nothing: there is no simple exact test beyond n = 3.
    """
    rng = np.random.default_rng(seed)

    def worst(log_d: np.ndarray) -> float:
        d = np.exp(np.clip(log_d, -_SPREAD, _SPREAD))
        return least_real_part(m, d / d.max())

    for _ in range(_STARTS):
        found = minimize(worst, rng.uniform(-_SPREAD, _SPREAD, len(m)), method="Nelder-Mead")
        if found.fun < -1e-9 * float(np.max(np.abs(m))):
            return np.asarray(np.exp(np.clip(found.x, -_SPREAD, _SPREAD)))
    return None
