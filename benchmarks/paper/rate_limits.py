"""What a rate limit of a servo does to (13): its describing function, and the readings that follow from it.

Words as in `paper.bandwidth`. The describing function is that of Gelb and Vander Velde, Multiple-Input Describing
Functions and Nonlinear System Design (1968), for an element that follows its input as fast as R.
"""

from __future__ import annotations

import cmath
import math

import numpy as np
from scipy.optimize import brentq

from paper.bandwidth import offset_reading_within

FULLY_RATE_LIMITED = 1.0 / math.sqrt(1.0 + (math.pi / 2.0) ** 2)
"""R / (A w) below which a rate limit R makes a triangle of the sine A sin(w t): it never meets the sine's own slope."""


def rate_limited(share: float) -> complex:
    """Response of a rate limit R to A sin(w t), its describing function, with share = R / (A w).

    From where the sine becomes faster than R the position is a line, until it meets the sine again. Below FULLY_RATE_LIMITED it
    never does: the position is a triangle of amplitude pi R / (2 w), late by arccos(pi share / 2). The phase is that of a lag of
    -tan(arg) / w, which grows with the amplitude.
    """
    if share >= 1.0 - 1e-9:  # so near the limit the line and the sine differ by less than rounding
        return 1.0 + 0.0j
    if share <= FULLY_RATE_LIMITED:
        late = math.acos(0.5 * math.pi * share)
        return 4.0 * share / math.pi * cmath.exp(-1j * late)
    begin = math.pi - math.acos(share)
    top = math.sin(begin) + share * begin
    first = begin + math.sin(begin)  # they meet at about three times this way from `begin`, where they touch
    end = float(brentq(lambda x: top - share * x - math.sin(x), first, begin + math.pi))
    found = _line(end, top, share) - _line(begin, top, share) + _sine(begin + math.pi) - _sine(end)
    return 2.0 / math.pi * found


def _line(x: float, top: float, share: float) -> complex:
    """Integral of (top - share x) (sin x + j cos x)."""
    y = top - share * x
    return complex(-y * math.cos(x) - share * math.sin(x), y * math.sin(x) - share * math.cos(x))


def _sine(x: float) -> complex:
    """Integral of sin x (sin x + j cos x)."""
    return complex(0.5 * x - 0.25 * math.sin(2.0 * x), 0.5 * math.sin(x) ** 2)


def rate_limited_offset_reading(
    share: float, limit: float, servo: complex = 1.0, modelled: complex = 1.0
) -> float:
    """Reading of r_0 (1 + share sin w t) wholly within epsilon, behind a servo with an unmodelled rate limit R.

    The amplitude of the command is share |r_0| / lambda_hat, so the reading x is that of `offset_reading_within` for the response
    at x. The largest x that solves it is where an estimate that begins at the truth ends. As the offset is seen in full, x is at
    least 1 / (1 + share^2 / 2).

    Args:
        limit: lambda R / (share |r_0| w), the rate limit over the fastest command of a right estimate.
        servo: response of the servo before the limit.
        modelled: response of its model.
    """
    moving = share * abs(modelled)

    def excess(x: float) -> float:
        actual = servo * rate_limited(limit * x / abs(servo))
        return offset_reading_within(actual / modelled, moving) - x

    grid = np.linspace(1.2, 0.0, 1201)
    below = next((k for k, x in enumerate(grid) if excess(float(x)) >= 0.0), len(grid) - 1)
    return float(brentq(excess, grid[below], grid[below - 1])) if below else float(grid[0])


def rate_limited_reading(share: float) -> float:
    """Reading of A sin(w t) within epsilon behind an unmodelled rate limit R, with share = R / (A w): the in-phase part.

    Of a triangle it is 2 share^2. Since A = |r| / lambda_hat grows as the estimate falls, this is no equilibrium that holds (see
    `rate_limit_trap`).
    """
    return rate_limited(share).real


def rate_limit_trap(amplitude: float, w: float, rate: float, truth: float) -> float:
    """Estimate below which an unmodelled rate limit drives the plain law's estimate to zero: (|r| w)^2 / (2 lambda R^2).

    `rate_limited_reading` with A = |r| / lambda_hat gives lambda_hat = lambda 2 (R lambda_hat / (|r| w))^2. This does not hold:
    below it the command is larger, and the reading smaller still.
    """
    return (amplitude * w) ** 2 / (2.0 * truth * rate**2)
