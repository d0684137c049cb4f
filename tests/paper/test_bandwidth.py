"""What lag, delay, sampling, rate limit and stops do to (13), on the ideal plant with the functions that fly (section 5.2).

Readings are checked without waiting: the estimate is frozen by a tiny gamma at a value, and the mean rate of its logarithm over
whole periods must vanish at the predicted reading and be E[kappa] (reading/estimate - 1) elsewhere (`pull`).
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from paper.ideal import UNLIMITED, IdealLoop, IdealPlant, Tuning
from scipy.signal import cont2discrete, lfilter

from paper import bandwidth, rate_limits

DT, TRUTH = 0.005, 0.7
PERIOD, WARM, PERIODS = 400, 8, 4
SLOW = 1e-7
PHASE = 2.0 * math.pi * (np.arange((WARM + PERIODS) * PERIOD) + 0.5) / PERIOD
W = 2.0 * math.pi / (PERIOD * DT)
"""Frequency of the commands [rad/s]."""
SINE = np.sin(PHASE)


def warped(w_tau: float) -> float:
    """Corner [rad/s] of a bilinear lag with which the sampled command of frequency W has exactly this w tau."""
    return 2.0 / DT * math.tan(math.pi / PERIOD) / w_tau


def pull(
    r: np.ndarray, estimate: float, epsilon: float, lag: float, modelled: float = 0.0, rate: float = UNLIMITED
) -> tuple[float, float]:
    """Mean rate of log lambda_hat over gamma, and E[kappa], with the estimate held at a value.

    Args:
        r: [steps] reference; the first WARM periods are left out.
        lag, rate: of the real servo [rad/s, 1/s].
        modelled: lag of the model's servo [rad/s], 0 for the plain law.
    """
    loop = IdealLoop(IdealPlant(np.eye(4), lag=lag, rate=rate), Tuning(SLOW, epsilon, DT), estimate)
    loop._models["lag"][0], loop._models["rate"][0] = modelled, UNLIMITED
    history = loop.fly(np.tile(r[:, None], (1, 4)), TRUTH)
    log = np.log(history.lambda_hat[WARM * PERIOD :, 0])
    a = history.a[WARM * PERIOD :, 0]
    kappa = np.where(np.abs(a) > epsilon, 1.0, (a / epsilon) ** 2).mean()
    return float((log[-1] - log[0]) / (SLOW * DT * (len(log) - 1))), float(kappa)


def check_reading(reading: float, rounding: float = 1e-5, **flown: object) -> None:
    """The mean rate is gamma E[kappa] (reading lambda / estimate - 1), at the reading and on both sides of it."""
    for factor in (1.0, 0.9, 1.2):
        rate, kappa = pull(estimate=TRUTH * reading * factor, **flown)  # type: ignore[arg-type]
        assert abs(rate - (1.0 / factor - 1.0) * kappa) <= rounding * max(kappa, abs(rate))


EPSILONS = (5.0, 1e-9)
"""All commands within epsilon, and all beyond."""


@pytest.mark.parametrize("epsilon", EPSILONS)
@pytest.mark.parametrize("modelled", [0.5, 2.0])
def test_eq_13_with_a_wrong_servo_model_reads_re_f_over_f_m(modelled: float, epsilon: float) -> None:
    """A model with half or twice the time constant, at w tau = 1: .75 and 1.5, both far from 1.

    The command is ahead by the model's phase, so that the modelled position has its zeros half a step off the samples: there the
    mean of 1/a vanishes by symmetry.
    """
    reading = bandwidth.moving_reading(bandwidth.lag(1.0, 1.0), bandwidth.lag(1.0, modelled))
    assert reading == pytest.approx({0.5: 0.75, 2.0: 1.5}[modelled])
    ahead = np.sin(PHASE + math.atan(modelled))
    check_reading(reading, 1e-4, r=ahead, epsilon=epsilon, lag=warped(1.0), modelled=warped(modelled))


@pytest.mark.parametrize("w_tau", [0.3, 1.0, 2.0])
def test_eq_13_of_a_moving_command_with_an_offset_reads_above_one(w_tau: float) -> None:
    """Far beyond epsilon, and never through zero: the plain law over-estimates."""
    reading = bandwidth.offset_reading(bandwidth.lag(1.0, w_tau), 0.8)
    assert 1.0 < reading < 1.7
    check_reading(reading, r=1.0 + 0.8 * SINE, epsilon=1e-9, lag=warped(w_tau))


@pytest.mark.parametrize("share", [0.5, 3.0])
def test_eq_13_of_a_moving_command_with_an_offset_reads_below_one_within_epsilon(share: float) -> None:
    reading = bandwidth.offset_reading_within(bandwidth.lag(1.0, 1.0), share)
    assert 0.5 < reading < 1.0
    check_reading(reading, r=0.3 * (1.0 + share * SINE), epsilon=5.0, lag=warped(1.0))


def test_any_waveform_reads_the_mean_of_g_a_over_the_mean_of_kappa() -> None:
    """Of a command with three harmonics and an offset, half of it within epsilon; the lag by scipy, not by the law's servo."""
    r = 0.1 + 0.5 * SINE + 0.3 * np.sin(3 * PHASE + 1.0) - 0.2 * np.cos(5 * PHASE)
    lag = warped(0.7)
    b = lag * DT / (2.0 + lag * DT)
    a = lfilter([b, b], [1.0, -(2.0 - lag * DT) / (2.0 + lag * DT)], r)[WARM * PERIOD :]
    reading = bandwidth.waveform_reading(r[WARM * PERIOD :], a, 0.3)
    assert reading < 0.95
    # epsilon is in units of u = r / estimate here, so that the same samples are within it for each estimate
    for factor in (1.0, 0.9, 1.2):
        estimate = TRUTH * reading * factor
        rate, kappa = pull(r, estimate, 0.3 / estimate, lag)
        assert abs(rate - (1.0 / factor - 1.0) * kappa) <= 1e-6


