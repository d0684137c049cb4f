"""The certificate of the input matrix: each bound on random plants within it, with plants outside that break it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from paper.ideal import IdealLoop, IdealPlant, Tuning
from paper.input_matrix import equilibrium, sign_condition

from testbed.margins.bounds import (
    bias_bound,
    certified_range,
    entry_limits,
    error_bound,
    largest_ratios,
    mismatch,
    remaining_limit,
    sector_bias,
    uniform_limit,
)
from testbed.margins.matrix_classes import jacobi_radius, spectral_radius

PROPERTY = settings(deadline=None, derandomize=True, max_examples=40, database=None)
FEW = settings(PROPERTY, max_examples=15)
seeds = st.integers(0, 2**32 - 1)
# A v-tail: two ruddervators, two propellers; rates p, q, r, u.
V_TAIL = np.array(
    [[1.2, -1.2, 0.65, -0.65], [-8.5, -8.5, 0.55, 0.55], [-3.7, 3.7, 1.3, -1.3], [0.03, 0.03, 0.4, 0.4]]
)


def vertices(rng: np.random.Generator, b_mc: np.ndarray, delta: np.ndarray, count: int) -> np.ndarray:
    """[count, m, n] input matrices of which each entry is off by all that Delta allows."""
    return b_mc + delta * rng.choice([-1.0, 1.0], (count, *b_mc.shape))


@PROPERTY
@given(seeds)
def test_every_plant_within_the_error_is_h_plus(seed: int) -> None:
    """rho(E) just below 1: |M - I| <= E, and M is H+ at each of 200 vertices."""
    rng = np.random.default_rng(seed)
    b_mc, delta = rng.normal(size=(4, 4)), rng.random((4, 4))
    delta *= 0.999 / spectral_radius(error_bound(b_mc, delta))
    e = error_bound(b_mc, delta)
    m = mismatch(b_mc, vertices(rng, b_mc, delta, 200))
    assert np.all(np.abs(m - np.eye(4)) <= e * (1.0 + 1e-6) + 1e-9)
    assert np.all(jacobi_radius(m) < 1.0)


def test_negative_control_beyond_the_uniform_limit_some_plant_is_not_h_plus() -> None:
    """Of the v-tail, at 0.999 of the limit all 65 536 vertices are H+; at twice the limit some are not even H+."""
    signs = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 16, indexing="ij"), axis=-1).reshape(-1, 4, 4)
    limit = uniform_limit(V_TAIL)
    for share, certain in ((0.999, True), (2.0, False)):
        m = mismatch(V_TAIL, V_TAIL * (1.0 + share * limit * signs))
        assert bool(np.all(jacobi_radius(m) < 1.0)) is certain


@PROPERTY
@given(seeds)
def test_uniform_limit_does_not_depend_on_units(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows, columns = np.exp(rng.normal(size=(2, 4)))
    assert uniform_limit(V_TAIL) == pytest.approx(0.32, abs=0.01)
    assert uniform_limit(rows[:, None] * V_TAIL * columns) == pytest.approx(uniform_limit(V_TAIL))
    assert uniform_limit(np.diag(columns)) == pytest.approx(1.0)


@PROPERTY
@given(seeds)
def test_remaining_limit_about_a_mismatch_that_is_known(seed: int) -> None:
    """At 0.999 of it, 200 vertices about an M that is H+ are H+; it is `uniform_limit` about M = I, and 0 about one that is not."""
    rng = np.random.default_rng(seed)
    m = np.eye(4) + 0.2 * rng.uniform(-1.0, 1.0, (4, 4))
    e = rng.random((4, 4))
    limit = remaining_limit(m, e)
    assert np.all(jacobi_radius(vertices(rng, m, 0.999 * limit * e, 200)) < 1.0)
    q = error_bound(V_TAIL, np.abs(V_TAIL))
    assert remaining_limit(np.eye(4), q) == pytest.approx(uniform_limit(V_TAIL))
    assert remaining_limit(np.ones((4, 4)), q) == 0.0


def test_limit_of_one_entry_is_exact_for_its_worse_sign() -> None:
    """At the limit M_jj is 0; at 0.99 of it, with either sign, M is H+."""
    limits, share = entry_limits(V_TAIL), np.linalg.inv(V_TAIL).T * V_TAIL
    for i in range(4):
        for j in range(4):
            for factor in (0.99, -0.99, 1.0):
                b_c = V_TAIL.copy()
                b_c[i, j] *= 1.0 - factor * np.sign(share[i, j]) * limits[i, j]
                m = mismatch(V_TAIL, b_c)
                if factor == 1.0:
                    assert m[j, j] == pytest.approx(0.0, abs=1e-9)
                else:
                    assert float(jacobi_radius(m)) < 1.0


@PROPERTY
@given(seeds)
def test_bias_stays_within_its_bound(seed: int) -> None:
    """beta < 1: the equilibrium exists, and its bias is between 1/(1 + beta) and 1/(1 - beta), at 200 vertices."""
    rng = np.random.default_rng(seed)
    b_mc, delta, r = rng.normal(size=(4, 4)), rng.random((4, 4)), rng.normal(size=4)
    delta *= shrunk_to(error_bound(b_mc, delta), largest_ratios(r[None]), 0.9)
    beta = bias_bound(error_bound(b_mc, delta), r)
    assert beta.max() == pytest.approx(0.9, rel=1e-3)
    m = mismatch(b_mc, vertices(rng, b_mc, delta, 200))
    assert np.all(sign_condition(m, np.broadcast_to(r, (200, 4))))
    low, high = certified_range(beta)
    bias = np.array([equilibrium(each, np.ones(4), r) for each in m])
    assert np.all((low * (1 - 1e-9) <= bias) & (bias <= high * (1 + 1e-9)))


def shrunk_to(e: np.ndarray, ratios: np.ndarray, target: float) -> float:
    """The factor on E with which the largest `sector_bias` is this."""
    low, high = 0.0, 1.0 / spectral_radius(e * ratios)
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if sector_bias(middle * e, ratios).max() < target else (low, middle)
    return low


def test_bias_bound_of_one_direction_is_the_sector_bound() -> None:
    e, r = 0.05 * error_bound(V_TAIL, np.abs(V_TAIL)), np.array([0.3, -0.2, 1.5, 1.2])
    np.testing.assert_allclose(sector_bias(e, largest_ratios(r[None])), bias_bound(e, r))
    other = r * [1.0, 1.5, 1.0, 1.0]
    wider = sector_bias(e, largest_ratios(np.array([r, other])))
    assert np.all(wider > bias_bound(e, r)) and np.all(wider > bias_bound(e, other))


def test_bounds_are_infinite_where_nothing_is_certified() -> None:
    e = np.full((2, 2), 0.1)
    assert bias_bound(e, np.array([0.0, 1.0]))[0] == np.inf
    assert np.all(np.isinf(bias_bound(6.0 * e, np.ones(2))))
    assert np.all(np.isinf(sector_bias(e, np.array([[1.0, np.inf], [1.0, 1.0]]))))
    low, high = certified_range(np.array([0.5, 1.0, np.inf]))
    np.testing.assert_array_equal(low, [1.0 / 1.5, 0.0, 0.0])
    np.testing.assert_array_equal(high, [2.0, np.inf, np.inf])


class Within:
    """A random plant within the certificate, references of a sector, and the bound of their bias."""

    def __init__(self, seed: int, target: float) -> None:
        self.rng = rng = np.random.default_rng(seed)
        b_mc = rng.normal(size=(4, 4))
        directions = np.exp(rng.normal(size=4)) * rng.choice([-1.0, 1.0], 4)
        self.r = directions * np.exp(rng.uniform(-0.3, 0.3, (40, 4)))
        delta = rng.random((4, 4))
        delta *= shrunk_to(error_bound(b_mc, delta), largest_ratios(self.r), target)
        self.plant = IdealPlant(b_mc, B_c=vertices(rng, b_mc, delta, 1)[0])
        self.beta = sector_bias(error_bound(b_mc, delta), largest_ratios(self.r))
        self.lam = rng.uniform(0.05, 1.0, 4)


@FEW
@given(seeds, st.floats(0.1, 0.95))
def test_estimates_enter_the_sector_bound_and_never_leave_it(seed: int, target: float) -> None:
    """r jumps at random within its sector, every half second. From far off, lam_hat / lam enters the interval; from a corner of it,
    it never leaves, though each r has another equilibrium. Without projection."""
    c = Within(seed, target)
    r = np.repeat(c.r, 50, axis=0)
    low, high = certified_range(c.beta)
    tuning = Tuning(2.0, 1e-3, 0.01)
    corner = c.lam * np.where(c.rng.random(4) < 0.5, low, high)
    bias = IdealLoop(c.plant, tuning, corner).fly(r, c.lam).lambda_hat / c.lam
    assert np.all((low * (1 - 1e-9) <= bias) & (bias <= high * (1 + 1e-9)))
    loop = IdealLoop(c.plant, tuning, c.lam * np.exp(c.rng.uniform(-3.0, 3.0, 4)))
    for _ in range(40):
        bias = loop.fly(r, c.lam).lambda_hat / c.lam
        if np.all((low <= bias[-1]) & (bias[-1] <= high)):
            break
    assert np.all((low * (1 - 1e-6) <= bias[-1]) & (bias[-1] <= high * (1 + 1e-6)))


@FEW
@given(seeds)
def test_a_lost_actuator_is_seen_at_least_at_the_certified_rate(seed: int) -> None:
    """Once the others are within their bound, log(lam_hat) of one with lam = 0 falls by gamma (1 - beta) or more a second."""
    c = Within(seed, 0.6)
    low, high = certified_range(c.beta)
    c.lam[0] = 0.0
    start = np.where(c.lam > 0.0, c.lam * np.where(c.rng.random(4) < 0.5, low, high), 1.0)
    tuning = Tuning(2.0, 1e-3, 0.01)
    history = IdealLoop(c.plant, tuning, start).fly(np.repeat(c.r, 10, axis=0), c.lam)
    rates = np.diff(np.log(history.lambda_hat[:, 0])) / tuning.dt_s
    assert np.all(rates <= -2.0 * (1.0 - c.beta[0]) + 1e-9)


def test_negative_control_outside_its_sector_an_estimate_breaks_the_bound() -> None:
    """The same plant and error, references from a sector that was not certified."""
    c = Within(3, 0.5)
    _, high = certified_range(c.beta)
    r = c.r[0] * np.array([0.05, 1.0, 1.0, 1.0])
    broken = []
    for sign in (-1.0, 1.0):
        plant = IdealPlant(c.plant.B, B_c=c.plant.B + sign * (c.plant.B_c - c.plant.B))
        bias = IdealLoop(plant, Tuning(2.0, 1e-3, 0.01)).fly(np.tile(r, (3000, 1)), c.lam).lambda_hat / c.lam
        broken.append(bias[-1, 0] > high[0])
    assert any(broken)
