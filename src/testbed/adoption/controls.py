"""What can be controlled of a model: the surfaces that its flight control moves and its aerodynamics read, found by moving its
sticks on the bench; and its engines, with their kinds, places and names."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from testbed.adoption.bench import MOVED, Bench, StickSweep, swept
from testbed.adoption.source import Source, file_of, parsed
from testbed.adoption.wiring import POSITIONS, READERS, STICKS, Dynamics, Wiring, bare, dynamics_of, range_of
from testbed.aircraft.changes import place_of
from testbed.inputs.problems import BadInput, Problem

_SECTIONS = ("aerodynamics", "external_reactions")
_PARTS = re.compile(
    r"^fcs/(?P<mag>mag-)?(?P<base>.*?)(?:-(?:pos|cmd|position))?(?:-(?P<unit>rad|deg|norm))?$"
)
_SAME_RAD = 1e-4
_NOMINAL_RAD = math.radians(20.0)
"""Deflection that a fraction of 1 is called, where the model knows only fractions, and the travel of a surface that has none."""
_PER_RAD = {"rad": 1.0, "deg": math.degrees(1.0)}
_UNITS = ("rad", "deg", "norm")
PISTON, TURBINE = "piston_engine", "turbine_engine"
ELECTRIC = ("electric_engine", "brushless_dc_motor")
ADOPTED = {
    PISTON: "piston engine", "turboprop_engine": "turboprop", TURBINE: "turbine", **dict.fromkeys(ELECTRIC, "electric engine"),
}  # fmt: skip
"""Kinds of engine, by the first tag of their files, that become actuators, in words. A rocket stays off."""


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
        name: of the actuator.
        readings: what the aerodynamics read of it.
        travel: lowest and highest deflection [rad].
        stick: which of `wiring.STICKS` moves it most; None where none moved it on the bench.
        dynamics: its lag and rate limit, as far as the model has them.
        nominal: whether radians are ours, because the model has only fractions.
        unlimited: whether the travel is a default, because the model has none.
    """

    name: str
    readings: tuple[Reading, ...]
    travel: tuple[float, float]
    stick: str | None
    dynamics: Dynamics = field(default_factory=Dynamics)
    nominal: bool = False
    unlimited: bool = False


def places_read(tree: ET.Element) -> Iterator[tuple[str, ET.Element]]:
    """(name, element) of each place where aerodynamics or external reactions read a property below `fcs/`."""
    for section in (each for each in tree if each.tag in _SECTIONS):
        for element in section.iter():
            name = bare(element.text) if element.tag in READERS else ""
            if name.startswith("fcs/"):
                yield name, element


def find_surfaces(tree: ET.Element, bench: Bench) -> list[Surface]:
    """The surfaces of a model, in the order of the sticks for pitch, roll and yaw; the bench holds it in flight.

    A surface is what some moment depends on, and what a stick moves or would move through the model's flight control. JSBSim's own
    positions are surfaces too where nothing moves them, as in a model without flight control.
    """
    wiring, groups = Wiring(tree), surface_groups(tree)
    native = {base: [f"fcs/{base}-pos-{unit}" for unit in _UNITS] for base in groups}  # JSBSim's own names
    families = {base: [*group, *native[base]] for base, group in groups.items()}
    sweep = swept(bench, list(dict.fromkeys(name for family in families.values() for name in family)))
    surfaces = []
    for base, group in groups.items():
        stick = sweep.stick_of(families[base])
        known = stick or base in POSITIONS or wiring.follows(families[base], STICKS.values())
        if known and wiring.turns(group):
            surfaces.append(_surface(tree, sweep, base, group, stick))
    order = [*STICKS, None]
    return _surface_names(sorted(surfaces, key=lambda each: (order.index(each.stick), each.name)))


def surface_groups(tree: ET.Element) -> dict[str, list[str]]:
    """What aerodynamics and external reactions read below `fcs/`, in the order of the file, by the names without units."""
    groups: dict[str, list[str]] = {}
    for name in dict.fromkeys(name for name, _ in places_read(tree)):
        groups.setdefault(_parts(name)["base"], []).append(name)
    return groups


def _parts(name: str) -> re.Match[str]:
    parts = _PARTS.match(name)
    assert parts is not None
    return parts


def _surface(tree: ET.Element, sweep: StickSweep, base: str, group: list[str], stick: str | None) -> Surface:
    primary, unit = _primary(tree, sweep, base, group)
    per_rad = _PER_RAD.get(unit, 1.0 / _NOMINAL_RAD)
    reached = [*sweep.every(primary), *(range_of(tree, primary) or ())]  # in the sweep, and by its component
    low, high = min(reached) / per_rad, max(reached) / per_rad
    unlimited = high - low < MOVED
    if unlimited:
        low, high = -_NOMINAL_RAD, _NOMINAL_RAD
    # What nobody writes stays as it is.
    alive = [name for name in group if stick is None or sweep.spread(name) > MOVED]
    readings = tuple(_reading(sweep, name, primary, per_rad, stick, (low, high)) for name in alive)
    dynamics = dynamics_of(tree, primary, (low, high))
    return Surface(
        base.replace("-", "_").replace("/", "_"), readings, (low, high), stick, dynamics, unit == "norm", unlimited,
    )  # fmt: skip