def test_an_unmodelled_rate_limit_reads_twice_the_square_of_its_share() -> None:
    """A lag of one step makes the position late by half a step, a phase of pi / PERIOD: its effect is below that."""
    share = 0.4
    reading = rate_limits.rate_limited_reading(share)
    amplitude = 1.0
    estimate = TRUTH * reading
    rate, kappa = pull(amplitude * estimate * SINE, estimate, 50.0, 2.0 / DT, rate=share * amplitude * W)
    assert abs(rate) <= 2.0 * math.pi / PERIOD / reading * kappa


@pytest.mark.parametrize("share", [0.2, 0.5, 0.55, 0.7, 0.9, 0.99, 0.999999, 1.0, 1.5])
def test_a_rate_limit_has_its_describing_function(share: float) -> None:
    """The fundamental of a rate-limited sine in small steps: triangle, sine with straight parts, sine."""
    steps = 5000
    phase = 2.0 * math.pi * np.arange(30 * steps) / steps
    y, a, most = np.sin(phase), 0.0, share * 2.0 * math.pi / steps
    found = np.empty_like(y)
    for k, target in enumerate(y):
        a += min(max(target - a, -most), most)
        found[k] = a
    last = slice(-steps, None)
    measured = 2.0 * (found[last] * (np.sin(phase[last]) + 1j * np.cos(phase[last]))).mean()
    predicted = rate_limits.rate_limited(share)
    assert abs(measured - predicted) < 2e-3
    assert rate_limits.rate_limited_reading(share) == predicted.real


@pytest.mark.parametrize("modelled", [0.0, 12.0])
@pytest.mark.parametrize("limit", [0.9, 0.7, 0.55])
def test_an_unmodelled_rate_limit_about_an_offset(limit: float, modelled: float) -> None:
    """The mean rate of (13) vanishes at the reading; without the limit, the reading of the lag alone is another."""
    share, offset, lag = 1.4, 0.3, 12.0
    f, f_m = bandwidth.lag(W, 1.0 / lag), bandwidth.lag(W, 1.0 / modelled) if modelled else 1.0
    reading = rate_limits.rate_limited_offset_reading(share, limit, f, f_m)
    r = TRUTH * offset * (1.0 + share * SINE)
    rate, kappa = pull(r, TRUTH * reading, 50.0, lag, modelled, limit * share * offset * W)
    assert abs(rate) <= 2e-3 * kappa
    assert abs(reading - bandwidth.offset_reading_within(f / f_m, share * abs(f_m))) > 1e-3


