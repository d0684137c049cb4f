"""The stationary laws of an estimate under white noise, and how soon it converges: what follows from (32) and (22).

x = lambda_hat / lambda, under white noise of shape nu = 2 r^2 / (gamma s) with s the intensity of the actuator's part of it. At a
constant reference r the noise is multiplied by the estimate (`ReferenceHeld`). In a flight, outer loops hold the force of the
actuator, and so its position: then the noise is additive (`PositionHeld`). To first order in 1 / nu the variance of both is 1 / nu.

Source: the stationary solution of the Fokker-Planck equation of (32) in log x (Risken, The Fokker-Planck Equation, 5.3).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from scipy.special import erf, gammaincc

SETTLED = 0.05
"""An estimate has converged when this part of its first error is left."""


def convergence_time(gamma: float, kappa: float = 1.0) -> float:
    """Time in which (22) takes an estimate to within `SETTLED` of its first error [s]: 3.0 / (gamma kappa)."""
    return -math.log(SETTLED) / (gamma * kappa)


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
