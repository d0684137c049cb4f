"""Error of the input matrix, (39) to (42): each equation, the equilibrium, and what does and does not converge.

The law on the ideal plant is the one that flies (`paper.ideal`); its equations in continuous time are `paper.input_matrix`.
"""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from paper.ideal import IdealLoop, IdealPlant, Tuning
from paper.input_matrix import (
    box_equilibrium,
    equilibrium,
    error_matrix,
    error_rate,
    estimate_rate,
    jacobian,
    lotka_volterra,
    measured_error,
    sign_condition,
)
from paper.matrix_classes import is_p_matrix
from scipy.integrate import solve_ivp

from testbed.margins.bounds import mismatch
from testbed.margins.matrix_classes import diagonal_stability, jacobi_radius

PROPERTY = settings(deadline=None, derandomize=True, max_examples=40, database=None)
FEW = settings(PROPERTY, max_examples=10)
seeds = st.integers(0, 2**32 - 1)
GAMMA, EPSILON = 2.0, 0.05


class Case:
    """A random plant, its model, and a moment of the adaptation; some references within epsilon, none zero."""

    def __init__(self, seed: int, error: float = 0.3) -> None:
        self.rng = rng = np.random.default_rng(seed)
        self.b_mc = np.linalg.qr(rng.normal(size=(4, 4)))[0] * np.exp(rng.normal(size=4))
        self.m = np.eye(4) + error * rng.uniform(-1.0, 1.0, (4, 4))
        self.b_c = self.b_mc @ self.m
        self.lam, self.lam_hat = rng.uniform(0.1, 1.0, (2, 4))
        self.r = rng.uniform(0.01, 1.0, 4) * rng.choice([-1.0, 1.0], 4)

    @property
    def law(self) -> tuple[float, float]:
        return GAMMA, EPSILON


@PROPERTY
@given(seeds)
def test_eq_39_40_error_of_the_flying_law(seed: int) -> None:
    """(39), (40): the e that the flying law measures on a plant with B_c in place of B_mc."""
    c = Case(seed)
    loop = IdealLoop(IdealPlant(c.b_mc, B_c=c.b_c), Tuning(GAMMA, EPSILON), c.lam_hat)
    history = loop.fly(c.r[None], c.lam)
    expected = measured_error(c.b_mc, c.b_c, c.lam, c.lam_hat, c.r)
    np.testing.assert_allclose(history.e[0], expected, atol=1e-10 * np.abs(expected).max())


@PROPERTY
@given(seeds)
def test_eq_41_rate_of_the_estimates(seed: int) -> None:
    """(41): from (13) with (40), the paper's last form of it, and a step of the flying law beyond epsilon.

    In the paper's first line "- I" stands for "- B_mc": with I it is another vector.
    """
    c = Case(seed)
    rate = estimate_rate(mismatch(c.b_mc, c.b_c), c.lam, c.lam_hat, c.r, *c.law)
    g = np.where(np.abs(c.r) > EPSILON, 1.0 / c.r, c.r / EPSILON**2)
    e = measured_error(c.b_mc, c.b_c, c.lam, c.lam_hat, c.r)
    np.testing.assert_allclose(rate, GAMMA * (np.linalg.inv(c.b_mc) @ e) * c.lam_hat * g, rtol=1e-8)
    last_form = c.lam_hat[:, None] * np.linalg.inv(c.b_mc) @ c.b_c @ (c.lam / c.lam_hat * c.r) * g
    np.testing.assert_allclose(rate, GAMMA * (last_form - c.lam_hat * g * c.r), rtol=1e-8)
    printed = np.linalg.inv(c.b_mc) @ (c.b_c @ (c.lam / c.lam_hat * c.r) - c.r)
    assert not np.allclose(rate, GAMMA * printed * c.lam_hat * g, rtol=1e-3)
    r = np.sign(c.r) * np.maximum(np.abs(c.r), 2.0 * EPSILON)  # so that the command is beyond epsilon too
    dt = 1e-3
    after = IdealLoop(IdealPlant(c.b_mc, B_c=c.b_c), Tuning(GAMMA, EPSILON, dt), c.lam_hat).fly(
        r[None], c.lam
    )
    flown = np.log(after.lambda_hat[1] / c.lam_hat) * c.lam_hat / dt
    np.testing.assert_allclose(flown, estimate_rate(c.m, c.lam, c.lam_hat, r, *c.law), rtol=1e-6, atol=1e-9)


