"""Equations (30) to (38) of the paper, section 4.1 and 4.2, each with the functions that fly.

The flying law integrates log(lambda_hat) and has the modelled position a in place of r. On an ideal plant a = r / lambda_hat,
and beyond epsilon both forms are the same. Tolerances are those of `test_equations`: rounding, or four standard errors of a
seeded run.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from paper.ideal import IdealLoop, IdealPlant, Tuning

from paper import noise
from testbed.controllers.inversion import law

U = 2.0**-53
PROPERTY = settings(deadline=None, derandomize=True, max_examples=40, database=None)
seeds = st.integers(0, 2**32 - 1)
TUNING = Tuning(gamma=2.0, epsilon=0.05)


def random_plant(rng: np.random.Generator, **more: object) -> IdealPlant:
    """B with singular values in [0.5, 3], and a random stable f."""
    u, _, vt = np.linalg.svd(rng.normal(size=(4, 4)))
    a = rng.normal(size=(4, 5))
    a[:3, 2:] -= 3.0 * np.eye(3)
    return IdealPlant(u @ np.diag(rng.uniform(0.5, 3.0, 4)) @ vt, A=a, bias=rng.normal(size=4), **more)  # type: ignore[arg-type]


def random_reference(rng: np.random.Generator, shape: tuple[int, ...]) -> np.ndarray:
    return np.asarray(rng.choice([-1.0, 1.0], shape) * rng.uniform(0.1, 2.0, shape))


class Measured:
    """One moment of (30): a plant that is disturbed, and sensors that err, with everything drawn at random."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.plant = random_plant(rng)
        loop = IdealLoop(self.plant, TUNING)
        self.m, self.c, self.s = loop._models[0], loop._settings[0], loop._memories[0]
        self.y = loop._y[0]
        self.truth, self.estimate = rng.uniform(0.1, 1.2, 4), rng.uniform(0.1, 1.2, 4)
        self.r = random_reference(rng, (4,))
        self.s.lambda_hat[:], self.s.position[:] = self.estimate, self.r / self.estimate
        x, d_x, n_x = rng.normal(size=5), 0.1 * rng.normal(size=5), 0.1 * rng.normal(size=5)
        d_rate, n_rate = rng.normal(size=4), rng.normal(size=4)
        self.f_disturbed, self.f_measured = self.f(x + d_x), self.f(x + d_x + n_x)
        effect = self.plant.B @ (self.truth / self.estimate * self.r)
        self.rates = self.f_disturbed + effect + d_rate  # (30), first line
        self.rates_measured = self.rates + n_rate  # (30), last line
        self.n = d_rate + self.f_disturbed - self.f_measured  # of (33)
        self.n_measured = self.n + n_rate  # of (31)

    def f(self, x: np.ndarray) -> np.ndarray:
        """f_mc of the plant, by the flying function, where the airspeed is the reference's."""
        self.y.alpha, self.y.beta, self.y.p, self.y.q, self.y.r = x
        self.y.pitch, found = 0.0, np.zeros(4)
        law.state_function(self.y, self.m, found)
        return found

    def error(self, rates: np.ndarray) -> np.ndarray:
        """(9), (10): the law's error for these rates, at the measured state."""
        e, phi = np.zeros(4), np.zeros((4, 4))
        law.regressor(1.0, self.m, self.s, phi)
        law.measured_error(rates - self.f_measured, phi, self.s, e)
        return e

    @property
    def of_estimates(self) -> np.ndarray:
        """B_mc (Lambda Lambda_hat^-1 - I) r."""
        return self.plant.B @ ((self.truth / self.estimate - 1.0) * self.r)

    @property
    def tolerance(self) -> float:
        size = np.abs(self.rates_measured).max() + np.abs(self.f_measured).max() + 10.0
        return 256 * U * float(size)


@PROPERTY
@given(seeds)
def test_eq_30_31_measured_error_contains_all_noise(seed: int) -> None:
    """(30), (31): e-tilde = B (Lambda Lambda_hat^-1 - I) r + n-tilde, n-tilde with noise of rates and state, and disturbances."""
    at = Measured(seed)
    assert np.abs(at.error(at.rates_measured) - at.of_estimates - at.n_measured).max() <= at.tolerance


