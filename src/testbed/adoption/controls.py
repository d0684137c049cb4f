"""Find the surfaces that a model's flight control moves and its aerodynamics read, by moving its sticks on the bench."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from testbed.adoption.bench import Bench
from testbed.adoption.components import Dynamics, dynamics_of, range_of

STICKS = {axis: f"fcs/{axis}-cmd-norm" for axis in ("elevator", "aileron", "rudder")}
"""JSBSim's own names of the pilot's controls."""

_READERS = ("aerodynamics", "external_reactions")
_NAMED = re.compile(r"elevator|aileron|rudder|elevon|stabilator|taileron|ruddervator|canard|flaperon|tvc")
# What has a setting and not a stick; a `mix` is a sum of surfaces that are read on their own.
_NO_CONTROL = re.compile(
    r"flap-|flaps|spoiler|speedbrake|speed-brake|slat|lef-|gear|throttle|mixture|brake|-mix"
)
_PARTS = re.compile(
    r"^fcs/(?P<mag>mag-)?(?P<base>.*?)(?:-(?:pos|cmd|position))?(?:-(?P<unit>rad|deg|norm))?$"
)
_GRID = (-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0, 0.0)
_HOLD_S = 2.5
_MOVED = 1e-6
_SAME_RAD = 1e-4
_NOMINAL_RAD = math.radians(20.0)
"""Deflection that a fraction of 1 is called, where the model knows only fractions."""
_PER_RAD = {"rad": 1.0, "deg": math.degrees(1.0)}


@dataclass(frozen=True)
class Reading:
    """A property that aerodynamics read, as a function of the surface's deflection.

    Attributes:
        name: of the property.
        table: rows (deflection [rad], value), ascending; empty where it is the deflection times `gain`, or its magnitude.
    """

    name: str
    gain: float = 1.0
    magnitude: bool = False
    table: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Surface:
    """One surface that can be controlled, or several that the model moves as one.

    Attributes:
        name: of the actuator, such as `left_aileron`.
        readings: what the aerodynamics read of it.
        travel: lowest and highest deflection [rad].
        stick: which of `STICKS` moves it most; None where only its name says that it is a control.
        dynamics: its lag and rate limit, as far as the model has them.
        nominal: whether radians are ours, because the model has only fractions.
    """

    name: str
    readings: tuple[Reading, ...]
    travel: tuple[float, float]
    stick: str | None
    dynamics: Dynamics = field(default_factory=Dynamics)
    nominal: bool = False


def properties_read(tree: ET.Element) -> list[str]:
    """Properties below `fcs/` that aerodynamics and external reactions read, in the order of the file, each once."""
    return list(dict.fromkeys(name for name, _ in places_read(tree)))


def places_read(tree: ET.Element) -> Iterator[tuple[str, ET.Element]]:
    """(name, element) of each place where aerodynamics or external reactions read a property below `fcs/`."""
    for section in (each for each in tree if each.tag in _READERS):
        for element in section.iter():
            name = bare(element.text) if element.tag in ("property", "p", "independentVar") else ""
            if name.startswith("fcs/"):
                yield name, element


def bare(text: str | None) -> str:
    """A property's name without sign and without the index of the first of several."""
    return (text or "").strip().lstrip("-").removesuffix("[0]")


@dataclass(frozen=True)
class _Sweep:
    """Values of properties while one stick after another is moved: by stick, [positions of `_GRID`, properties]."""

    names: list[str]
    values: dict[str, list[list[float]]]

    def curve(self, stick: str, name: str) -> list[tuple[float, float]]:
        """(stick, value), ascending."""
        column = self.names.index(name)
        return sorted((at, row[column]) for at, row in zip(_GRID, self.values[stick], strict=True))

    def every(self, name: str) -> list[float]:
        column = self.names.index(name)
        return [row[column] for rows in self.values.values() for row in rows]

    def travel(self, stick: str, name: str) -> float:
        values = [value for _, value in self.curve(stick, name)]
        return max(values) - min(values)

    def steers(self, stick: str, name: str) -> bool:
        """Whether the stick moves it to both sides of where it is with the stick in the middle: flaps that come up with
        the elevator on either side, or an autopilot's saturation, are no control."""
        curve = dict(self.curve(stick, name))
        up, down = curve[1.0] - curve[0.0], curve[-1.0] - curve[0.0]
        return up * down < 0.0 and min(abs(up), abs(down)) > _MOVED


def _swept(bench: Bench, names: list[str]) -> _Sweep:
    read = bench.reader(names)
    values = {}
    for stick, command in STICKS.items():
        rows = []
        for at in _GRID:
            bench[command] = at
            bench.settle(_HOLD_S)
            rows.append(read())
        values[stick] = rows
    return _Sweep(names, values)


def find_surfaces(tree: ET.Element, bench: Bench) -> list[Surface]:
    """The surfaces of a model, in the order elevator, aileron, rudder sticks; the bench holds it in flight."""
    groups: dict[str, list[str]] = {}
    for name in properties_read(tree):
        parts = _PARTS.match(name)
        assert parts is not None
        groups.setdefault(parts["base"], []).append(name)
    native = [f"fcs/{base}-pos-{unit}" for base in groups for unit in ("rad", "deg", "norm")]
    names = list(dict.fromkeys([name for group in groups.values() for name in group] + native))
    sweep = _swept(bench, names)
    surfaces = []
    for base, group in groups.items():
        stick = _stick(sweep, [*group, *(f"fcs/{base}-pos-{unit}" for unit in ("rad", "deg", "norm"))])
        if (stick is None and not _NAMED.search(base)) or _NO_CONTROL.search(base + "-"):
            continue
        surfaces.append(_surface(tree, sweep, base, group, stick))
    return _renamed(sorted(surfaces, key=lambda each: _order(each.stick, each.name)))


