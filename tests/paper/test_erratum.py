"""The paper's slips: each printed form fails where its correction holds (docs/explanation/erratum.md)."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
import pytest
from paper.ideal import IdealLoop, IdealPlant, Tuning
from vtail_setup import PAPER, trim_state, vtail_setup

from testbed.controllers.initial_records import model_record
from testbed.controllers.inversion.law import modified_inverse, state_function
from testbed.controllers.records import Q_DOT

GAMMA, EPSILON = 2.0, 0.1
RNG = np.random.default_rng(42)
_FIRST_DRAW = RNG.bit_generator.state


@pytest.fixture(autouse=True)
def the_same_draws_in_any_order() -> None:
    RNG.bit_generator.state = _FIRST_DRAW


B = np.linalg.qr(RNG.normal(size=(4, 4)))[0] @ np.diag([0.5, 1.0, 2.0, 3.0])
R = np.array([0.4, -0.3, 0.05, 0.8])
TRUTH, ESTIMATE = np.array([0.5, 1.0, 0.2, 0.9]), np.array([0.8, 0.6, 0.5, 1.1])
G = np.array([modified_inverse(x, EPSILON) for x in R])
K = R * G


def test_eq_17_k_is_only_semidefinite() -> None:
    """Printed: "K is a positive-diagonal matrix". At r = 0 it is zero, and the estimate does not move."""
    assert 0.0 * modified_inverse(0.0, EPSILON) == 0.0
    r = np.tile([0.0, 0.3, 0.3, 0.3], (400, 1))
    estimate = IdealLoop(IdealPlant(np.eye(4)), Tuning(), 1.0).fly(r, 0.5).lambda_hat
    assert estimate[-1, 0] == 1.0 and estimate[-1, 1] < 0.6


def test_eq_25_first_line_has_the_estimate_and_not_its_inverse() -> None:
    """The bracket is Lambda_hat' of (13), gamma diag(B^-1 e) Lambda_hat G. Printed is Lambda_hat^-1 there."""
    e = B @ ((TRUTH / ESTIMATE - 1.0) * R)

    def first_line(middle: np.ndarray) -> np.ndarray:
        rate = GAMMA * np.diag(np.linalg.inv(B) @ e) @ np.diag(middle) @ np.diag(G)
        return np.asarray(-B @ np.diag(TRUTH / ESTIMATE) @ rate @ np.diag(1.0 / ESTIMATE) @ R)

    last_line = -GAMMA * B @ np.diag(TRUTH / ESTIMATE * K) @ np.linalg.inv(B) @ e
    assert first_line(ESTIMATE) == pytest.approx(last_line, rel=1e-12)
    assert np.abs(first_line(1.0 / ESTIMATE) - last_line).max() > 0.1 * np.abs(last_line).max()


def test_eq_32_is_the_derivative_of_the_estimate() -> None:
    """Printed: Lambda_hat = ... The right-hand side vanishes where the estimate rests, and the estimate is not zero there."""
    n = 0.3 * R
    rests_at = TRUTH / (1.0 - n / R)
    right = GAMMA * (TRUTH * K - rests_at * (K - n * G))
    assert right == pytest.approx(np.zeros(4), abs=1e-15)
    assert rests_at.min() > 0.2
    loop = IdealLoop(IdealPlant(B), Tuning(GAMMA, EPSILON), rests_at)
    flown = loop.fly(np.tile(R, (2000, 1)), TRUTH, B @ n).lambda_hat
    assert flown[-1] == pytest.approx(rests_at, rel=1e-9)


def test_eq_34_first_term_has_the_inverse_of_the_estimate_and_not_of_its_derivative() -> None:
    """With r, Lambda_hat and n that move: the corrected (34) is the slope of (33), the printed one is not."""
    r_dot, estimate_dot, n_dot = np.array(
        [[1.0, -0.5, 0.2, 0.3], [0.4, -0.3, 0.2, 0.5], [0.1, 0.2, -0.3, 0.1]]
    )

    def e(t: float) -> np.ndarray:
        return np.asarray(B @ ((TRUTH / (ESTIMATE + estimate_dot * t) - 1.0) * (R + r_dot * t)) + n_dot * t)

    def printed(inverse: np.ndarray) -> np.ndarray:
        first = B @ (np.diag(TRUTH * inverse) - np.eye(4)) @ r_dot
        return np.asarray(first - B @ np.diag(TRUTH / ESTIMATE**2 * estimate_dot) @ R + n_dot)

    h = 1e-6
    slope = (e(h) - e(-h)) / (2 * h)
    assert slope == pytest.approx(printed(1.0 / ESTIMATE), abs=1e-8)
    assert np.abs(slope - printed(1.0 / estimate_dot)).max() > 0.5