@PROPERTY
@given(seeds)
def test_eq_33_real_error_lacks_the_noise_of_the_rates(seed: int) -> None:
    """(33): e = B (Lambda Lambda_hat^-1 - I) r + n, and e-tilde - e is the noise of the measured rates alone."""
    at = Measured(seed)
    assert np.abs(at.error(at.rates) - at.of_estimates - at.n).max() <= at.tolerance
    noise_of_rates = at.rates_measured - at.rates
    assert np.abs(at.error(at.rates_measured) - at.error(at.rates) - noise_of_rates).max() <= 2 * at.tolerance


@PROPERTY
@given(seeds)
def test_eq_32_one_step_on_a_measured_error(seed: int) -> None:
    """(32): lambda_hat' = gamma (Lambda K - lambda_hat (K - diag(B^-1 n-tilde) G)), from the error that the law measures."""
    at = Measured(seed)
    law.adapt(at.error(at.rates_measured), 1.0, at.m, at.c, at.s)
    n = np.linalg.solve(at.plant.B, at.n_measured)
    wanted = TUNING.gamma * (at.truth - at.estimate * (1.0 - n / at.r))  # kappa = 1, g = 1/r
    step = np.log(at.s.lambda_hat / at.estimate) * at.estimate / TUNING.dt_s
    assert step == pytest.approx(wanted, rel=1e-9, abs=1e-9)


@PROPERTY
@given(seeds)
def test_eq_34_error_dynamics_under_disturbance(seed: int) -> None:
    """(34), with Lambda_hat' of (32) in its third term: r, Lambda and n all change, and each term is there.

    One step of 1e-7 s: the second derivative is some tens, so the difference is good to 1e-5; rounding is U / 1e-7.
    """
    rng = np.random.default_rng(seed)
    dt = 1e-7
    tuning, plant = Tuning(gamma=2.0, epsilon=0.05, dt_s=dt), random_plant(rng)
    r, r_dot = random_reference(rng, (4,)), rng.normal(size=4)
    truth, truth_dot = rng.uniform(0.3, 1.2, 4), rng.normal(size=4)
    n, n_dot = rng.normal(size=4), rng.normal(size=4)
    estimate = rng.uniform(0.3, 1.2, 4)
    time = np.array([[0.0], [dt]])
    history = IdealLoop(plant, tuning, estimate).fly(
        r + r_dot * time, truth + truth_dot * time, n + n_dot * time
    )
    b_n = np.linalg.solve(plant.B, n)
    estimate_dot = tuning.gamma * (truth - estimate * (1.0 - b_n / r))  # (32)
    terms = [
        plant.B @ ((truth / estimate - 1.0) * r_dot),
        plant.B @ (truth_dot / estimate * r),
        -plant.B @ (truth / estimate * estimate_dot / estimate * r),
        n_dot,
    ]
    measured = (history.e[1] - history.e[0]) / dt
    assert measured == pytest.approx(sum(terms), abs=2e-4)
    assert all(np.abs(term).max() > 2e-3 for term in terms)  # without any one of them the test would fail


@PROPERTY
@given(seeds)
def test_eq_35_36_37_38_error_of_the_state_function(seed: int) -> None:
    """(35) to (38): f_c is not f_mc. (36) holds at the first step; (37) is the estimate's first change; (38) is the error's, and
    its last term is the Jacobian of f_c - f_mc times the rates."""
    rng = np.random.default_rng(seed)
    dt = 1e-7
    tuning = Tuning(gamma=2.0, epsilon=0.05, dt_s=dt)
    plant = random_plant(rng, bias_error=rng.normal(size=4), A_error=rng.normal(size=(4, 5)))
    r, r_dot = random_reference(rng, (4,)), rng.normal(size=4)
    truth, truth_dot = rng.uniform(0.3, 1.2, 4), rng.normal(size=4)
    estimate = rng.uniform(0.3, 1.2, 4)
    loop = IdealLoop(plant, tuning, estimate)
    state = rng.normal(size=3)
    loop._y["p"], loop._y["q"], loop._y["r"] = state
    time = np.array([[0.0], [dt]])
    history = loop.fly(r + r_dot * time, truth + truth_dot * time)

    x = np.concatenate([[0.0, 0.0], state])
    delta_f = plant.bias_error + plant.A_error @ x
    assert history.e[0] == pytest.approx(plant.B @ ((truth / estimate - 1.0) * r) + delta_f, abs=1e-12)

    estimate_dot = tuning.gamma * (truth - estimate * (1.0 - np.linalg.solve(plant.B, delta_f) / r))
    change = (history.lambda_hat[1] - history.lambda_hat[0]) / dt
    assert change == pytest.approx(estimate_dot, rel=1e-4, abs=1e-4)

    rates = plant.bias + plant.bias_error + (plant.A + plant.A_error) @ x + plant.B @ (truth / estimate * r)
    d = truth / estimate
    terms = [
        plant.B @ ((d - 1.0) * r_dot),
        plant.B @ (truth_dot / estimate * r),
        -tuning.gamma * plant.B @ (d * np.linalg.solve(plant.B, history.e[0])),
        plant.A_error[:, 2:] @ rates[:3],
    ]
    measured = (history.e[1] - history.e[0]) / dt
    assert measured == pytest.approx(sum(terms), rel=1e-4, abs=5e-4)
    assert all(np.abs(term).max() > 5e-3 for term in terms)