@PROPERTY
@given(seeds)
def test_eq_41_is_a_lotka_volterra_system(seed: int) -> None:
    """theta = 1 / lam_hat: theta' = -lam_hat' / lam_hat^2 = theta (b - A theta), with b >= 0."""
    c = Case(seed)
    b, a = lotka_volterra(c.m, c.lam, c.r, *c.law)
    theta = 1.0 / c.lam_hat
    expected = -estimate_rate(c.m, c.lam, c.lam_hat, c.r, *c.law) * theta**2
    np.testing.assert_allclose(
        theta * (b - a @ theta), expected, rtol=1e-9, atol=1e-12 * np.abs(expected).max()
    )
    assert np.all(b >= 0.0)


@PROPERTY
@given(seeds)
def test_eq_42_rate_of_the_error(seed: int) -> None:
    """(42) is the derivative of (40) along (41), by central differences, with r and Lambda varying."""
    c = Case(seed)
    lam_rate, r_rate = c.rng.normal(size=(2, 4)) * 0.1
    estimate = estimate_rate(c.m, c.lam, c.lam_hat, c.r, *c.law)
    h = 1e-6
    ends = [
        measured_error(c.b_mc, c.b_c, c.lam + s * lam_rate, c.lam_hat + s * estimate, c.r + s * r_rate)
        for s in (-h, h)
    ]
    found = error_rate(c.b_mc, c.b_c, c.lam, c.lam_hat, c.r, *c.law, lam_rate, r_rate)
    scale = np.abs(error_matrix(c.b_mc, c.b_c, c.lam, c.lam_hat, c.r, *c.law)).max() * np.abs(c.b_c).max()
    np.testing.assert_allclose((ends[1] - ends[0]) / (2 * h), found, atol=1e-5 * max(scale, 1.0), rtol=1e-5)


@PROPERTY
@given(seeds)
def test_eq_42_eigenvalues_are_those_of_minus_gamma_m_d(seed: int) -> None:
    """The matrix below (42) is similar to -gamma M D; an actuator without reference adds a zero, and leaves M of the others."""
    c = Case(seed)
    c.r[0] = 0.0
    d = c.lam / c.lam_hat * np.where(np.abs(c.r) > EPSILON, 1.0, (c.r / EPSILON) ** 2)
    matrix = error_matrix(c.b_mc, c.b_c, c.lam, c.lam_hat, c.r, *c.law)
    found = np.poly(matrix)
    np.testing.assert_allclose(found, np.poly(-GAMMA * c.m * d), atol=1e-8 * np.abs(found).max())
    others = np.poly(-GAMMA * (c.m * d)[1:, 1:])
    np.testing.assert_allclose(found, np.append(others, 0.0), atol=1e-8 * np.abs(found).max())


