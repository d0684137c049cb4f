"""Changes to the truth of an aircraft: its mass, its balance, and its aerodynamic coefficients.

They are made in the text of the JSBSim model when it is loaded, so any model can be changed and no file of it is. The controller is
not told: it has the design model, the trim and the limits of the aircraft as its files are.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree

import numpy as np

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.model_files.safe_xml import read_bytes, read_xml
from testbed.common.cache import Cache
from testbed.common.writing import write_new
from testbed.inputs.base import Number, Positive, Settings, Text
from testbed.inputs.problems import BadInput, Problem, TreePath, did_you_mean
from testbed.inputs.yaml_source import dotted

_KG = {"KG": 1.0, "LBS": 0.45359237, "LB": 0.45359237, "SLUG": 14.59390294}
METRES = {"M": 1.0, "FT": 0.3048, "IN": 0.0254, "CM": 0.01, "MM": 0.001, "KM": 1000.0}
_INERTIA = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
_HEAVIEST = 100.0  # largest change of mass, as a ratio: more is a slip of units


class ChangedAircraft(Settings):
    """An aircraft of which some numbers are not those of its files; the controller does not know."""

    name: Text
    """Name of a shipped aircraft, or path of an aircraft folder with a slash."""
    mass_kg: Positive | None = None
    """Mass with everything on board [kg]. The empty airframe takes the difference, and its moments of inertia grow in proportion;
    the centre of gravity of the whole stays."""
    cg_shift_x_m: Number = 0.0
    """Shift of the centre of gravity aft [m]."""
    cg_shift_y_m: Number = 0.0
    """Shift of the centre of gravity to the right [m]."""
    cg_shift_z_m: Number = 0.0
    """Shift of the centre of gravity up [m]."""
    coefficients: dict[str, Number] = {}  # noqa: RUF012  (pydantic copies it)
    """Factor on each of these aerodynamic functions of the JSBSim model, by its name or the last part of it, such as `Cm_q`."""

    @property
    def changes(self) -> dict[str, object]:
        """What differs from the files."""
        return self.model_dump(exclude={"name"}, exclude_defaults=True)

    def __str__(self) -> str:
        said = ", ".join(f"{key} {value}" for key, value in self.changes.items())
        return f"{self.name} with {said}" if said else self.name


def name_in(said: object) -> str:
    """The aircraft's name or folder in what a tree read from YAML says of it: a text, or a mapping with `name`."""
    return str(said["name"] if isinstance(said, Mapping) else said)


def load_with_changes(choice: str | ChangedAircraft) -> Aircraft:
    """The aircraft of a scenario; raises BadInput if it cannot be loaded, or has no part that is to be changed.

    A problem with a change has its path below the scenario's `aircraft`, and no file.
    """
    if isinstance(choice, str):
        return load_aircraft(choice)
    aircraft = load_aircraft(choice.name)
    if not choice.changes:
        return aircraft
    _changed(aircraft, choice)
    return aircraft.changed_by(choice)


_texts: Cache[str] = Cache(16)


@contextmanager
def model_folder(aircraft: Aircraft, rotating_air: bool = False) -> Iterator[Path]:
    """The folder from which JSBSim loads the model: the aircraft's own, or a temporary copy with its changes.

    With `rotating_air` there is a copy that feels air that rotates (see `put_rotation`).
    """
    if aircraft.changes is None and not rotating_air:
        yield Path(aircraft.folder).resolve()
        return
    changes = aircraft.changes or ChangedAircraft(name=aircraft.name)
    assert isinstance(changes, ChangedAircraft)
    content = read_bytes(aircraft.model_file)
    key = (content, changes.model_dump_json(), rotating_air)
    changed = _texts.get(key, lambda: _changed(aircraft, changes, rotating_air))
    with TemporaryDirectory(prefix="testbed-") as folder:
        _copy(aircraft, changed, Path(folder))
        yield Path(folder)


def _copy(aircraft: Aircraft, changed: str, to: Path) -> None:
    """The aircraft's XML files, with the model's own replaced."""
    own = aircraft.model_file
    for file in aircraft.folder.resolve().rglob("*.xml"):
        place = to / file.relative_to(own.parent)
        place.parent.mkdir(parents=True, exist_ok=True)
        write_new(place, changed if file == own else read_bytes(file))


def _changed(aircraft: Aircraft, choice: ChangedAircraft, rotating_air: bool = False) -> str:
    """The text of the changed model; raises BadInput if it has no such part."""
    read_xml(aircraft.model_file)  # safe to parse
    root = ElementTree.fromstring(read_bytes(aircraft.model_file))
    _balance(root, aircraft.model_file.name, choice)
    functions = _functions(root)
    for name, factor in choice.coefficients.items():
        if name not in functions:
            what = f"{choice.name} has no aerodynamic function of this name"
            raise _refused(("coefficients", name), what, suggestion=did_you_mean(name, functions))
        _multiply(functions[name], factor)
    if rotating_air:
        put_rotation(root)
    return ElementTree.tostring(root, encoding="unicode")


def _functions(root: ElementTree.Element) -> Mapping[str, ElementTree.Element]:
    """The aerodynamic functions, by their whole names and by the last part of each."""
    section = root.find("aerodynamics")
    found = [] if section is None else section.findall("axis/function")
    named = [(function.get("name", "").strip(), function) for function in found]
    return {key: f for name, f in reversed(named) if name for key in (name, name.rpartition("/")[2])}