# --- The four remarks after (32) ----------------------------------------------------------------------------


@pytest.mark.parametrize("gamma", [1.0, 4.0])
@pytest.mark.parametrize("r", [0.1, 1.0])
def test_remarks_1_and_2_direction_and_gain_of_a_perturbation(gamma: float, r: float) -> None:
    """A disturbance moves the estimate up if n g > 0, down if n g < 0, by gamma g n dt in log lambda_hat from the truth."""
    tuning = Tuning(gamma=gamma, epsilon=0.05)
    n = np.array([0.01, -0.01, 0.02, 0.0])
    history = IdealLoop(IdealPlant(np.eye(4)), tuning).fly(np.full((1, 4), r), 1.0, n)
    step = np.log(history.lambda_hat[1])
    assert step == pytest.approx(gamma / r * n * tuning.dt_s, rel=1e-12, abs=1e-15)


def test_remark_3_corrected_divergence_does_not_depend_on_the_estimate() -> None:
    """n g > kappa, that is n/r > 1, diverges, and n/r < 1 does not, from an estimate of 0.02 and of 50 alike.

    By the paper's condition, n g > lambda_hat kappa, n/r = 0.5 would diverge from 0.02, and n/r = 2 would not from 50.
    """
    r, gamma, dt = 0.5, 2.0, 0.005
    ratios = np.array([0.5, 0.9, 1.5, 2.0])
    for start in (0.02, 50.0):
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-60, dt), start)
        estimate = loop.fly(np.full((6000, 4), r), 1.0, ratios * r).lambda_hat
        for i, ratio in enumerate(ratios):
            end = noise.biased_by_reference(1.0, ratio * r, r)
            growth = math.log(estimate[-1, i] / estimate[-201, i]) / (200 * dt)
            if math.isinf(end):
                rate = noise.divergence_rate(gamma, ratio * r, r)
                assert growth == pytest.approx(rate, abs=gamma / estimate[-201, i] + 1e-9)
            else:
                slowest = math.exp(-gamma * (1.0 - ratio) * 30.0)
                assert estimate[-1, i] == pytest.approx(end, rel=max(60.0 * slowest, 1e-9))


def test_remark_4_an_excursion_to_zero_is_taken_for_a_failure() -> None:
    """A disturbance with n/r < 1 - lambda/threshold flags a healthy actuator; one just above that never does."""
    tuning = Tuning(gamma=2.0, epsilon=0.05, threshold=0.2)
    limit = 1.0 - 1.0 / tuning.threshold
    n = 0.5 * np.array([1.02 * limit, 0.98 * limit, 0.0, 0.0])
    failed = IdealLoop(IdealPlant(np.eye(4)), tuning).fly(np.full((4000, 4), 0.5), 1.0, n).failed
    assert failed[-1].tolist() == [1.0, 0.0, 0.0, 0.0] and not failed[:, 1:].any()


# --- What follows from (32) for noise -----------------------------------------------------------------------


def held(position: float, loop: IdealLoop) -> None:
    """Both stops at this position: the actuators stand there whatever is asked of them."""
    for name in ("low", "high"):
        loop._models[name] = position