@pytest.mark.parametrize("gamma_dt", [0.5, 1.2, 1.8])
def test_a_loss_in_large_steps_overshoots_from_gamma_dt_1_on(gamma_dt: float) -> None:
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma_dt / DT, 1e-6, DT), 1.0)
    lowest = float(loop.fly(np.ones((1000, 4)), 0.2).lambda_hat.min())
    assert lowest == pytest.approx(bandwidth.sampled_extreme(1.0, 0.2, gamma_dt), rel=1e-9)
    assert (lowest < 0.2 * (1.0 - 1e-6)) is (gamma_dt > 1.0)


def test_below_the_trap_a_rate_limit_drives_the_estimate_to_zero() -> None:
    """The equilibrium of the reading does not hold: the estimate moves away from it on both sides."""
    limit = 0.5
    trap = rate_limits.rate_limit_trap(amplitude := 0.4 * 2.0 * TRUTH * limit / W, W, limit, TRUTH)
    assert 0.2 < trap < 0.3
    below, above = (
        pull(amplitude * SINE, trap * factor, 50.0, 2.0 / DT, rate=limit)[0] for factor in (0.9, 1.1)
    )
    assert below < 0.0 < above


@pytest.mark.parametrize("demand", [1.25, 4.0])
def test_eq_13_at_a_stop_falls_exponentially_unless_the_stop_is_modelled(demand: float) -> None:
    """Exact in discrete time: x = lambda a_max - r and g = 1/u give (lambda a_max / r - 1) whatever lambda_hat is."""
    gamma, stop = 4.0, 0.5
    r = np.full((400, 4), demand * TRUTH * stop)
    rates = []
    for modelled in (False, True):
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 0.05, DT), TRUTH)
        for which in (1, 0)[: 1 + modelled]:
            loop._models["low"][which], loop._models["high"][which] = -stop, stop
        log = np.log(loop.fly(r, TRUTH).lambda_hat[:, 0])
        rates.append((log[-1] - log[0]) / (400 * DT))
    assert rates[0] == pytest.approx(bandwidth.saturated_rate(gamma, demand), rel=1e-12)
    assert abs(rates[1]) < 1e-12


@pytest.mark.parametrize("known", [0.5, 5.0])
def test_the_fall_at_a_stop_ends_where_allocation_asks_for_no_more(known: float) -> None:
    """r is at most lambda_hat times the known travel, as allocation has it: the plain law ends at lambda real / known."""
    real, wanted, estimate = 0.5, 2.0, 1.0
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(8.0, 1e-3, DT), 1.0)
    loop._models["high"][1] = real
    for _ in range(3000):
        r = min(wanted, estimate * known)
        estimate = float(loop.fly(np.full((1, 4), r), TRUTH).lambda_hat[1, 0])
    assert estimate == pytest.approx(TRUTH * bandwidth.stop_reading(real, known), rel=1e-3)


# Behind an unmodelled first-order lag: x times the truth after a loss to 0.2, a recovery from 0.2.
LOSSES = {0.5: 0.97, 1.0: 0.84, 2.0: 0.64, 5.0: 0.38}
RECOVERIES = {0.25: 1.10, 1.0: 6.7}


@pytest.mark.parametrize("gamma_tau", [*LOSSES, *RECOVERIES])
def test_eq_21_behind_an_unmodelled_lag_overshoots(gamma_tau: float) -> None:
    """The flying law behind the flying servo, against an adaptive integration of the continuous equation.

    Explicit steps of gamma dt = 1e-3 are wrong by about half of that in the logarithm, times the span of the logarithm.
    """
    for cases, start, truth in ((LOSSES, 1.0, 0.2), (RECOVERIES, 0.2, 1.0)):
        if gamma_tau not in cases:
            continue
        predicted = bandwidth.extreme(start, truth, gamma_tau)
        assert predicted / truth == pytest.approx(cases[gamma_tau], abs=0.05 if predicted > 2 else 0.006)
        gamma = 2.0
        plant = IdealPlant(np.eye(4), lag=gamma / gamma_tau, modelled=False)
        loop = IdealLoop(plant, Tuning(gamma, 1e-6, 5e-4), start)
        loop.start_at(np.full(4, 1.0 / start))
        estimate = loop.fly(np.ones((16000, 4)), truth).lambda_hat[:, 0]
        flown = estimate.min() if truth < start else estimate.max()
        assert math.log(flown / predicted) == pytest.approx(0.0, abs=2e-3 * max(1.0, math.log(1.0 / 0.2)))


