"""The mathematics of the paper on its ideal plant, with the functions that fly (`paper.ideal`).

Tolerances are derived, not tuned. Two kinds occur:

* rounding: `U` is the unit roundoff, and a sum of products of n terms is wrong by at most about n U times
  the sum of the absolute values (Higham, Accuracy and Stability, sec. 3.1). `rounding_of_x` writes that down.
* statistics: bounds of four standard errors on a seeded run, the standard error estimated from batch means.

What the flying law integrates is log(lambda_hat), one explicit step at a time:

    log lambda_hat+ - log lambda_hat = gamma dt kappa (lambda / lambda_hat - 1)               (*)

which is (19) divided by lambda_hat. kappa is (17) at the modelled position a, not at r = lambda_hat a: equal
to the paper's where both are beyond epsilon, see `test_eq_23_literal_form_differs_within_epsilon`.
"""

from __future__ import annotations

import math
from itertools import combinations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from paper.ideal import History, IdealLoop, IdealPlant, Tuning, first_order
from scipy.linalg import solve_discrete_lyapunov
from scipy.signal import lfilter

from paper import ideal
from testbed.aircraft.control_design import ControlDesign
from testbed.aircraft.design_model import DesignModel
from testbed.common.signals import RATES
from testbed.controllers.inversion import law
from testbed.controllers.inversion.modes import Mode, enumerate_modes

U = 2.0**-53
PROPERTY = settings(deadline=None, derandomize=True, max_examples=60, database=None)
FEW = settings(PROPERTY, max_examples=25)
seeds = st.integers(0, 2**32 - 1)
sizes = st.sampled_from([2, 4])
"""Actuators. The law has four rates; with fewer actuators B_mc^-1 is its left inverse and everything holds as
well."""


def random_plant(rng: np.random.Generator, n: int = 4, **more: object) -> IdealPlant:
    """B with singular values in [0.5, 3], so that cond B <= 6, a random stable f, airspeed off the
    reference."""
    u, _, vt = np.linalg.svd(rng.normal(size=(4, n)), full_matrices=False)
    b = u @ np.diag(rng.uniform(0.5, 3.0, n)) @ vt
    a = rng.normal(size=(4, 5))
    a[:3, 2:] = -3.0 * np.eye(3) + 0.3 * rng.normal(size=(3, 3))
    values = {"A": a, "bias": rng.normal(size=4), "airspeed": float(rng.uniform(0.7, 1.5))} | more
    return IdealPlant(b, **values)  # type: ignore[arg-type]


def random_effectiveness(rng: np.random.Generator, n: int = 4) -> np.ndarray:
    return np.asarray(10.0 ** rng.uniform(-1.0, 0.2, n))


def random_reference(rng: np.random.Generator, shape: tuple[int, ...]) -> np.ndarray:
    """Both signs, a factor of 1000 in size, and now and then exactly zero."""
    r = rng.choice([-1.0, 1.0], shape) * 10.0 ** rng.uniform(-2.5, 0.5, shape)
    return np.where(rng.random(shape) < 0.05, 0.0, r)


def g(alpha: np.ndarray, epsilon: float) -> np.ndarray:
    """(14), written from the paper and not from the law."""
    alpha = np.asarray(alpha, dtype=float)
    with np.errstate(divide="ignore"):
        return np.where(np.abs(alpha) > epsilon, 1.0 / alpha, alpha / epsilon**2)


def kappa(alpha: np.ndarray, epsilon: float) -> np.ndarray:
    """(17), written from the paper."""
    alpha = np.asarray(alpha, dtype=float)
    return np.where(np.abs(alpha) > epsilon, 1.0, alpha**2 / epsilon**2)


def rounding_of_x(plant: IdealPlant, effectiveness: np.ndarray, history: History) -> np.ndarray:
    """[steps, n] bound on the rounding of x = B_mc^-1 e.

    Every term of z - Phi lambda_hat is at most |f| + |B| (lambda + lambda_hat) |a|; f cancels and leaves its
    rounding. |f| is bounded by what the random plants can reach. 32 covers the operations in sequence (2 n
    for each product, f). Last term: B_mc^-1 itself is only as good as B_mc^-1 B_mc is the identity.
    """
    inverse, size = np.abs(np.linalg.pinv(plant.B)), np.abs(plant.B)
    estimate = history.lambda_hat[:-1]
    terms = ((effectiveness + estimate) * np.abs(history.a)) @ size.T
    f = 4.0 * (np.abs(plant.A).sum() + np.abs(plant.bias).sum() + 10.0)
    identity = np.abs(np.linalg.pinv(plant.B) @ plant.B - np.eye(plant.B.shape[1])) + 8 * U * inverse @ size
    return (
        32 * U * (terms + f) @ inverse.T / plant.airspeed**2
        + np.abs(estimate - effectiveness) * np.abs(history.a) @ identity.T
    )


def check_steps(
    plant: IdealPlant,
    tuning: Tuning,
    effectiveness: np.ndarray,
    history: History,
    n: np.ndarray | float = 0.0,
) -> None:
    """(*) at every step, with the disturbance B_mc^-1 n of (32): exact but for rounding."""
    estimate, after = history.lambda_hat[:-1], history.lambda_hat[1:]
    gain = tuning.gamma * tuning.dt_s * np.abs(g(history.a, tuning.epsilon)) / estimate
    wanted = tuning.gamma * tuning.dt_s * kappa(history.a, tuning.epsilon) * (effectiveness / estimate - 1.0)
    wanted = wanted + tuning.gamma * tuning.dt_s * g(history.a, tuning.epsilon) * n / estimate
    tolerance = gain * (rounding_of_x(plant, effectiveness, history) + 64 * U * np.abs(n)) + 16 * U * (
        1.0 + np.abs(wanted)
    )
    error = np.abs(np.log(after / estimate) - wanted)
    assert np.all(error <= tolerance), f"{np.max(error / tolerance):.3g} times the rounding allowed"


# --- (5), (6), (9) to (12): inversion and error -------------------------------------------------------------


@PROPERTY
@given(seeds, sizes)
def test_eq_6_inverts_eq_5(seed: int, n: int) -> None:
    """(5) with r gives rates from which (6) finds r again, at any airspeed; and with a perfect model x_c_dot
    follows."""
    rng = np.random.default_rng(seed)
    plant = random_plant(rng, n)
    r = random_reference(rng, (20, n))
    history = IdealLoop(plant, Tuning()).fly(r, 1.0)
    # wanted = (f_m + B r) - f_m carries the rounding of f_m and is multiplied with B^-1.
    tolerance = rounding_of_x(plant, np.ones(n), history)
    assert np.all(np.abs(history.r - r) <= tolerance)
    assert np.all(np.abs(history.e) <= tolerance @ np.abs(plant.B).T * plant.airspeed**2)


