"""Roots: of a function of one number in a bracket; and of a system of equations, the one within bounds that is nearest to a
preferred point.

Both do without scipy.optimize as far as they can: importing that takes a tenth of a run.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

_STEP = 3e-3
"""Of the differences for the Jacobian, in the unknowns' own scale."""
SMALLEST = 1e-11
"""Default of the sum of the residual and of the last change of the unknowns at which the search ends."""
_RANK = 1e-8  # singular values below this fraction of the largest count as zero
_ITERATIONS, _FARTHEST_STEP = 40, 2.0
_PREFERENCE = 2e-3
"""Weight of the preferred point in the least-squares search that is made from where Newton's method ends without a root."""

_WITHIN, _RELATIVE, _MOST = 2e-12, 4.0 * 2.0**-52, 100
"""Tolerances and most steps, as `scipy.optimize.brentq` has them by default: it gives the same root, to the last bit."""

Vector = np.ndarray


def bracketed_root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function is zero, by Brent's method (Brent, Algorithms for Minimization without Derivatives, 1973, chapter 4).

    Args:
        low, high: points at which the function has opposite signs, or is zero at one.
    """
    before, best, f_before, f_best = low, high, function(low), function(high)
    if f_before == 0.0:
        return before
    other, f_other = before, f_before  # with `best` on both sides of the root
    last = step = best - before
    for _ in range(_MOST):
        if f_before != 0.0 and (f_before > 0.0) != (f_best > 0.0):
            other, f_other, last, step = before, f_before, best - before, best - before
        if abs(f_other) < abs(f_best):
            before, best, other = best, other, best
            f_before, f_best, f_other = f_best, f_other, f_best
        near, half = (_WITHIN + _RELATIVE * abs(best)) / 2.0, (other - best) / 2.0
        if f_best == 0.0 or abs(half) < near:
            break
        last, step = _next_step((before, best, other), (f_before, f_best, f_other), (last, step), near)
        before, f_before = best, f_best
        best += step if abs(step) > near else (near if half > 0.0 else -near)
        f_best = function(best)
    return best


def _next_step(
    x: tuple[float, float, float], f: tuple[float, float, float], steps: tuple[float, float], near: float
) -> tuple[float, float]:
    """(last, step): by interpolation if that converges fast enough, else half of the bracket."""
    (before, best, other), (f_before, f_best, f_other), (last, step) = x, f, steps
    half = (other - best) / 2.0
    if not (abs(last) > near and abs(f_best) < abs(f_before)):
        return half, half
    if before == other:  # linear
        tried = -f_best * (best - before) / (f_best - f_before)
    else:  # inverse quadratic
        to_before, to_other = (f_before - f_best) / (before - best), (f_other - f_best) / (other - best)
        tried = -f_best * (f_other * to_other - f_before * to_before)
        tried /= to_other * to_before * (f_other - f_before)
    return (step, tried) if 2.0 * abs(tried) < min(abs(last), 3.0 * abs(half) - near) else (half, half)


@dataclass(frozen=True)
class NearestRoot:
    """Of the x with f(x) = 0 and low <= x <= high, the one with the smallest sum of (weight (x - preferred(x)))^2.

    Newton's method with the weighted pseudo-inverse of the Jacobian, which is updated by Broyden's formula; an unknown at a bound
    stays there. With as many equations as unknowns it is Newton's method.

    Attributes:
        function: f, of x [n].
        low, high: [n] bounds.
        weight: [n], above zero.
        preferred: the preferred point [n], which may depend on x (that of the step before is used).
        enough: sum of the residual and of the last change of the unknowns at which the search ends.
        noise: error of the function. A difference below it teaches nothing about the Jacobian.
        coarse: the same problem with a cheaper, less exact function, and the tolerance of its roots. The search is then made with
            that, and goes on with the exact one from its root and with its Jacobian.
    """

    function: Callable[[Vector], Vector]
    low: Vector
    high: Vector
    weight: Vector
    preferred: Callable[[Vector], Vector]
    enough: float = SMALLEST
    noise: float = 0.0
    coarse: tuple[NearestRoot, float] | None = None

    def find(self, guess: Vector, tolerance: float, thorough: bool = True) -> Vector:
        """The x [n] that was found; it is a root only if the function is small there.

        Args:
            tolerance: largest element of the function at a root.
            thorough: whether to search on by least squares where Newton's method ends without a root.

        Where the function or its Jacobian is not finite, the search ends.
        """
        return self._search(np.clip(guess, self.low, self.high), tolerance, thorough)[0]

    def _search(self, x: Vector, tolerance: float, thorough: bool) -> tuple[Vector, Vector, Vector]:
        """The x that was found, the function and its Jacobian there."""
        jacobian = None
        if self.coarse is not None:
            near, enough = self.coarse
            x, f, jacobian = near._search(x, enough, thorough)
            if np.max(np.abs(f)) >= enough:
                return x, f, jacobian
        x, f, jacobian = self._newton(x, tolerance, jacobian)
        if thorough and np.max(np.abs(f)) >= tolerance and np.isfinite(jacobian).all():
            x, f, jacobian = self._newton(self._least_squares(x), tolerance)
        return x, f, jacobian

    def _newton(
        self, x: Vector, tolerance: float, jacobian: Vector | None = None
    ) -> tuple[Vector, Vector, Vector]:
        """The root, the function and the Jacobian there; `jacobian` is the one to begin with, if it is known.

        The search may pass one root and then fail to reach a nearer one: then the last root that it passed is returned.
        """
        f, fresh, root = self.function(x), jacobian is None, None
        jacobian = self._jacobian(x, f) if jacobian is None else jacobian
        for _ in range(_ITERATIONS):
            if not np.isfinite(jacobian).all():
                break
            if np.max(np.abs(f)) < tolerance:
                root = x, f, jacobian
            step = self._step(x, f, jacobian)
            x_next, f_next = self._shortened(x, f, step)
            if x_next is None or f_next is None:
                if fresh:
                    break
                jacobian, fresh = self._jacobian(x, f), True
                continue
            moved = x_next - x
            unexpected = f_next - f - jacobian @ moved
            if np.linalg.norm(unexpected) > self.noise:
                jacobian = jacobian + np.outer(unexpected, moved) / (moved @ moved)
            x, f, fresh = x_next, f_next, False
            if np.max(np.abs(f)) + np.max(np.abs(moved)) < self.enough:
                break
        return root if root is not None and np.max(np.abs(f)) >= tolerance else (x, f, jacobian)

    def _jacobian(self, x: Vector, f: Vector) -> Vector:
        columns = []
        for i in range(len(x)):
            step = np.zeros(len(x))
            step[i] = _STEP if x[i] + _STEP <= self.high[i] else -_STEP
            columns.append((self.function(x + step) - f) / step[i])
        return np.array(columns).T

    def _step(self, x: Vector, f: Vector, jacobian: Vector) -> Vector:
        """Newton's step to the root of the linear system that is nearest to the preferred point, within the bounds."""
        away = x - self.preferred(x)
        step, free = np.zeros(len(x)), np.ones(len(x), bool)
        while free.any():
            scaled = jacobian[:, free] / self.weight[free]
            target = scaled @ (self.weight * away)[free] - f - jacobian[:, ~free] @ step[~free]
            nearest = np.linalg.lstsq(scaled, target, rcond=_RANK)[0] / self.weight[free]
            step[free] = nearest - away[free]
            excess = np.where(free, np.maximum(self.low - x - step, x + step - self.high), -np.inf)
            worst = int(np.argmax(excess))
            if excess[worst] <= 1e-12:
                break
            step[worst] = np.clip(x[worst] + step[worst], self.low[worst], self.high[worst]) - x[worst]
            free[worst] = False
        return step * min(1.0, _FARTHEST_STEP / max(np.max(np.abs(step)), 1e-12))

    def _shortened(self, x: Vector, f: Vector, step: Vector) -> tuple[Vector | None, Vector | None]:
        """The first point along the step with a small enough residual, and its residual; None if there is none.

        It must be smaller than before, or small compared with the step: near a root, the way to the nearest one leaves it.
        """
        size = float(np.linalg.norm(f))
        if np.max(np.abs(step)) < 1e-13:
            return None, None
        for fraction in (1.0, 0.5, 0.25, 0.1, 0.03):
            there = np.clip(x + fraction * step, self.low, self.high)
            value = self.function(there)
            enough = max((1.0 - 0.1 * fraction) * size, 0.1 * fraction * float(np.linalg.norm(step)))
            if np.linalg.norm(value) < enough:
                return there, value
        return None, None

    def _least_squares(self, x: Vector) -> Vector:
        """Where the function and the distance from the preferred point are smallest."""
        from scipy.optimize import least_squares

        def residual(at: Vector) -> Vector:
            away = self.weight * (at - self.preferred(at))
            return np.concatenate([self.function(at), _PREFERENCE * away])

        def jacobian(at: Vector) -> Vector:
            return np.vstack([self._jacobian(at, self.function(at)), _PREFERENCE * np.diag(self.weight)])

        inside = np.clip(x, self.low + 1e-6, self.high - 1e-6)
        found = least_squares(
            residual, inside, jacobian, bounds=(self.low, self.high), max_nfev=40,
            xtol=max(1e-6, self.enough), ftol=max(1e-8, self.enough),
        )  # fmt: skip
        return np.asarray(found.x)
