"""How noise, disturbances and an error of the state function move the estimates: what follows from (30) to (38).

With x = lambda_hat / lambda, a disturbance n of the rates (31), n_i = (B_mc^-1 n)_i of actuator i, and kappa of (17), (32) is

    x' = gamma kappa (1 - x + x n_i / r_i)

for a constant reference r. The noise is multiplied by the estimate. The law integrates log x, so for white noise of two-sided
intensity s the stationary 1/x has a gamma distribution with shape nu = 2 max(|r|, epsilon)^2 / (gamma s) and mean 1
(`ReferenceHeld`). In a flight, outer loops hold the force of the actuator, and so its position a = r / lambda_hat rather than r.
Then the noise is additive, and x has the density x exp(-nu (x - 1)^2 / 2) but for a factor (`PositionHeld`). To first order in
1 / nu the variance of both is 1 / nu.

Intensities are two-sided: a white noise of intensity S, sampled every dt, has the variance S / dt. A sensor whose one-sided
density is N per root hertz has S = N^2 / 2.

Sources: the gamma law is the stationary solution of the Fokker-Planck equation of (32) in log x (Risken, The Fokker-Planck
Equation, 5.3); so is that of a held position. The mean over coloured noise is the spectral integral of a first-order lag
(Papoulis, Probability, Random Variables and Stochastic Processes, 9-4).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.special import erf, gammaincc

from testbed.gains.false_alarms import POSITION, false_alarm_rate

SETTLED = 0.05
"""An estimate has converged when this part of its first error is left."""
_QUIET = 2.0**14  # a deviation of 1 %


def convergence_time(gamma: float, kappa: float = 1.0) -> float:
    """Time in which (22) takes an estimate to within `SETTLED` of its first error [s]: 3.0 / (gamma kappa)."""
    return -math.log(SETTLED) / (gamma * kappa)


def one_sided_intensity(density: float) -> float:
    """Two-sided intensity S of a sensor's noise with this one-sided density [unit per root hertz]: N^2 / 2."""
    return 0.5 * density * density


def actuator_intensity(b_inverse: np.ndarray, intensity: np.ndarray) -> np.ndarray:
    """[n] intensity s_i of (B_mc^-1 n)_i in (32), in scaled units squared times second.

    Args:
        b_inverse: [n, 4] B_mc^-1.
        intensity: [4, 4] two-sided intensity of the noise of the rates, or its diagonal [4].
    """
    matrix = np.diag(intensity) if np.ndim(intensity) == 1 else np.asarray(intensity)
    found: np.ndarray = np.einsum("ij,jk,ik->i", b_inverse, matrix, b_inverse)
    return found


def shape(r: np.ndarray | float, gamma: float, s: np.ndarray | float, epsilon: float = 0.0) -> np.ndarray:
    """nu of (32) with white noise: 2 max(|r|, epsilon)^2 / (gamma s), the same in both parts of (14) [1]; infinite without noise.

    Args:
        r: reference of the actuator, or its position where that is held [scaled].
        s: two-sided intensity of (B_mc^-1 n)_i [scaled^2 s].
    """
    with np.errstate(divide="ignore"):
        found: np.ndarray = 2.0 * np.maximum(np.abs(r), epsilon) ** 2 / np.multiply(gamma, s)
    return found


def deviation(nu: np.ndarray | float, step: float = 0.0) -> np.ndarray:
    """Standard deviation of lambda / lambda_hat under white noise [1].

    It is exact for a reference that is held and a small control step. A step of gamma kappa dt makes it larger as the
    discrete Lyapunov equation says.
    """
    found: np.ndarray = 1.0 / np.sqrt(np.multiply(nu, 1.0 - 0.5 * step))
    return found


def euler_variance(gamma: float, dt: float, g: float, kappa: float, s: float) -> float:
    """Variance of lambda_hat / lambda if (32) is integrated as it stands, by Euler's method [1]; infinite where it has none.

    Exact for any control step: of x+ = x + gamma dt (kappa (1 - x) + g n x), in which n has the variance s / dt.
    """
    left = 2.0 * kappa - gamma * kappa * kappa * dt - gamma * g * g * s
    return gamma * g * g * s / left if left > 0.0 else math.inf


def time_times_variance(r: np.ndarray | float, s: np.ndarray | float) -> np.ndarray:
    """Convergence time times variance [s]: 1.5 s / r^2. No gamma and no epsilon changes it, in either part of (14)."""
    found: np.ndarray = 0.5 * convergence_time(1.0) * np.divide(s, np.square(r))
    return found


def gyro_deviation(gamma: float, r: float, density: float, corner: float, kappa: float = 1.0) -> float:
    """Standard deviation of the estimate under a differentiated gyro with a first-order filter [1].

    Its spectrum is zero at zero frequency, so that the deviation grows as gamma and not as its root.

    Args:
        density: root of the two-sided intensity of the gyro's noise through B_mc^-1 [scaled per root hertz].
        corner: of the filter [rad/s].
    """
    return gamma * kappa / abs(r) * density * corner / math.sqrt(2.0 * (gamma * kappa + corner))