@PROPERTY
@given(seeds, sizes)
def test_eq_12_error_is_b_times_lambda_over_estimate_minus_one_times_r(seed: int, n: int) -> None:
    """(12): e = B_mc (Lambda Lambda_hat^-1 - I) r, while the estimate moves."""
    rng = np.random.default_rng(seed)
    plant, effectiveness = random_plant(rng, n), random_effectiveness(rng, n)
    r = random_reference(rng, (50, n))
    history = IdealLoop(plant, Tuning(), random_effectiveness(rng, n)).fly(r, effectiveness)
    x = (effectiveness / history.lambda_hat[:-1] - 1.0) * history.r
    tolerance = rounding_of_x(plant, effectiveness, history)
    pressure = plant.airspeed**2
    assert np.all(np.abs(history.e - pressure * x @ plant.B.T) <= pressure * tolerance @ np.abs(plant.B).T)


# --- (13) to (17) -------------------------------------------------------------------------------------------

positive = st.floats(1e-6, 1e3)
numbers = st.floats(-1e6, 1e6, allow_subnormal=False)


@PROPERTY
@given(numbers, positive)
def test_eq_14_modified_inverse_is_exact(alpha: float, epsilon: float) -> None:
    """(14): 1/alpha beyond epsilon, alpha/epsilon^2 within it, to the last bit; odd; never above
    1/epsilon."""
    value = law.modified_inverse(alpha, epsilon)
    assert value == (1.0 / alpha if abs(alpha) > epsilon else alpha / (epsilon * epsilon))
    assert law.modified_inverse(-alpha, epsilon) == -value
    assert abs(value) <= (1.0 / epsilon) * (1.0 + 4 * U)


@PROPERTY
@given(positive)
def test_eq_14_is_continuous_at_epsilon(epsilon: float) -> None:
    """(14): both branches are 1/epsilon at epsilon; neighbours differ by rounding (two divisions and a
    product)."""
    within, beyond = (
        law.modified_inverse(epsilon, epsilon),
        law.modified_inverse(np.nextafter(epsilon, 1e9), epsilon),
    )
    assert abs(within - 1.0 / epsilon) <= 4 * U / epsilon
    assert abs(beyond - 1.0 / epsilon) <= 4 * U / epsilon


@PROPERTY
@given(numbers, positive)
def test_eq_17_kappa(alpha: float, epsilon: float) -> None:
    """(17): alpha g(alpha) is 1 beyond epsilon and alpha^2/epsilon^2 within, each rounded at most three
    times.

    The paper calls K positive: it is semidefinite, zero at r = 0.
    """
    value = alpha * law.modified_inverse(alpha, epsilon)
    wanted = 1.0 if abs(alpha) > epsilon else (alpha / epsilon) ** 2
    assert abs(value - wanted) <= 6 * U * wanted
    assert (value == 0.0) == (alpha == 0.0) or wanted < 1e-300


@PROPERTY
@given(seeds, sizes)
def test_eq_13_one_step_is_the_papers_rate(seed: int, n: int) -> None:
    """(13): `adapt` on any e, Lambda_hat and a moves log lambda_hat by gamma dt (B_mc^-1 e) g(r) where |r|,
    |a| > epsilon.

    Here e is not (12) but anything: the law may not know where it came from.
    """
    rng = np.random.default_rng(seed)
    loop = IdealLoop(random_plant(rng, n, airspeed=1.0), tuning := Tuning(gamma=3.0, epsilon=0.05))
    m, c, s = loop._models[0], loop._settings[0], loop._memories[0]
    estimate = random_effectiveness(rng, n)
    r = rng.choice([-1.0, 1.0], n) * rng.uniform(0.1, 2.0, n)
    s.lambda_hat[:], s.position[:] = estimate, r / estimate
    e = rng.normal(size=4)
    law.adapt(e, 1.0, m, c, s)
    rate = tuning.gamma * np.diag(np.linalg.pinv(m.B) @ e) @ np.diag(estimate) @ np.diag(g(r, tuning.epsilon))
    step = tuning.dt_s * np.diag(rate) / estimate
    size = tuning.gamma * tuning.dt_s * (np.abs(np.linalg.pinv(m.B)) @ np.abs(e)) / np.abs(r)
    assert np.all(np.abs(np.log(s.lambda_hat / estimate) - step) <= 32 * U * size + 8 * U)


# --- (18) to (23): the three cases --------------------------------------------------------------------------


@PROPERTY
@given(seeds, sizes)
def test_eq_18_19_every_step_whatever_r_does(seed: int, n: int) -> None:
    """(18), (19) in the discrete form (*): random B, f, Lambda, airspeed; r jumping in sign and size every
    step.

    Also: the projection is not active, and kappa = 0 moves nothing at all.
    """
    rng = np.random.default_rng(seed)
    plant, effectiveness = random_plant(rng, n), random_effectiveness(rng, n)
    tuning = Tuning(gamma=float(rng.uniform(0.5, 10.0)), epsilon=float(10 ** rng.uniform(-2, -0.5)))
    history = IdealLoop(plant, tuning, random_effectiveness(rng, n)).fly(
        random_reference(rng, (100, n)), effectiveness
    )
    check_steps(plant, tuning, effectiveness, history)


@FEW
@given(seeds)
def test_eq_18_with_changing_effectiveness(seed: int) -> None:
    """(18) with Lambda(t): failures in steps and in ramps, every step (*)."""
    rng = np.random.default_rng(seed)
    plant, tuning = random_plant(rng), Tuning()
    jumps = np.repeat([random_effectiveness(rng) for _ in range(3)], 10, axis=0)
    ramp = np.tile(np.linspace(1.0, 0.0, 30)[:, None], (1, 4))
    effectiveness = np.vstack([jumps, ramp])
    history = IdealLoop(plant, tuning).fly(random_reference(rng, (60, 4)), effectiveness)
    check_steps(plant, tuning, effectiveness, history)


