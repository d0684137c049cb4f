"""The `sensors` block of a scenario: `ideal`, `mems`, or a mapping with changes to one of them and with faults.

White noise is given by N, the root of its one-sided spectral density, in units per root hertz. Sampled at `rate_hz`, its
standard deviation is N sqrt(rate_hz / 2). The two-sided spectral density is N^2 / 2.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Field, create_model, model_serializer, model_validator

from testbed.inputs.base import NonNegative, Number, Positive, Settings, any_of, refuse, retype
from testbed.inputs.problems import OWN_PART, guess
from testbed.sensors.channels import CHANNELS, SI
from testbed.sensors.faults import TABLE, SensorFault, clash

Scale = Annotated[Number, Field(gt=-1, lt=1)]


class SensorModel(Settings):
    """Errors of one sensor, all zero by default. They act in this order:

    reading(t) = [(1 + scale error) low_pass(truth) + bias + drift + wander + noise] delayed, then quantised.
    """

    unit: ClassVar[str]

    low_pass_rad_s: NonNegative = 0.0
    """Bandwidth of the first-order lag with which the sensor follows the truth; 0 is none."""
    delay_s: NonNegative = 0.0
    """Age of the reading, to the nearest whole control step."""
    scale_error: Scale = 0.0
    """Relative error of the scale, the same in every flight."""
    scale_error_sigma: Annotated[Number, Field(ge=0, lt=1)] = 0.0
    """Standard deviation of a scale error that is drawn for each flight and added to `scale_error`."""
    wander_time_s: Positive = 10.0
    """Correlation time of the wander, a stationary first-order Gauss-Markov process."""

    def si(self, name: str) -> float:
        """A setting with a unit, in SI: `noise`, `bias`, `bias_sigma`, `drift`, `wander` or `resolution`."""
        value: float = getattr(self, name + _SUFFIX[name].format(self.unit)) * SI[self.unit]
        return value


# Settings in the sensor's unit, and the end of their names, with {} for the unit. Noise is a density, in units per root hertz.
# Drift is a random walk, in units per root second.
_SUFFIX = {
    "noise": "_{}_rthz",
    "bias": "_{}",
    "bias_sigma": "_{}",
    "drift": "_{}_rts",
    "wander": "_{}",
    "resolution": "_{}",
}


def _model(name: str, unit: str) -> type[SensorModel]:
    """The model of a sensor that reads in this unit."""
    fields: dict[str, Any] = {
        name + suffix.format(unit): (Number if name == "bias" else NonNegative, 0.0)
        for name, suffix in _SUFFIX.items()
    }
    doc = SensorModel.__doc__
    made = create_model(name, __base__=SensorModel, __module__=__name__, __doc__=doc, **fields)
    made.unit = unit
    return made


# By their own names in this module, so that a scenario can be pickled.
AngularRate = _model("AngularRate", "deg_s")
Angle = _model("Angle", "deg")
Acceleration = _model("Acceleration", "m_s2")
Speed = _model("Speed", "m_s")
Length = _model("Length", "m")
_MODELS = {model.unit: model for model in (AngularRate, Angle, Acceleration, Speed, Length)}
SENSORS: dict[str, type[SensorModel]] = {c.sensor: _MODELS[c.unit] for c in CHANNELS}
# A vane on a boom with a 12 bit encoder; 0.3 deg at 200 Hz.
_VANE = {"noise_deg_rthz": 0.03, "bias_sigma_deg": 0.3, "resolution_deg": 0.088, "low_pass_rad_s": 60.0}
MEMS: dict[str, dict[str, float]] = {
    # ICM-20689, BMI088 class; bias and scale as left by a calibration on the ground. 0.07 deg/s at 200 Hz.
    "gyro": {
        "noise_deg_s_rthz": 0.007,
        "bias_sigma_deg_s": 0.05,
        "drift_deg_s_rts": 0.001,
        "scale_error_sigma": 0.005,
        "resolution_deg_s": 0.0153,  # +-500 deg/s in 16 bits
        "low_pass_rad_s": 578.0,  # the 92 Hz filter on the chip
    },
    "accelerometer": {
        "noise_m_s2_rthz": 0.0015,  # 150 ug/rtHz
        "bias_sigma_m_s2": 0.03,  # 3 mg left by calibration
        "drift_m_s2_rts": 0.0005,
        "scale_error_sigma": 0.005,
        "resolution_m_s2": 0.0024,  # +-8 g in 16 bits
        "low_pass_rad_s": 578.0,
    },
    # Output of an attitude estimator (EKF), whose error is correlated over several seconds.
    "attitude": {"wander_deg": 0.4, "wander_time_s": 10.0, "noise_deg_rthz": 0.003},
    "heading": {"wander_deg": 0.5, "wander_time_s": 20.0, "bias_sigma_deg": 0.5, "noise_deg_rthz": 0.003},
    # MS4525DO class at 18 m/s, zeroed on the ground, with its tube; 0.3 m/s at 200 Hz.
    "airspeed": {
        "noise_m_s_rthz": 0.03,
        "bias_sigma_m_s": 0.2,
        "wander_m_s": 0.2,
        "wander_time_s": 30.0,
        "scale_error_sigma": 0.01,
        "low_pass_rad_s": 60.0,
    },
    "alpha": _VANE,
    "beta": _VANE,
    # MS5611 class: 0.15 m at 200 Hz; the wander is the effect of wind on the static pressure.
    "altitude": {
        "noise_m_rthz": 0.015,
        "wander_m": 0.3,
        "wander_time_s": 60.0,
        "resolution_m": 0.01,
        "low_pass_rad_s": 30.0,
    },
    # Output of the same estimator, from barometer and accelerometer.
    "climb_rate": {"noise_m_s_rthz": 0.005, "wander_m_s": 0.1, "wander_time_s": 5.0},
    # Satellite navigation, without corrections.
    "position": {"noise_m_rthz": 0.02, "wander_m": 1.5, "wander_time_s": 100.0, "delay_s": 0.1},
}
"""The sensors of a small UAV, `sensors: mems`: MEMS inertial sensors, a barometer, a pitot tube, vanes. The values are typical of
the datasheets that docs/reference/sensors.md names for each sensor. They were written from memory, not copied from them."""
PRESETS: dict[str, dict[str, dict[str, float]]] = {"ideal": {}, "mems": MEMS}


class SensorSettings(Settings):
    """All sensors of an aircraft, one block each. What a block does not set has the value of the preset `model`."""

    model: str = "ideal"
    faults: tuple[SensorFault, ...] = ()

    @model_validator(mode="before")
    @classmethod
    def _complete(cls, value: Any) -> Any:
        """Complete the sensors from a preset: the value is its name, or a mapping that names it with the key `model`."""
        if isinstance(value, SensorSettings):
            return value
        if isinstance(value, str):
            if value not in PRESETS:
                raise refuse(f"{value!r} is not known ({OWN_PART})", *guess(value, PRESETS))
            value = {"model": value}
        if not isinstance(value, dict):
            raise refuse(f"is {value!r}", "ideal, mems or a mapping")
        whole = dict(value)
        for sensor, preset in PRESETS.get(str(value.get("model", "ideal")), {}).items():
            said = value.get(sensor, {})
            if isinstance(said, dict):
                whole[sensor] = {**preset, **said}
        return whole

    @model_validator(mode="after")
    def _consistent(self) -> SensorSettings:
        heading = self.of("heading")
        if heading.scale_error or heading.scale_error_sigma:
            raise refuse("heading has a scale error, which an angle all round cannot have", "none")
        for (i, one), (j, other) in combinations(enumerate(self.faults), 2):
            name = clash(one, other)
            if name:
                raise refuse(
                    f"faults {i} and {j} both decide what {name} reads", "time windows that do not overlap"
                )
        return self

    @model_serializer(mode="wrap")
    def _shortest(self, write: Any) -> Any:
        return "ideal" if self.is_ideal else write(self)

    def of(self, sensor: str) -> SensorModel:
        """Model of one sensor."""
        model: SensorModel = getattr(self, sensor)
        return model

    @property
    def is_ideal(self) -> bool:
        """Whether the controller is simply told the truth."""
        return not self.faults and all(self.of(name) == model() for name, model in SENSORS.items())


if TYPE_CHECKING:
    Sensors = SensorSettings
else:
    Sensors = create_model(
        "Sensors",
        __base__=SensorSettings,
        __module__=__name__,
        __doc__=SensorSettings.__doc__,
        **{name: (model, model()) for name, model in SENSORS.items()},
    )


def take_parts() -> None:
    """Take the faults and presets that their tables have now."""
    retype(Sensors, model=Literal[tuple(PRESETS)], faults=tuple[any_of(TABLE), ...])  # type: ignore[misc]


take_parts()