def gust_deviation(gamma: float, r: float, sigma: float, corner: float, kappa: float = 1.0) -> float:
    """Standard deviation of the estimate under a first-order Gauss-Markov disturbance [1].

    Args:
        sigma: standard deviation of (B_mc^-1 n)_i [scaled].
        corner: one over its correlation time [rad/s].
    """
    return sigma / abs(r) * math.sqrt(gamma * kappa / (gamma * kappa + corner))


def biased_by_reference(truth: float, n: float, r: float) -> float:
    """Where (32) and (37) take an estimate under a constant n = (B_mc^-1 n)_i at a constant reference: lambda / (1 - n/r).

    Neither gamma nor epsilon enters. Infinite if n/r is 1 or more: then the estimate diverges.
    """
    return truth / (1.0 - n / r) if n / r < 1.0 else math.inf


def biased_by_position(truth: float, n: float, a: float) -> float:
    """The same where the position a is held, by outer loops or by a stop: lambda + n/a.

    It is the fixed point of `biased_by_reference` at the reference r = lambda_hat a that such a flight ends with. A negative
    value means the lower bound of the estimates.
    """
    return truth + n / a


def divergence_rate(gamma: float, n: float, r: float, epsilon: float = 0.0) -> float:
    """Growth rate of log lambda_hat for a large estimate under a constant n [1/s]: gamma (n g - kappa).

    It is positive if and only if n/r > 1. The condition does not contain lambda_hat, contrary to the third remark of the paper
    after (32).
    """
    g = 1.0 / r if abs(r) > epsilon else r / epsilon**2
    return gamma * g * (n - r)


def state_noise_mean(sigma: float, r: float) -> float:
    """lambda_hat / lambda under noise of the measured state that enters r and n together ((31)), to second order [1].

    Args:
        sigma: standard deviation of (B_mc^-1 [f_m(x) - f_m(x + n_x)])_i [scaled].
    """
    return 1.0 / (1.0 + (sigma / r) ** 2)


def shape_for(
    per_second: float, rate: float, dt: float, persistence_s: float, threshold: float, held: int = POSITION
) -> float:
    """The nu from which on there are no more false alarms than `per_second`, to 1 %, and at least 2.

    Other arguments as in `false_alarm_rate`. It is sought from above: with very much noise, too, an estimate does not stay low.
    """

    def tolerable(nu: float) -> bool:
        return false_alarm_rate(nu, rate, dt, persistence_s, threshold, held) <= per_second

    high = _QUIET
    while high > 2.0 and tolerable(0.5 * high):
        high *= 0.5
    low = 0.5 * high
    while high > 2.0 and high > 1.01 * low:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if tolerable(middle) else (middle, high)
    return high


@dataclass(frozen=True)
class ReferenceHeld:
    """At a constant reference 1/x is gamma distributed, with shape nu and mean 1.

    Low estimates are rarer than for a normal law, because u = r / lambda_hat grows as lambda_hat falls; high ones are more
    frequent, with a tail of the power nu + 1.
    """

    nu: float

    def below(self, x: float) -> float:
        """Probability of an estimate below x times the truth."""
        return float(x > 1.0) if math.isinf(self.nu) else float(gammaincc(self.nu, self.nu / x))

    @property
    def mean(self) -> float:
        """Mean of x; infinite if nu is 1 or less."""
        return self.nu / (self.nu - 1.0) if self.nu > 1.0 else math.inf

    @property
    def variance(self) -> float:
        """Variance of x; infinite if nu is 2 or less."""
        return self.mean**2 / (self.nu - 2.0) if self.nu > 2.0 else math.inf


@dataclass(frozen=True)
class PositionHeld:
    """At a constant position the density of x is x exp(-nu (x - 1)^2 / 2), but for a factor."""

    nu: float

    def below(self, x: float) -> float:
        """Probability of an estimate below x times the truth."""
        if math.isinf(self.nu):
            return float(x > 1.0)
        sigma = 1.0 / math.sqrt(self.nu)
        return (self._mass(x) - self._mass(0.0)) / (sigma * math.sqrt(math.pi / 2.0) - self._mass(0.0))

    def _mass(self, x: float) -> float:
        """Integral of y exp(-(y-1)^2 / (2 sigma^2)) dy up to x, but for a constant."""
        sigma = 1.0 / math.sqrt(self.nu)
        z = (x - 1.0) / sigma
        normal = sigma * math.sqrt(math.pi / 2.0) * float(erf(z / math.sqrt(2.0)))
        return normal - sigma * sigma * math.exp(-0.5 * z * z)

    @property
    def mean(self) -> float:
        """Mean of x."""
        return self._moment(2) / self._moment(1)

    @property
    def variance(self) -> float:
        """Variance of x."""
        return self._moment(3) / self._moment(1) - self.mean**2

    def _moment(self, power: int) -> float:
        """Integral of x^power exp(-nu (x-1)^2 / 2) over x > 0, by integration by parts."""
        sigma2 = 1.0 / self.nu
        edge = math.exp(-0.5 * self.nu)
        moments = [math.sqrt(math.pi * sigma2 / 2.0) * (1.0 + float(erf(math.sqrt(0.5 * self.nu))))]
        moments.append(moments[0] + sigma2 * edge)
        for k in range(1, power):
            moments.append(moments[k] + k * sigma2 * moments[k - 1])
        return moments[power]