@FEW
@given(seeds)
def test_eq_20_case_1_nothing_moves_at_zero(seed: int) -> None:
    """(20): r_i = 0 leaves estimate i where it is, to the last bit, whatever the other actuators and a noise
    do."""
    rng = np.random.default_rng(seed)
    r = random_reference(rng, (50, 4))
    r[:, 1] = 0.0
    plant = random_plant(rng)
    loop = IdealLoop(plant, Tuning(), random_effectiveness(rng))
    # (6) gives r back only to rounding; a zero needs the command itself to be zero.
    loop._modes["B_hat_inv"][0, 1] = 0.0
    history = loop.fly(r, random_effectiveness(rng), rng.normal(size=(50, 4)))
    assert np.all(history.lambda_hat[:, 1] == history.lambda_hat[0, 1])


# Leading error of explicit Euler for an autonomous xi' = h(xi): -dt/2 h(t) log(h(t)/h(0)) [Taylor: E' = h' E
# - h' h / 2,
# whose homogeneous solution is h]. Case 2 and 3: xi = log lambda_hat, h = lambda_hat' / lambda_hat.
CASES = {
    "21 case 2, loss": (1.0, 0.2, 0.5, 0.05),
    "21 case 2, recovery": (0.3, 0.9, -0.5, 0.05),
    "21 case 2, negative": (1.0, 0.05, -0.3, 0.05),
}


@pytest.mark.parametrize("case", CASES)
def test_eq_21_22_case_2_first_order_lag(case: str) -> None:
    """(21), (22): beyond epsilon the estimate is a first-order lag with time constant 1/gamma.

    The law's step is explicit in log lambda_hat, so its error against (22) is of first order in dt with a
    known coefficient. Checked: error = dt times that coefficient, up to a remainder that is of second order
    (ratio 4 as dt halves; the ratio itself is wrong by O(gamma dt), hence 5 % at gamma dt <= 0.005).
    """
    start, truth, r, epsilon = CASES[case]
    gamma, remainders = 2.0, []
    for dt in (0.0025, 0.00125):
        time = np.arange(round(2.0 / dt) + 1) * dt
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, epsilon, dt), start)
        simulated = loop.fly(np.full((len(time) - 1, 4), r), truth).lambda_hat[:, 0]
        exact = first_order(start, truth, gamma, time)
        h = gamma * (truth / exact - 1.0)
        leading = -0.5 * dt * h * np.log(h / h[0])
        error = np.log(simulated / exact)
        remainders.append((error - leading)[:: round(0.1 / dt)][1:])
    ratio = np.linalg.norm(remainders[0]) / np.linalg.norm(remainders[1])
    assert ratio == pytest.approx(4.0, rel=0.05)


def test_eq_22_settles_on_the_truth_at_the_rate_gamma() -> None:
    """(21) near the truth: the distance shrinks by (1 - gamma dt) each step, the Euler factor of exp(-gamma
    dt)."""
    tuning = Tuning(gamma=4.0)
    history = IdealLoop(IdealPlant(np.eye(4)), tuning, 0.6 * (1.0 + 1e-6)).fly(np.ones((10, 4)), 0.6)
    distance = history.lambda_hat[:, 0] - 0.6
    # Second-order term of the map: relative 1e-6; rounding of the distance itself: U / 1e-6.
    assert distance[1:] / distance[:-1] == pytest.approx(1.0 - tuning.gamma * tuning.dt_s, rel=3e-6)


@pytest.mark.parametrize("fraction", [1.0, 0.6, 0.2, 0.05])
def test_eq_23_case_3_lag_slowed_by_kappa(fraction: float) -> None:
    """(23) in the law's variable: at a constant *position* |a| <= epsilon, lambda_hat lags with gamma
    a^2/epsilon^2.

    The actuator stands at a stop, whatever r asks of it. Same convergence statement as in case 2.
    """
    start, truth, epsilon, gamma = 1.0, 0.2, 0.1, 2.0
    a = fraction * epsilon
    rate = gamma * fraction**2
    remainders = []
    for dt in (0.0025 / fraction**2, 0.00125 / fraction**2):
        time = np.arange(round(2.0 / rate / dt) + 1) * dt
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, epsilon, dt), start)
        for name in ("low", "high"):
            loop._models[name] = a  # both stops: the actuator stands there whatever is asked of it
        simulated = loop.fly(np.full((len(time) - 1, 4), a), truth).lambda_hat[:, 0]
        exact = first_order(start, truth, rate, time)
        h = rate * (truth / exact - 1.0)
        error = np.log(simulated / exact) + 0.5 * dt * h * np.log(h / h[0])
        remainders.append(error[:: round(0.1 / rate / dt)][1:])
    assert np.linalg.norm(remainders[0]) / np.linalg.norm(remainders[1]) == pytest.approx(4.0, rel=0.05)


@pytest.mark.parametrize("start", [1.0, 0.6])
def test_eq_23_case_3_constant_r(start: float) -> None:
    """(23) at a constant *reference* r, as the law flies it: kappa at a = r/lambda_hat, not at r.

    While |r/lambda_hat| <= epsilon: lambda_hat' = gamma (lambda - lambda_hat) r^2 / (epsilon lambda_hat)^2,
    with the closed form gamma r^2/epsilon^2 t = F(lambda_hat) - F(start), F(x) = -x^2/2 - lambda x - lambda^2
    log|lambda - x|. The paper's literal (23) has r^2/epsilon^2 and so adapts 1/lambda_hat^2 slower after a
    loss. Where |r| <= epsilon < |r/lambda_hat| the law is at full speed, kappa = 1. Same convergence
    statement as in case 2.
    """
    truth, epsilon, gamma, r = 0.8, 0.1, 2.0, 0.03  # |a| <= 0.05 throughout
    slow = gamma * (r / epsilon) ** 2

    def primitive(x: np.ndarray) -> np.ndarray:
        return -(x**2) / 2 - truth * x - truth**2 * np.log(np.abs(truth - x))

    remainders = []
    for dt in (0.02, 0.01):
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, epsilon, dt), start)
        steps = round(8.0 / dt)
        simulated = loop.fly(np.full((steps, 4), r), truth).lambda_hat[:, 0]
        # The closed form gives the time of an estimate: (time error) times the slope is the error of the
        # estimate.
        late = (primitive(simulated) - primitive(np.array(start))) / slow - np.arange(steps + 1) * dt
        h = slow * (truth - simulated) / simulated**3  # xi' with xi = log lambda_hat
        leading = -0.5 * dt * np.log(h / h[0])  # error of xi over xi'
        remainders.append((late - leading)[:: round(0.4 / dt)][1:])
    assert np.linalg.norm(remainders[0]) / np.linalg.norm(remainders[1]) == pytest.approx(4.0, rel=0.05)