def test_a_small_change_overshoots_beyond_a_quarter_only() -> None:
    """The linear rule: damping 1 at gamma tau = 1/4; a large recovery overshoots at that already, as above."""
    assert bandwidth.damping(bandwidth.OVERSHOOT_LIMIT) == 1.0
    for gamma_tau, overshoots in ((0.24, False), (0.5, True)):
        found = bandwidth.extreme(1.01, 1.0, gamma_tau)
        assert (found < 1.0 - 1e-5) == overshoots


def test_the_lag_alone_never_destabilises() -> None:
    """The proof's function V = tau xi'^2 / 2 + gamma (lambda exp(-xi) + xi) falls in flight at gamma tau = 20, far beyond 1/4."""
    gamma, tau, dt = 20.0, 1.0, 1e-4
    loop = IdealLoop(IdealPlant(np.eye(4), lag=1.0 / tau, modelled=False), Tuning(gamma, 1e-9, dt), 1.0)
    loop.start_at(np.full(4, 1.0))
    xi = np.log(loop.fly(np.ones((60000, 4)), 0.5).lambda_hat[:, 0])
    rate = np.diff(xi) / dt
    energy = 0.5 * tau * rate**2 + gamma * (0.5 * np.exp(-xi[:-1]) + xi[:-1])
    assert np.diff(energy[::100]).max() <= gamma**2 * dt  # one explicit step's error
    assert energy[-1] - gamma * (1.0 + math.log(0.5)) < 0.01 * energy[0]


# --- limits of stability: just inside a small error decays, just outside it grows ------------------------------------------------


def driven(
    gamma_dt: float,
    position: Callable[[float], float],
    steps: int,
    start: float = 0.5 * (1.0 + 1e-6),
    truth: float = 0.5,
) -> np.ndarray:
    """Deviations of log lambda_hat from the truth with the real position computed here: what it differs from the command is a
    disturbance of the rates, so any actuator can stand behind the flying law."""
    dt = 0.01
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma_dt / dt, 1e-9, dt), start)
    estimate, found = start, []
    for _ in range(steps):
        u = 1.0 / estimate
        lost = truth * (position(u) - u)
        estimate = float(loop.fly(np.ones((1, 4)), truth, np.full(4, lost)).lambda_hat[1, 0])
        found.append(math.log(estimate / truth))
    return np.array(found)


