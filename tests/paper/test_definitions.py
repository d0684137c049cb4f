"""The paper's definitions and identities, (1) to (5), (7) to (11), (15), (16), (24), (26) and (27), in the paper's own words.

Where a test flies, it is the ideal plant with the functions of the flying law. The others are of the design model, or of matrices.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from paper.ideal import IdealLoop, IdealPlant, Tuning
from vtail_setup import trim_state, vtail_setup

from testbed.aircraft.design_model import ROWS
from testbed.common.signals import RATES
from testbed.controllers.initial_records import model_record
from testbed.controllers.inversion.law import modified_inverse, state_function

U = 2.0**-53
PROPERTY = settings(deadline=None, derandomize=True, max_examples=30, database=None)
seeds = st.integers(0, 2**32 - 1)
EPSILON, GAMMA = 0.1, 2.0


def drawn(seed: int, **more: object) -> tuple[IdealPlant, np.ndarray, np.ndarray, np.ndarray]:
    """A plant with f and a well conditioned B, and r, Lambda and Lambda_hat, all at random."""
    rng = np.random.default_rng(seed)
    u, _, vt = np.linalg.svd(rng.normal(size=(4, 4)))
    b = u @ np.diag(rng.uniform(0.5, 3.0, 4)) @ vt
    plant = IdealPlant(b, A=rng.normal(size=(4, 5)), bias=rng.normal(size=4), **more)  # type: ignore[arg-type]
    r = rng.choice([-1.0, 1.0], 4) * 10.0 ** rng.uniform(-2.0, 0.3, 4)
    return plant, r, 10.0 ** rng.uniform(-1.0, 0.2, 4), 10.0 ** rng.uniform(-1.0, 0.2, 4)


def f_at(plant: IdealPlant, airspeed: float = 1.0) -> np.ndarray:
    """f at the state in which a flight on the ideal plant begins: no angles, no rates."""
    return np.asarray(airspeed**2 * plant.bias)


def rates_of(
    plant: IdealPlant, r: np.ndarray, truth: np.ndarray | float, estimate: np.ndarray | float = 1.0
) -> np.ndarray:
    """x_c_dot of the plant in the first step of a flight."""
    loop = IdealLoop(plant, Tuning(GAMMA, EPSILON), estimate)
    loop.fly(r[None, :], truth)
    return loop._x_c_dot.copy()


@PROPERTY
@given(seeds)
def test_eq_1_7_8_the_plant_is_f_plus_b_lambda_u(seed: int) -> None:
    """(1): x_dot = f + B r of a healthy plant. (7): f + B Lambda u of a broken one. (8): with u = Lambda_hat^-1 r it is
    f + B Lambda Lambda_hat^-1 r."""
    plant, r, truth, estimate = drawn(seed)
    size = 64 * U * (np.abs(plant.bias).sum() + np.abs(plant.B).sum() * np.abs(r / estimate).max() + 1.0)
    assert np.abs(rates_of(plant, r, 1.0) - (f_at(plant) + plant.B @ r)).max() <= size
    wanted = f_at(plant) + plant.B @ np.diag(truth) @ np.linalg.inv(np.diag(estimate)) @ r
    assert np.abs(rates_of(plant, r, truth, estimate) - wanted).max() <= size


def test_eq_2_4_the_design_model_is_f_m_plus_b_m_r_and_its_first_rows_are_controlled() -> None:
    """(2), and (3), (4): the model's six rates are f_m + B_m r; the controlled ones come first, and the law has these alone."""
    setup = vtail_setup()
    model = setup.model
    assert (ROWS[:4], ROWS[4:]) == (RATES, ("v_dot", "w_dot"))
    m, y, f = model_record(setup)[0], trim_state(model, alpha=0.05, beta=0.03, q=0.2, p=-0.1), np.zeros(4)
    state_function(y, m, f)
    x = {name: float(y[name]) for name in ("airspeed", "alpha", "beta", "p", "q", "r", "roll", "pitch")}
    r = np.array(model.trim) + 0.05 * setup.scale
    predicted = model.rates(x, r, np.ones(4))
    assert predicted.shape == (6,)
    assert predicted[:4] == pytest.approx(f + m.B @ (r / setup.scale), abs=1e-9)
    assert m.B.shape == (4, 4) and np.linalg.matrix_rank(m.B) == 4


