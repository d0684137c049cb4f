"""The weighted estimation: a Kalman filter, on effectiveness and on the model's own error."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from vtail_setup import state

from testbed.controllers.inversion.estimator import (
    JAM_NOISE,
    JAM_VARIANCE,
    LATENESS_MAX,
    REVERSAL_NOISE,
    REVERSAL_S,
    UNKNOWN_VARIANCE,
    adapt_weighted,
    beyond_model,
    delay_regressor,
    expect_change,
    predict,
    project,
    reset_covariance,
    update_by_rate,
    update_model_error_variance,
)
from testbed.controllers.inversion.evidence import MEAN_S
from testbed.controllers.inversion.law import lag_gain, low_pass, regressor
from testbed.controllers.records import (
    D_ALPHA,
    Q_DOT,
    U_DOT,
    memory_dtype,
    model_dtype,
    settings_dtype,
)

N = 4
RNG = np.random.default_rng(4)
_FIRST_DRAW = RNG.bit_generator.state


@pytest.fixture(autouse=True)
def the_same_draws_in_any_order() -> None:
    RNG.bit_generator.state = _FIRST_DRAW


def records() -> tuple[Any, Any, Any]:
    """Settings, model and memory of an estimator with round numbers."""
    c, m, s = (np.zeros(1, dtype(N))[0] for dtype in (settings_dtype, model_dtype, memory_dtype))
    c.dt, c.process_noise, c.model_error_rate = 0.005, 0.1, 0.1
    c.lambda_min, c.lambda_max = -10.0, 10.0
    c.noise[:] = [2.0, 0.5, 0.15, 0.08]
    m.low[:], m.high[:], m.stall_alpha = -3.0, 3.0, 1.0
    s.lambda_hat[:], s.since_flag[:] = 1.0, math.inf
    s.P[:N, :N] = 0.01 * np.eye(N)
    s.model_error_variance[:] = [0.3, 0.4, 0.4, 0.05]
    return c, m, s


def test_the_weighted_gain_is_a_kalman_filters() -> None:
    """Against the filter in matrices, all four rows at once: they are the same filter when the noises are independent."""
    c, m, s = records()
    x, P = np.concatenate([s.lambda_hat, s.b]), s.P.copy()
    fade = np.diag([1.0] * N + [1.0 - c.model_error_rate * c.dt] * 4)
    drive = 2.0 * c.model_error_rate * c.dt * s.model_error_variance
    Q = np.diag([c.process_noise**2 * c.dt] * N + list(drive))
    R = np.diag(c.noise**2 / c.dt)
    for _ in range(200):
        phi, z = RNG.normal(size=(4, N)), RNG.normal(size=4)
        adapt_weighted(z, phi, np.zeros(N + 4), m, c, s)
        Hx = np.hstack([phi, np.eye(4)])
        x, P = fade @ x, fade @ P @ fade.T + Q
        K = P @ Hx.T @ np.linalg.inv(Hx @ P @ Hx.T + R)
        x, P = x + K @ (z - Hx @ x), P - K @ Hx @ P
    assert np.allclose(np.concatenate([s.lambda_hat, s.b]), x, rtol=1e-9, atol=1e-9)
    assert np.allclose(s.P, P, rtol=1e-9, atol=1e-9)


def test_one_rate_updates_as_one_scalar_measurement() -> None:
    """A single known number: variance p, noise r, gain p h / (h^2 p + b + r)."""
    c, _, s = records()
    s.P[:], s.b[:] = 0.0, 0.0
    s.P[1, 1], s.P[N + 2, N + 2] = 0.04, 0.09
    P_h, h = np.zeros(N + 4), np.array([0.0, 2.0, 0.0, 0.0])
    r = c.noise[2] ** 2 / c.dt
    total = 4.0 * 0.04 + 0.09 + r
    update_by_rate(2, 1.0, h, P_h, c, s)
    error = 1.0 - 2.0
    assert s.lambda_hat[1] == pytest.approx(1.0 + 0.04 * 2.0 * error / total)
    assert s.b[2] == pytest.approx(0.09 * error / total)
    assert s.P[1, 1] == pytest.approx(0.04 - (0.04 * 2.0) ** 2 / total)
    assert s.P[1, N + 2] == pytest.approx(-0.04 * 2.0 * 0.09 / total)
    assert s.lambda_hat[[0, 2, 3]].tolist() == [1.0] * 3


def test_without_a_measurement_uncertainty_grows_to_its_bound_and_the_models_error_fades() -> None:
    c, m, s = records()
    s.b[:], s.jammed[3] = 1.0, 1
    for _ in range(2000):
        predict(m, c, s)
    assert s.P[0, 0] == pytest.approx(0.01 + c.process_noise**2 * 10.0)
    assert s.P[3, 3] == pytest.approx(0.01 + JAM_NOISE**2 * 10.0)
    assert s.b == pytest.approx(np.full(4, math.exp(-1.0)), rel=1e-3)
    c.dt = 0.05
    for _ in range(20000):
        predict(m, c, s)
    assert s.P[0, 0] == UNKNOWN_VARIANCE and s.P[3, 3] == JAM_VARIANCE
    stationary = s.model_error_variance / (1.0 - 0.5 * c.model_error_rate * c.dt)  # of the discrete process
    assert np.diag(s.P)[N:] == pytest.approx(stationary, rel=1e-9)


def test_a_surface_just_found_jammed_may_be_anywhere_a_moment_later() -> None:
    """Until `REVERSAL_S`, and not a motor: what is reversed goes back with its command, within 0.1 s."""
    c, m, s = records()
    m.servo[:2], s.jammed[1:3], s.P[1, 1], s.P[2, 2] = 1, 1, 0.01, 0.01
    for since, noise in ((0.9 * REVERSAL_S, REVERSAL_NOISE), (REVERSAL_S, JAM_NOISE)):
        s.since_flag[:] = since
        before = s.P[1, 1]
        predict(m, c, s)
        assert s.P[1, 1] - before == pytest.approx(noise**2 * c.dt)
    assert s.P[2, 2] == pytest.approx(0.01 + 2.0 * JAM_NOISE**2 * c.dt)


def test_estimates_are_projected_and_a_jammed_position_onto_its_stops() -> None:
    c, m, s = records()
    c.lambda_min, c.lambda_max = -1.2, 1.2
    s.lambda_hat[:], s.jammed[3] = [-5.0, 5.0, 0.3, 5.0], 1
    project(m, c, s)
    assert s.lambda_hat.tolist() == [-1.2, 1.2, 0.3, 3.0]


def test_a_state_that_starts_again_is_correlated_with_nothing() -> None:
    _, _, s = records()
    s.P[:] = RNG.normal(size=(N + 4, N + 4))
    before = s.P.copy()
    reset_covariance(2, 0.5, s)
    assert s.P[2].tolist() == s.P[:, 2].tolist() == [0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0]
    others = [i for i in range(N + 4) if i != 2]
    assert np.array_equal(s.P[np.ix_(others, others)], before[np.ix_(others, others)])


def estimate_after(phi: np.ndarray, missing: np.ndarray, with_b: bool) -> tuple[np.ndarray, np.ndarray]:
    """Estimates and their standard deviations after 20 s in which f_m leaves out a constant of each rate."""
    c, m, s = records()
    if not with_b:
        s.model_error_variance[:] = 0.0
    for _ in range(4000):
        adapt_weighted(phi @ np.ones(N) + missing, phi, np.zeros(N + 4), m, c, s)
    return s.lambda_hat.copy(), np.sqrt(np.diag(s.P)[:N])


def test_a_wrong_model_does_not_read_as_a_lost_actuator() -> None:
    """A propeller that hardly pulls, and 0.7 rad/s2 of yaw that the model does not know. Without the model's error the
    filter is certain of a loss. With it the estimate stays, or is said to be uncertain."""
    phi = np.diag([0.5, 5.0, 0.8, 0.6])
    missing = np.array([0.0, 0.0, -0.7, 0.0])
    estimate, std = estimate_after(phi, missing, with_b=False)
    assert estimate[2] < 0.3 and std[2] < 0.15
    estimate, std = estimate_after(phi, missing, with_b=True)
    assert estimate[2] > 0.4 and std[2] > 0.15
    assert np.allclose(estimate[[0, 1, 3]], 1.0, atol=0.05)


def test_model_error_variance_grows_with_the_terms_of_the_model() -> None:
    """floor^2 + coefficient_error^2 x sum of squared changes, since the trim, of the terms of f_m and Phi lambda."""
    c, m, s = records()
    c.coefficient_error, c.model_error_std[:] = 0.2, [0.3, 0.3, 0.1, 0.1]
    m.airspeed, m.alpha, m.A[:], m.B[:] = 18.0, 0.05, RNG.normal(size=(4, 5)), RNG.normal(size=(4, N))
    m.servo[:] = 1
    y = state(airspeed=20.0, alpha=0.08, beta=0.04, p=0.1, q=-0.2, r=0.3)
    s.position[:], m.trim_position[:] = [0.5, -0.4, 1.5, 2.0], [0.2, 0.2, 1.4, 1.4]
    phi, pressure, speed = np.zeros((4, N)), (20.0 / 18.0) ** 2, 20.0 / 18.0
    regressor(pressure, m, s, phi)
    for _ in range(8000):
        update_model_error_variance(y, pressure, phi, m, c, s)
    x = np.array([pressure * 0.03, pressure * 0.04, speed * 0.1, speed * -0.2, speed * 0.3])
    moved = (pressure * m.B * (s.position - m.trim_position)) ** 2
    squares = ((m.A * x) ** 2).sum(1) + moved.sum(1)
    assert np.allclose(s.model_error_variance, c.model_error_std**2 + 0.04 * squares, rtol=1e-9)
    y = state(airspeed=18.0, alpha=0.05)
    s.position[:] = m.trim_position
    regressor(1.0, m, s, phi)
    for _ in range(8000):
        update_model_error_variance(y, 1.0, phi, m, c, s)
    assert np.allclose(s.model_error_variance, c.model_error_std**2, rtol=1e-9), (
        "at its trim the model is exact"
    )


def test_model_error_variance_of_forward_acceleration_rises_at_once() -> None:
    """That of the rotations is averaged in both directions, that of u_dot only while it falls."""
    c, m, s = records()
    c.coefficient_error, c.model_error_std[:] = 0.2, 0.1
    m.airspeed, m.A[:] = 18.0, 1.0
    far, near, phi = state(airspeed=18.0, alpha=0.5), state(airspeed=18.0), np.zeros((4, N))
    s.model_error_variance[:], s.lambda_hat[:] = 0.01, 0.0
    update_model_error_variance(far, 1.0, phi, m, c, s)
    final = 0.01 + 0.04 * 0.25
    assert s.model_error_variance[U_DOT] == pytest.approx(final)
    assert np.allclose(s.model_error_variance[:U_DOT], 0.01 + c.dt / MEAN_S * (final - 0.01))
    update_model_error_variance(near, 1.0, phi, m, c, s)
    assert s.model_error_variance[U_DOT] == pytest.approx(final - c.dt / MEAN_S * (final - 0.01))


def test_where_f_is_no_model_it_may_be_wrong_by_all_that_it_has() -> None:
    """Beyond the stall by the slope of what no longer grows, and of u_dot in a sideslip by the side force that leans forward."""
    c, m, s = records()
    m.airspeed, m.alpha, m.stall_alpha, m.side_slope, m.forward_curvature = 18.0, 0.05, 0.2, -16.0, 80.0
    m.A[:, D_ALPHA], c.coefficient_error = (0.0, -60.0, 0.0, 12.0), 1e-9
    phi = np.zeros((4, N))
    for alpha, beta, expected in (
        (0.19, 0.0, [0.0, 0.0, 0.0, 0.0]),
        (0.25, 0.0, [0.0, 3.0, 0.0, 0.05 * (12.0 + 160.0 * 0.15)]),
        (0.1, -0.5, [0.0, 0.0, 0.0, 4.0]),
        (0.25, 0.5, [0.0, 3.0, 0.0, math.hypot(1.8, 4.0)]),
    ):
        y = state(airspeed=18.0, alpha=alpha, beta=beta)
        assert [beyond_model(row, y, m) for row in range(4)] == pytest.approx(expected)
        s.model_error_variance[:] = 0.0
        update_model_error_variance(y, 0.5, phi, m, c, s)
        assert s.model_error_variance[U_DOT] == pytest.approx((0.5 * expected[U_DOT]) ** 2)
    c.coefficient_error, s.model_error_variance[:] = 0.0, 0.0  # the model error is switched off
    update_model_error_variance(y, 0.5, phi, m, c, s)
    assert not s.model_error_variance.any()


def sudden_change(lost: dict[int, float], seconds: float, expected: bool = True) -> Any:
    """Memory some time after these changes of effectiveness; each actuator's column of Phi stands out in a row of its own."""
    c, m, s = records()
    s.model_error_variance[:] = 0.01
    phi = np.diag([24.0, 6.0, 2.0, 1.0]) @ (np.eye(4) + 0.2 * RNG.normal(size=(4, N)))
    true = np.ones(N)
    for i, value in lost.items():
        true[i] = value
    for _ in range(round(seconds / c.dt)):
        e = phi @ true - phi @ s.lambda_hat
        if expected:
            expect_change(e, phi, m, c, s, np.zeros(4))
        adapt_weighted(phi @ true, phi, np.zeros(N + 4), m, c, s)
    return s