def test_eq_42_error_does_not_vanish_for_a_moving_reference() -> None:
    """Its first term is zero at the true estimates for M = I, but not for another M, at any estimate: e keeps a part that is
    proportional to r'. Flown: twice the frequency of r, about twice the error."""
    still = {}
    for error in (0.0, 0.2):
        m = np.eye(2) + error * np.array([[0.0, 1.0], [-1.0, 0.0]])
        for frequency in (0.25, 0.5):
            t = np.arange(0.0, 40.0, 0.01)
            angle = frequency * t
            r = np.stack([1.0 + 0.3 * np.sin(angle), 1.0 + 0.3 * np.cos(angle)], axis=1)
            b_mc = np.eye(4, 2)
            history = IdealLoop(IdealPlant(b_mc, B_c=b_mc @ m), Tuning(GAMMA, EPSILON, 0.01)).fly(r, 0.5)
            still[error, frequency] = np.abs(history.e[len(t) // 2 :]).max()
    assert still[0.0, 0.5] < 1e-9
    assert still[0.2, 0.5] / still[0.2, 0.25] == pytest.approx(2.0, abs=0.25)


@PROPERTY
@given(seeds)
def test_equilibrium_has_no_error_and_its_own_bias(seed: int) -> None:
    """lam_hat* = lam r / (M^-1 r): e = 0 there; the bias does not depend on Lambda, and to first order is 1 + (Delta r)_i / r_i."""
    c = Case(seed)
    found = equilibrium(c.m, c.lam, c.r)
    e = measured_error(c.b_mc, c.b_c, c.lam, found, c.r)
    np.testing.assert_allclose(e, 0.0, atol=1e-9 * np.abs(c.b_mc).max())
    np.testing.assert_allclose(found / c.lam, equilibrium(c.m, np.ones(4), c.r), rtol=1e-9)
    delta = 1e-4 * (c.m - np.eye(4))
    first = 1.0 + delta @ c.r / c.r
    np.testing.assert_allclose(equilibrium(np.eye(4) + delta, np.ones(4), c.r), first, atol=1e-4)


@PROPERTY
@given(seeds)
def test_jacobian_at_the_equilibrium(seed: int) -> None:
    """J = -gamma G M diag(M^-1 r), against differences of (41) in log(lam_hat); its eigenvalues are those of (42) there, and
    -gamma is one of them when all references are beyond epsilon."""
    c = Case(seed, error=0.1)
    c.r = np.sign(c.r) * (0.2 + 0.1 * np.abs(c.r))  # with an equilibrium, beyond epsilon
    star, j, h = equilibrium(c.m, c.lam, c.r), jacobian(c.m, c.r, *c.law), 1e-6
    for i in range(4):
        ends = [star * np.exp(s * h * (np.arange(4) == i)) for s in (-1.0, 1.0)]
        low, high = (estimate_rate(c.m, c.lam, x, c.r, *c.law) / x for x in ends)
        np.testing.assert_allclose((high - low) / (2 * h), j[:, i], atol=1e-6)
    of_42 = np.poly(error_matrix(c.b_mc, c.b_c, c.lam, star, c.r, *c.law))
    np.testing.assert_allclose(np.poly(j), of_42, rtol=1e-6, atol=1e-8)
    assert np.abs(np.linalg.eigvals(j) + GAMMA).min() < 1e-9


@PROPERTY
@given(seeds)
def test_no_mismatch_has_an_equilibrium_for_every_reference(seed: int) -> None:
    """Unless M is diagonal: let (M^-1)_ij be not 0, r_i small, and r_j of the sign that makes (M^-1 r)_i r_i negative."""
    c = Case(seed, error=0.05)
    inverse = np.linalg.inv(c.m)
    i, j = 0, int(c.rng.integers(1, 4))
    r = np.full(4, 1e-9)
    r[i], r[j] = 1e-3 * abs(inverse[i, j]), -np.sign(inverse[i, j])
    assert not sign_condition(c.m, r)
    assert sign_condition(np.diag(np.diag(c.m)), r)


@FEW
@given(seeds)
def test_flying_law_converges_to_the_equilibrium_of_a_small_mismatch(seed: int) -> None:
    """From ten times too much and from a tenth, to the same biased estimates, with e = 0."""
    c = Case(seed, error=0.08)
    c.r = np.sign(c.r) * c.rng.uniform(0.5, 1.0, 4)
    r = np.tile(c.r, (4000, 1))
    for start in (0.1, 10.0):
        history = IdealLoop(IdealPlant(c.b_mc, B_c=c.b_c), Tuning(GAMMA, EPSILON, 0.01), c.lam * start).fly(
            r, c.lam
        )
        np.testing.assert_allclose(history.lambda_hat[-1], equilibrium(c.m, c.lam, c.r), rtol=1e-9)
        assert np.abs(history.e[-1]).max() < 1e-9


def test_limited_estimate_of_a_reference_outside_the_sector_rests_at_its_limit() -> None:
    """M = [[1, .2], [0, 1]] is as good as can be, but r = (.1, 1) needs the first actuator on the other side. Without limits its
    estimate diverges (`test_equations.test_eq_41_counter_example_...`); with them it rests where `box_equilibrium` says."""
    m, r = np.array([[1.0, 0.2], [0.0, 1.0]]), np.array([0.1, 1.0])
    assert float(jacobi_radius(m)) == 0.0 and diagonal_stability(m)[0] > 0.8
    assert not sign_condition(m, r)
    plant = IdealPlant(np.eye(4, 2), B_c=np.eye(4, 2) @ m)
    tuning = Tuning(GAMMA, 0.01, 0.0025, lambda_min=0.05, lambda_max=1.1)
    history = IdealLoop(plant, tuning).fly(np.tile(r, (4000, 1)), 1.0)
    (rest,) = box_equilibrium(m, np.ones(2), r, 0.05, 1.1)
    np.testing.assert_allclose(history.lambda_hat[-1], rest, rtol=1e-9)
    assert rest[0] == pytest.approx(1.1) and abs(history.e[-1, 0]) > 0.09


def in_time(m: np.ndarray, lam: np.ndarray, r: np.ndarray, start: np.ndarray, end_s: float) -> np.ndarray:
    """log(lam_hat) at the end, by (41) in continuous time."""

    def rate(_: float, log: np.ndarray) -> np.ndarray:
        return estimate_rate(m, lam, np.exp(log), r, GAMMA, EPSILON) / np.exp(log)

    found = solve_ivp(rate, (0.0, end_s), np.log(start), method="LSODA", rtol=1e-9, atol=1e-9)
    assert found.success
    return np.asarray(found.y)


def test_negative_control_may_leonard_mismatch_cycles() -> None:
    """All principal minors are at least 0.5, and yet the estimates leave their equilibrium in growing cycles."""
    m = np.array([[1.0, 2.5, 0.2], [0.2, 1.0, 2.5], [2.5, 0.2, 1.0]])
    r, lam = np.full(3, 0.5), np.ones(3)
    assert is_p_matrix(m) and sign_condition(m, r)
    star = equilibrium(m, lam, r)
    assert np.linalg.eigvals(jacobian(m, r, GAMMA, EPSILON)).real.max() > 0.1
    path = in_time(m, lam, r, star * [1.01, 1.0, 1.0], 120.0)
    halves = [
        np.abs(path[:, a:b] - np.log(star)[:, None]).max() for a, b in ((0, len(path[0]) // 2), (0, None))
    ]
    assert halves[1] > 10.0 and halves[1] > 1.2 * halves[0]


@FEW
@given(seeds)
def test_projected_law_rests_at_one_point_of_a_diagonally_stable_mismatch(seed: int) -> None:
    """With projection, the flying law goes to the only solution of the box, from two starts, wherever r points; also for M that
    are far from H+, and for r that no positive estimates could follow."""
    rng = np.random.default_rng(seed)
    skew = rng.normal(size=(4, 4))
    m = np.diag(rng.uniform(0.5, 1.5, 4)) + 0.5 * (skew - skew.T)
    lam, r = rng.uniform(0.2, 1.0, 4), rng.uniform(0.3, 1.0, 4) * rng.choice([-1.0, 1.0], 4)
    assert diagonal_stability(m)[0] > 0.0
    (rest,) = box_equilibrium(m, lam, r, 0.05, 1.1)
    tuning = Tuning(GAMMA, EPSILON, 0.002, lambda_min=0.05, lambda_max=1.1)
    b_mc = np.linalg.qr(rng.normal(size=(4, 4)))[0]
    for start in (0.06, 1.0):
        loop = IdealLoop(IdealPlant(b_mc, B_c=b_mc @ m), tuning, start)
        for _ in range(20):
            end = loop.fly(np.tile(r, (5000, 1)), lam).lambda_hat[-1]
            if np.abs(np.log(end / rest)).max() < 1e-6:
                break
        np.testing.assert_allclose(end, rest, rtol=1e-6)
