"""Limit states with known failure probabilities, on which `testbed.failure_probability` is measured and tested.

Each takes [n, d] standard normals and fails at or below 0. A closed form is given where there is one; the others were
integrated numerically.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy import integrate, stats

LimitState = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Case:
    """A limit state with its dimensions and its failure probability, and the distance of its smallest failure."""

    limit_state: LimitState
    dimensions: int
    probability: float
    distance: float


def linear(dimensions: int, probability: float) -> Case:
    """A half space, seen from none of the axes: b - sum(u) / sqrt(d)."""
    b = float(stats.norm.isf(probability))
    return Case(lambda u: b - u.sum(axis=1) / math.sqrt(dimensions), dimensions, probability, b)


def series(dimensions: int, parts: int, b: float) -> Case:
    """Fails when any of the parts does: min(b - u_i)."""
    probability = -math.expm1(parts * math.log(stats.norm.cdf(b)))
    return Case(lambda u: np.min(b - u[:, :parts], axis=1), dimensions, probability, b)


def parallel(dimensions: int, parts: int, b: float) -> Case:
    """Fails when all of the parts do: max(b - u_i)."""
    probability = float(stats.norm.sf(b)) ** parts
    return Case(lambda u: np.max(b - u[:, :parts], axis=1), dimensions, probability, b * math.sqrt(parts))


def two_sided(dimensions: int, b: float, c: float) -> Case:
    """Two failure regions that do not touch: min(b - u_1, c + u_1), b below c."""
    probability = float(stats.norm.sf(b) + stats.norm.sf(c))
    return Case(lambda u: np.minimum(b - u[:, 0], c + u[:, 0]), dimensions, probability, b)


def sphere(dimensions: int, radius: float) -> Case:
    """Every direction fails alike: radius^2 - |u|^2."""
    probability = float(stats.chi2.sf(radius**2, dimensions))
    return Case(lambda u: radius**2 - np.sum(u**2, axis=1), dimensions, probability, radius)


def quadratic(dimensions: int, b: float, curvature: float) -> Case:
    """A curved surface: b - u_1 + curvature u_2^2."""
    probability = _over_normal(lambda x: stats.norm.sf(b + curvature * x**2))
    return Case(lambda u: b - u[:, 0] + curvature * u[:, 1] ** 2, dimensions, probability, b)


def four_branch(dimensions: int = 2, a: float = 3.0) -> Case:
    """The series system of four branches (Waarts 2000): two curved, at a, and two straight, at a + 1/2.

    2.22e-3 as it is published, with a = 3; 1e-5 with a = FOUR_BRANCH_1E5. Further coordinates do not matter.
    """
    probability = _over_normal(lambda x: _branches_at(x, a), (-a - 0.5, a + 0.5))
    return Case(lambda u: _four(u[:, 0], u[:, 1], a), dimensions, probability, a)


FOUR_BRANCH_1E5 = 4.333998104547023


def _four(x: np.ndarray, y: np.ndarray, a: float) -> np.ndarray:
    curved, along, across = a + 0.1 * (x - y) ** 2, (x + y) / math.sqrt(2), x - y
    straight = (2 * a + 1) / math.sqrt(2)
    return np.minimum.reduce([curved - along, curved + along, straight + across, straight - across])


def _branches_at(across: float, a: float) -> float:
    """Probability of failure where (x - y) / sqrt(2) is `across`, over (x + y) / sqrt(2)."""
    return 1.0 if abs(across) >= a + 0.5 else float(2 * stats.norm.sf(a + 0.2 * across**2))


def _over_normal(inner: Callable[[float], float], kinks: tuple[float, ...] = (0.0,)) -> float:
    """Mean of a function of one standard normal."""
    mean = integrate.quad(
        lambda x: inner(x) * stats.norm.pdf(x), -12, 12, limit=500, points=kinks, epsabs=1e-14
    )
    return float(mean[0])
