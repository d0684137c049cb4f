"""Whether the aircraft's YAML and its JSBSim model say the same: numbers of engines and point masses, limits, motors."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from testbed.aircraft.description import Aircraft, Engine, MotorActuator, Servo
from testbed.aircraft.model_files.mass import point_masses
from testbed.aircraft.model_files.numbers import finite
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.sections import ENGINES, engines
from testbed.aircraft.model_files.used import ModelFiles
from testbed.common.units import DEGREES_PER_RADIAN
from testbed.inputs.problems import Issue, TreePath

_RELATIVE = 1e-3
"""Largest relative difference of a number in the YAML from that in the XML; both are rounded to some digits."""
_MOTOR = {
    "max_volts": "maxvolts",
    "velocity_constant_rpm_v": "velocityconstant",
    "resistance_ohm": "coilresistance",
    "no_load_current_a": "noloadcurrent",
}
"""Fields of the YAML's `motor`, and the elements of a brushless motor's file."""
_BRUSHLESS = "brushless_dc_motor"


class Difference(NamedTuple):
    """A number of the YAML that the model says otherwise.

    Attributes:
        path: its place in the YAML.
        ours: the YAML's number.
        theirs: the model's, in the YAML's unit.
        element: where the model says it, a property with a value or an element with a number.
        said, wanted: what stands there, and what would agree with the YAML, in the model's unit.
    """

    path: TreePath
    ours: float
    theirs: float
    element: Element
    said: float
    wanted: float

    @property
    def name(self) -> str:
        """The property's name, or the element's."""
        return self.element.text if self.element.tag == "property" else f"<{self.element.tag}>"

    @property
    def issue(self) -> Issue:
        """The issue of the YAML, with what would have to be changed in either file."""
        place = f"{self.element.file.name}:{self.element.line}"
        what = f"is {self.ours:g}, {self.name} in {place} is {self.said:g}"
        offer = f"{self.wanted:g} there, which `testbed identify --write` writes"
        return Issue(self.path, what, f"{self.theirs:g} here, or {offer}")


def disagreements(aircraft: Aircraft, files: ModelFiles) -> Iterator[Issue]:
    """Issues of the YAML, by their path in it."""
    for name, actuator in aircraft.actuators.items():
        here: TreePath = ("actuators", name)
        if isinstance(actuator, Servo):
            yield from _point_mass(actuator, here, point_masses(files))
        else:
            yield from _engine(actuator, here, files)
    yield from (each.issue for each in differences(aircraft, files))


def differences(aircraft: Aircraft, files: ModelFiles) -> Iterator[Difference]:
    """The numbers that the two say differently."""
    declared = _declared(files)
    for name, actuator in aircraft.actuators.items():
        here: TreePath = ("actuators", name)
        if isinstance(actuator, Servo):
            yield from _limits(actuator, here, declared)
        elif isinstance(actuator, Engine):
            yield from _throttle(actuator, here, declared)
        else:
            yield from _motor(actuator, here, files)


def _declared(files: ModelFiles) -> dict[str, Element]:
    """Properties that the model declares with a value, by name."""
    found: dict[str, Element] = {}
    for element in files.elements():
        if element.tag == "property" and finite(element.attributes.get("value", "")) is not None:
            found.setdefault(element.text, element)
    return found


def _point_mass(actuator: Servo, here: TreePath, count: int) -> Iterator[Issue]:
    if actuator.pointmass is not None and actuator.pointmass >= count:
        what = f"{actuator.pointmass} is not the number of a point mass of the model"
        yield Issue((*here, "pointmass"), what, _from_zero(count, "point mass"))


def _limits(actuator: Servo, here: TreePath, declared: dict[str, Element]) -> Iterator[Difference]:
    degrees = DEGREES_PER_RADIAN if actuator.unit == "deg" else 1.0
    pairs = [
        (("limits", 0), actuator.limits[0], "servo-min-rad", degrees),
        (("limits", 1), actuator.limits[1], "servo-max-rad", degrees),
        (("rate_limit",), actuator.rate_limit, "servo-rate-rad_sec", degrees),
        (("lag_rad_s",), actuator.lag_rad_s, "servo-lag-rad_sec", 1.0),
    ]
    for path, ours, name, factor in pairs:
        yield from _compared((*here, *path), ours, f"{actuator.prefix}/{name}", declared, factor)


def _throttle(actuator: Engine, here: TreePath, declared: dict[str, Element]) -> Iterator[Difference]:
    for i, end in enumerate(("min", "max")):
        name = f"{actuator.prefix}/throttle-{end}-norm"
        yield from _compared((*here, "throttle", i), actuator.throttle[i], name, declared)


def _compared(
    path: TreePath, ours: float, name: str, declared: dict[str, Element], factor: float = 1.0
) -> Iterator[Difference]:
    """A number of the YAML that is not that of a property, in the property's unit times a factor."""
    element = declared.get(name)
    if element is not None:
        said = float(element.attributes["value"])
        if not _same(ours, said * factor):
            yield Difference(path, ours, said * factor, element, said, ours / factor)


def _engine(actuator: MotorActuator | Engine, here: TreePath, files: ModelFiles) -> Iterator[Issue]:
    count = len(engines(files))
    if actuator.engine >= count:
        what = f"{actuator.engine} is not the number of an engine of the model"
        yield Issue((*here, "engine"), what, _from_zero(count, "engine"))
    elif (found := _engine_file(actuator.engine, files)) is not None:
        kind = "motor" if found.tag == _BRUSHLESS else "engine"
        if actuator.kind != kind:
            yield Issue((*here, "kind"), f"engine {actuator.engine} of the model is a <{found.tag}>", kind)


def _engine_file(number: int, files: ModelFiles) -> Element | None:
    """What describes an engine of the model; None where there is none."""
    known = engines(files)[number : number + 1]
    for engine in known:
        found = files.content.get(engine) or next(
            (one for one in engine.children if one.tag in ENGINES), None
        )
        return found if found is not None and found.tag in ENGINES else None
    return None


def _motor(actuator: MotorActuator, here: TreePath, files: ModelFiles) -> Iterator[Difference]:
    found = _engine_file(actuator.engine, files)
    if found is None or found.tag != _BRUSHLESS:
        return
    for field, tag in _MOTOR.items():
        element = found.first(tag)
        ours = getattr(actuator.motor, field, None)
        said = None if element is None else finite(element.text)
        if element is not None and ours is not None and said is not None and not _same(ours, said):
            yield Difference((*here, "motor", field), ours, said, element, said, ours)


def _from_zero(count: int, kind: str) -> str:
    return f"a number from 0 to {count - 1}" if count else f"a model with at least one {kind}"


def _same(ours: float, theirs: float) -> bool:
    return math.isclose(ours, theirs, rel_tol=_RELATIVE, abs_tol=1e-9)
