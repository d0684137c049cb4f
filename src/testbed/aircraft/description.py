"""The YAML half of an aircraft: actuators, their properties and limits, axes by priority, envelope."""

from __future__ import annotations

import math
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, PrivateAttr, field_validator

from testbed.aircraft.shipped import find_aircraft
from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, Whole, refuse
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import parsed, read_text

Axis = Literal["p_dot", "q_dot", "r_dot", "u_dot"]


class Reference(Settings):
    """The condition at which the aircraft is trimmed and its design model identified."""

    altitude_m: Number
    airspeed_m_s: Positive


class Envelope(Settings):
    """Outside of this the aircraft counts as lost; a limit that is not given does not exist."""

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


class Actuator(Settings):
    """What servos and motors share. `limits` and `scale` (1 in the scaled input matrix) are in `unit`."""

    kind: str
    """What kind of actuator it is."""
    prefix: Text
    """Where its block of properties is in the JSBSim model: `fcs/left-ruddervator`."""
    unit: Text
    """Unit of `limits`, `rate_limit`, `scale` and the log's columns: `deg` for a servo, `N` for a motor."""
    limits: tuple[Number, Number]
    """Lowest and highest position that the controller may ask for."""
    scale: Positive = 1.0
    """Position that counts as one unit in the scaled input matrix, so that servos and motors compare."""

    @field_validator("limits")
    @classmethod
    def _ascending(cls, limits: tuple[float, float]) -> tuple[float, float]:
        if limits[0] >= limits[1]:
            raise refuse(f"{list(limits)} leaves no travel", "[lowest, highest]")
        return limits


class Servo(Actuator):
    """A control surface's servo: first-order lag, rate limit [unit/s], stops; `pointmass` is the surface's number
    in JSBSim, where it has a mass of its own."""

    kind: Literal["servo"] = "servo"
    pointmass: Whole | None = None
    """Number of the surface's point mass in the JSBSim model, if it has one."""
    rate_limit: Positive
    """Fastest movement, in `unit` per second."""
    lag_rad_s: Positive
    """Bandwidth of the first-order lag."""


class MotorActuator(Actuator):
    """A propeller's motor, commanded as thrust; `engine` is its number in JSBSim."""

    kind: Literal["motor"] = "motor"
    engine: Whole
    """Number of its engine in the JSBSim model."""
    motor: Motor
    rate_limit: Positive = 1e9
    """Thrust [N/s] is limited by nothing but the rotor's lag."""

    @property
    def lag_rad_s(self) -> float:
        """How fast the rotor follows the voltage, K_t / (R J K_v) without the propeller's load [rad/s]."""
        motor = self.motor
        k_t = 60.0 / (2.0 * math.pi * motor.velocity_constant_rpm_v)
        return k_t * k_t / (motor.resistance_ohm * motor.rotor_inertia_kg_m2)


class Aircraft(Settings):
    """aircraft/<name>/<name>.yaml, checked. `folder` is where it and the JSBSim model are."""

    name: Text
    """Name of the aircraft."""
    description: str = ""
    """One line for `testbed list`."""
    model: Text
    """Name of the JSBSim model: MODEL.xml in the aircraft's folder."""
    reference: Reference
    axes: tuple[Axis, ...] = Field(min_length=1)
    """State rates that are controlled directly, x_c of the paper, in order of priority."""
    actuators: dict[str, Annotated[Servo | MotorActuator, Field(discriminator="kind")]] = Field(min_length=1)
    """Each actuator by its name. Its order is that of commands everywhere."""
    envelope: Envelope = Envelope()
    control: dict[str, Any] = {}  # noqa: RUF012  (pydantic copies it; the control designer's own settings)
    _folder: Path = PrivateAttr(default=Path("."))

    @field_validator("axes")
    @classmethod
    def _distinct(cls, axes: tuple[Axis, ...]) -> tuple[Axis, ...]:
        if len(set(axes)) != len(axes):
            raise refuse("names an axis twice", "each axis once, in order of priority")
        return axes

    @property
    def folder(self) -> Path:
        """The aircraft's folder: its YAML and the JSBSim model's files."""
        return self._folder


def load_aircraft(name: str) -> Aircraft:
    """Load an aircraft by name or folder; raises BadInput with everything wrong in its YAML."""
    file = find_aircraft(name)
    return _checked(file, read_text(file))


@lru_cache(maxsize=16)
def _checked(file: Path, text: str) -> Aircraft:
    """The aircraft of a YAML file that says this; kept, as a sweep's worker asks for it again and again."""
    aircraft = validated(Aircraft, parsed(text, str(file)))
    aircraft._folder = file.parent
    return aircraft
