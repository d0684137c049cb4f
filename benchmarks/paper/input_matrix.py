"""The paper's section 4.3: what the adaptation does if the real input matrix B_c is not the modelled B_mc, (39) to (42).

Notation: M = B_mc^-1 B_c; r the reference; lam = diag(Lambda) the real and lam_hat the estimated effectiveness; g, K of (14) and
(16), so that K = diag(kappa), kappa_i = g_i r_i; x = B_mc^-1 e. The error is algebraic in the estimates,

    x = M Lambda Lambda_hat^-1 r - r                                                       (40)

so in theta_i = 1 / lam_hat_i the law (41) is a Lotka-Volterra system, theta_i' = theta_i (b_i - (A theta)_i). What follows from
that, with proofs, is on the page "Error of the input matrix" of the documentation.

All vectors are [n], all matrices [n, n], in scaled units; B_mc is square and invertible.
"""

from __future__ import annotations

from itertools import product

import numpy as np


def modified_inverse(r: np.ndarray, epsilon: float) -> np.ndarray:
    """g of (14)."""
    small = np.abs(r) <= epsilon
    return np.where(small, r / epsilon**2, 1.0 / np.where(small, 1.0, r))


def measured_error(
    b_mc: np.ndarray, b_c: np.ndarray, lam: np.ndarray, lam_hat: np.ndarray, r: np.ndarray
) -> np.ndarray:
    """(40): e = (B_c Lambda Lambda_hat^-1 - B_mc) r."""
    return np.asarray(b_c @ (lam / lam_hat * r) - b_mc @ r)


def estimate_rate(
    m: np.ndarray, lam: np.ndarray, lam_hat: np.ndarray, r: np.ndarray, gamma: float, epsilon: float
) -> np.ndarray:
    """(41): lam_hat_i' = gamma lam_hat_i g_i ((M Lambda Lambda_hat^-1 r)_i - r_i). The paper's first line has I for B_mc."""
    x = m @ (lam / lam_hat * r) - r
    return np.asarray(gamma * lam_hat * modified_inverse(r, epsilon) * x)


def lotka_volterra(
    m: np.ndarray, lam: np.ndarray, r: np.ndarray, gamma: float, epsilon: float
) -> tuple[np.ndarray, np.ndarray]:
    """b [n] and A [n, n] of theta_i' = theta_i (b_i - (A theta)_i): b = gamma kappa, A = gamma G M Lambda diag(r)."""
    g = modified_inverse(r, epsilon)
    return gamma * g * r, gamma * g[:, None] * m * (lam * r)


def error_rate(
    b_mc: np.ndarray,
    b_c: np.ndarray,
    lam: np.ndarray,
    lam_hat: np.ndarray,
    r: np.ndarray,
    gamma: float,
    epsilon: float,
    lam_rate: np.ndarray | float = 0.0,
    r_rate: np.ndarray | float = 0.0,
) -> np.ndarray:
    """(42): e' for varying r and Lambda.

    The first term does not vanish for an M that is not diagonal, at any estimate: e' = 0 needs r' = 0.
    """
    first = (b_c * (lam / lam_hat) - b_mc) @ np.broadcast_to(r_rate, r.shape)
    second = b_c @ (lam_rate / lam_hat * r)
    e = measured_error(b_mc, b_c, lam, lam_hat, r)
    return np.asarray(first + second + error_matrix(b_mc, b_c, lam, lam_hat, r, gamma, epsilon) @ e)


def error_matrix(
    b_mc: np.ndarray,
    b_c: np.ndarray,
    lam: np.ndarray,
    lam_hat: np.ndarray,
    r: np.ndarray,
    gamma: float,
    epsilon: float,
) -> np.ndarray:
    """The matrix -gamma B_c Lambda Lambda_hat^-1 K B_mc^-1 below (42). It is similar to -gamma M D, D = Lambda Lambda_hat^-1 K."""
    d = lam / lam_hat * modified_inverse(r, epsilon) * r
    return np.asarray(-gamma * (b_c * d) @ np.linalg.inv(b_mc))


def equilibrium(m: np.ndarray, lam: np.ndarray, r: np.ndarray) -> np.ndarray:
    """lam_hat* = lam r / (M^-1 r), the only estimates with e = 0 for a constant r without zeros; it depends on neither gamma nor
    epsilon. An entry that is not positive cannot be reached: see `sign_condition`."""
    return np.asarray(lam * r / np.linalg.solve(m, r))


def sign_condition(m: np.ndarray, r: np.ndarray) -> np.ndarray:
    """[...] whether r_i (M^-1 r)_i > 0 for each i: the real plant needs each actuator on the side to which the model sends it.

    Exactly then the estimates have an equilibrium with e = 0.

    Args:
        m: [..., n, n].
        r: [..., n].
    """
    needed = np.linalg.solve(m, r[..., None])[..., 0]
    return np.all(r * needed > 0.0, axis=-1)


def jacobian(m: np.ndarray, r: np.ndarray, gamma: float, epsilon: float) -> np.ndarray:
    """Of the law in log(lam_hat), at the equilibrium: -gamma G M diag(M^-1 r). Lambda drops out.

    -gamma is an eigenvalue of it if no |r_i| is within epsilon.
    """
    g = modified_inverse(r, epsilon)
    return np.asarray(-gamma * g[:, None] * m * np.linalg.solve(m, r))


def box_equilibrium(
    m: np.ndarray, lam: np.ndarray, r: np.ndarray, lam_min: float, lam_max: float
) -> list[np.ndarray]:
    """All lam_hat [n] at which the law with projection onto [lam_min, lam_max] rests and towards which it pushes.

    An estimate is either inside with x_i = 0, or at a limit with a rate that points outwards. They are found by trying each
    combination of limits. For a diagonally stable M and r without zeros there is exactly one.
    """
    theta_low, theta_high = 1.0 / lam_max, 1.0 / lam_min
    # theta_i' has the sign of kappa_i - (sign(r) M Lambda diag(r) theta)_i / |r_i| kappa_i
    a, b = np.sign(r)[:, None] * m * (lam * r), np.abs(r)
    found = []
    for states in product((-1, 0, 1), repeat=len(r)):
        state = np.array(states)
        theta = np.where(state < 0, theta_low, theta_high)
        free = state == 0
        if free.any():
            try:
                theta[free] = np.linalg.solve(
                    a[np.ix_(free, free)], b[free] - a[np.ix_(free, ~free)] @ theta[~free]
                )
            except np.linalg.LinAlgError:
                continue
        inside = bool(np.all((theta[free] >= theta_low) & (theta[free] <= theta_high)))
        push = (b - a @ theta) * state
        if inside and bool(np.all(push >= -1e-12 * np.abs(b).max())):
            found.append(1.0 / theta)
    return found
