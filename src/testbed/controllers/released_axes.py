"""Which axes the actuators can control in gusts, and which have to be given up: derived from the design model.

The authority over an axis is the largest rate, either way, that the actuators give within their stops while the other kept
axes stay as they are. The disturbance of an axis is the standard deviation of the rate that gusts cause, and that an inversion
has to cancel. A kept axis needs `MARGIN` times its disturbance: with less, its demands saturate the actuators in weather, and
every other axis loses with it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from testbed.aircraft.control_design import Axis
from testbed.aircraft.design_model import DesignModel
from testbed.common.cache import Cache
from testbed.common.signals import RATES

REFERENCE_W20_M_S = 7.62
"""Wind at 20 ft of the turbulence for which axes are chosen: 25 ft/s."""
GUST_STD_M_S = 0.1 * REFERENCE_W20_M_S
"""Standard deviation of each component of the gusts (MIL-F-8785C, 3.7.3.4: sigma_w = 0.1 W20)."""
MARGIN = {"p_dot": 3.0, "q_dot": 3.0, "r_dot": 3.0, "u_dot": 1.0}
"""Authority that a kept axis needs, in standard deviations of its disturbance. Airspeed changes slowly, and may be given up for
a moment; attitude may not."""


_DEPENDENT, _NONE = 1e-9, 1e-300  # less than these is no independent row, and no effect
_NEARLY = 0.95
"""Share of the authority that an axis needs with which it is still kept, if as many axes are given up as have to be: to lose the
axis would cost more than the missing authority."""


@dataclass(frozen=True)
class AxisAuthority:
    """What the actuators can do about one axis.

    Attributes:
        axis: one of `signals.RATES`.
        authority: largest rate that is available either way [rad/s2; u_dot m/s2].
        disturbance: standard deviation of the rate that gusts cause, same unit.
    """

    axis: str
    authority: float
    disturbance: float

    @property
    def suffices(self) -> bool:
        """Whether the axis can be kept."""
        return self.authority >= MARGIN[self.axis] * self.disturbance

    @property
    def ratio(self) -> float:
        """Authority in units of what is needed [1]."""
        return self.authority / (MARGIN[self.axis] * self.disturbance)


def gust_disturbance(model: DesignModel) -> np.ndarray:
    """[4] standard deviation of each rate of `signals.RATES` by gusts along the three body axes [rad/s2; u_dot m/s2].

    A gust w changes alpha by w/V, a gust v changes beta by v/V, and a gust u the dynamic pressure by 2 u/V.
    """
    angle = GUST_STD_M_S / model.airspeed_m_s
    columns = model.angle_slopes[:4].T
    surfaces = [kind == "servo" for kind in model.kinds]
    aerodynamic = np.array(model.bias)[:4] + np.array(model.input_matrix)[:4] @ np.multiply(
        surfaces, model.trim
    )
    return angle * np.sqrt(np.sum(np.square([*columns, 2.0 * aerodynamic]), axis=0))


def authorities(
    model: DesignModel, limits: np.ndarray, kept: Sequence[str], available: Sequence[int]
) -> tuple[AxisAuthority, ...]:
    """Authority and disturbance of each kept axis.

    Args:
        limits: [n, 2] stops [rad or N].
        kept: axes that are controlled together.
        available: indices of the actuators that remain.
    """
    used = list(available)
    travel = (limits - np.array(model.trim)[:, None])[used]
    rows = [RATES.index(axis) for axis in kept]
    inputs, disturbance = np.array(model.input_matrix)[:4, used], gust_disturbance(model)
    return tuple(
        AxisAuthority(
            RATES[row],
            _authority(inputs, row, [r for r in rows if r != row], travel),
            float(disturbance[row]),
        )
        for row in rows
    )


def _authority(inputs: np.ndarray, row: int, others: list[int], travel: np.ndarray) -> float:
    """Largest rate of a row within the travel, the lesser of both signs, with the other rows at zero."""
    scale = np.maximum(np.abs(travel).max(axis=1), 1e-9)
    low, high = np.minimum(travel[:, 0] / scale, 0.0), np.maximum(travel[:, 1] / scale, 0.0)
    effects = inputs * scale
    left = _left_of(effects[row], effects[others])
    return float(min(np.maximum(s * left * low, s * left * high).sum(axis=1).min() for s in (1.0, -1.0)))


def _left_of(row: np.ndarray, others: np.ndarray) -> np.ndarray:
    """[points, n] row - y A at each vertex y of the dual of "largest row u with A u = 0 within the travel", A the other rows.

    By duality that largest rate is the least, over all y, of what the travel gives of row - y A without any other condition.
    This is convex and piecewise linear in y, so its least value is where as many actuators as A has rows have nothing left.
    """
    norms = np.maximum(np.linalg.norm(others, axis=1, keepdims=True), _NONE)
    _, sizes, rows = np.linalg.svd(others / norms, full_matrices=False)
    basis = rows[sizes > _DEPENDENT]
    sets = list(combinations(range(len(row)), len(basis)))
    chosen = np.array(sets, dtype=int).reshape(len(sets), len(basis))
    matrices = np.moveaxis(basis[:, chosen], 0, -1)
    solvable = np.abs(np.linalg.det(matrices)) > _DEPENDENT
    y = np.linalg.solve(matrices[solvable], row[chosen][solvable][..., None])[..., 0]
    return np.asarray(row - y @ basis)


def axes_to_release(
    model: DesignModel, limits: np.ndarray, available: Sequence[int], priorities: Sequence[Axis]
) -> tuple[str, ...]:
    """The fewest axes to give up so that each kept one has the authority it needs, lowest priority first.

    Never more axes are kept than actuators remain. One axis more than that is given up only where `_NEARLY` of the need is not
    met without. Where that does not suffice either, the axes are kept whose worst ratio of authority to need is largest.

    Args:
        limits: [n, 2] stops [rad or N].
        available: indices of the actuators that remain.
        priorities: all axes, the most important first.
    """
    fewest = max(len(priorities) - len(available), 0)
    best, largest = tuple(reversed(priorities))[:fewest], -math.inf
    for released in _candidates(priorities, fewest):
        if len(released) > fewest and largest >= _NEARLY:
            break
        kept = [axis for axis in priorities if axis not in released]
        each = authorities(model, limits, kept, available)
        if all(one.suffices for one in each):
            best = released
            break
        worst = min(one.ratio for one in each)
        if len(released) == fewest and worst > largest:
            best, largest = released, worst
    return tuple(axis for axis in RATES if axis in best)


def _candidates(priorities: Sequence[Axis], fewest: int) -> Iterator[tuple[Axis, ...]]:
    """Sets of axes to give up, first of the fewest, then of one more; in each size the least important axes first."""
    for count in (fewest, fewest + 1):
        if count < len(priorities):
            yield from combinations(reversed(priorities), count)


_released: Cache[tuple[str, ...]] = Cache(32)


def released_from_start(
    model: DesignModel, limits: np.ndarray, priorities: Sequence[Axis]
) -> tuple[str, ...]:
    """Axes that `released: auto` gives up while no actuator is flagged as failed; arguments as in `axes_to_release`.

    The result is cached: all flights of a sweep share it.
    """
    key = (model, limits.tobytes(), tuple(priorities))
    every = range(len(model.actuators))
    return _released.get(key, lambda: axes_to_release(model, limits, every, priorities))
