"""What is measured on the bench: the stall speed, from which the flight condition follows, and what the pilot's sticks move."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from testbed.adoption.bench import Bench
from testbed.adoption.wiring import STICKS
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


MOVED = 1e-6
"""Change of a property that counts as one."""
_GRID = (-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0, 0.0)
_HOLD_S = 2.5  # in which servos reach their place


@dataclass(frozen=True)
class StickSweep:
    """Values of properties while one stick after another is moved: by stick, [positions of the stick, properties]."""

    names: list[str]
    values: dict[str, list[list[float]]]

    def curve(self, stick: str, name: str) -> list[tuple[float, float]]:
        """(stick, value), ascending."""
        column = self.names.index(name)
        return sorted((at, row[column]) for at, row in zip(_GRID, self.values[stick], strict=True))

    def every(self, name: str) -> list[float]:
        """All values of a property."""
        column = self.names.index(name)
        return [row[column] for rows in self.values.values() for row in rows]

    def spread(self, name: str) -> float:
        """Largest less smallest value of a property."""
        return max(self.every(name)) - min(self.every(name))

    def stick_of(self, names: Sequence[str]) -> str | None:
        """The stick that steers one of these properties furthest, relative to its whole travel."""
        best, furthest = None, 0.0
        for name in names:
            for stick in STICKS:
                if self._steers(stick, name) and self._travel(stick, name) / self.spread(name) > furthest:
                    best, furthest = stick, self._travel(stick, name) / self.spread(name)
        return best

    def _travel(self, stick: str, name: str) -> float:
        values = [value for _, value in self.curve(stick, name)]
        return max(values) - min(values)

    def _steers(self, stick: str, name: str) -> bool:
        """Whether the stick moves it to both sides of where it is with the stick in the middle: flaps that come up with the stick
        on either side, or an autopilot's saturation, are no control."""
        curve = dict(self.curve(stick, name))
        up, down = curve[1.0] - curve[0.0], curve[-1.0] - curve[0.0]
        return up * down < 0.0 and min(abs(up), abs(down)) > MOVED


def swept(bench: Bench, names: list[str]) -> StickSweep:
    """Move each stick of a bench through its travel, and read these properties."""
    read = bench.reader(names)
    values = {}
    for stick, command in STICKS.items():
        rows = []
        for at in _GRID:
            bench[command] = at
            bench.settle(_HOLD_S)
            rows.append(read())
        values[stick] = rows
    return StickSweep(names, values)