def _balance(root: ElementTree.Element, file: str, choice: ChangedAircraft) -> None:
    """Change mass and centre of gravity."""
    shift = (choice.cg_shift_x_m, choice.cg_shift_y_m, choice.cg_shift_z_m)
    if choice.mass_kg is None and not any(shift):
        return
    path: TreePath = ("mass_kg",) if choice.mass_kg is not None else ("cg_shift_x_m",)
    section = root.find("mass_balance")
    empty = None if section is None else section.find("emptywt")
    if section is None or empty is None:
        raise _refused(path, f"{file} has no mass_balance with emptywt of its own to change")
    place = next((e for e in section.findall("location") if e.get("name") == "CG"), None)
    if place is None:
        raise _refused(path, f"{file} has no location of the CG in its mass_balance")
    carried = [*section.findall("pointmass"), *root.findall("propulsion/tank")]
    loads = [(_carried(e), place_of(e.find("location"))) for e in carried]
    old_empty, others = _quantity(empty, _KG, "LBS"), sum(mass for mass, _ in loads)
    mass = choice.mass_kg if choice.mass_kg is not None else old_empty + others
    _check_mass(mass, old_empty, others)
    ratio = (mass - others) / old_empty
    _scale(empty, ratio)
    for element in (e for name in _INERTIA for e in section.findall(name)):
        _scale(element, ratio)
    moment = sum((m * at for m, at in loads), np.zeros(3))
    centre = (old_empty * place_of(place) + moment) / (old_empty + others) + shift
    _put(place, (mass * centre - moment) / (mass - others))


def _carried(element: ElementTree.Element) -> float:
    """Mass of a point mass or of the contents of a tank [kg]."""
    weight = element.find("weight" if element.tag == "pointmass" else "contents")
    return 0.0 if weight is None else _quantity(weight, _KG, "LBS")


def place_of(location: ElementTree.Element | None) -> np.ndarray:
    """[3] a location [m]; the origin where there is none, as in JSBSim."""
    if location is None:
        return np.zeros(3)
    metres = METRES[location.get("unit", "IN").upper()]
    return metres * np.array([float(location.findtext(axis) or 0.0) for axis in "xyz"])


def _put(location: ElementTree.Element, at_m: np.ndarray) -> None:
    metres = METRES[location.get("unit", "IN").upper()]
    for axis, value in zip("xyz", at_m, strict=True):
        element = location.find(axis)
        if element is None:
            element = ElementTree.SubElement(location, axis)
        element.text = repr(float(value / metres))


def _check_mass(mass: float, empty: float, others: float) -> None:
    if not others < mass <= _HEAVIEST * (empty + others):
        expected = f"more than {others:.6g} kg, what its point masses and fuel weigh"
        if mass > others:
            expected = f"no more than {_HEAVIEST:g} times the {empty + others:.6g} kg of its files"
        raise _refused(("mass_kg",), f"is {mass:g}", expected)


def _multiply(function: ElementTree.Element, factor: float) -> None:
    """Put what a function computes into a product with a factor."""
    operation = next(child for child in function if child.tag != "description")
    place = list(function).index(operation)
    function.remove(operation)
    product, number = ElementTree.Element("product"), ElementTree.Element("value")
    number.text = repr(factor)
    product.extend([number, operation])
    function.insert(place, product)


def _scale(element: ElementTree.Element, ratio: float) -> None:
    element.text = repr(float(element.text or 0.0) * ratio)


def _quantity(element: ElementTree.Element, units: Mapping[str, float], default: str) -> float:
    return float(element.text or math.nan) * units[element.get("unit", default).upper()]


def _refused(path: TreePath, what: str, expected: str = "", suggestion: str = "") -> BadInput:
    return BadInput([Problem(what, path=dotted(path), expected=expected, suggestion=suggestion)])


# Air that rotates -------------------------------------------------------------------------------------------------

_RATES = {f"velocities/{axis}-aero-rad_sec": f"testbed/{axis}-aero-rad_sec" for axis in "pqr"}
"""JSBSim's rate relative to the air, and that which takes its place."""
ROTATION = tuple(f"testbed/{axis}-gust-rad_sec" for axis in "pqr")
"""Rotation of the air about the body axes [rad/s]."""


def put_rotation(root: ElementTree.Element) -> None:
    """Let a model feel air that rotates: JSBSim gives it only the rotation of its own turbulence, which nobody can write.

    In the tree of the model's own file, within <aerodynamics>, the properties of the rates relative to the air are replaced by
    functions that subtract a rotation that can be written. Without rotation the model computes the same bits. Aerodynamics in
    another file do not feel it.
    """
    section = root.find("aerodynamics")
    if section is None or section.get("file"):
        return
    for element in section.iter("property"):
        name = (element.text or "").strip()
        element.text = _RATES.get(name, element.text)
    rates = [_difference(*rate, gust) for rate, gust in zip(_RATES.items(), ROTATION, strict=True)]
    for element in reversed([*map(_declared, ROTATION), *rates]):
        section.insert(0, element)


def _declared(name: str) -> ElementTree.Element:
    element = ElementTree.Element("property", value="0")
    element.text = name
    return element


def _difference(theirs: str, ours: str, gust: str) -> ElementTree.Element:
    function = ElementTree.Element("function", name=ours)
    difference = ElementTree.SubElement(function, "difference")
    for name in (theirs, gust):
        ElementTree.SubElement(difference, "property").text = name
    return function
