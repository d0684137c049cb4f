"""The root of a function of one number in a bracket, without scipy.optimize: importing that takes a tenth of a run."""

from __future__ import annotations

from collections.abc import Callable

_WITHIN, _RELATIVE, _MOST = 2e-12, 4.0 * 2.0**-52, 100
"""Tolerances and most steps, as `scipy.optimize.brentq` has them by default: it gives the same root, to the last bit."""


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