@pytest.mark.parametrize(
    ("hold", "epsilon"),
    [("reference", 0.05), ("position", 0.05), pytest.param("position", 1.0, marks=pytest.mark.nightly)],
)
def test_eq_32_white_noise_stationary_laws(hold: str, epsilon: float) -> None:
    """Mean, deviation and low tail of x under white noise: `ReferenceHeld` and `PositionHeld`, in both parts of (14).

    Four actuators of 400 time constants in 100 batches: four standard errors, and the relative effect c = gamma kappa dt of a
    finite step. At a held reference within epsilon, kappa is that of the position r/x, which the law of the reference does not
    have; so that case is the position's alone.
    """
    rng = np.random.default_rng(5)
    r, nu, gamma = 0.5, 20.0, 2.0
    kappa = 1.0 if abs(r) > epsilon else (r / epsilon) ** 2
    dt = 0.01 / (gamma * kappa)
    s = 2.0 * max(r, epsilon) ** 2 / (gamma * nu)
    assert noise.shape(r, gamma, s, epsilon) == pytest.approx(nu)
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, epsilon, dt, lambda_min=0.05, lambda_max=20.0))
    if hold == "position":
        held(r, loop)
    expected = noise.ReferenceHeld(nu) if hold == "reference" else noise.PositionHeld(nu)
    batches = []
    for _ in range(100):
        disturbance = math.sqrt(s / dt) * rng.normal(size=(40000, 4))
        x = loop.fly(np.full((40000, 4), r), 1.0, disturbance).lambda_hat[1:]
        batches.append(
            np.stack(
                [x.mean(axis=0), ((x - expected.mean) ** 2).mean(axis=0), (x < 0.6).mean(axis=0)], axis=1
            )
        )
    found = np.concatenate(batches)
    error = 4.0 * found.std(axis=0, ddof=1) / math.sqrt(len(found))
    wanted = np.array([expected.mean, expected.variance, expected.below(0.6)])
    assert np.all(np.abs(found.mean(axis=0) - wanted) <= error + 0.02 * np.array([0.0, wanted[1], wanted[2]]))
    assert error[2] < 0.1 * wanted[2]  # and the tail is known well enough to tell the two laws apart


def test_the_two_stationary_laws_differ_where_it_matters() -> None:
    """Same variance to first order; the position's low tail is the heavier one, by ten times at nu = 12 and half the truth."""
    one, other = noise.ReferenceHeld(400.0), noise.PositionHeld(400.0)
    assert one.variance == pytest.approx(1.0 / 400.0, rel=0.02)
    assert other.variance == pytest.approx(1.0 / 400.0, rel=0.02)
    assert noise.PositionHeld(12.0).below(0.5) > 5.0 * noise.ReferenceHeld(12.0).below(0.5)
    assert noise.PositionHeld(12.0).below(50.0) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("gamma", [1.0, 8.0])
@pytest.mark.parametrize("epsilon", [0.05, 1.0])
def test_time_times_variance_is_invariant(gamma: float, epsilon: float) -> None:
    """Convergence time times variance is 1.5 s/r^2 whatever gamma and epsilon: here from the law's own steps.

    The position is held. The variance is that of a linear recursion, whose factor and gain are read off the law's step.
    """
    r, s, dt = 0.5, 0.01, 1e-4
    tuning = Tuning(gamma, epsilon, dt)

    def after_one_step(start: float, n: float) -> float:
        loop = IdealLoop(IdealPlant(np.eye(4)), tuning, start)
        held(r, loop)
        return float(loop.fly(np.full((1, 4), r), 1.0, np.full(4, n)).lambda_hat[1, 0])

    small = 1e-6
    factor = (after_one_step(1.0 + small, 0.0) - 1.0) / small
    gain = (after_one_step(1.0, small) - 1.0) / small
    variance = gain**2 * (s / dt) / (1.0 - factor**2)
    time = math.log(noise.SETTLED) / math.log(factor) * dt
    assert time * variance == pytest.approx(noise.time_times_variance(r, s), rel=2e-3)
    assert variance == pytest.approx(noise.deviation(noise.shape(r, gamma, s, epsilon)) ** 2, rel=2e-3)
    kappa = min(1.0, (r / epsilon) ** 2)
    assert time == pytest.approx(noise.convergence_time(gamma, kappa), rel=2e-3)