def test_remark_3_of_4_1_needs_no_estimate() -> None:
    """Printed: n g > lambda_hat kappa diverges. Corrected: n g > kappa, n/r > 1. Between the two, at an estimate of 0.3 with
    n/r = 0.6, the printed condition holds and the estimate comes to rest."""
    ratio, r = 0.6, 0.5
    assert ratio * r * modified_inverse(r, EPSILON) > 0.3 * r * modified_inverse(r, EPSILON)
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(GAMMA, 1e-9), 0.3)
    estimate = loop.fly(np.full((8000, 4), r), 0.3, np.full(4, ratio * r)).lambda_hat
    assert estimate[-1] == pytest.approx(np.full(4, 0.3 / (1.0 - ratio)), rel=1e-6)


def test_remark_of_2_2_6_needs_a_kappa_whose_integral_diverges() -> None:
    """Printed: the estimates approach the truth "whenever r is not 0". With r = epsilon exp(-t) it is never 0, kappa is exp(-2 t),
    and (19) leaves the share exp(-gamma int kappa) = exp(-gamma/2) of the error for ever. The law has kappa of a = r / lambda_hat,
    which is between kappa(r) and kappa(r / 0.5) here."""
    dt = 0.005
    r = EPSILON * np.exp(-dt * np.arange(8000))
    start, truth = 1.0, 0.5
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(GAMMA, EPSILON, dt), start)
    left = (loop.fly(np.tile(r[:, None], (1, 4)), truth).lambda_hat[-1, 0] - truth) / (start - truth)
    assert r.min() > 0.0
    # kappa(r / 0.5) is 1 for log 2 and exp(-2 (t - log 2)) from then on
    fastest, slowest = math.exp(-GAMMA * (math.log(2.0) + 0.5)), math.exp(-GAMMA * 0.5)
    assert fastest - 0.01 < left < slowest + 0.01


def test_eq_38_needs_the_whole_state_in_its_jacobian_term() -> None:
    """Printed: J x_c_dot. The difference of two design models moves with angle of attack too, which is no controlled state: the
    slope of delta_f is J x_dot, and what J x_c_dot leaves out is most of it here."""
    right, wrong = (
        vtail_setup(),
        vtail_setup(PAPER.model_copy(update={"model_error": {"Cm_alpha": 1.2, "Cm_q": 1.1}})),
    )
    moves = {"alpha": 0.3, "q": 0.5}

    def delta_f(t: float, moving: Iterable[str]) -> np.ndarray:
        y = trim_state(
            right.model,
            **{name: right.model.alpha_rad * (name == "alpha") + moves[name] * t for name in moving},
        )
        f, f_m = np.zeros(4), np.zeros(4)
        state_function(y, model_record(right)[0], f)
        state_function(y, model_record(wrong)[0], f_m)
        return f - f_m

    def slope(moving: Iterable[str]) -> np.ndarray:
        return np.asarray((delta_f(1e-4, moving) - delta_f(-1e-4, moving)) / 2e-4)

    assert slope(("alpha", "q")) == pytest.approx(slope(("alpha",)) + slope(("q",)), abs=1e-9)
    assert abs(slope(("q",))[Q_DOT]) < 0.5 * abs(slope(("alpha", "q"))[Q_DOT])


def test_eq_41_first_line_has_b_mc_in_its_bracket() -> None:
    """Printed: B_mc^-1 [B_c Lambda Lambda_hat^-1 - I] r. With (40) it is B_mc^-1 [B_c Lambda Lambda_hat^-1 - B_mc] r, which its own
    second line has too."""
    b_c = B @ (np.eye(4) + 0.2 * RNG.normal(size=(4, 4)))

    def first_line(subtracted: np.ndarray) -> np.ndarray:
        bracket = np.linalg.inv(B) @ (b_c @ np.diag(TRUTH / ESTIMATE) - subtracted) @ R
        return GAMMA * bracket * ESTIMATE * G

    second_line = GAMMA * ESTIMATE * (np.linalg.inv(B) @ b_c @ np.diag(TRUTH / ESTIMATE) @ R - R) * G
    assert first_line(B) == pytest.approx(second_line, rel=1e-12)
    assert np.abs(first_line(np.eye(4)) - second_line).max() > 0.1 * np.abs(second_line).max()
    dt = 1e-8
    loop = IdealLoop(IdealPlant(B, B_c=b_c), Tuning(GAMMA, 1e-9, dt), ESTIMATE)
    flown = loop.fly(R[None, :], TRUTH).lambda_hat
    beyond = GAMMA * ESTIMATE * (np.linalg.inv(B) @ b_c @ np.diag(TRUTH / ESTIMATE) @ R - R) / R
    assert (flown[1] - flown[0]) / dt == pytest.approx(beyond, rel=1e-5)


def test_eq_29_as_printed_needs_the_failed_actuator_to_reach_the_released_axis() -> None:
    """The printed B_hat keeps B_42. Where the failed actuator has no effect on the released axis it is singular, although the three
    others control the three axes that are kept: their inverse exists by itself."""
    b = B.copy()
    b[3, 1] = 0.0
    printed = b.copy()
    printed[:3, 1], printed[3, [0, 2, 3]] = 0.0, 0.0
    assert np.linalg.matrix_rank(printed) == 3
    kept = b[np.ix_([0, 1, 2], [0, 2, 3])]
    assert kept @ np.linalg.inv(kept) == pytest.approx(np.eye(3), abs=1e-12)
