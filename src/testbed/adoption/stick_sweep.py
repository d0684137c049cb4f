"""The pilot's sticks moved through their travel on the bench, and what follows them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from testbed.adoption.bench import Bench
from testbed.adoption.wiring import STICKS

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
