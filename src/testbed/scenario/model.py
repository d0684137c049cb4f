"""The model of a scenario: every key of its YAML with default, range and meaning."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any

from pydantic import AfterValidator, Discriminator, Field, PrivateAttr, Tag, ValidationInfo, field_validator

from testbed.air.config import Atmosphere
from testbed.aircraft.changes import ChangedAircraft
from testbed.common.files import slug
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.config import AdaptiveInversionSettings, AnyController
from testbed.failures import TABLE as FAILURES
from testbed.failures import Failure
from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, Whole, any_of, refuse, retype
from testbed.inputs.yaml_source import Source
from testbed.scenario.requirement import Requirement
from testbed.sensors import settings
from testbed.sensors.settings import Sensors

_TURN_DEG_S, _TURN_BANK = 4.0, math.radians(20.0)
MOST_FAILURES = 1000
"""Each is compared with those before it."""
MAX_RATE_HZ = 10_000
"""Highest rate of control and physics steps [Hz]: with it, to find a trim takes some seconds of computing."""
MAX_NAME = 120
"""Longest name of a flight [characters]: folders are named after it, and file systems allow 255."""


def _all_round(heading_deg: float) -> float:
    if not 0.0 <= heading_deg <= 360.0:
        raise refuse(f"is {heading_deg:g}", "0 to 360", f"{heading_deg % 360.0:g}")
    return heading_deg


Heading = Annotated[
    Number, AfterValidator(_all_round), Field(json_schema_extra={"minimum": 0, "maximum": 360})
]
"""An angle clockwise from north [deg]."""


class Initial(Settings):
    """Initial condition: trimmed level flight."""

    altitude_m: Number
    """Above mean sea level, which is also the height of the ground."""
    airspeed_m_s: Positive
    """Relative to the air, also in wind."""
    heading_deg: Heading = 0.0
    """Clockwise from north."""


class Command(Settings):
    """New values to fly to from `at_s` on; a value that is not given does not change."""

    at_s: NonNegative
    """Time since the start of the flight."""
    altitude_m: Number | None = None
    """Above mean sea level."""
    airspeed_m_s: Positive | None = None
    """Relative to the air."""
    heading_deg: Heading | None = None
    """Clockwise from north; flown to the short way round."""


class CommandRates(Settings):
    """Rates at which the references approach a new command."""

    heading_deg_s: Positive | None = None
    """By default 4, or the rate of a turn with 20 deg of bank at the initial airspeed if that is less."""
    altitude_m_s: Positive = 1.0
    """Rate of the altitude reference, up and down."""
    airspeed_m_s2: Positive = 0.5
    """Rate of the airspeed reference, up and down."""


def _shape(value: Any) -> str:
    return "mapping" if isinstance(value, dict | ChangedAircraft) else "text"


AnyAircraft = Annotated[
    Annotated[Text, Tag("text")] | Annotated[ChangedAircraft, Tag("mapping")], Discriminator(_shape)
]
"""An aircraft's name or folder, or a mapping with changes to it."""


class Scenario(Settings):
    """Everything that determines a flight, except the files of its aircraft."""

    name: Text = Field(max_length=MAX_NAME)
    """Title of the flight; the run folder is named after it."""
    aircraft: AnyAircraft
    """Name of a shipped aircraft, or path of an aircraft folder with a slash, such as `./mine`; or a mapping with this as `name`,
    and changes to the truth that the controller does not know."""
    duration_s: Positive
    """Duration of the flight, if nothing ends it earlier [s]; a whole number of control steps."""
    rate_hz: Whole = Field(default=200, gt=0, le=MAX_RATE_HZ)
    """Control steps per second."""
    physics_hz: Whole = Field(default=0, validate_default=True, le=MAX_RATE_HZ)
    """Physics steps per second, a whole multiple of `rate_hz`; 0 means `rate_hz`."""
    log_hz: Whole = Field(default=0, validate_default=True)
    """Logged rows per second, `rate_hz` divided by a whole number; 0 means `rate_hz`."""
    seed: Whole = 1
    """Seed of everything random: turbulence, sensor errors, random failures."""
    initial: Initial
    controller: AnyController = AdaptiveInversionSettings()
    """The controller, by its `type`, and its settings."""
    commands: tuple[Command, ...] = Field(default=(), validate_default=True)
    command_rates: CommandRates = Field(default=CommandRates(), validate_default=True)
    reference: Text | None = None
    """Name of a reference of your own, flown to in place of the commands; needs `--with` its file."""
    failures: tuple[Failure, ...] = Field(default=(), max_length=MOST_FAILURES)
    """The failures: what breaks, when, and how."""
    sensors: Sensors = Sensors()
    atmosphere: Atmosphere = Atmosphere()
    requirements: tuple[Requirement, ...] = ()
    _source: Source = PrivateAttr(default_factory=Source)

    @field_validator("physics_hz")
    @classmethod
    def _multiple(cls, physics_hz: int, info: ValidationInfo) -> int:
        rate = info.data.get("rate_hz", 1)
        if physics_hz % rate:
            below = max(physics_hz // rate, 1) * rate
            raise refuse(
                f"{physics_hz} is no whole multiple of rate_hz {rate}", f"such as {below} or {below + rate}"
            )
        return physics_hz or rate

    @field_validator("log_hz")
    @classmethod
    def _divisor(cls, log_hz: int, info: ValidationInfo) -> int:
        rate = info.data.get("rate_hz", 0)
        if log_hz and rate % log_hz:
            raise refuse(f"{log_hz} does not divide rate_hz {rate}", f"{rate} divided by a whole number")
        return log_hz or rate

    @field_validator("commands")
    @classmethod
    def _complete(cls, commands: tuple[Command, ...], info: ValidationInfo) -> tuple[Command, ...]:
        """Make the first command one at 0 s with all values; those that the file does not give are the initial condition's."""
        times = [command.at_s for command in commands]
        if any(later <= earlier for earlier, later in pairwise(times)):
            raise refuse(f"are at {', '.join(f'{t:g}' for t in times)} s", "ascending times")
        initial = info.data.get("initial")
        if initial is None:
            return commands
        first, rest = (
            (commands[0], commands[1:]) if times and times[0] == 0 else (Command(at_s=0.0), commands)
        )
        said = first.model_dump(exclude_none=True)
        return (Command.model_validate({**initial.model_dump(), **said}), *rest)

    @field_validator("command_rates")
    @classmethod
    def _turnable(cls, rates: CommandRates, info: ValidationInfo) -> CommandRates:
        initial = info.data.get("initial")
        if rates.heading_deg_s is not None or initial is None:
            return rates
        bank = math.degrees(GRAVITY_M_S2 * math.tan(_TURN_BANK) / initial.airspeed_m_s)
        return rates.model_copy(update={"heading_deg_s": min(_TURN_DEG_S, bank)})

    @property
    def physics_steps(self) -> int:
        """Physics steps in one control step."""
        return self.physics_hz // self.rate_hz

    @property
    def steps(self) -> int:
        """Control steps in the whole flight."""
        return round(self.duration_s * self.rate_hz)

    @property
    def slug(self) -> str:
        """The name as a file name."""
        return slug(self.name, otherwise="flight")

    @property
    def source(self) -> Source:
        """The file and line of each value; empty for a scenario made in Python."""
        return self._source


def take_parts() -> None:
    """Take the types that the tables of failures and of sensors have now."""
    settings.take_parts()
    retype(Scenario, failures=tuple[any_of(FAILURES), ...])  # type: ignore[misc]


take_parts()
