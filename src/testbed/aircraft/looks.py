"""What an aircraft's JSBSim files say of its looks: areas, arms, wings, wheels and engines. Nothing that flies depends on it.

Positions are in body axes from the centre of gravity of the empty aircraft: x forward, y right, z down [m].
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from testbed.aircraft.changes import METRES
from testbed.aircraft.description import Aircraft, Servo
from testbed.aircraft.model_files.numbers import finite
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.aircraft.shape import Point
from testbed.common.cache import Cache

_SQUARE_METRES = {f"{unit}2": metres**2 for unit, metres in METRES.items()}
_UNKNOWN_M = 1.0  # diameter of a propeller whose file does not say
_TIP = 0.3  # of the span: a contact this far out, named so, is a wing's
_HULL = ("HUMP", "HULL", "STEP", "KEEL", "FLOAT")
_looks: Cache[Looks] = Cache(16)


@dataclass(frozen=True)
class Power:
    """Where an engine pushes, the actuator that it is, and the diameter of its propeller: 0 for a jet."""

    at: Point
    actuator: str
    diameter_m: float


@dataclass(frozen=True)
class Looks:
    """Sizes of an aircraft [m, m^2]; 0 where its files do not say. `contacts` are those with the ground, `tips` the wings' ends."""

    span_m: float
    wing_m2: float = 0.0
    tail_m2: float = 0.0
    tail_arm_m: float = 0.0
    fin_m2: float = 0.0
    wing_at: Point = (0.0, 0.0, 0.0)
    eye_x_m: float = 0.0
    contacts: tuple[Point, ...] = ()
    tips: tuple[Point, ...] = ()
    wheels: tuple[Point, ...] = ()
    hull: bool = False
    engines: tuple[Power, ...] = field(default=())


def looks_of(aircraft: Aircraft) -> Looks:
    """What the files of an aircraft say; of one that cannot be read, nothing."""
    return _looks.get(aircraft.fingerprint(), lambda: _read(aircraft))


def _read(aircraft: Aircraft) -> Looks:
    files = ModelFiles(aircraft.folder, aircraft.model)
    metrics, ground = files.section("metrics"), files.section("ground_reactions")
    centre = _named(files.section("mass_balance"), "CG")
    sizes = {} if metrics is None else {each.tag: each for each in metrics.children}
    span, contacts = _size(sizes.get("wingspan"), METRES), [] if ground is None else ground.all("contact")
    here = [(each, _at(each, centre)) for each in contacts]
    places = {at for _, at in here}
    wing, eye = (_body(_named(metrics, name), centre) for name in ("AERORP", "EYEPOINT"))
    wheels = [at for each, at in here if _is_wheel(each)] if len(places) > 2 else []
    return Looks(
        span_m=span,
        wing_m2=_size(sizes.get("wingarea"), _SQUARE_METRES),
        tail_m2=_size(sizes.get("htailarea"), _SQUARE_METRES),
        tail_arm_m=_size(sizes.get("htailarm"), METRES),
        fin_m2=_size(sizes.get("vtailarea"), _SQUARE_METRES),
        wing_at=wing,
        eye_x_m=eye[0],
        contacts=tuple(sorted(places)),
        tips=tuple(at for each, at in here if abs(at[1]) > _TIP * span and _says(each, "TIP", "WING", "WT")),
        wheels=tuple(wheels),
        hull=_has_hull(contacts),
        engines=tuple(_engines(aircraft, files, centre)),
    )


def _has_hull(contacts: list[Element]) -> bool:
    """Whether it comes down on water: it has contacts but no wheels, or one that is a hull's."""
    if any(_says(each, *_HULL) for each in contacts):
        return True
    return bool(contacts) and not any(each.attributes.get("type") == "BOGEY" for each in contacts)


def _is_wheel(contact: Element) -> bool:
    """Whether a contact is a wheel that stays out."""
    retracts = contact.first("retractable")
    up = retracts is not None and finite(retracts.text) not in (0.0, None)
    return contact.attributes.get("type") == "BOGEY" and not up


def _says(element: Element, *words: str) -> bool:
    return any(word in element.attributes.get("name", "").upper() for word in words)


def _engines(aircraft: Aircraft, files: ModelFiles, centre: Point) -> Iterator[Power]:
    there = files.inside("propulsion", "engine")
    for name, actuator in aircraft.actuators.items():
        if isinstance(actuator, Servo) or actuator.engine >= len(there):
            continue
        engine = there[actuator.engine]
        thrusters = files.children(engine, "thruster")
        holder = next((e for e in (*thrusters, engine) if e.first("location") is not None), engine)
        yield Power(_at(holder, centre), name, _diameter(files, thrusters))


def _diameter(files: ModelFiles, thrusters: list[Element]) -> float:
    """Of a propeller; 0 for another thruster."""
    for thruster in thrusters:
        if (found := files.described(thruster, ("propeller",))) is not None:
            return _size(found.first("diameter"), METRES) or _UNKNOWN_M
    return 0.0


def _named(section: Element | None, name: str) -> Point:
    """The place with a name, in the files' axes [m]: x backward, y right, z up."""
    for each in [] if section is None else section.all("location"):
        if each.attributes.get("name") == name:
            return _place(each)
    return (0.0, 0.0, 0.0)


def _at(holder: Element, centre: Point) -> Point:
    location = holder.first("location")
    return _body(centre if location is None else _place(location), centre)


def _body(place: Point, centre: Point) -> Point:
    x, y, z = (a - b for a, b in zip(place, centre, strict=True))
    return (-x, y, -z)


def _place(location: Element) -> Point:
    factor = METRES.get(location.attributes.get("unit", "IN"), 1.0)
    x, y, z = ((finite(each.text) or 0.0) * factor if each else 0.0 for each in map(location.first, "xyz"))
    return (x, y, z)


def _size(element: Element | None, units: dict[str, float]) -> float:
    if element is None:
        return 0.0
    number = finite(element.text) or 0.0
    return max(number, 0.0) * units.get(element.attributes.get("unit", next(iter(units))), 1.0)
