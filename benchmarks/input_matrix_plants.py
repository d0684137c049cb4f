"""Random plants within the certificate of the input matrix, with the law that flies: does any diverge or break its bound?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from paper.ideal import IdealLoop, IdealPlant, Tuning
from paper.input_matrix import equilibrium

from testbed.margins.bounds import certified_range, error_bound, largest_ratios, mismatch, sector_bias
from testbed.margins.matrix_classes import spectral_radius

GAMMA, DT_S = 2.0, 0.01
PHASES, JUMPS, JUMP_STEPS = 6, 24, 50
"""The effectiveness jumps 5 times; within each phase, r jumps 24 times, every half second."""
LONGEST_S = 400.0
"""A constant r is flown for so long at most, after the phases."""
ROUNDING = 1e-9


@dataclass(frozen=True)
class Drawn:
    """A plant with |B_c - B_mc| <= Delta, and references of a sector in which each estimate's bias is bounded by beta < 1."""

    b_mc: np.ndarray
    b_c: np.ndarray
    references: np.ndarray
    beta: np.ndarray


@dataclass(frozen=True)
class Found:
    """What happened to one plant.

    Attributes:
        beta: the largest bound of the bias.
        finite: whether all estimates stayed finite.
        overshoot: largest ratio of an estimate's shortfall to the bound that the comparison system gives; at most 1.
        left: whether an estimate that was within its bound left it while the effectiveness was constant.
        off: largest relative distance from the equilibrium at the end of a constant r.
        bias: least and largest lam_hat / lam at that end.
    """

    beta: float
    finite: bool
    overshoot: float
    left: bool
    off: float
    bias: tuple[float, float]


def draw(rng: np.random.Generator) -> Drawn:
    """B_mc normal; Delta of random shape, so large that the largest bound is between 0.05 and 0.95; B_c at a vertex or inside."""
    b_mc, delta = rng.normal(size=(4, 4)), rng.random((4, 4))
    directions = np.exp(rng.normal(size=4)) * rng.choice([-1.0, 1.0], 4)
    references = directions * np.exp(rng.uniform(-0.5, 0.5, (PHASES * JUMPS, 4)) * rng.random())
    ratios, e = largest_ratios(references), error_bound(b_mc, delta)
    target = rng.uniform(0.05, 0.95)
    low, high = 0.0, 1.0 / spectral_radius(e * ratios)
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if sector_bias(middle * e, ratios).max() < target else (low, middle)
    where = rng.choice([-1.0, 1.0], (4, 4)) if rng.random() < 0.5 else rng.uniform(-1.0, 1.0, (4, 4))
    return Drawn(b_mc, b_mc + low * delta * where, references, sector_bias(low * e, ratios))


def fly_one(drawn: Drawn, rng: np.random.Generator, outside: float = 1.0) -> Found:
    """Adapt to one plant, without projection: effectiveness and references jump, and then stay.

    Args:
        outside: factor on the first reference, which with anything but 1 leaves the sector: a negative control.
    """
    beta, r = drawn.beta, drawn.references * [outside, 1.0, 1.0, 1.0]
    low, high = certified_range(beta)
    lam = rng.uniform(0.05, 1.0, 4)
    plant = IdealPlant(drawn.b_mc, B_c=drawn.b_c)
    loop = IdealLoop(plant, Tuning(GAMMA, 1e-3, DT_S), lam * np.exp(rng.uniform(-2.0, 3.0, 4)))
    overshoot, left, finite = 0.0, False, True
    for phase in range(PHASES):
        if phase:
            lam = np.where(rng.random(4) < 0.5, rng.uniform(0.05, 1.0, 4), lam)
        rows = np.repeat(r[phase * JUMPS : (phase + 1) * JUMPS], JUMP_STEPS, axis=0)
        y = lam / loop.fly(rows, lam).lambda_hat
        highest = np.max(y / (1.0 + beta), axis=1)
        overshoot = max(overshoot, float(highest.max() / max(highest[0], 1.0)))
        inside = np.all((1.0 / y >= low * (1 - ROUNDING)) & (1.0 / y <= high * (1 + ROUNDING)), axis=1)
        left |= bool(np.any(np.diff(inside.astype(int)) < 0))
        finite &= bool(np.all(np.isfinite(1.0 / y)))
    star = equilibrium(mismatch(drawn.b_mc, drawn.b_c), lam, r[-1])
    off = np.inf
    for _ in range(int(LONGEST_S / 20.0)):
        end = loop.fly(np.tile(r[-1], (int(20.0 / DT_S), 1)), lam).lambda_hat[-1]
        off = float(np.abs(end / star - 1.0).max())
        if off < 1e-4:
            break
    bias = end / lam
    return Found(float(beta.max()), finite, overshoot, left, off, (float(bias.min()), float(bias.max())))


def study(count: int, seed: int = 1) -> list[Found]:
    """`fly_one` of this many random plants; plant i depends on the seed and on i alone."""
    found = []
    for i in range(count):
        rng = np.random.default_rng([seed, i])
        found.append(fly_one(draw(rng), rng))
    return found
