"""The model of a suite's file: every key with its meaning. Where a value is drawn it is a distribution, as in a sweep's `vary`."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, Field, field_validator, model_validator

from testbed.controllers.config import AnyController
from testbed.failures import TABLE as FAILURES
from testbed.inputs.base import Number, Positive, Settings, Text, refuse
from testbed.inputs.problems import guess
from testbed.inputs.yaml_source import describe
from testbed.sensors.faults import TABLE as SENSOR_FAULTS
from testbed.sensors.settings import PRESETS
from testbed.studies.benchmark.limits import Limits
from testbed.studies.drawing.distributions import Distribution
from testbed.studies.model import Study

Share = Annotated[Number, Field(ge=0, le=1)]
Range = tuple[Positive, Positive]
SHARES = {
    "stuck_at": {"value": "place"},
    "position_limit": {"low": "place", "high": "place"},
    "bias": {"value": "travel"},
    "oscillation": {"amplitude": "travel"},
    "runaway": {"rate": "speed"},
    "rate_limit": {"value": "rate"},
    "lag": {"lag_rad_s": "lag"},
}
"""Keys of failures that a suite gives as a share: of the way from the lowest to the highest command, of that distance, of that
distance per second, of the servo's rate limit, of the corner frequency of its lag."""


def _of_numbers(drawn: Distribution) -> Distribution:
    options = drawn.parameters if drawn.name == "choice" else ()
    for option in options:
        if isinstance(option, bool) or not isinstance(option, int | float):
            raise refuse(f"can draw {describe(option)}", "numbers")
    return drawn


Numbers = Annotated[Distribution, AfterValidator(_of_numbers)]


def _one_of(name: str, known: Any) -> str:
    if name not in known:
        raise refuse(f"{name!r} is not known", *guess(name, known))
    return name


def _among(known: Any) -> AfterValidator:
    return AfterValidator(lambda name: _one_of(name, known))


class Craft(Settings):
    """An aircraft of a suite, by its shipped name or by what is adopted, and where it is flown."""

    adopt: Text | None = None
    """Name of a model in the jsbsim package, which is adopted for it; default: a shipped aircraft."""
    weight: Positive = 1.0
    """How often it is drawn, against the others."""
    span_m: Positive
    """Wing span [m]."""
    airspeed_m_s: Range
    """Lowest and highest airspeed at which a flight begins, and that is commanded [m/s]."""
    altitude_m: Range
    """Lowest and highest altitude at which a flight begins, and that is commanded [m]."""
    mass_kg: Positive | None = None
    """Mass with everything on board [kg]; where it is given, a changed truth may have another."""
    chord_m: Positive | None = None
    """Mean chord of the wing [m]; where it is given, a changed truth may have another centre of gravity."""
    coefficients: tuple[Text, ...] = ()
    """Aerodynamic functions of the model that a changed truth may have otherwise."""
    w20_factor: Positive = 1.0
    """Factor on the W20 of the weather. Above 2000 ft turbulence has steps: any W20 below 11.6 m/s is the same light one."""

    def placed(self, name: str) -> str:
        """How a scenario names this aircraft of the suite, beside those that are adopted: the same on every machine."""
        return name if self.adopt is None else f"./{self.adopt}"


class Truth(Settings):
    """How the aircraft differs from its files, which are all that the controller knows."""

    share: Share
    """Share of the flights in which it differs; each of the following then does in half of them."""
    mass: Numbers
    """Factor on the mass."""
    cg_shift: Numbers
    """Shift of the centre of gravity aft, in chords."""
    coefficient: Numbers
    """Factor on each of the aircraft's `coefficients`."""
    servo: Numbers
    """Factor on the corner frequency of all servos' lags."""


class References(Settings):
    """What is commanded: legs, each with a new heading, and perhaps a new altitude and airspeed."""

    legs: Numbers
    """Number of legs."""
    at_s: Numbers
    """When a leg begins [s]."""
    heading_deg: Numbers
    """Change of heading [deg]."""
    altitude_s: Numbers
    """Change of altitude, in seconds of flight at the first airspeed; the other way where it would leave `altitude_m`."""
    airspeed: Numbers
    """Airspeed, as a factor on the first one; within the aircraft's range."""
    bank_deg: Numbers
    """Bank of the turns, which sets the rate of the heading's reference [deg]."""
    slope: Numbers
    """Slope of climbs and descents, which sets the rate of the altitude's reference."""


class Weather(Settings):
    """One kind of weather."""

    weight: Positive
    """How often it is drawn, against the others."""
    turbulence_w20_m_s: Numbers | None = None
    """W20 of MIL-F-8785C [m/s]; none by default."""
    wind_m_s: Numbers | None = None
    """Steady wind from any side [m/s]; none by default."""