@PROPERTY
@given(seeds)
def test_eq_9_10_11_error_of_a_plant_that_is_not_the_model(seed: int) -> None:
    """(9): e = x_c_dot - x_dc_dot with (5), x_dc_dot = f_mc + B_mc r. (10) is measured, here without error. (11): it is
    [f_c + B_c Lambda Lambda_hat^-1 r] - [f_mc + B_mc r], with another f and another B than the model's."""
    rng = np.random.default_rng(seed)
    plant, r, truth, estimate = drawn(seed, bias_error=rng.normal(size=4), B_c=rng.normal(size=(4, 4)))
    assert plant.B_c is not None
    loop = IdealLoop(plant, Tuning(GAMMA, EPSILON), estimate)
    history = loop.fly(r[None, :], truth)
    desired = f_at(plant) + plant.B @ r
    real = f_at(plant) + plant.bias_error + plant.B_c @ (truth / estimate * r)
    size = 256 * U * (np.abs(plant.bias).sum() + (np.abs(plant.B) + np.abs(plant.B_c)).sum() * 20.0)
    assert np.abs(history.e[0] - (loop._x_c_dot - desired)).max() <= size
    assert np.abs(history.e[0] - (real - desired)).max() <= size


def g(r: np.ndarray) -> np.ndarray:
    return np.array([modified_inverse(float(x), EPSILON) for x in r])


@PROPERTY
@given(seeds)
def test_eq_15_16_every_line_of_the_simplification_is_the_same(seed: int) -> None:
    """(15), its five lines with the diagonal matrices as they are printed, and (18) with R, G and K = R G of (16)."""
    plant, r, truth, estimate = drawn(seed)
    b, R, G = plant.B, np.diag(r), np.diag(g(r))
    Lambda, Lambda_hat, K, I = np.diag(truth), np.diag(estimate), np.diag(r) @ np.diag(g(r)), np.eye(4)  # noqa: E741
    inverse = np.linalg.inv(Lambda_hat)
    lines = (
        GAMMA * np.diag(np.linalg.inv(b) @ b @ (Lambda @ inverse - I) @ r) @ Lambda_hat @ G,
        GAMMA * (Lambda @ inverse - I) @ R @ Lambda_hat @ G,
        GAMMA * (Lambda @ inverse - I) @ Lambda_hat @ R @ G,
        GAMMA * (Lambda @ inverse @ Lambda_hat - Lambda_hat) @ R @ G,
        GAMMA * (Lambda - Lambda_hat) @ R @ G,
        GAMMA * (Lambda - Lambda_hat) @ K,
    )
    for line in lines[:-1]:
        assert line == pytest.approx(lines[-1], rel=1e-11, abs=1e-12)


Matrix = Callable[[float], np.ndarray]


def slope(of: Callable[[float], np.ndarray]) -> np.ndarray:
    """Derivative at 0 of a smooth function of time, by central differences with Richardson's step: error of fourth order."""
    h = 1e-3
    return np.asarray((8.0 * (of(h) - of(-h)) - (of(2 * h) - of(-2 * h))) / (12.0 * h))


def moving(rng: np.random.Generator, low: float, high: float) -> tuple[Matrix, Matrix]:
    """A vector that moves smoothly between two bounds, and its derivative."""
    middle, size, phase = 0.5 * (low + high), 0.5 * (high - low), rng.uniform(0.0, 6.0, 4)
    return (lambda t: middle + size * np.sin(phase + 2.0 * t)), (
        lambda t: 2.0 * size * np.cos(phase + 2.0 * t)
    )


@PROPERTY
@given(seeds)
def test_eq_24_derivative_of_the_error(seed: int) -> None:
    """(24): the derivative of (12) has three terms, for r, Lambda and Lambda_hat that all move."""
    rng = np.random.default_rng(seed)
    b = drawn(seed)[0].B
    (r, r_dot), (truth, truth_dot), (estimate, estimate_dot) = (
        moving(rng, *bounds) for bounds in ((-1.0, 1.0), (0.2, 1.0), (0.3, 1.2))
    )

    def e(t: float) -> np.ndarray:
        return np.asarray(b @ ((truth(t) / estimate(t) - 1.0) * r(t)))

    inverse = np.diag(1.0 / estimate(0.0))
    printed = (
        b @ (np.diag(truth(0.0)) @ inverse - np.eye(4)) @ r_dot(0.0)
        + b @ np.diag(truth_dot(0.0)) @ inverse @ r(0.0)
        - b @ np.diag(truth(0.0)) @ inverse @ np.diag(estimate_dot(0.0)) @ inverse @ r(0.0)
    )
    assert slope(e) == pytest.approx(printed, abs=1e-6)


@PROPERTY
@given(seeds, st.floats(-5.0, 5.0))
def test_eq_26_27_the_determinant_does_not_see_b(seed: int, v: float) -> None:
    """(26), (27): det(A - v I) with A of (25) is det(-gamma Lambda Lambda_hat^-1 K - v I) for every v, eigenvalue or not."""
    plant, r, truth, estimate = drawn(seed)
    d = -GAMMA * truth / estimate * r * g(r)
    a = plant.B @ np.diag(d) @ np.linalg.inv(plant.B)
    scale = np.prod(np.abs(d) + abs(v)) + 1e-12
    assert (
        abs(np.linalg.det(a - v * np.eye(4)) - np.prod(d - v)) <= 1e-8 * scale * np.linalg.cond(plant.B) ** 4
    )