def _primary(tree: ET.Element, sweep: StickSweep, base: str, group: list[str]) -> tuple[str, str]:
    """The property that stands for the deflection, and its unit: in radians if there is one that moves, else degrees, else
    fractions of the full deflection."""
    for unit in _UNITS:
        for name in (
            f"fcs/{base}-pos-{unit}",
            *(n for n in group if n.endswith(f"-{unit}") and "/mag-" not in n),
        ):
            if name in sweep.names and (sweep.spread(name) > MOVED or range_of(tree, name)):
                return name, unit
    first = next((name for name in group if "/mag-" not in name), group[0])
    return first, _parts(first)["unit"] or "norm"


def _reading(
    sweep: StickSweep, name: str, primary: str, per_rad: float, stick: str | None, travel: tuple[float, float]
) -> Reading:
    """How what is read follows from the deflection."""
    if name == primary:
        return Reading(name, gain=per_rad)
    parts = _parts(name)
    magnitude = parts["mag"] is not None
    if magnitude or (parts["unit"] in _PER_RAD and per_rad in _PER_RAD.values()):
        return Reading(name, _PER_RAD.get(parts["unit"] or "", 1.0 / _NOMINAL_RAD), magnitude)
    table = _table(sweep, name, primary, per_rad, stick)
    if len(table) < 2:  # nothing moved on the bench: the full travel is 1
        return Reading(name, gain=1.0 / max(map(abs, travel)))
    return Reading(name, table=_extended(table, travel))


def _table(
    sweep: StickSweep, name: str, primary: str, per_rad: float, stick: str | None
) -> list[tuple[float, float]]:
    """Rows (deflection [rad], value), ascending, without deflections that are all but equal, which JSBSim refuses."""
    rows = sorted(
        (deflection / per_rad, value)
        for each in ([stick] if stick else STICKS)
        for (_, deflection), (_, value) in zip(
            sweep.curve(each, primary), sweep.curve(each, name), strict=True
        )
    )
    return [row for i, row in enumerate(rows) if i == 0 or row[0] - rows[i - 1][0] > _SAME_RAD]


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


def _surface_names(surfaces: list[Surface]) -> list[Surface]:
    """Plain names: a left surface that stands for both sides is named without its side."""
    names = {each.name for each in surfaces}
    out = []
    for each in surfaces:
        name = each.name.removeprefix("effective_")
        for side, other in (("left_", "right_"), ("right_", "left_")):
            plain = name.removeprefix(side)
            if plain != name and other + plain not in names and plain not in names:
                name = plain
        out.append(replace(each, name=name))
    return out


@dataclass(frozen=True)
class Propulsor:
    """One engine with its propeller or jet.

    Attributes:
        name: of the actuator.
        number: of the engine in JSBSim.
        kind: first tag of its file.
        propeller: whether its thruster is a propeller.
        location_m: [3] of its thruster, in JSBSim's structural frame.
        direction: [3] of its thrust, in body axes.
        throttle: lowest and highest throttle, without the afterburner, with which thrust would jump.
    """

    name: str
    number: int
    kind: str
    propeller: bool
    location_m: tuple[float, float, float]
    direction: tuple[float, float, float]
    throttle: tuple[float, float] = (0.0, 1.0)


def find_propulsors(tree: ET.Element, source: Source) -> list[Propulsor]:
    """The engines that can be actuators, in JSBSim's order; raises BadInput when a file of one is missing."""
    found = []
    for number, engine in enumerate(tree.findall("propulsion/engine")):
        thruster = engine.find("thruster")
        if thruster is None:
            raise BadInput([Problem(f"its engine {number} has no <thruster>", str(source.file))])
        contents = parsed(file_of(engine, source))
        if contents.tag not in ADOPTED:
            continue
        propeller = parsed(file_of(thruster, source)).tag == "propeller"
        own = thruster.find("location")
        x, y, z = map(float, place_of(engine.find("location") if own is None else own))
        found.append(
            Propulsor(
                "engine",
                number,
                contents.tag,
                propeller,
                (x, y, z),
                _direction(thruster),
                _throttle(contents),
            )
        )
    return _engine_names(found)


def _direction(thruster: ET.Element) -> tuple[float, float, float]:
    """Direction of thrust from the thruster's pitch and yaw: nose up is a thrust upwards, -z."""
    orient = thruster.find("orient")
    if orient is None:
        return 1.0, 0.0, 0.0
    scale = math.radians(1.0) if orient.get("unit", "RAD").upper() == "DEG" else 1.0
    pitch, yaw = (scale * float(orient.findtext(axis) or 0.0) for axis in ("pitch", "yaw"))
    direction = np.array([math.cos(pitch) * math.cos(yaw), math.cos(pitch) * math.sin(yaw), -math.sin(pitch)])
    x, y, z = map(float, np.where(np.abs(direction) < 1e-12, 0.0, direction))
    return x, y, z


def _throttle(engine: ET.Element) -> tuple[float, float]:
    """JSBSim lights an afterburner of method 1 above a throttle of 0.99; one of method 2 is above 1."""
    lights_itself = int(float(engine.findtext("augmethod") or 0)) == 1
    return 0.0, 0.98 if lights_itself else 1.0


def _engine_names(found: list[Propulsor]) -> list[Propulsor]:
    """One is `engine`, two are left and right, more are numbered from the left, as pilots number them."""
    from_left = sorted(range(len(found)), key=lambda i: (found[i].location_m[1], found[i].number))
    names = ["engine"] if len(found) == 1 else [f"engine_{i + 1}" for i in range(len(found))]
    if len(found) == 2 and found[from_left[0]].location_m[1] < found[from_left[1]].location_m[1]:
        names = ["left_engine", "right_engine"]
    by_index = dict(zip(from_left, names, strict=True))
    return [replace(each, name=by_index[i]) for i, each in enumerate(found)]