def literal_adapt(e, pressure, m, c, s):  # type: ignore[no-untyped-def]
    """(13) to the letter: g(r, epsilon) at r = lambda_hat a; log lambda_hat integrated as in the law."""
    x = m.B_inv @ e / pressure
    for i in range(len(s.lambda_hat)):
        rate = c.gamma[i] * x[i] * law.modified_inverse(s.lambda_hat[i] * s.position[i], c.epsilon[i])
        s.lambda_hat[i] = min(max(s.lambda_hat[i] * math.exp(c.dt * rate), c.lambda_min), c.lambda_max)


def test_eq_23_literal_form_differs_within_epsilon(monkeypatch: pytest.MonkeyPatch) -> None:
    """(13), (23) to the letter have kappa(r); the law has kappa(a), a = r/lambda_hat. Both are (19) with some
    kappa.

    Equal when r and a are on the same far side of epsilon; with |r| <= epsilon the law's kappa is larger by
    1/lambda_hat^2, up to 1: it is judged by what the actuator does, not by what was asked.
    """
    tuning, truth = Tuning(), np.array([0.2, 0.2, 0.2, 0.2])
    start = np.array([0.5, 0.5, 0.5, 1.0])
    r = np.tile([0.2, 0.04, 0.01, 0.04], (20, 1))  # a: .4, .08, .02, .04 at the start; epsilon .05
    flying = IdealLoop(IdealPlant(np.eye(4)), tuning, start).fly(r, truth)
    monkeypatch.setattr(ideal, "adapt", literal_adapt)
    monkeypatch.setattr(ideal, "ideal_loop", ideal.ideal_loop.py_func)
    literal = IdealLoop(IdealPlant(np.eye(4)), tuning, start).fly(r, truth)
    for history, argument in ((flying, flying.a), (literal, literal.r)):
        rate = tuning.gamma * tuning.dt_s * kappa(argument, tuning.epsilon)
        step = np.log(history.lambda_hat[1:] / history.lambda_hat[:-1])
        assert step == pytest.approx(rate * (truth / history.lambda_hat[:-1] - 1.0), rel=1e-13, abs=1e-15)
    assert literal.lambda_hat[:, 0] == pytest.approx(flying.lambda_hat[:, 0], rel=1e-14)
    first = [np.log(h.lambda_hat[1] / h.lambda_hat[0]) for h in (flying, literal)]
    assert first[0] / first[1] == pytest.approx([1.0, (0.05 / 0.04) ** 2, 1 / 0.5**2, 1.0], rel=1e-12)


@PROPERTY
@given(st.floats(1e-3, 0.999), st.floats(0.001, 1.0), st.booleans())
def test_eq_19_discrete_step_never_overshoots_below_a_known_gain(
    ratio: float, share: float, loss: bool
) -> None:
    """(19) is monotone; (*) is so from above for gamma dt <= 1, and from below iff gamma dt <= rho
    log(1/rho)/(1 - rho), rho = lambda_hat/lambda: beyond that a recovery jumps over the truth in one step."""
    limit = 1.0 if loss else ratio * math.log(1.0 / ratio) / (1.0 - ratio)
    start = 1.0 / ratio if loss else ratio
    step = 0.999 * share * limit
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(step / 0.005), start)
    estimate = loop.fly(np.full((30, 4), 1e4), 1.0).lambda_hat[:, 0]
    distance = (estimate - 1.0) * (1.0 if loss else -1.0)
    assert np.all(np.diff(distance) <= 4 * U * estimate[1:]) and np.all(distance >= -8 * U)
    if not loss and ratio < 0.9:
        beyond = IdealLoop(IdealPlant(np.eye(4)), Tuning(1.001 * limit / 0.005), start)
        assert beyond.fly(np.full((1, 4), 1e4), 1.0).lambda_hat[1, 0] > 1.0


# --- (24) to (28): error dynamics ---------------------------------------------------------------------------


@PROPERTY
@given(seeds, sizes)
def test_eq_25_to_28_eigenvalues(seed: int, n: int) -> None:
    """(28): eigenvalues of -gamma B Lambda Lambda_hat^-1 K B^-1 are -gamma lambda/lambda_hat kappa (and zeros
    for rates without an actuator). Bauer-Fike: the matrix is formed to n U |B||D||B^-1|, eigenvalues move by
    cond(B) times that."""
    rng = np.random.default_rng(seed)
    plant = random_plant(rng, n)
    d = (
        2.0
        * random_effectiveness(rng, n)
        / random_effectiveness(rng, n)
        * kappa(random_reference(rng, (n,)), 0.1)
    )
    eigenvalues = np.linalg.eigvals(-plant.B @ np.diag(d) @ np.linalg.pinv(plant.B))
    wanted = np.sort(np.concatenate([-d, np.zeros(4 - n)]))
    tolerance = 64 * U * np.linalg.cond(plant.B) ** 2 * d.max()
    assert np.abs(np.sort(eigenvalues.real) - wanted).max() <= tolerance
    assert np.abs(eigenvalues.imag).max() <= tolerance


@PROPERTY
@given(seeds, sizes)
def test_eq_25_28_error_decays_as_the_eigenvalues_say(seed: int, n: int) -> None:
    """(25): the first change of e on the simulated plant is A e, with A by (25) at the law's kappa(a).

    A difference over one step of gamma dt lambda/lambda_hat kappa = c is wrong by the second derivative:
    theta+ = theta exp(-c (..)), so |error| <= c^2 (1 + |x|..)/2; with c <= 1e-6 that is 1e-6 relative, and
    rounding U/c is smaller.
    """
    rng = np.random.default_rng(seed)
    plant, effectiveness = random_plant(rng, n, airspeed=1.0), random_effectiveness(rng, n)
    estimate = random_effectiveness(rng, n)
    r = rng.choice([-1.0, 1.0], n) * 10.0 ** rng.uniform(-1.5, 0.3, n)
    tuning = Tuning(gamma=2.0, epsilon=0.1, dt_s=1e-8)
    history = IdealLoop(plant, tuning, estimate).fly(np.tile(r, (2, 1)), effectiveness)
    ratio = effectiveness / estimate
    v = -tuning.gamma * ratio * kappa(r / estimate, tuning.epsilon)
    matrix = plant.B @ np.diag(v) @ np.linalg.pinv(plant.B)
    x = (ratio - 1.0) * r
    c = tuning.dt_s * np.abs(v).max() * max(1.0, np.abs(ratio - 1.0).max())
    noise = 2 * rounding_of_x(plant, effectiveness, history).max(axis=0) / tuning.dt_s
    tolerance = np.abs(plant.B) @ (c * np.abs(v * x) * (1.0 + 1.0 / ratio) + noise)
    assert np.all(np.abs((history.e[1] - history.e[0]) / tuning.dt_s - matrix @ history.e[0]) <= tolerance)