def _order(stick: str | None, name: str) -> tuple[int, str]:
    return (list(STICKS).index(stick) if stick else len(STICKS)), name


def _stick(sweep: _Sweep, names: Sequence[str]) -> str | None:
    """The stick that steers one of these properties furthest, relative to its whole travel."""
    best, furthest = None, 0.0
    for name in names:
        whole = max(sweep.every(name)) - min(sweep.every(name))
        for stick in STICKS:
            if sweep.steers(stick, name) and sweep.travel(stick, name) / whole > furthest:
                best, furthest = stick, sweep.travel(stick, name) / whole
    return best


def _surface(tree: ET.Element, sweep: _Sweep, base: str, group: list[str], stick: str | None) -> Surface:
    primary, unit = _primary(tree, sweep, base, group)
    per_rad = _PER_RAD.get(unit, 1.0 / _NOMINAL_RAD)
    low, high = _travel(tree, sweep, primary, per_rad)
    alive = [
        name for name in group if stick is None or _spread(sweep, name) > _MOVED
    ]  # what nobody writes stays as it is
    readings = tuple(_reading(sweep, name, primary, per_rad, stick, (low, high)) for name in alive)
    dynamics = dynamics_of(tree, primary, (low, high))
    return Surface(
        base.replace("-", "_").replace("/", "_"), readings, (low, high), stick, dynamics, unit == "norm"
    )


def _primary(tree: ET.Element, sweep: _Sweep, base: str, group: list[str]) -> tuple[str, str]:
    """The property that stands for the deflection, and its unit: in radians if there is one that moves, else degrees, else
    fractions of the full deflection."""
    for unit in ("rad", "deg", "norm"):
        for name in (
            f"fcs/{base}-pos-{unit}",
            *(n for n in group if n.endswith(f"-{unit}") and "/mag-" not in n),
        ):
            if name in sweep.names and (_spread(sweep, name) > _MOVED or range_of(tree, name)):
                return name, unit
    first = (
        next(name for name in group if "/mag-" not in name)
        if any("/mag-" not in n for n in group)
        else group[0]
    )
    parts = _PARTS.match(first)
    return first, (parts["unit"] if parts and parts["unit"] else "norm")


def _spread(sweep: _Sweep, name: str) -> float:
    return max(sweep.every(name)) - min(sweep.every(name))


def _travel(tree: ET.Element, sweep: _Sweep, primary: str, per_rad: float) -> tuple[float, float]:
    """Lowest and highest deflection [rad]: what the sweep reached, and what the writing component could."""
    ends = [*sweep.every(primary), *(range_of(tree, primary) or ())]
    return min(ends) / per_rad, max(ends) / per_rad


def _reading(
    sweep: _Sweep, name: str, primary: str, per_rad: float, stick: str | None, travel: tuple[float, float]
) -> Reading:
    """How what is read follows from the deflection."""
    if name == primary:
        return Reading(name, gain=per_rad)
    parts, of = _PARTS.match(name), _PARTS.match(primary)
    assert parts is not None and of is not None
    if parts["unit"] in _PER_RAD and (per_rad in _PER_RAD.values()):
        return Reading(name, gain=_PER_RAD[parts["unit"]], magnitude=parts["mag"] is not None)
    if parts["mag"] is not None:
        return Reading(name, gain=_PER_RAD.get(parts["unit"] or "", 1.0 / _NOMINAL_RAD), magnitude=True)
    table = _table(sweep, name, primary, per_rad, stick)
    if len(table) < 2:  # nothing moved on the bench: the full travel is 1
        return Reading(name, gain=1.0 / max(map(abs, travel)))
    return Reading(name, table=_extended(table, travel))


def _table(
    sweep: _Sweep, name: str, primary: str, per_rad: float, stick: str | None
) -> list[tuple[float, float]]:
    rows = [
        (deflection / per_rad, value)
        for each in ([stick] if stick else STICKS)
        for (_, deflection), (_, value) in zip(
            sweep.curve(each, primary), sweep.curve(each, name), strict=True
        )
    ]
    return _thinned(rows)


def _thinned(rows: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Ascending, without deflections that are all but equal, which JSBSim refuses."""
    ascending = sorted(rows)
    return [row for i, row in enumerate(ascending) if i == 0 or row[0] - ascending[i - 1][0] > _SAME_RAD]


def _extended(
    table: list[tuple[float, float]], travel: tuple[float, float]
) -> tuple[tuple[float, float], ...]:
    """The table with its outer slopes continued to the ends of the travel, since JSBSim holds a table's end values."""
    out = list(table)
    for end, (first, second) in ((travel[0], table[:2]), (travel[1], table[:-3:-1])):
        slope = (second[1] - first[1]) / (second[0] - first[0])
        if not table[0][0] - _SAME_RAD <= end <= table[-1][0] + _SAME_RAD:
            out.append((end, first[1] + slope * (end - first[0])))
    return tuple(sorted(out))


def _renamed(surfaces: list[Surface]) -> list[Surface]:
    """Plain names: a left surface that stands for both sides is named without its side."""
    names = {each.name for each in surfaces}
    out = []
    for each in surfaces:
        name = each.name.removeprefix("effective_")
        for side, other in (("left_", "right_"), ("right_", "left_")):
            if name.startswith(side) and other + name.removeprefix(side) not in names:
                name = name.removeprefix(side)
        out.append(replace(each, name=name))
    return out