def grows(deviations: np.ndarray) -> bool:
    """Whether the deviation is larger in the last quarter than in the first ten steps. Beyond the limit it ends in a cycle."""
    return bool(np.abs(deviations[-(len(deviations) // 4) :]).max() > np.abs(deviations[:10]).max())


def delayed(steps: int) -> Callable[[float], float]:
    """The position is the command of some steps ago."""
    line = [2.0] * steps

    def position(u: float) -> float:
        line.append(u)
        return line.pop(0)

    return position


@pytest.mark.parametrize("steps", [0, 1, 2, 3, 5])
def test_eq_21_with_a_late_error_is_stable_up_to_the_delay_limit(steps: int) -> None:
    quiet, stable = bandwidth.delay_limits(steps)
    assert stable == pytest.approx({0: 2.0, 1: 1.0, 2: 0.618, 3: 0.445, 5: 0.285}[steps], abs=5e-4)
    assert not grows(driven(0.97 * stable, delayed(steps), 600))
    assert grows(driven(1.03 * stable, delayed(steps), 600))
    # Without overshoot a positive deviation stays positive.
    assert driven(0.99 * quiet, delayed(steps), 200).min() > -1e-13
    assert driven(1.25 * quiet, delayed(steps), 200).min() < -1e-12


@pytest.mark.parametrize(("start", "truth"), [(1.0, 0.2), (0.2, 1.0)])
@pytest.mark.parametrize("gamma_delay", [0.2, 0.5, 1.0])
def test_eq_21_with_a_late_error_overshoots(start: float, truth: float, gamma_delay: float) -> None:
    """The flying law with its error late by 20 steps: late_extreme with as many. A step of effectiveness is seen as late."""
    steps = 20
    line = [1.0 / start] * steps

    def position(u: float) -> float:
        line.append(u)
        return line.pop(0)

    estimate = truth * np.exp(driven(gamma_delay / steps, position, 2500, start, truth))
    found = estimate.min() if truth < start else estimate.max()
    predicted = bandwidth.late_extreme(start, truth, gamma_delay, steps)
    assert found == pytest.approx(predicted, rel=1e-9)


def test_many_steps_of_delay_are_a_dead_time() -> None:
    """d steps of delay, and half a step for sampling, tend to the limits of a dead time in continuous time."""
    quiet, stable = bandwidth.dead_time_limits(1.0)
    for continuous, sampled in zip((quiet, stable), bandwidth.delay_limits(400), strict=True):
        assert sampled * 400.5 == pytest.approx(continuous, rel=1e-5)


def linear(response: tuple[np.ndarray, ...]) -> Callable[[float], float]:
    """A sampled linear actuator (A, B, C, D) that rests at 2: its position at the end of the step for which u was held."""
    a, b, c, _ = response
    state = np.linalg.solve(np.eye(len(a)) - a, b[:, 0] * 2.0)

    def position(u: float) -> float:
        nonlocal state
        state = a @ state + b[:, 0] * u
        return float(c[0] @ state)

    return position


def held(numerator: list[float], denominator: list[float], dt: float) -> tuple[np.ndarray, ...]:
    """State space of a transfer function behind a zero-order hold."""
    b0 = numerator[-1]
    n = len(denominator) - 1
    a = np.zeros((n, n))
    a[:-1, 1:] = np.eye(n - 1)
    a[-1] = -np.array(denominator[:0:-1]) / denominator[0]
    b = np.zeros((n, 1))
    b[-1, 0] = 1.0 / denominator[0]
    c = np.zeros((1, n))
    c[0, 0] = b0
    return cont2discrete((a, b, c, np.zeros((1, 1))), dt)[:4]


@pytest.mark.parametrize(("tau_over_dt", "limit"), [(10.0, 40.0), (3.0, 12.1)])
def test_a_sampled_lag_has_a_limit(tau_over_dt: float, limit: float) -> None:
    found = bandwidth.sampled_lag_limit(tau_over_dt)
    assert found == pytest.approx(limit, rel=2e-3)
    for share, unstable in ((0.97, False), (1.03, True)):
        servo = linear(held([1.0], [tau_over_dt, 1.0], 1.0))
        assert grows(driven(share * found, servo, 600)) == unstable


def test_the_flying_servo_has_the_limit_of_no_servo() -> None:
    """Behind the bilinear lag the limit is gamma dt = 2, whatever tau: the product of the two roots is 1 there."""
    for step, unstable in ((1.96, False), (2.04, True)):
        plant = IdealPlant(np.eye(4), lag=30.0, modelled=False)
        loop = IdealLoop(plant, Tuning(step / DT, 1e-9, DT), 0.5 * (1.0 + 1e-6))
        loop.start_at(np.full(4, 2.0))
        assert grows(np.log(loop.fly(np.ones((800, 4)), 0.5).lambda_hat[:, 0] / 0.5)) == unstable


def test_a_second_order_servo_limits_gamma_to_twice_its_damping_times_its_frequency() -> None:
    """Sampled at w dt = 0.02: the limit moves by about half a step of delay, w^2 dt / 2 in the characteristic equation."""
    natural, zeta, dt = 1.0, 0.7, 0.02
    limit = bandwidth.second_order_limit(natural, zeta)
    assert limit == pytest.approx(1.4)
    for share, unstable in ((0.95, False), (1.05, True)):
        servo = linear(held([natural**2], [1.0, 2 * zeta * natural, natural**2], dt))
        assert grows(driven(share * limit * dt, servo, 8000)) == unstable


# --- what may be asked of a servo and a sensor ------------------------------------------------------------------------------


def test_the_slowest_servo_and_the_latest_sensor_read_what_is_tolerated() -> None:
    tau = bandwidth.slowest_servo(5.0, 0.2)
    assert bandwidth.moving_reading(bandwidth.lag(5.0, tau)) == pytest.approx(0.8)
    late = bandwidth.latest_sensor(1.0, 5.0, 0.2)
    assert bandwidth.moving_reading(bandwidth.dead_time(5.0, late)) == pytest.approx(0.8)
    # A fast estimator is limited by its own overshoot first.
    assert bandwidth.latest_sensor(40.0, 5.0, 0.2) == bandwidth.dead_time_limits(40.0)[0]
    servo = bandwidth.second_order(20.0, 20.0, 0.7)
    assert bandwidth.moving_reading(servo) == pytest.approx(
        0.0, abs=1e-15
    )  # 90 deg of phase: nothing is left