@FEW
@given(seeds, st.integers(0, 3))
def test_eq_28_eigenvectors_are_the_columns_of_b(seed: int, i: int) -> None:
    """(27), (28): with one estimate wrong e stays along B's column i, and decays along it at v_i for a small
    error."""
    rng = np.random.default_rng(seed)
    plant, effectiveness = random_plant(rng, airspeed=1.0), random_effectiveness(rng)
    estimate = effectiveness.copy()
    estimate[i] *= 1.0 + 1e-5
    tuning = Tuning(epsilon=1e-3)
    history = IdealLoop(plant, tuning, estimate).fly(np.full((200, 4), 0.5), effectiveness)
    x = history.e @ np.linalg.pinv(plant.B).T
    tolerance = rounding_of_x(plant, effectiveness, history).max()
    assert np.abs(np.delete(x, i, axis=1)).max() <= tolerance
    # lambda/lambda_hat = 1 here, so v_i = -gamma; the Euler factor of it, and 2e-5 for the curvature of (*)
    # and of 1/theta.
    factor = 1.0 - tuning.gamma * tuning.dt_s
    assert np.abs(
        x[1:, i] - factor * x[:-1, i]
    ).max() <= 2 * tolerance + 2e-5 * tuning.gamma * tuning.dt_s * abs(x[0, i])


# --- (29): modified inversion -------------------------------------------------------------------------------

NAMES = ("left_tail", "right_tail", "left_propeller", "right_propeller")


def random_aircraft(rng: np.random.Generator) -> tuple[DesignModel, np.ndarray, ControlDesign]:
    """A design model with a random input matrix and scales, and an owner who chose what to release."""
    plant = random_plant(rng)
    scale = 10.0 ** rng.uniform(-1.0, 1.0, 4)
    rows = tuple(map(tuple, np.vstack([plant.B / scale, rng.normal(size=(2, 4))]).tolist()))
    nothing = tuple(tuple([0.0] * 4) for _ in range(6))
    model = DesignModel(
        18.0, 300.0, 0.05, 1.2, NAMES, ("servo", "servo", "motor", "motor"), (0.0,) * 4, (0.0,) * 6,
        tuple(tuple([0.0] * 5) for _ in range(6)), rows, nothing, nothing, (None,) * 4,
    )  # fmt: skip
    release = {name: [str(rng.choice(RATES))] for name in NAMES if rng.random() < 0.7}
    control = ControlDesign(
        release=release,
        priorities=tuple(map(str, rng.permutation(RATES))),
        condition_max=float(10 ** rng.uniform(0.5, 2.5)),
    )
    return model, scale, control


def literal_b_hat(b: np.ndarray, failed: tuple[int, ...], released: list[int]) -> np.ndarray:
    """Section 2.3 to the letter: zeros for failed actuators in kept rows and for effective ones in released
    rows."""
    b_hat = b.copy()
    for i in range(4):
        for j in range(4):
            if (i in released) != (j in failed):
                b_hat[i, j] = 0.0
    return b_hat


def check_mode(b: np.ndarray, failed: tuple[int, ...], mode: Mode) -> None:
    """(29): rates kept are reproduced by the actuators that remain, and by nothing else."""
    kept = [i for i, axis in enumerate(RATES) if axis not in mode.released]
    alive = [j for j in range(4) if j not in failed]
    # pinv is good to about cond^2 (SVD, then the product); nothing is lost but rounding.
    tolerance = 256 * U * mode.condition**2
    effect = b[:, alive] @ mode.inverse[alive]
    assert np.abs(effect[np.ix_(kept, kept)] - np.eye(len(kept))).max() <= tolerance
    released = [i for i in range(4) if i not in kept]
    assert not mode.inverse[list(failed)].any() and not mode.inverse[:, released].any()


@PROPERTY
@given(seeds)
def test_eq_29_inverts_for_every_admissible_combination(seed: int) -> None:
    """(29): all 15 combinations of failures of a random aircraft either invert exactly or are refused with
    words."""
    model, scale, control = random_aircraft(np.random.default_rng(seed))
    b = np.array(model.input_matrix)[:4] * scale
    modes = enumerate_modes(model, scale, control)
    assert set(modes) == {c for k in range(4) for c in combinations(range(4), k)}
    for failed, mode in modes.items():
        kept = [i for i, axis in enumerate(RATES) if axis not in mode.released]
        alive = [j for j in range(4) if j not in failed]
        assert 0 < len(kept) <= len(alive) and mode.failed == tuple(NAMES[j] for j in failed)
        singular = np.linalg.svd(b[np.ix_(kept, alive)], compute_uv=False)
        condition = singular[0] / singular[-1]
        assert mode.condition == pytest.approx(condition, rel=64 * U * condition)
        assert bool(mode.refused) == (mode.condition > control.condition_max)
        if mode.refused:
            assert not mode.inverse.any()
            assert all(name in mode.refused for name in (*mode.failed, *mode.released))
            assert f"{mode.condition:.3g}" in mode.refused and "condition number" in mode.refused
        else:
            check_mode(b, failed, mode)


@PROPERTY
@given(seeds)
def test_eq_29_same_commands_as_the_papers_modified_matrix(seed: int) -> None:
    """(29): wherever the paper's B_hat is square block by block and invertible, B_hat^-1 gives effective
    actuators the same commands as `Mode.inverse` does for the kept rates."""
    rng = np.random.default_rng(seed)
    model, scale, control = random_aircraft(rng)
    b = np.array(model.input_matrix)[:4] * scale
    wanted = rng.normal(size=4)
    compared = 0
    for failed, mode in enumerate_modes(model, scale, control).items():
        released = [i for i, axis in enumerate(RATES) if axis in mode.released]
        literal = literal_b_hat(b, failed, released)
        if mode.refused or len(released) != len(failed) or np.linalg.cond(literal) > 1e6:
            continue
        alive = [j for j in range(4) if j not in failed]
        r = mode.inverse @ wanted
        size = 64 * U * np.abs(wanted).sum() / np.linalg.svd(b, compute_uv=False)[-1]
        commands = np.linalg.solve(literal, wanted)
        bound = size * np.linalg.cond(literal) * mode.condition * max(1.0, np.abs(r).max())
        assert np.abs(commands[alive] - r[alive]).max() <= bound
        compared += 1
    assume(compared)  # an aircraft whose every combination is refused shows nothing


