"""The flight condition for trim and identification: from the stall speed, measured on the bench."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from testbed.adoption.bench import Bench
from testbed.common.units import METRES_PER_FOOT, NEWTONS_PER_POUND

_ALPHAS_DEG = range(-4, 21)
_FIRST_SPEED_M_S = 80.0
SPEEDS = (1.6, 1.4, 1.9, 2.3, 1.25, 2.8, 3.4)
"""Airspeeds to try, by the stall's, the usual one first."""


@dataclass(frozen=True)
class Size:
    """What the condition and the defaults of an aircraft follow from.

    Attributes:
        stall_m_s: least airspeed of level flight at `altitude_m`.
        stall_alpha_deg: angle of attack at it.
        span_m, weight_n, altitude_m: of the wing, of the aircraft, at which it was measured.
        lifts: rows (lift by the largest lift, angle of attack [rad]), ascending, without deflections.
    """

    stall_m_s: float
    stall_alpha_deg: float
    span_m: float
    weight_n: float
    altitude_m: float
    lifts: tuple[tuple[float, float], ...] = ()

    def alpha_at(self, airspeed_m_s: float) -> float:
        """Angle of attack of level flight [rad], with surfaces in the middle."""
        lift, alpha = np.array(self.lifts).T
        return float(np.interp((self.stall_m_s / airspeed_m_s) ** 2, lift, alpha))


def drag_n(bench: Bench, alpha_rad: float) -> float:
    """Drag in the present state of a bench [N]."""
    x, z = bench["forces/fbx-aero-lbs"], bench["forces/fbz-aero-lbs"]
    return -(x * math.cos(alpha_rad) + z * math.sin(alpha_rad)) * NEWTONS_PER_POUND


def measure_size(bench: Bench, altitude_m: float) -> Size | None:
    """Find the largest lift up to 20 deg of angle of attack; None when there is none upwards."""
    lifts = {}
    for alpha_deg in _ALPHAS_DEG:
        alpha = math.radians(alpha_deg)
        bench.place(_FIRST_SPEED_M_S, altitude_m, alpha)
        bench.settle(1.0 / bench.hz)
        x, z = bench["forces/fbx-aero-lbs"], bench["forces/fbz-aero-lbs"]
        lifts[alpha_deg] = x * math.sin(alpha) - z * math.cos(alpha)
    stall_deg = max(lifts, key=lambda alpha: lifts[alpha])
    weight, most = bench["inertia/weight-lbs"], lifts[stall_deg]
    if not most > 0.0:
        return None
    stall = _FIRST_SPEED_M_S * math.sqrt(weight / most)
    rows = sorted((lifts[alpha] / most, math.radians(alpha)) for alpha in _ALPHAS_DEG if alpha <= stall_deg)
    span = bench["metrics/bw-ft"] * METRES_PER_FOOT
    return Size(stall, float(stall_deg), span, weight * NEWTONS_PER_POUND, altitude_m, tuple(rows))
