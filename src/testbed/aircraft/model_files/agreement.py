"""Whether the aircraft's YAML and its JSBSim model say the same: numbers of engines and point masses, limits, motors.

`adjust` writes those of the YAML into the model.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

from testbed.aircraft.description import Aircraft, AnyActuator, Engine, MotorActuator, Servo
from testbed.aircraft.model_files.numbers import finite
from testbed.aircraft.model_files.safe_xml import Element, read_bytes
from testbed.aircraft.model_files.used import ENGINES, ModelFiles
from testbed.common.units import DEGREES_PER_RADIAN
from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Issue, TreePath

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
_ENCODING = "latin-1"
"""Gives each byte of any file back as it was; what is looked for is ASCII."""


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
    points = len(files.inside("mass_balance", "pointmass"))
    for name, actuator in aircraft.actuators.items():
        here: TreePath = ("actuators", name)
        if not isinstance(actuator, Servo):
            yield from _engine(actuator, here, files)
        elif actuator.pointmass is not None and actuator.pointmass >= points:
            what = f"{actuator.pointmass} is not the number of a point mass of the model"
            yield Issue((*here, "pointmass"), what, _from_zero(points, "point mass"))
    yield from (each.issue for each in differences(aircraft, files))


def differences(aircraft: Aircraft, files: ModelFiles) -> Iterator[Difference]:
    """The numbers that the two say differently."""
    declared = _declared(files)
    for name, actuator in aircraft.actuators.items():
        for path, ours, element, factor in _counterparts(actuator, files, declared):
            said = None if element is None else finite(element.attributes.get("value", element.text))
            if element is None or said is None:
                continue
            if not math.isclose(ours, said * factor, rel_tol=_RELATIVE, abs_tol=1e-9):
                here = ("actuators", name, *path)
                yield Difference(here, ours, said * factor, element, said, ours / factor)


def _declared(files: ModelFiles) -> dict[str, Element]:
    """Properties that the model declares with a value, by name."""
    found: dict[str, Element] = {}
    for element in files.elements():
        if element.tag == "property" and finite(element.attributes.get("value", "")) is not None:
            found.setdefault(element.text, element)
    return found


def _counterparts(
    actuator: AnyActuator, files: ModelFiles, declared: dict[str, Element]
) -> Iterator[tuple[TreePath, float, Element | None, float]]:
    """(path, number) in the YAML; the element of the model that says the same, and the factor from its unit to the YAML's."""
    if isinstance(actuator, MotorActuator):
        found = _engine_file(actuator.engine, files)
        if found is not None and found.tag == _BRUSHLESS:
            for field, tag in _MOTOR.items():
                yield ("motor", field), getattr(actuator.motor, field), found.first(tag), 1.0
        return
    if isinstance(actuator, Servo):
        unit = DEGREES_PER_RADIAN if actuator.unit == "deg" else 1.0
        numbers: list[tuple[TreePath, float, str, float]] = [
            (("limits", 0), actuator.limits[0], "servo-min-rad", unit),
            (("limits", 1), actuator.limits[1], "servo-max-rad", unit),
            (("rate_limit",), actuator.rate_limit, "servo-rate-rad_sec", unit),
            (("lag_rad_s",), actuator.lag_rad_s, "servo-lag-rad_sec", 1.0),
        ]
    else:
        numbers = [
            (("throttle", i), end, f"throttle-{which}-norm", 1.0)
            for i, (end, which) in enumerate(zip(actuator.throttle, ("min", "max"), strict=True))
        ]
    for path, ours, name, factor in numbers:
        yield path, ours, declared.get(f"{actuator.prefix}/{name}"), factor


def _engine(actuator: MotorActuator | Engine, here: TreePath, files: ModelFiles) -> Iterator[Issue]:
    count = len(files.inside("propulsion", "engine"))
    if actuator.engine >= count:
        what = f"{actuator.engine} is not the number of an engine of the model"
        yield Issue((*here, "engine"), what, _from_zero(count, "engine"))
    elif (found := _engine_file(actuator.engine, files)) is not None:
        kind = "motor" if found.tag == _BRUSHLESS else "engine"
        if actuator.kind != kind:
            yield Issue((*here, "kind"), f"engine {actuator.engine} of the model is a <{found.tag}>", kind)


def _engine_file(number: int, files: ModelFiles) -> Element | None:
    """What describes an engine of the model; None where there is none."""
    known = files.inside("propulsion", "engine")
    return files.described(known[number], ENGINES) if number < len(known) else None


def _from_zero(count: int, kind: str) -> str:
    return f"a number from 0 to {count - 1}" if count else f"a model with at least one {kind}"


def adjust(aircraft: Aircraft) -> Iterator[str]:
    """Write numbers of the YAML into the model's files, where the two differ; every other byte stays.

    Yields for each number what was changed, in words. Raises BadInput for files that cannot be read or are outside the aircraft's
    folder, or a number that is not found as it stands, and OSError.
    """
    files = ModelFiles(aircraft.folder, aircraft.model)
    if files.problems:
        raise BadInput(files.problems)
    written = set()  # two engines may share a file
    for each in differences(aircraft, files):
        if each.element not in written:
            written.add(each.element)
            file, line = each.element.file, each.element.line
            if not file.is_relative_to(aircraft.folder):
                raise each.element.refused("is not in the aircraft's folder", f"{each.wanted:.9g}, by hand")
            text = _changed(read_bytes(file).decode(_ENCODING), each)
            write(file, text.encode(_ENCODING), within=aircraft.folder)
            yield f"{file}:{line}: {each.name} {each.said:g} -> {each.wanted:g}"


def _changed(text: str, each: Difference) -> str:
    """The text of a model's file with another number in an element."""
    begin = sum(map(len, text.splitlines(keepends=True)[: each.element.line - 1]))
    found = _pattern(each).match(text, text.find(f"<{each.element.tag}", begin))
    if found is None:
        raise each.element.refused("cannot be changed as it stands", f"{each.wanted:.9g}, by hand")
    return f"{text[: found.start(1)]}{each.wanted:.9g}{text[found.end(1) :]}"


def _pattern(each: Difference) -> re.Pattern[str]:
    """What matches the element, with its number as the first group."""
    if each.element.tag == "property":
        return re.compile(
            rf"<property\s[^>]*?\bvalue\s*=\s*[\"']([^\"']*)[\"'][^>]*>\s*{re.escape(each.name)}\s*<"
        )
    return re.compile(rf"<{each.element.tag}[^>]*>\s*([^<\s]+)\s*</")
