"""The YAML file of an aircraft: actuators, their properties and limits, controlled axes, envelope, control design."""

from __future__ import annotations

import hashlib
import math
import os
import re
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, PrivateAttr, field_validator

from testbed.aircraft.control_design import Axis, ControlDesign
from testbed.aircraft.model_files.safe_xml import read_bytes
from testbed.aircraft.shipped import find_aircraft
from testbed.common.cache import Cache
from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, Whole, refuse
from testbed.inputs.input_file import read_text
from testbed.inputs.problems import Issue, guess, one_of
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import TreePath, describe, parsed

_SEGMENT = r"[A-Za-z_][\w.-]*(\[\d+\])?"
_PROPERTY = re.compile(rf"{_SEGMENT}(/{_SEGMENT})*", re.ASCII)
"""Names that JSBSim's properties can have."""
_ACTUATOR = re.compile(r"[^\W\d][\w-]*")
"""Names of actuators: the log's columns begin with them, and `+` and `.` have a meaning in `control` and in --set."""


class Reference(Settings):
    """The condition at which the aircraft is trimmed and its design model identified."""

    altitude_m: Number
    airspeed_m_s: Positive


class Envelope(Settings):
    """Limits of the flight envelope; outside them the aircraft counts as lost. A limit that is not given does not apply."""

    alpha_max_deg: Positive | None = None
    beta_max_deg: Positive | None = None
    airspeed_min_m_s: NonNegative | None = None
    airspeed_max_m_s: Positive | None = None
    roll_max_deg: Positive | None = None
    altitude_min_m: Number | None = None


class Motor(Settings):
    """A brushless motor (speed constant, resistance, no-load current) and its propeller."""

    max_volts: Positive
    velocity_constant_rpm_v: Positive
    resistance_ohm: Positive
    no_load_current_a: NonNegative
    rotor_inertia_kg_m2: Positive
    diameter_m: Positive


def _ascending(ends: tuple[float, float]) -> tuple[float, float]:
    if ends[0] >= ends[1]:
        raise refuse(f"{list(ends)} leaves no travel", "[lowest, highest]")
    return ends


Travel = Annotated[tuple[Number, Number], AfterValidator(_ascending)]
"""Lowest and highest value."""


class Actuator(Settings):
    """What servos and motors share.

    Its command, position and effectiveness are properties of the JSBSim model below `prefix`. `limits` and `scale` are in
    `unit`.
    """

    kind: str
    """What kind of actuator it is."""
    prefix: Text
    """Beginning of the names of its properties in the JSBSim model, such as `actuator/NAME`."""
    unit: Text
    """Unit of `limits`, `rate_limit`, `scale` and the log's columns: `deg` for a servo, `N` for a motor."""
    limits: Travel
    """Lowest and highest position that the controller may ask for."""
    scale: Positive = 1.0
    """Deflection or thrust that is one unit in the scaled input matrix, so that servos and motors can be compared."""

    @field_validator("prefix")
    @classmethod
    def _property(cls, prefix: str) -> str:
        if not _PROPERTY.fullmatch(prefix):
            raise refuse(
                f"{describe(prefix)} is no name of a property",
                "letters, digits and ._- between slashes, as fcs/left or engine[1]",
            )
        return prefix


class Servo(Actuator):
    """A control surface's servo: first-order lag, rate limit [unit/s], stops.

    `pointmass` is the number of the surface's point mass in JSBSim, where it has one.
    """

    kind: Literal["servo"] = "servo"
    pointmass: Whole | None = None
    """Number of the surface's point mass in the JSBSim model, if it has one."""
    rate_limit: Positive
    """Fastest movement, in `unit` per second."""
    lag_rad_s: Positive
    """Corner frequency of the first-order lag."""


class MotorActuator(Actuator):
    """A propeller's motor. The control law works with its thrust; JSBSim gets a throttle."""

    kind: Literal["motor"] = "motor"
    engine: Whole
    """Number of its engine in the JSBSim model."""
    motor: Motor
    rate_limit: Positive = 1e9
    """Rate limit of the thrust [N/s]. By default only the rotor's lag limits how fast thrust changes."""

    @property
    def throttle(self) -> tuple[float, float]:
        """Lowest and highest throttle: none, and full voltage."""
        return 0.0, 1.0

    @property
    def lag_rad_s(self) -> float:
        """Corner frequency with which rotor speed follows voltage, without the propeller's load: K_t^2 / (R J) [rad/s]."""
        motor = self.motor
        k_t = 60.0 / (2.0 * math.pi * motor.velocity_constant_rpm_v)
        return k_t * k_t / (motor.resistance_ohm * motor.rotor_inertia_kg_m2)


class Engine(Actuator):
    """An engine of any other kind, piston or turbine, with its propeller or jet. JSBSim gets a throttle; the control law works
    with the thrust, which is identified as a function of throttle and airspeed."""

    kind: Literal["engine"] = "engine"
    engine: Whole
    """Number of its engine in the JSBSim model."""
    throttle: Travel = (0.0, 1.0)
    """Lowest and highest throttle."""
    rate_limit: Positive = 1e9
    """Rate limit of the thrust [N/s]. By default only the engine's own lag limits how fast thrust changes."""
    lag_rad_s: Positive | None = None
    """Corner frequency of the first-order lag of thrust behind throttle; by default it is identified."""


AnyActuator = Servo | MotorActuator | Engine
"""An actuator of any kind; its `kind` says which."""


class StartStep(Settings):
    """One step of making the JSBSim model ready to fly: properties to write, then a time to run with the airframe held."""

    set: dict[str, Number] = {}  # noqa: RUF012  (pydantic copies it)
    """Properties to write, in JSBSim's units."""
    run_s: NonNegative = 0.0
    """How long to run after that [s]."""