def test_eq_32_euler_variance_is_exact() -> None:
    """Euler's recursion of (32): its second moment from the recursion of moments, for steps up to gamma dt = 0.5."""
    for gamma, dt, g, kappa, s in ((2.0, 0.005, 2.0, 1.0, 0.01), (5.0, 0.1, 10.0, 0.4, 1e-3)):
        mean, second = 1.0, 1.0
        for _ in range(20000):
            grow = 1.0 - gamma * dt * kappa
            second = (
                (grow**2 + (gamma * g) ** 2 * s * dt) * second
                + 2 * grow * gamma * dt * kappa * mean
                + (gamma * dt * kappa) ** 2
            )
        assert noise.euler_variance(gamma, dt, g, kappa, s) == pytest.approx(second - 1.0, rel=1e-9)
    assert noise.euler_variance(2.0, 0.005, 10.0, 1.0, 0.1) == math.inf


@pytest.mark.parametrize(("gamma", "corner"), [(2.0, 30.0), (8.0, 30.0), (8.0, 5.0)])
def test_coloured_noise_deviations(gamma: float, corner: float) -> None:
    """`gyro_deviation` and `gust_deviation` against the recursion of the linearised law, summed in the frequency domain.

    (1/2 pi) int S(w) gamma^2 / (r^2 (w^2 + gamma^2)) dw by quadrature, for the two spectra.
    """
    r, density, sigma = 0.3, 0.01, 0.02
    w = np.tan(np.linspace(-math.pi / 2, math.pi / 2, 400001)[1:-1])  # dw = (1 + w^2) d(angle)
    weight = (1.0 + w**2) * math.pi / 400000 / (2.0 * math.pi)
    of_estimate = (gamma / r) ** 2 / (w**2 + gamma**2)
    gyro = density**2 * w**2 * corner**2 / (w**2 + corner**2)
    gust = sigma**2 * 2.0 * corner / (w**2 + corner**2)
    assert noise.gyro_deviation(gamma, r, density, corner) ** 2 == pytest.approx(
        (of_estimate * gyro * weight).sum(), rel=1e-3
    )
    assert noise.gust_deviation(gamma, r, sigma, corner) ** 2 == pytest.approx(
        (of_estimate * gust * weight).sum(), rel=1e-3
    )


def test_noise_of_the_measured_state_lowers_the_mean() -> None:
    """(31): n_x is in r and in n alike; slow adaptation then settles at lambda / (1 + sigma^2 / r^2).

    Second order in sigma/r: the next term is 3 (sigma/r)^4; four standard errors of the batches are smaller.
    """
    rng = np.random.default_rng(11)
    r, gamma, dt = 1.0, 0.05, 0.005
    for sigma in (0.1, 0.2):
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-3, dt), 0.97)
        rho = sigma * rng.normal(size=(200000, 4))
        loop.fly(r - rho, 1.0, -rho)
        estimates = []
        for _ in range(10):
            rho = sigma * rng.normal(size=(40000, 4))
            estimates.append(1.0 / loop.fly(r - rho, 1.0, -rho).lambda_hat.mean(axis=0))
        found = np.array(estimates)
        standard = found.std(ddof=1) / math.sqrt(found.size / 5.0)
        wanted = 1.0 / noise.state_noise_mean(sigma, r)
        assert abs(found.mean() - wanted) <= 4.0 * standard + 4.0 * sigma**4


def test_intensity_through_the_inverse() -> None:
    """s_i of correlated and of independent noise, and a datasheet's density."""
    rng = np.random.default_rng(2)
    inverse, root = rng.normal(size=(4, 4)), rng.normal(size=(4, 4))
    s = noise.actuator_intensity(inverse, root @ root.T)
    assert s == pytest.approx(np.square(inverse @ root).sum(axis=1))
    assert noise.actuator_intensity(inverse, np.ones(4)) == pytest.approx(np.square(inverse).sum(axis=1))
    assert noise.one_sided_intensity(0.2) == pytest.approx(0.02)


@pytest.mark.parametrize(("n", "a"), [(0.04, 0.2), (-0.08, 0.2), (0.04, -0.2)])
def test_a_held_position_and_its_reference_have_one_fixed_point(n: float, a: float) -> None:
    """lambda + n/a is lambda/(1 - n/r) at r = lambda_hat a."""
    truth = 0.8
    estimate = noise.biased_by_position(truth, n, a)
    assert noise.biased_by_reference(truth, n, estimate * a) == pytest.approx(estimate, rel=1e-12)