# --- (30) to (32): noise and disturbances -------------------------------------------------------------------


@PROPERTY
@given(seeds, sizes)
def test_eq_32_every_step(seed: int, n: int) -> None:
    """(32): any disturbance of the rates moves lambda_hat by gamma g (B_mc^-1 n) more, every step, any
    colour."""
    rng = np.random.default_rng(seed)
    plant, effectiveness = random_plant(rng, n), random_effectiveness(rng, n)
    tuning = Tuning(gamma=2.0, epsilon=0.05)
    noise = 0.05 * rng.normal(size=(50, n))
    r = rng.choice([-1.0, 1.0], (50, n)) * rng.uniform(0.05, 2.0, (50, n))
    loop = IdealLoop(plant, tuning, random_effectiveness(rng, n))
    history = loop.fly(r, effectiveness, noise @ plant.B.T * plant.airspeed**2)
    check_steps(plant, tuning, effectiveness, history, noise)


@pytest.mark.parametrize(("gamma", "epsilon"), [(2.0, 0.05), (8.0, 0.05), (2.0, 0.4)])
@pytest.mark.parametrize("ratio", [-5.0, -0.5, 0.5])
def test_eq_32_37_constant_disturbance_biases(gamma: float, epsilon: float, ratio: float) -> None:
    """(32), and (37) with an error of f: lambda_hat goes to lambda/(1 - n/r), whatever gamma, epsilon.

    A fixed point, so exact once settled: the slowest case pulls with gamma (1 - n/r) kappa(a) = 2 * 0.5 *
    (0.05/0.4)^2, and 2000 s of that leave exp(-31) = 3e-14. Its own rounding is that of x over r.
    """
    plant = random_plant(np.random.default_rng(3), airspeed=1.0)
    r, truth = np.array([0.1, -0.2, 0.3, 1.0]), np.array([1.0, 0.5, 0.2, 1.5])
    tuning = Tuning(gamma, epsilon, 0.02)
    reference = np.tile(r, (100000, 1))
    n = plant.B @ (ratio * r)
    model_error = IdealPlant(plant.B, A=plant.A, bias=plant.bias, bias_error=n)
    for loop, disturbance in ((IdealLoop(plant, tuning), n), (IdealLoop(model_error, tuning), np.zeros(4))):
        history = loop.fly(reference, truth, disturbance)
        wanted = truth / (1.0 - ratio)
        tolerance = 2 * rounding_of_x(plant, truth, history)[-1] / np.abs(r) / (1.0 - ratio)
        assert np.all(np.abs(history.lambda_hat[-1] / wanted - 1.0) <= tolerance)


@pytest.mark.parametrize("epsilon", [0.05, 0.4])
def test_eq_32_disturbance_is_additive_for_an_actuator_that_stands_still(epsilon: float) -> None:
    """(32) takes u = r/lambda_hat for granted. At a stop, or held after a failure, a is given: lambda_hat
    goes to lambda + n/a, without the 1/(1 - n/r) that keeps it positive; negative means the lower
    bound."""
    a, truth = 0.2, np.array([0.3, 0.3, 0.3, 0.0])
    n = np.array([0.0, 0.04, -0.08, 0.12])
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(2.0, epsilon, 0.02, lambda_min=0.01))
    for name in ("low", "high"):
        loop._models[name] = a
    # Rate 2 kappa >= 0.5 for 200 s.
    estimate = loop.fly(np.ones((10000, 4)), truth, n).lambda_hat[-1]
    assert estimate == pytest.approx(np.maximum(truth + n / a, 0.01), abs=32 * U)


def test_eq_32_diverges_when_the_disturbance_exceeds_r() -> None:
    """(32): n/r > 1 diverges at the rate gamma (n g - kappa) without lambda_hat in the condition (the paper's
    third bullet in 4.1 has one too many); the projection stops it at its bound, n/r < 1 does not get
    there."""
    r, ratio, gamma = 0.5, 1.2, 2.0
    reference, noise = np.full((4000, 4), r), np.array([ratio * r, 0.9 * r, 0.0, -3.0 * r])
    open_loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-12)).fly(reference, 1.0, noise).lambda_hat
    growth = math.log(open_loop[-1, 0] / open_loop[-201, 0]) / (200 * 0.005)
    # (*): growth = gamma (lambda/lambda_hat + n/r - 1), and lambda/lambda_hat <= 1/lambda_hat one second
    # before the end.
    assert 0.0 <= growth - gamma * (ratio - 1.0) <= gamma / open_loop[-201, 0] + 1e-9
    assert open_loop[-1, 1] < 10.0
    bounded = (
        IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, lambda_max=1.1)).fly(reference, 1.0, noise).lambda_hat
    )
    assert np.all(bounded[-100:, 0] == 1.1) and bounded.max() <= 1.1


def test_eq_32_white_noise_gives_the_stationary_law() -> None:
    """(32) with white noise, exponential update: theta = 1/lambda_hat ~ Gamma(nu), nu = 2
    r^2/(gamma s).

    Exactly, from the stationarity of log lambda_hat: E[theta] = 1/lambda. In the limit of small gamma dt: var
    theta = 1/(nu lambda^2), E[lambda_hat] = lambda nu/(nu - 1). One step of finite size changes the variance
    by the factor 1/(1 - gamma dt/2) to first order in the noise (discrete Lyapunov equation). Bounds: 4
    standard errors from 240 batch means of 40 000 steps (200 time constants) each, plus a relative gamma dt:
    the finite step's effect beyond the Lyapunov equation is of the order gamma dt / nu.
    """
    rng = np.random.default_rng(20240607)
    gamma, dt, truth, r, nu = 2.0, 0.0025, 0.8, 0.5, 20.0
    c = gamma * dt
    sigma = math.sqrt(2.0 * r * r / (gamma * nu) / dt)  # of a sample: s = sigma^2 dt
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-6, dt, lambda_max=50.0), truth)
    reference = np.full((40000, 4), r)
    loop.fly(reference, truth, sigma * rng.normal(size=(40000, 4)))
    means, squares, estimates = [], [], []
    for _ in range(60):
        estimate = loop.fly(reference, truth, sigma * rng.normal(size=(40000, 4))).lambda_hat[1:]
        theta = truth / estimate
        means.extend(theta.mean(axis=0))
        squares.extend(((theta - 1.0) ** 2).mean(axis=0))
        estimates.extend((estimate / truth).mean(axis=0))

    def standard_error(batches: list[float]) -> float:
        return float(np.std(batches, ddof=1) / math.sqrt(len(batches)))

    assert abs(np.mean(means) - 1.0) <= 4 * standard_error(means)
    lyapunov = solve_discrete_lyapunov([[1.0 - c]], [[(c * sigma / r) ** 2]])[0, 0]
    assert lyapunov * nu == pytest.approx(1.0 / (1.0 - c / 2.0), rel=1e-12)
    assert abs(np.mean(squares) - lyapunov) <= 4 * standard_error(squares) + c * lyapunov
    assert abs(np.mean(estimates) - nu / (nu - 1.0)) <= 4 * standard_error(estimates) + c / nu
    # The bounds decide: Euler's update would have the mean estimate 1, and the variance is known to better
    # than 4 %.
    assert np.mean(estimates) - 1.0 > 8 * standard_error(estimates) + c / nu
    assert 4 * standard_error(squares) * nu < 0.04