class Aircraft(Settings):
    """The contents of aircraft/<name>/<name>.yaml, checked. `folder` has this file and the JSBSim model."""

    name: Text
    """Name of the aircraft."""
    description: str = ""
    """One line for `testbed list`."""
    model: Text
    """Name of the JSBSim model: MODEL.xml in the aircraft's folder."""
    reference: Reference
    axes: tuple[Axis, ...] = Field(min_length=1)
    """State rates that are controlled directly, x_c of the paper. Their priorities are `control.priorities`."""
    actuators: dict[str, Annotated[AnyActuator, Field(discriminator="kind")]] = Field(min_length=1)
    """Each actuator by its name. Commands are in this order everywhere."""
    start: tuple[StartStep, ...] = ()
    """How engines are started and the gear is raised, once, when the model is first placed in flight."""
    envelope: Envelope = Envelope()
    control: ControlDesign = ControlDesign()
    _folder: Path = PrivateAttr(default=Path("."))
    _changes: Settings | None = PrivateAttr(default=None)

    @field_validator("actuators")
    @classmethod
    def _columns(cls, actuators: dict[str, Actuator]) -> dict[str, Actuator]:
        for name in actuators:
            if not _ACTUATOR.fullmatch(name):
                raise refuse(
                    f"{describe(name)} cannot begin the name of a column", "letters, digits, _ and -"
                )
        return actuators

    @field_validator("axes")
    @classmethod
    def _distinct(cls, axes: tuple[Axis, ...]) -> tuple[Axis, ...]:
        if len(set(axes)) != len(axes):
            raise refuse("names an axis twice", "each axis once")
        return axes

    @property
    def folder(self) -> Path:
        """The aircraft's folder: its YAML and the JSBSim model's files."""
        return self._folder

    @property
    def model_file(self) -> Path:
        """The JSBSim model's own file."""
        return self._folder.resolve() / f"{self.model}.xml"

    @property
    def changes(self) -> Settings | None:
        """What differs from the aircraft's files (`aircraft.changes`); None if nothing does."""
        return self._changes

    @property
    def nominal(self) -> Aircraft:
        """The aircraft as its files are."""
        return self if self._changes is None else self.changed_by(None)

    def changed_by(self, changes: Settings | None) -> Aircraft:
        """The same aircraft with these changes to its truth, checked already; its files are looked at anew."""
        other = self.model_copy()
        other.__dict__.pop("_contents", None)
        other._changes = changes
        return other

    @property
    def has_engines(self) -> bool:
        """Whether it has engines, which take their own time to become steady."""
        return any(isinstance(a, Engine) for a in self.actuators.values())

    def fingerprint(self) -> str:
        """Hash of everything that the plant and its trim depend on: JSBSim files, actuators, reference, start; not `control`.

        The files are read once for each time that the aircraft is loaded (0.1 ms), so the next flight notices an edit. Raises
        BadInput for one that is no regular file.
        """
        return self._contents

    @cached_property
    def _contents(self) -> str:
        included = {"model", "reference", "actuators"} | ({"start"} if self.start else set())
        seen = self.model_dump_json(include=included)
        text = hashlib.sha256(seen.encode())
        for name in sorted(_model_files(str(self.folder))):
            text.update(name.encode("utf-8", "surrogateescape") + read_bytes(self.folder / name))
        if self._changes is not None:
            text.update(self._changes.model_dump_json(exclude={"name"}).encode())
        return text.hexdigest()


def _model_files(folder: str) -> Iterator[str]:
    """Paths in a folder of every XML file in it; `Path.rglob` takes three times as long."""
    for place, _, names in os.walk(folder):
        inside = os.path.relpath(place, folder) if place != folder else ""
        for name in names:
            if name.endswith(".xml"):
                yield os.path.join(inside, name)


_aircraft: Cache[Aircraft] = Cache(16)


def load_aircraft(name: str) -> Aircraft:
    """Load an aircraft by name or folder; raises BadInput with everything wrong in its YAML."""
    file = find_aircraft(name)
    text = read_text(file)
    return _aircraft.get((file, text), lambda: _checked(file, text)).changed_by(None)


def _checked(file: Path, text: str) -> Aircraft:
    """The aircraft of a YAML file with this text."""
    aircraft = validated(Aircraft, parsed(text, str(file)), _unknown_names)
    aircraft._folder = file.parent
    return aircraft


def _unknown_names(aircraft: Aircraft) -> Iterator[Issue]:
    """Problems of the names in `control`: no actuator or axis of this aircraft, in the wrong order, or given twice."""
    names, control = list(aircraft.actuators), aircraft.control
    for key, axes in control.release.items():
        path = ("control", "release", key)
        parts = key.split("+")
        unknown = [part for part in parts if part not in names]
        for part in unknown:
            yield Issue(path, f"{aircraft.name} has no actuator {part!r}", *guess(part, names))
        in_order = "+".join(name for name in names if name in parts)
        if not unknown and key != in_order:
            yield Issue(path, "is not in the order of the actuators", in_order)
        yield from _unknown_axes(aircraft, path, axes)
    if "priorities" in control.model_fields_set:
        yield from _unknown_axes(aircraft, ("control", "priorities"), control.priorities)


def _unknown_axes(aircraft: Aircraft, path: TreePath, axes: tuple[Axis, ...]) -> Iterator[Issue]:
    for i, axis in enumerate(axes):
        if axis not in aircraft.axes:
            yield Issue((*path, i), f"{aircraft.name} has no axis {axis}", one_of(aircraft.axes))
        elif axis in axes[:i]:
            yield Issue((*path, i), f"names {axis} twice", "each axis once")
