"""Mixtures of normals about design points, or fitted to failures: densities for importance sampling.

Failures differ from standard normal points in a few directions only, and what is fitted has as many dimensions as they tell of.
Elsewhere it is the standard normal itself, so that dimensions that do not matter add nothing to the weights (as in
failure-informed cross-entropy sampling, Uribe and others 2021, SIAM/ASA Journal on Uncertainty Quantification 9:818).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import logsumexp

MOST = 4
"""Most components."""
NARROWEST = 0.7
"""Smallest variance of a component: with less than 1/2 the weights have no variance."""
MARGIN = 1.1
"""Factor beyond what chance gives, from which on a direction's mean square tells of the failures."""
ROUNDS, SETTLED = 20, 1e-3
"""Most steps of expectation and maximisation, and the gain in the mean log-likelihood that ends them."""


@dataclass
class Mixture:
    """`shares` [k] of normals with `means` [k, r] and `covariances` [k, r, r] along the directions `basis` [d, r]."""

    basis: np.ndarray
    shares: np.ndarray
    means: np.ndarray
    covariances: np.ndarray

    def __post_init__(self) -> None:
        self.roots = np.linalg.cholesky(self.covariances)

    def draw(self, n: int, random: np.random.Generator) -> np.ndarray:
        """Draw n points [n, d]."""
        points = random.standard_normal((n, len(self.basis)))
        which = random.choice(len(self.shares), n, p=self.shares)
        noise = random.standard_normal((n, self.basis.shape[1]))
        along = self.means[which] + np.einsum("nij,nj->ni", self.roots[which], noise)
        return points + (along - points @ self.basis) @ self.basis.T

    def log_ratio(self, points: np.ndarray) -> np.ndarray:
        """Logarithm of the density over that of the standard normal, at points [n, d]."""
        along = points @ self.basis
        return logsumexp(self._logs(along), axis=0) + np.sum(along**2, axis=1) / 2

    def _logs(self, along: np.ndarray) -> np.ndarray:
        """Logarithms [k, n] of each component's share of the density, but for a constant."""
        logs = []
        for share, mean, root in zip(self.shares, self.means, self.roots, strict=True):
            scaled = np.linalg.solve(root, (along - mean).T)
            logs.append(math.log(share) - np.log(np.diag(root)).sum() - np.sum(scaled**2, axis=0) / 2)
        return np.array(logs)

    def mean_log(self, along: np.ndarray, weights: np.ndarray) -> tuple[float, np.ndarray]:
        """Weighted mean of the log-density at points [n, r], and the weighted part [k, n] of each component in each."""
        logs = self._logs(along)
        whole = logsumexp(logs, axis=0)
        return float(weights @ whole), np.exp(logs - whole) * weights

    def wider(self, factor: float) -> Mixture:
        """The same with every covariance so much larger, and with shares halfway to equal ones: rare components are drawn too."""
        shares = (self.shares + 1 / len(self.shares)) / 2
        return Mixture(self.basis, shares, self.means, factor * self.covariances)

    def broad(self, scale: float) -> Mixture:
        """One component about the origin, with `scale` standard deviations in every direction of the basis."""
        r = self.basis.shape[1]
        return Mixture(self.basis, np.ones(1), np.zeros((1, r)), scale**2 * np.eye(r)[None])


@dataclass
class Blend:
    """Several densities, such as mixtures in directions of their own, drawn with the probabilities `shares`."""

    parts: Sequence[Density]
    shares: np.ndarray

    def draw(self, n: int, random: np.random.Generator) -> np.ndarray:
        counts = random.multinomial(n, self.shares)
        return np.vstack([part.draw(count, random) for part, count in zip(self.parts, counts, strict=True)])

    def log_ratio(self, points: np.ndarray) -> np.ndarray:
        logs = [math.log(s) + part.log_ratio(points) for s, part in zip(self.shares, self.parts, strict=True)]
        return np.asarray(logsumexp(logs, axis=0))


@dataclass
class AboutPoints:
    """Standard normals about the design points `centres` [k, d], drawn with the probabilities `shares` [k]."""

    centres: np.ndarray
    shares: np.ndarray

    def draw(self, n: int, random: np.random.Generator) -> np.ndarray:
        centre = self.centres[random.choice(len(self.shares), n, p=self.shares)]
        return centre + random.standard_normal(centre.shape)

    def log_ratio(self, points: np.ndarray) -> np.ndarray:
        return np.asarray(logsumexp(self._exponents(points), axis=1, b=self.shares))

    def likeliest(self, points: np.ndarray) -> np.ndarray:
        """The design point [n] about which each of the points [n, d] is likeliest to have been drawn."""
        return np.asarray(np.argmax(self._exponents(points), axis=1))

    def _exponents(self, points: np.ndarray) -> np.ndarray:
        return np.asarray(points @ self.centres.T - np.sum(self.centres**2, axis=1) / 2)


