"""Classes of matrices for (42): each certificate on random matrices, and matrices that must not pass it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from paper.matrix_classes import column_weights, destabilising_scaling, is_p_matrix, least_real_part
from scipy.linalg import expm

from testbed.margins.matrix_classes import diagonal_margin, diagonal_stability, jacobi_radius, normalised

PROPERTY = settings(deadline=None, derandomize=True, max_examples=50, database=None)
FEW = settings(PROPERTY, max_examples=20)
seeds = st.integers(0, 2**32 - 1)
MAY_LEONARD = np.array([[1.0, 2.5, 0.2], [0.2, 1.0, 2.5], [2.5, 0.2, 1.0]])
"""May and Leonard, SIAM J. Appl. Math. 29, 1975: three competitors that cycle."""


def random_h_plus(rng: np.random.Generator, n: int = 4, radius: float | None = None) -> np.ndarray:
    """[n, n] with this `jacobi_radius` (default: random below 1), badly scaled."""
    m = rng.normal(size=(n, n)) * (1.0 - np.eye(n))
    m *= (rng.uniform(0.0, 0.99) if radius is None else radius) / float(jacobi_radius(m + np.eye(n)))
    return (m + np.eye(n)) * np.exp(rng.normal(size=(n, 1))) * np.exp(rng.normal(size=n))


def worst_period(m: np.ndarray, one: np.ndarray, other: np.ndarray) -> float:
    """Largest spectral radius over a period of x' = -M D x, where D is diag(one) and then diag(other) for any times up to 3."""
    times = np.linspace(0.05, 3.0, 30)
    first = np.array([expm(-m @ np.diag(one) * t) for t in times])
    then = np.array([expm(-m @ np.diag(other) * t) for t in times])
    return float(np.abs(np.linalg.eigvals(then[:, None] @ first)).max())


@FEW
@given(seeds)
def test_h_plus_matrix_is_diagonally_stable_p_and_d_stable(seed: int) -> None:
    """The hierarchy, from the top; 1 - radius bounds the margin of diagonal stability from below."""
    rng = np.random.default_rng(seed)
    m = random_h_plus(rng)
    margin, p = diagonal_stability(m)
    assert 1.0 - float(jacobi_radius(m)) <= margin + 1e-6 <= 1.0 + 2e-6
    assert margin == pytest.approx(diagonal_margin(normalised(m), p)) and np.all(p > 0.0)
    assert is_p_matrix(m)
    for d in np.exp(rng.uniform(-7.0, 7.0, (200, 4))) * (rng.random((200, 4)) < 0.8):
        assert least_real_part(m, d) >= -1e-9 * np.abs(m * d).max()


@PROPERTY
@given(seeds)
def test_classes_do_not_depend_on_scale_or_signs(seed: int) -> None:
    """Scaling of rows and columns, and the signs of r, change neither the radius nor whether M is a P-matrix."""
    rng = np.random.default_rng(seed)
    m = np.eye(4) + rng.normal(size=(4, 4)) * 0.6
    assume(np.all(np.diag(m) > 0.05))
    rows, columns = np.exp(rng.normal(size=(2, 4)))
    sign = rng.choice([-1.0, 1.0], 4)
    other = (rows * sign)[:, None] * m * (columns * sign)
    assert float(jacobi_radius(other)) == pytest.approx(float(jacobi_radius(m)), rel=1e-6)
    assert is_p_matrix(other) == is_p_matrix(m)


@FEW
@given(seeds)
def test_two_actuators_are_diagonally_stable_exactly_if_p(seed: int) -> None:
    """n = 2: a P-matrix is diagonally stable, and the other way round. With more actuators it need not be, see below."""
    m = np.random.default_rng(seed).normal(size=(2, 2)) + np.eye(2)
    assume(abs(np.linalg.det(m)) > 0.02 and np.all(np.abs(np.diag(m)) > 0.02))
    assert (diagonal_stability(m)[0] > 0.0) == is_p_matrix(m)


@pytest.mark.nightly
@FEW
@given(seeds)
def test_weighted_norm_never_increases_under_any_switching(seed: int) -> None:
    """|x|_c along x' = -M D(t) x of an H+ matrix, D random over six decades and partly zero: it never increases."""
    rng = np.random.default_rng(seed)
    m = random_h_plus(rng)
    c, x = column_weights(m), rng.normal(size=4)
    np.testing.assert_allclose(c * np.diag(m) - (c @ np.abs(m) - c * np.diag(m)), 1.0, rtol=1e-7)
    for _ in range(40):
        d = 10.0 ** rng.uniform(-3, 3, 4) * (rng.random(4) < 0.7)
        after = expm(-m @ np.diag(d) * rng.exponential(1.0) / max(np.abs(m * d).max(), 1.0)) @ x
        assert c @ np.abs(after) <= c @ np.abs(x) * (1.0 + 1e-9)
        x = after


def test_diagonal_matrix_has_margin_one_whatever_its_scale() -> None:
    assert diagonal_stability(np.diag([1.0, 5.0, 0.1, 20.0]))[0] == pytest.approx(1.0)
    assert float(jacobi_radius(np.diag([1.0, 5.0, 0.1]))) == 0.0


def test_negative_control_may_leonard_is_p_but_neither_diagonally_stable_nor_d_stable() -> None:
    assert is_p_matrix(MAY_LEONARD)
    assert diagonal_stability(MAY_LEONARD)[0] == pytest.approx(-0.35, abs=1e-3)
    found = destabilising_scaling(MAY_LEONARD)
    assert found is not None and least_real_part(MAY_LEONARD, found) < 0.0
    with pytest.raises(ValueError):
        column_weights(MAY_LEONARD)


def test_negative_control_switching_destabilises_a_diagonally_stable_matrix() -> None:
    """[[1, k], [-k, 1]] has the identity for its symmetric part, so its margin is 1 for each k. But H+ ends at k = 1, and a D that
    switches between diag(.1, 1) and diag(1, .1) destabilises it at k = 2."""
    spectral_radii = {}
    for k in (0.9, 2.0, 3.0):
        m = np.array([[1.0, k], [-k, 1.0]])
        assert diagonal_stability(m)[0] == pytest.approx(1.0)
        assert (float(jacobi_radius(m)) < 1.0) == (k < 1.0)
        assert destabilising_scaling(m) is None  # no constant D does it
        spectral_radii[k] = worst_period(m, np.array([0.1, 1.0]), np.array([1.0, 0.1]))
    assert spectral_radii[0.9] < 1.0
    assert spectral_radii[2.0] == pytest.approx(1.45, abs=0.01)
    assert spectral_radii[3.0] == pytest.approx(2.42, abs=0.02)


def test_negative_control_d_stability_is_not_inherited_by_principal_submatrices() -> None:
    """[[0, 1], [-1, 1]]: D-stable, but a zero reference of the second actuator leaves the first with M_11 = 0."""
    m = np.array([[0.0, 1.0], [-1.0, 1.0]])
    assert destabilising_scaling(m) is None
    assert least_real_part(m, np.array([1.0, 0.0])) == pytest.approx(0.0)
    assert not is_p_matrix(m) and diagonal_stability(m)[0] == -np.inf and float(jacobi_radius(m)) == np.inf