@pytest.mark.parametrize("lost", range(N))
def test_a_sudden_loss_is_followed_at_once_and_blamed_on_nobody_else(lost: int) -> None:
    s = sudden_change({lost: 0.0}, 0.5)
    assert abs(s.lambda_hat[lost]) < 0.25
    assert np.delete(np.array(s.lambda_hat), lost) == pytest.approx(np.ones(3), abs=0.15)
    assert sudden_change({lost: 0.0}, 0.5, expected=False).lambda_hat[lost] > 0.3, (
        "a random walk alone is slow"
    )


def test_without_a_change_no_variance_grows() -> None:
    before = sudden_change({}, 0.4).P[:N, :N].diagonal()
    assert np.all(before <= 0.01 + 0.1**2 * 0.4)


def test_what_two_actuators_explain_alike_is_blamed_on_neither() -> None:
    """Two equal columns: the residual is as likely the one's as the other's."""
    c, m, s = records()
    phi = np.ones((4, N))
    for _ in range(100):
        expect_change(np.full(4, 5.0), phi, m, c, s, np.zeros(4))
    assert np.array_equal(s.P[:N, :N], 0.01 * np.eye(N))


def test_what_two_explain_alike_is_blamed_on_the_one_that_is_jammed() -> None:
    c, m, s = records()
    s.jammed[2] = 1
    for _ in range(100):
        expect_change(np.full(4, 5.0), np.ones((4, N)), m, c, s, np.zeros(4))
    assert s.P[2, 2] > 0.01 and s.P[0, 0] == s.P[1, 1] == s.P[3, 3] == 0.01


