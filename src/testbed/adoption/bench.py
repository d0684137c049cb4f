"""A model on JSBSim's bench: held in a flight state while its flight control and engines run, before it is an aircraft here."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from testbed.adoption.wiring import STICKS
from testbed.common import writing
from testbed.common.units import METRES_PER_FOOT, NEWTONS_PER_POUND
from testbed.plant.jsbsim import EngineError, engine_errors, opened
from testbed.plant.properties import INTEGRATORS

HZ = 120.0
_MISSING = re.compile(
    r"property ['\"]?(?:fdm/jsbsim/)?([A-Za-z_][^\s'\"]*?)['\"]? (?:does not exist|is not defined|not found)"
)
_MISSING_MAX = 200
_ALPHAS_DEG = range(-4, 21)
_FIRST_SPEED_M_S = 80.0
SPEEDS = (1.6, 1.4, 1.9, 2.3, 1.25, 2.8, 3.4)
"""Airspeeds to try, by the stall's, the usual one first."""
MOVED = 1e-6
"""Change of a property that counts as one."""
_GRID = (-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0, 0.0)
_HOLD_S = 2.5  # in which servos reach their place


class Bench:
    """A loaded model, held where `place` puts it.

    Args:
        folder: of the model's XML, and of its engines' in `Engines`.
        model: name of the model.

    Raises:
        EngineError: JSBSim does not load or start it.

    Attributes:
        missing: properties that functions read and nobody provides. They are made, with the value 0.
    """

    def __init__(self, folder: Path, model: str) -> None:
        self._fdm, words = opened(folder, model, HZ)
        self._manager = self._fdm.get_property_manager()
        self.missing: list[str] = []
        for _ in range(_MISSING_MAX):
            try:
                with engine_errors():
                    self._fdm.run_ic()
                return
            except EngineError as error:
                found = _MISSING.search(one_line(f"{error} {' '.join(words[-3:])}"))
                if found is None:
                    raise
                self._fdm[found[1]] = 0.0
                self.missing.append(found[1])
        raise EngineError(f"more than {_MISSING_MAX} properties are missing")

    def place(self, airspeed_m_s: float, altitude_m: float, alpha_rad: float = 0.0) -> None:
        """Level flight at this state; engines and actuators keep theirs."""
        fdm, speed = self._fdm, airspeed_m_s / METRES_PER_FOOT
        for name, value in (
            ("ic/lat-geod-deg", 0.0), ("ic/long-gc-deg", 0.0), ("ic/h-sl-ft", altitude_m / METRES_PER_FOOT),
            ("ic/psi-true-rad", 0.0), ("ic/phi-rad", 0.0), ("ic/theta-rad", alpha_rad),
            ("ic/u-fps", speed * math.cos(alpha_rad)), ("ic/v-fps", 0.0), ("ic/w-fps", speed * math.sin(alpha_rad)),
        ):  # fmt: skip
            fdm[name] = value
        fdm.run_ic()
        for name in INTEGRATORS:  # held from here on
            fdm[name] = 0

    def settle(self, seconds: float) -> None:
        """Let flight control and engines run while the airframe is held."""
        for _ in range(round(seconds * HZ)):
            self._fdm.run()

    def has(self, name: str) -> bool:
        return bool(self._manager.hasNode(name))

    def reader(self, names: list[str]) -> Callable[[], list[float]]:
        """Function that reads these properties; one that does not exist reads 0."""
        nodes = [self._manager.get_node(name) if self.has(name) else None for name in names]
        return lambda: [node.get_double_value() if node else 0.0 for node in nodes]

    def set(self, values: Mapping[str, float]) -> None:
        for name, value in values.items():
            self._fdm[name] = value

    def __getitem__(self, name: str) -> float:
        return float(self._fdm.get_property_value(name))

    def __setitem__(self, name: str, value: float) -> None:
        self._fdm[name] = value


def one_line(text: str) -> str:
    """JSBSim's words without colours and line breaks."""
    return " ".join(re.sub(r"\x1b\[[0-9;]*m", "", text).split())


def write(folder: Path, model: str, tree: ET.Element) -> None:
    """Write a model where `Bench` finds it."""
    writing.write(folder / f"{model}.xml", ET.tostring(tree, encoding="unicode"))


# What is measured on it: the stall speed, from which the flight condition follows, and what the sticks move ------


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
        bench.settle(1.0 / HZ)
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