# --- (41): divergence without projection; see also test_input_matrix ------------------------------


def counter_example(lambda_max: float) -> History:
    m = np.array([[1.0, 0.2], [0.0, 1.0]])
    b = np.array([[1.0, 0.3], [-0.2, 0.8], [0.5, 0.1], [0.0, 0.4]])
    loop = IdealLoop(IdealPlant(b, B_c=b @ m), Tuning(2.0, 1e-12, 0.001, lambda_max=lambda_max))
    return loop.fly(np.tile([0.1, 1.0], (10000, 1)), 1.0)


def test_eq_41_counter_example_diverges_without_projection_and_is_bounded_with_it() -> None:
    """(41), a counter-example: M = [[1, .2], [0, 1]], r = (.1, 1) is as nice as M gets, and lambda_hat_1 grows at
    gamma for ever.

    Closed form: lambda_hat_1' = gamma (1 + lambda_hat_1), so 2 exp(gamma t) - 1 = 9.7e8 after 10 s, which (*)
    approaches to first order: its log lags the exact one by at most dt/2 gamma log(h0/h) = gamma dt/2 log 2.
    """
    free = counter_example(1e300).lambda_hat
    lag = math.log(2.0 * math.exp(20.0) - 1.0) - math.log(free[-1, 0])
    assert abs(lag) <= 1.01 * 0.002 / 2 * math.log(2.0)
    assert math.log(free[-1, 0] / free[-1001, 0]) == pytest.approx(2.0, abs=2.0 / free[-1001, 0] + 1e-9)
    projected = counter_example(1.1)
    assert projected.lambda_hat.max() <= 1.1 and projected.lambda_hat[-1, 0] == 1.1
    assert np.all(projected.lambda_hat[:, 1] == pytest.approx(1.0, abs=1e-12))


def test_eq_41_law_slows_the_divergence_once_the_actuator_stands_still() -> None:
    """With a usual epsilon the estimate grows as sqrt(t), not exponentially, once |a| = |r|/lambda_hat <
    epsilon (the paper's own kappa(r) would keep growing): lambda_hat^2 grows by 2 gamma r^2/epsilon^2 per
    second (+ O(1/lambda_hat))."""
    m = np.eye(4)
    m[0, 1] = 0.2
    loop = IdealLoop(IdealPlant(np.eye(4), B_c=m), Tuning(2.0, 0.05, 0.005), [100.0, 1.0, 1.0, 1.0])
    estimate = loop.fly(np.tile([0.1, 1.0, 1.0, 1.0], (20000, 1)), 1.0).lambda_hat[:, 0]
    slope = np.diff(estimate[[0, -1]] ** 2)[0] / 100.0
    assert slope == pytest.approx(2.0 * 2.0 * (0.1 / 0.05) ** 2, rel=1.1 / 100.0)


# --- actuators, monitor --------------------------------------------------------------------------


@FEW
@given(seeds)
def test_eq_18_holds_behind_a_lagged_rate_limited_servo_that_is_modelled(seed: int) -> None:
    """(18): with the servo in plant and model, (*) holds at every step of any r, rate limit
    included, with kappa at the modelled position."""
    rng = np.random.default_rng(seed)
    plant = random_plant(rng, lag=rng.uniform(3.0, 40.0, 4), rate=rng.uniform(1.0, 10.0, 4))
    tuning, effectiveness = Tuning(), random_effectiveness(rng)
    r = np.cumsum(rng.normal(size=(400, 4)), axis=0) * 0.1
    history = IdealLoop(plant, tuning, random_effectiveness(rng)).fly(r, effectiveness)
    assert np.abs(np.diff(history.a, axis=0)).max() > 0.0 and np.abs(history.a - history.u).max() > 0.1
    check_steps(plant, tuning, effectiveness, history)


def test_modelled_servo_is_the_bilinear_first_order_lag() -> None:
    """The servo of plant and model is not only the same: it is Tustin's (1 + z^-1)/... by scipy, without a
    rate limit."""
    lag, dt = 20.0, 0.005
    plant = IdealPlant(np.eye(4), lag=lag)
    r = np.random.default_rng(0).normal(size=(300, 4))
    history = IdealLoop(plant, Tuning(dt_s=dt)).fly(r, 1.0)
    w = lag * dt
    wanted = lfilter([w / (2 + w), w / (2 + w)], [1.0, -(2 - w) / (2 + w)], history.u, axis=0)
    assert history.a == pytest.approx(wanted, abs=200 * U)


