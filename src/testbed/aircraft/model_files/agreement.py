"""Whether the aircraft's YAML and its JSBSim model say the same: numbers of engines and point masses, limits, motors."""

from __future__ import annotations

import math
from collections.abc import Iterator

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


def disagreements(aircraft: Aircraft, files: ModelFiles) -> Iterator[Issue]:
    """Issues of the YAML, by their path in it."""
    declared = _declared(files)
    for name, actuator in aircraft.actuators.items():
        here: TreePath = ("actuators", name)
        if isinstance(actuator, Servo):
            yield from _point_mass(actuator, here, point_masses(files))
            yield from _limits(actuator, here, declared)
        else:
            yield from _engine(actuator, here, files)
        if isinstance(actuator, Engine):
            yield from _throttle(actuator, here, declared)


def _declared(files: ModelFiles) -> dict[str, float]:
    """Properties that the model declares with a value."""
    found: dict[str, float] = {}
    for element in files.elements():
        value = finite(element.attributes.get("value", ""))
        if element.tag == "property" and value is not None:
            found.setdefault(element.text, value)
    return found


def _point_mass(actuator: Servo, here: TreePath, count: int) -> Iterator[Issue]:
    if actuator.pointmass is not None and actuator.pointmass >= count:
        what = f"{actuator.pointmass} is not the number of a point mass of the model"
        yield Issue((*here, "pointmass"), what, _from_zero(count, "point mass"))


def _limits(actuator: Servo, here: TreePath, declared: dict[str, float]) -> Iterator[Issue]:
    degrees = DEGREES_PER_RADIAN if actuator.unit == "deg" else 1.0
    pairs = [
        (("limits", 0), actuator.limits[0], "servo-min-rad", degrees),
        (("limits", 1), actuator.limits[1], "servo-max-rad", degrees),
        (("rate_limit",), actuator.rate_limit, "servo-rate-rad_sec", degrees),
        (("lag_rad_s",), actuator.lag_rad_s, "servo-lag-rad_sec", 1.0),
    ]
    for path, ours, name, factor in pairs:
        yield from _compared((*here, *path), ours, f"{actuator.prefix}/{name}", declared, factor)


def _throttle(actuator: Engine, here: TreePath, declared: dict[str, float]) -> Iterator[Issue]:
    for i, end in enumerate(("min", "max")):
        name = f"{actuator.prefix}/throttle-{end}-norm"
        yield from _compared((*here, "throttle", i), actuator.throttle[i], name, declared)


def _compared(
    path: TreePath, ours: float, name: str, declared: dict[str, float], factor: float = 1.0
) -> Iterator[Issue]:
    """A number of the YAML that is not that of a property, in the property's unit times a factor."""
    theirs = declared.get(name)
    if theirs is not None and not _same(ours, theirs * factor):
        what = f"is {ours:g}, the model's {name} is {theirs:g}"
        yield Issue(path, what, f"{theirs * factor:g}; to change it, edit both, here and in the XML")


def _engine(actuator: MotorActuator | Engine, here: TreePath, files: ModelFiles) -> Iterator[Issue]:
    all_engines = engines(files)
    if actuator.engine >= len(all_engines):
        what = f"{actuator.engine} is not the number of an engine of the model"
        yield Issue((*here, "engine"), what, _from_zero(len(all_engines), "engine"))
        return
    engine = all_engines[actuator.engine]
    found = files.content.get(engine) or next((each for each in engine.children if each.tag in ENGINES), None)
    if found is None or found.tag not in ENGINES:
        return
    kind = "motor" if found.tag == _BRUSHLESS else "engine"
    if actuator.kind != kind:
        yield Issue((*here, "kind"), f"engine {actuator.engine} of the model is a <{found.tag}>", kind)
    elif isinstance(actuator, MotorActuator):
        yield from _motor(actuator, here, found)


def _motor(actuator: MotorActuator, here: TreePath, found: Element) -> Iterator[Issue]:
    for field, tag in _MOTOR.items():
        element = found.first(tag)
        ours = getattr(actuator.motor, field, None)
        theirs = None if element is None else finite(element.text)
        if ours is not None and theirs is not None and not _same(ours, theirs):
            what = f"is {ours:g}, {_place(element)} has {theirs:g}"
            yield Issue((*here, "motor", field), what, f"{theirs:g}; to change it, edit both")


def _place(element: Element | None) -> str:
    return "" if element is None else f"<{element.tag}> of {element.file.name}"


def _from_zero(count: int, kind: str) -> str:
    return f"a number from 0 to {count - 1}" if count else f"a model with at least one {kind}"


def _same(ours: float, theirs: float) -> bool:
    return math.isclose(ours, theirs, rel_tol=_RELATIVE, abs_tol=1e-9)