Density = Mixture | Blend | AboutPoints
"""What points are drawn from; their methods are as those of `Mixture`."""


def fitted(points: np.ndarray, weights: np.ndarray, effective: float, random: np.random.Generator) -> Mixture:
    """The mixture of points [n, d] with weights [n] that sum to 1, with the effective sample size `effective`.

    Of one to MOST components the number with the least Bayesian information criterion (Schwarz 1978).
    """
    basis = _informed(points, weights, effective)
    along, r = points @ basis, basis.shape[1]
    best, least = None, math.inf
    for k in range(1, MOST + 1):
        if k > 1 and effective / k <= r + 1:
            break
        mixture, mean_log = _maximised(basis, along, weights, k, effective, random)
        parameters = len(mixture.shares) * (1 + r + r * (r + 1) / 2)
        criterion = parameters * math.log(max(effective, 3.0)) - 2 * effective * mean_log
        if criterion < least:
            best, least = mixture, criterion
    assert best is not None
    return best


def _informed(points: np.ndarray, weights: np.ndarray, effective: float) -> np.ndarray:
    """Orthonormal directions [d, r] with a mean square farther from 1 than chance brings it (Marchenko and Pastur 1967)."""
    squares, directions = np.linalg.eigh((points * weights[:, None]).T @ points)
    edge = math.sqrt(points.shape[1] / effective)
    tells = squares > MARGIN * (1 + edge) ** 2
    if edge < 1:
        tells |= squares < (1 - edge) ** 2 / MARGIN
    tells[-1] = True
    return np.ascontiguousarray(directions[:, tells])


def _maximised(
    basis: np.ndarray,
    along: np.ndarray,
    weights: np.ndarray,
    k: int,
    effective: float,
    random: np.random.Generator,
) -> tuple[Mixture, float]:
    """At most k components by expectation and maximisation (Dempster, Laird and Rubin 1977), with their mean log-density."""
    means = _spread_out(along, weights, k, random)
    k, r = means.shape
    mixture = Mixture(basis, np.full(k, 1 / k), means, np.repeat(np.eye(r)[None], k, axis=0))
    before, parts = mixture.mean_log(along, weights)
    for _ in range(ROUNDS):
        mixture = _likeliest(basis, along, parts, effective)
        mean_log, parts = mixture.mean_log(along, weights)
        if abs(mean_log - before) < SETTLED:
            break
        before = mean_log
    return mixture, mean_log


def _spread_out(along: np.ndarray, weights: np.ndarray, k: int, random: np.random.Generator) -> np.ndarray:
    """At most k of the points, far from each other (Arthur and Vassilvitskii 2007)."""
    chosen = [along[random.choice(len(along), p=weights)]]
    while len(chosen) < k:
        apart = np.min([np.sum((along - one) ** 2, axis=1) for one in chosen], axis=0) * weights
        if not apart.sum() > 0:
            break
        chosen.append(along[random.choice(len(along), p=apart / apart.sum())])
    return np.array(chosen)


def _likeliest(basis: np.ndarray, along: np.ndarray, parts: np.ndarray, effective: float) -> Mixture:
    """The components that these parts [k, n] of the points make likeliest; one with fewer than two points is left out.

    Covariances are drawn to 1, as by r + 2 points more, and are at least NARROWEST in all directions.
    """
    parts = parts[parts.sum(axis=1) * effective > 2] if len(parts) > 1 else parts
    if not len(parts):
        parts = np.full((1, len(along)), 1 / len(along))
    sums, r = parts.sum(axis=1), along.shape[1]
    means = parts @ along / sums[:, None]
    covariances = []
    for part, total, mean in zip(parts, sums, means, strict=True):
        apart = along - mean
        spread = effective * (part[:, None] * apart).T @ apart
        drawn = (spread + (r + 2) * np.eye(r)) / (effective * total + r + 2)
        variances, directions = np.linalg.eigh(drawn)
        covariances.append((directions * np.maximum(variances, NARROWEST)) @ directions.T)
    return Mixture(basis, sums / sums.sum(), means, np.array(covariances))