class Gusts(Settings):
    """A 1-cosine gust along one of the body axes."""

    share: Share
    """Share of the flights that have one."""
    with_failure: Share
    """Share of these gusts that begin with the first failure; the others at any time."""
    magnitude: Numbers
    """Velocity, as a share of the airspeed."""
    duration_s: Numbers
    """Duration of the rise [s]; the fall takes as long."""


class SensorFaultEntry(Settings):
    """One way in which a sensor fails. `values` are the keys of the fault, as in a scenario."""

    type: Annotated[Text, _among(SENSOR_FAULTS)]
    sensor: Text
    weight: Positive = 1.0
    values: dict[str, Distribution] = {}  # noqa: RUF012  (pydantic copies it)


class SensorFaults(Settings):
    """Faults of sensors, in flights whose sensors are not ideal."""

    share: Share
    """Share of these flights in which a sensor fails."""
    at_s: Numbers
    """When [s]."""
    ends: Share
    """Share of the faults that end."""
    lasts_s: Numbers
    """How long those last [s]."""
    faults: Annotated[tuple[SensorFaultEntry, ...], Field(min_length=1)]


class FailureEntry(Settings):
    """One way in which an actuator fails. `values` are the keys of the failure, as in a scenario, but where they are of the
    actuator's travel, rate or lag: there they are shares of that, so that one entry suits every actuator.

    Of a `property` failure, `values` are properties below the prefix of each actuator `of` a kind: all of them are held.
    """

    type: Annotated[Text, _among(FAILURES)]
    family: Text
    """What results are counted by."""
    weight: Positive = 1.0
    """How often it is drawn, against the others."""
    of: Literal["servo", "motor"] | None = None
    """Kind of the actuators that fail so; an engine counts as a motor. Default: every kind that can."""
    values: dict[str, Distribution] = {}  # noqa: RUF012

    @model_validator(mode="after")
    def _whose(self) -> FailureEntry:
        if self.type == "property" and self.of is None:
            raise refuse("does not say whose properties", "of: servo or motor")
        for key in SHARES.get(self.type, {}).keys() & self.values.keys():
            _of_numbers(self.values[key])
        return self


class Failures(Settings):
    """How many failures a flight has, when, on which actuators, and whether they end."""

    count: Numbers
    """Number of failures, without those that come back."""
    first_s: Numbers
    """When the first begins [s]."""
    together: Share
    """Share of the further ones that begin with the one before."""
    after_s: Numbers
    """How long after the one before the others begin [s]."""
    same: Share
    """Share of the further ones that befall the actuator of the one before."""
    ends: Share
    """Share of the failures that end, of those that can."""
    lasts_s: Numbers
    """How long those last [s]."""
    back: Share
    """Share of those that come back, once."""
    back_after_s: Numbers
    """How long after its end a failure comes back [s]."""
    types: Annotated[tuple[FailureEntry, ...], Field(min_length=1)]


class Suite(Settings):
    """A distribution of flights, and the controllers that are compared on them."""

    suite: Text
    """Name."""
    version: Annotated[int, Field(strict=True, gt=0)]
    """Results of one version can be compared, those of two cannot."""
    purpose: Text
    """What it is for, in a sentence."""
    duration_s: Positive
    """Duration of each flight [s]."""
    rate_hz: Annotated[int, Field(strict=True, gt=0)] = 200
    """Control steps per second."""
    time_limit_s: Positive = 300.0
    """Wall time [s] after which a flight counts as lost, since its controller takes too long."""
    controllers: Annotated[dict[str, AnyController], Field(min_length=1)]
    """`controller` blocks of a scenario, by the name under which each is compared. The first is the one that the others are
    compared with."""
    told: tuple[Text, ...] = ()
    """Those that are told the truth, and so say what is possible."""
    limits: Limits
    aircraft: Annotated[dict[str, Craft], Field(min_length=1)]
    truth: Truth | None = None
    references: References
    weather: Annotated[dict[str, Weather], Field(min_length=1)]
    gusts: Gusts | None = None
    sensors: Annotated[dict[str, Positive], Field(min_length=1)]
    """How often each of the presets `ideal` and `mems` is drawn."""
    sensor_faults: SensorFaults | None = None
    failures: Failures | None = None

    @field_validator("sensors")
    @classmethod
    def _presets(cls, sensors: dict[str, float]) -> dict[str, float]:
        for name in sensors:
            _one_of(name, PRESETS)
        return sensors

    @model_validator(mode="after")
    def _flown(self) -> Suite:
        for name in self.told:
            _one_of(name, self.controllers)
        return self


class Draws(Study):
    """The kind of study that flies the draws of a suite."""

    word: ClassVar[str] = "benchmark"
    free: ClassVar[tuple[str, ...]] = ("draws", "file", "word")

    scenario: Text | dict[str, Any] = "drawn"
