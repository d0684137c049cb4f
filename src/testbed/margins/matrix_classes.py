"""Classes of matrices that decide whether x' = -M D x is stable for every diagonal D > 0.

For a real square M, each class contains the next:

    H+ (`jacobi_radius` < 1)  =>  diagonally stable (margin of `diagonal_stability` > 0)  =>  D-stable  =>  P0+

Diagonally stable also implies P. H+ and diagonal stability are inherited by principal submatrices, and none of
the four changes when rows or columns are multiplied by positive numbers.

Sources: Berman and Plemmons, Nonnegative Matrices in the Mathematical Sciences, ch. 6; Hershkowitz, Handbook of Linear Algebra,
ch. 19; Kushel, arXiv:1907.07089.
"""

from __future__ import annotations

import warnings

import numpy as np
from scipy.linalg import eigh

_STEPS, _IMPROVEMENT = 30, 1e-7
_LEAST_WEIGHT = 1e-9


def spectral_radius(matrix: np.ndarray) -> float:
    """Largest modulus of the eigenvalues; 0 for an empty matrix."""
    return float(np.max(np.abs(np.linalg.eigvals(matrix)), initial=0.0))


def normalised(m: np.ndarray) -> np.ndarray:
    """M with each column divided by its diagonal entry, [..., n, n]. Column scale is effectiveness, and no error of M."""
    return m / np.diagonal(m, axis1=-2, axis2=-1)[..., None, :]


def jacobi_radius(m: np.ndarray) -> np.ndarray:
    """[...] spectral radius of |off-diagonal part of M| / diagonal; infinite where a diagonal entry is not positive.

    M is H+ exactly if it is below 1: then it has positive weights c with c_j M_jj > sum_{i != j} c_i |M_ij|.

    Args:
        m: [..., n, n].
    """
    diagonal = np.diagonal(m, axis1=-2, axis2=-1)
    positive = np.all(diagonal > 0.0, axis=-1)
    off = np.abs(m) * (1.0 - np.eye(m.shape[-1])) / np.where(diagonal > 0.0, diagonal, 1.0)[..., :, None]
    radius = np.max(np.abs(np.linalg.eigvals(off)), axis=-1)
    return np.where(positive, radius, np.inf)


def comparison(m: np.ndarray) -> np.ndarray:
    """[n, n] comparison matrix: the diagonal of |M|, and minus all else of |M|."""
    return 2.0 * np.diag(np.abs(np.diag(m))) - np.abs(m)


def diagonal_margin(m: np.ndarray, p: np.ndarray) -> float:
    """Largest mu with P (M - mu I) + (M - mu I)' P >= 0 for P = diag(p), p > 0."""
    product = p[:, None] * m
    return float(eigh(0.5 * (product + product.T), np.diag(p), eigvals_only=True)[0])


def diagonal_stability(m: np.ndarray) -> tuple[float, np.ndarray]:
    """Largest `diagonal_margin` of `normalised` M, and the p [n] that gives it.

    M is diagonally stable exactly if it is positive. It is 1 for a diagonal M, never more, and at least 1 - `jacobi_radius`.
    Minus infinity where a diagonal entry is not positive.

    Each step solves a linear matrix inequality in p, with cvxpy and Clarabel (the extra `certify`), and then takes the margin of
    its solution. So the margin is proved by p, not by what the solver says of it.

    Raises:
        ModuleNotFoundError: cvxpy is not installed.
    """
    import cvxpy

    n = len(m)
    best = np.ones(n)
    if np.any(np.diag(m) <= 0.0):
        return -np.inf, best
    m = normalised(m)
    p, slack, shifted = cvxpy.Variable(n), cvxpy.Variable(), cvxpy.Parameter((n, n))
    product = cvxpy.diag(p) @ shifted
    problem = cvxpy.Problem(
        cvxpy.Maximize(slack),
        [product + product.T >> slack * np.eye(n), p >= _LEAST_WEIGHT, cvxpy.sum(p) == n],
    )
    margin = diagonal_margin(m, best)
    for _ in range(_STEPS):
        if margin > 1.0 - _IMPROVEMENT:
            break
        shifted.value = m - margin * np.eye(n)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a solution that may be inaccurate is judged by its margin
            problem.solve(solver=cvxpy.CLARABEL)
        found = diagonal_margin(m, np.asarray(p.value))
        if found <= margin + _IMPROVEMENT:
            break
        margin, best = found, np.asarray(p.value)
    return margin, best