def test_the_variance_of_a_change_is_its_square_up_to_a_bound() -> None:
    c, m, s = records()
    phi = 10.0 * np.eye(4)
    for _ in range(2000):
        expect_change(np.array([0.0, 4.0, 0.0, 0.0]), phi, m, c, s, np.zeros(4))
    assert s.P[1, 1] == pytest.approx(0.4**2, rel=1e-3)
    expect_change(np.array([0.0, 1e6, 0.0, 0.0]), phi, m, c, s, np.zeros(4))
    assert s.P[1, 1] == UNKNOWN_VARIANCE
    assert s.P[0, 0] == s.P[2, 2] == 0.01


@pytest.mark.parametrize("late", [0.5, LATENESS_MAX])
def test_the_effect_of_a_late_actuator_that_is_thrown_over_never_goes_the_wrong_way(late: float) -> None:
    """It follows late, and as far: a filter that first goes the other way makes a healthy elevator look reversed."""
    c, _, s = records()
    c.filter_rate, s.late[0] = 20.0, late
    phi, effects = np.zeros((4, N)), [0.0]
    for _ in range(400):
        phi[:] = 0.0
        phi[Q_DOT, 0] = 1.0
        for row in range(4):
            low_pass(phi[row], s.filtered_phi[:, row], lag_gain(c.filter_rate * c.dt))
        delay_regressor(phi, c, s)
        effects.append(float(phi[Q_DOT, 0]))
    assert np.all(np.diff(effects) >= 0.0) and effects[-1] == pytest.approx(1.0, abs=0.01)
    behind = sum(1.0 - effect for effect in effects) * c.dt  # area before a step response is its delay
    assert behind == pytest.approx((2.0 + late) / c.filter_rate, rel=0.05)  # of steps of 5 ms