@pytest.mark.parametrize("w_tau", [0.1, 0.5, 1.0, 2.0])
@pytest.mark.parametrize("all_within_epsilon", [True, False])
def test_unmodelled_servo_reads_re_f(w_tau: float, all_within_epsilon: bool) -> None:
    """Without the model, a command moving at w reads Re F = 1/(1 + w^2 tau^2): w tau = 2 looks 80 %
    failed.

    Slow adaptation: over whole periods the mean rate of log lambda_hat vanishes at lambda Re F, and pulls
    back from either side with gamma (Re F lambda/lambda_hat - 1) E[kappa]; in both limits of epsilon (sampled
    half a step off the zeros, where the mean of 1/a vanishes by symmetry). F is the sampled servo's, w its
    Tustin-warped frequency.

    gamma, 1e-6 or less, freezes the estimate: its movement d changes the rate h by at most 4 d (|h| + kappa),
    as h has the terms lambda_hat^-2 and lambda_hat^-3; and log lambda_hat is rounded to a few U each step.
    """
    truth, period, warm, periods, dt = 0.7, 400, 8, 4, 0.005
    epsilon, gamma = (8.0, 1e-6) if all_within_epsilon else (1e-9, 1e-7)
    theta = 2.0 * math.pi * (np.arange((warm + periods) * period) + 0.5) / period
    lag = 2.0 / dt * math.tan(math.pi / period) / w_tau
    re_f = 1.0 / (1.0 + w_tau**2)
    r = np.tile(np.sin(theta)[:, None], (1, 4))
    settled = warm * period  # the servo's transient has gone: exp(-8 * 2 pi / w_tau) <= 1e-11
    for modelled, target in ((False, truth * re_f), (True, truth)):
        for factor in (1.0, 0.9, 1.2):
            plant = IdealPlant(np.eye(4), lag=lag, modelled=modelled)
            history = IdealLoop(plant, Tuning(gamma, epsilon, dt), target * factor).fly(r, truth)
            log = np.log(history.lambda_hat[:, 0] / (target * factor))
            rates = np.diff(log[settled:]) / (gamma * dt)
            k = kappa(history.a[settled:, 0], epsilon)
            moved = np.abs(log).max()
            tolerance = 4 * moved * (np.abs(rates) + k).mean() + 16 * U / (gamma * dt)
            assert tolerance < 1e-3 * k.mean()
            assert abs(rates.mean() - (1.0 / factor - 1.0) * k.mean()) <= tolerance


def test_monitor_reports_a_failure_after_its_persistence_and_takes_it_back() -> None:
    """Section 2.3: lambda_hat below the threshold for longer than the persistence, above the other for the way
    back, half a second here. The sample after the last within the time decides. Times by the closed form (22)."""
    tuning = Tuning(
        gamma=4.0, threshold=0.1, recovery=0.5, persistence_s=0.05, lambda_min=0.01, lambda_max=1.1
    )
    effectiveness = np.ones((1200, 4))
    effectiveness[200:700, 2] = 0.0
    history = IdealLoop(IdealPlant(np.eye(4)), tuning).fly(np.ones((1200, 4)), effectiveness)
    assert not history.failed[:, [0, 1, 3]].any()
    estimate, failed = history.lambda_hat[1:, 2], history.failed[:, 2]
    below = int(np.argmax(estimate < 0.1))
    detected = int(np.argmax(failed > 0.5))
    assert detected - below == 10 and not failed[:detected].any()
    # A total loss is log lambda_hat' = -gamma exactly: (*) has no error at lambda = 0.
    assert below - 200 + 1 == math.ceil(math.log(10.0) / (tuning.gamma * tuning.dt_s))
    above = 700 + int(np.argmax(estimate[700:] > 0.5))
    taken_back = 700 + int(np.argmax(failed[700:] < 0.5))
    assert taken_back - above == 100 and not failed[taken_back:].any()


# --- negative controls: the checks can fail -----------------------------------------------------------------


def flipped_adapt(e, pressure, m, c, s):  # type: ignore[no-untyped-def]
    """The law with the wrong sign."""
    law.adapt(-e, pressure, m, c, s)


def additive_adapt(e, pressure, m, c, s):  # type: ignore[no-untyped-def]
    """Euler's step on lambda_hat itself, not on its logarithm."""
    x = m.B_inv @ e / pressure
    for i in range(len(s.lambda_hat)):
        s.lambda_hat[i] += c.dt * c.gamma[i] * x[i] * law.modified_inverse(s.position[i], c.epsilon[i])


@pytest.mark.parametrize("mutant", [None, flipped_adapt, additive_adapt])
def test_negative_control_mutated_law_fails_the_check(
    mutant: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`check_steps` accepts the law, run uncompiled, and rejects a flipped sign and another integration."""
    rng = np.random.default_rng(1)
    plant, effectiveness, tuning = random_plant(rng), random_effectiveness(rng), Tuning()
    monkeypatch.setattr(ideal, "ideal_loop", ideal.ideal_loop.py_func)
    if mutant:
        monkeypatch.setattr(ideal, "adapt", mutant)
    history = IdealLoop(plant, tuning, 1.0).fly(rng.uniform(0.2, 1.0, (10, 4)), effectiveness)
    if mutant:
        with pytest.raises(AssertionError):
            check_steps(plant, tuning, effectiveness, history)
    else:
        check_steps(plant, tuning, effectiveness, history)


def test_negative_control_wrong_input_matrix_fails_the_check() -> None:
    """One entry of B_mc wrong by 1e-9 breaks (12), (18): the checks see a part in 1e9."""
    rng = np.random.default_rng(2)
    right = random_plant(rng)
    wrong = right.B.copy()
    wrong[1, 2] *= 1.0 + 1e-9
    tuning, effectiveness = Tuning(), random_effectiveness(rng)
    history = IdealLoop(IdealPlant(right.B, B_c=wrong), tuning).fly(
        rng.uniform(0.2, 1.0, (10, 4)), effectiveness
    )
    with pytest.raises(AssertionError):
        check_steps(right, tuning, effectiveness, history)


def test_negative_control_unmodelled_lag_fails_the_check() -> None:
    """The same servo as above, not modelled: (18) does not hold."""
    rng = np.random.default_rng(3)
    plant = random_plant(rng, lag=30.0, modelled=False)
    tuning, effectiveness = Tuning(), random_effectiveness(rng)
    history = IdealLoop(plant, tuning).fly(rng.uniform(0.2, 1.0, (10, 4)), effectiveness)
    with pytest.raises(AssertionError):
        check_steps(plant, tuning, effectiveness, history)


def test_negative_control_modes_fail_the_check() -> None:
    """(29) with one entry of the inverse off by 1e-9, and with the inverse of the unmodified matrix."""
    rng = np.random.default_rng(4)
    model, scale, _ = random_aircraft(rng)
    control = ControlDesign(release={"left_tail": ("r_dot",)}, condition_max=1e4)
    b = np.array(model.input_matrix)[:4] * scale
    mode = enumerate_modes(model, scale, control)[(0,)]
    check_mode(b, (0,), mode)
    off = mode.inverse.copy()
    off[1, 1] *= 1.0 + 1e-9
    for inverse in (off, np.linalg.inv(b)):
        with pytest.raises(AssertionError):
            check_mode(b, (0,), Mode(mode.failed, mode.released, inverse, mode.condition))
