"""Sufficient conditions on the error of the input matrix, and bounds of the estimates' bias: what the paper's 4.3 asks for.

|B_c - B_mc| <= Delta, entry by entry, gives |M - I| <= E = |B_mc^-1| Delta for M = B_mc^-1 B_c.

* rho(E) < 1: M is H+ (`matrix_classes`) for each such B_c.
* beta_i = (F |r|)_i / |r_i| < 1 for each i, with F = (I - E)^-1 - I: for this constant r the estimates converge from any start,
  e -> 0, and 1/(1 + beta_i) <= lam_hat_i / lam_i <= 1/(1 - beta_i).
* The same with `sector_bias` in place of beta, for an r(t) and an M(t) that vary in any way within a sector: then lam_hat_i / lam_i
  enters that interval and stays in it.

Multiplying a column of B_c by a positive number is the same as another effectiveness, and no error. Proofs are on the page
"Error of the input matrix" of the documentation.
"""

from __future__ import annotations

import numpy as np

from testbed.margins.matrix_classes import comparison, jacobi_radius, spectral_radius


def mismatch(b_mc: np.ndarray, b_c: np.ndarray) -> np.ndarray:
    """[n, n] M = B_mc^-1 B_c; the identity if there is no error. With fewer actuators than rates, the left inverse."""
    return np.asarray(np.linalg.pinv(b_mc) @ b_c)


def error_bound(b_mc: np.ndarray, delta: np.ndarray) -> np.ndarray:
    """[n, n] E = |B_mc^-1| Delta, a bound of |M - I|.

    Args:
        b_mc: [m, n] modelled input matrix of full column rank.
        delta: [m, n] largest error of each entry.
    """
    return np.asarray(np.abs(np.linalg.pinv(b_mc)) @ delta)


def uniform_limit(b_mc: np.ndarray) -> float:
    """Largest relative error of all entries at once for which M is certainly H+: 1 / rho(|B_mc^-1| |B_mc|).

    It is one over the least condition number in the infinity norm that scaling of rows and columns can give B_mc
    (Bauer, Numerische Mathematik 5, 1963), so units do not matter.
    """
    return 1.0 / spectral_radius(error_bound(b_mc, np.abs(b_mc)))


def remaining_limit(m: np.ndarray, e: np.ndarray) -> float:
    """Largest factor f such that each matrix within f E of an H+ matrix M is certainly H+: 1 / rho(C^-1 E), C its `comparison`.

    Args:
        m: [n, n] what is known of the mismatch; with the identity and E = |B_mc^-1| |B_mc| it is `uniform_limit`.
        e: [n, n] a bound of what is not known, entry by entry.
    """
    return 1.0 / spectral_radius(np.linalg.solve(comparison(m), e)) if jacobi_radius(m) < 1.0 else 0.0


def entry_limits(b_mc: np.ndarray) -> np.ndarray:
    """[m, n] largest relative error of one entry alone: 1 / |(B_mc^-1)_ji B_ij|. With the worse sign it makes M_jj zero."""
    share = np.abs(np.linalg.pinv(b_mc).T * b_mc)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 / share)


def bias_bound(e: np.ndarray, r: np.ndarray) -> np.ndarray:
    """[..., n] beta_i = (F |r|)_i / |r_i|, F = (I - E)^-1 - I; infinite where r_i is 0, and everywhere if rho(E) >= 1.

    Args:
        e: [n, n] bound of |M - I|.
        r: [..., n] references.
    """
    size = np.abs(r)
    if spectral_radius(e) >= 1.0:
        return np.full(size.shape, np.inf)
    f = np.linalg.inv(np.eye(len(e)) - e) - np.eye(len(e))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(size > 0.0, size @ f.T / size, np.inf)


def largest_ratios(r: np.ndarray) -> np.ndarray:
    """[n, n] largest |r_j| / |r_i| over the rows of r [k, n]: the sector of references. Infinite where r_i has a zero."""
    size = np.abs(r)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = np.where(size[:, :, None] > 0.0, size[:, None, :] / size[:, :, None], np.inf)
    ratios[:, range(size.shape[1]), range(size.shape[1])] = 1.0
    return np.asarray(np.max(ratios, axis=0))


def sector_bias(e: np.ndarray, ratios: np.ndarray) -> np.ndarray:
    """[n] bound of the bias over a sector, for an r(t) that varies in it in any way: (I - E_s)^-1 E_s 1, E_s = E * ratios.

    Infinite if rho(E_s) >= 1. For one direction of r it is `bias_bound`.

    Args:
        e: [n, n] bound of |M - I|.
        ratios: [n, n] largest |r_j| / |r_i|, as `largest_ratios` gives them.
    """
    n = len(e)
    with np.errstate(invalid="ignore"):
        within = np.where(e > 0.0, e * ratios, 0.0)
    if not np.all(np.isfinite(within)) or spectral_radius(within) >= 1.0:
        return np.full(n, np.inf)
    return np.asarray(np.linalg.solve(np.eye(n) - within, within @ np.ones(n)))


def certified_range(beta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Least and largest lam_hat / lam for these bounds of the bias; 0 and infinity where beta is not below 1."""
    inside = beta < 1.0
    low = np.where(inside, 1.0 / (1.0 + beta), 0.0)
    return low, np.where(inside, 1.0 / (1.0 - np.where(inside, beta, 0.0)), np.inf)
