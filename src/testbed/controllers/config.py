"""Settings of the controllers in a scenario: one class for each type of controller, listed in TABLE."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal, Union

from pydantic import Field, ValidationInfo, field_validator, model_validator

from testbed.aircraft.control_design import Axis
from testbed.inputs.base import NonNegative, Number, Positive, Settings, refuse

Fraction = Annotated[Number, Field(ge=0, le=1)]


class PerKind(Settings):
    """One number for each kind of actuator; a plain number stands for both."""

    servo: Positive
    motor: Positive

    @model_validator(mode="before")
    @classmethod
    def _spread(cls, value: Any) -> Any:
        if isinstance(value, int | float) and not isinstance(value, bool):
            return {"servo": value, "motor": value}
        if not isinstance(value, dict | PerKind):
            raise refuse(f"is {value!r}", "a number, or a mapping with servo and motor")
        return value

    def of(self, kind: str) -> float:
        """The number for actuators of this kind."""
        return float(getattr(self, kind))


class ControllerSettings(Settings):
    """What all controllers share."""

    type: str
    released: tuple[Axis, ...] = ()
    """Axes that are given up while no actuator is flagged as failed."""
    model_error: dict[str, Number] = {}  # noqa: RUF012  (pydantic copies it)
    """Factors on coefficients of the design model, such as `Cm_alpha: 1.2`, to study model error (the paper's section 4)."""


_DEFAULTS_OF_WEIGHTED = {
    "threshold": 0.15,
    "persistence_s": 0.2,
    "recovery": 0.8,
    "filter_rad_s": 20.0,
    "lambda_min": -1.2,
    "lambda_max": 1.2,
}


class AdaptiveInversionSettings(ControllerSettings):
    """The paper's controller: inversion (6), adaptation (13), monitor (29)."""

    type: Literal["adaptive_inversion"] = "adaptive_inversion"
    estimation: Literal["newton", "weighted"] = "newton"
    """`newton` is the paper's (13). `weighted` is a Kalman filter for weather and real sensors: the more gusts disturb a
    rate, the less weight it has. With `weighted` these defaults differ: threshold 0.15, persistence_s 0.2, recovery 0.8,
    filter_rad_s 20, lambda_min -1.2, lambda_max 1.2."""
    gamma: PerKind = PerKind(servo=4.0, motor=4.0)
    """Adaptation rate of (13) [1/s]."""
    epsilon: PerKind = PerKind(servo=0.05, motor=0.05)
    """Half-width of g in (14), in units of the actuator's `scale`."""
    threshold: Fraction = 0.1
    """An actuator whose estimate stays below this is flagged as failed."""
    recovery: Fraction = Field(default=0.6, validate_default=True)
    """A flagged actuator whose estimate stays above this is no longer flagged."""
    persistence_s: NonNegative = 0.1
    """How long the estimate must stay below the threshold [s]."""
    recovery_s: NonNegative = 1.0
    """How long the estimate must stay above `recovery` [s]."""
    flag_std_max: Positive = 0.15
    """Largest standard deviation of an estimate at which its actuator may be flagged, for `weighted`."""
    process_noise_per_root_s: Positive = 0.1
    """Process noise of effectiveness, which `weighted` models as a random walk [1/sqrt(s)]."""
    filter_rad_s: NonNegative = 0.0
    """Corner of two equal first-order lags on both sides of the regression, for noisy sensors [rad/s]; 0 is none."""
    lambda_min: Number = 0.05
    lambda_max: Positive = 1.1
    """Estimates are kept between `lambda_min` and `lambda_max`. `newton` integrates the logarithm of an estimate, so its
    `lambda_min` must be above zero."""

    @model_validator(mode="before")
    @classmethod
    def _defaults_of_weighted(cls, value: Any) -> Any:
        if isinstance(value, dict) and value.get("estimation") == "weighted":
            return {**_DEFAULTS_OF_WEIGHTED, **value}
        return value

    @field_validator("recovery")
    @classmethod
    def _above_threshold(cls, recovery: float, info: ValidationInfo) -> float:
        if recovery <= info.data.get("threshold", 0.0):
            raise refuse(f"{recovery:g} is not above threshold", f"more than {info.data['threshold']:g}")
        return recovery

    @field_validator("lambda_min")
    @classmethod
    def _positive_for_newton(cls, lambda_min: float, info: ValidationInfo) -> float:
        if lambda_min <= 0.0 and info.data.get("estimation") == "newton":
            raise refuse(f"{lambda_min:g} is not above 0, and newton integrates the logarithm", "more than 0")
        return lambda_min

    @field_validator("lambda_max")
    @classmethod
    def _above_min(cls, lambda_max: float, info: ValidationInfo) -> float:
        if lambda_max <= info.data.get("lambda_min", 0.0):
            raise refuse(f"{lambda_max:g} is not above lambda_min", f"more than {info.data['lambda_min']:g}")
        return lambda_max


class FixedInversionSettings(ControllerSettings):
    """Inversion (6) with all actuators taken as healthy: no adaptation, no monitor."""

    type: Literal["fixed_inversion"] = "fixed_inversion"


class PidSettings(ControllerSettings):
    """A conventional autopilot: ruddervator mixer, one throttle, cascaded loops scheduled with dynamic pressure.

    It never gives up an axis: `released` changes nothing. Gains are [1/s] unless the docstring says otherwise. They were
    found by a search (CMA-ES, rounded) on healthy flights only, in calm air and at W20 = 25 ft/s, seeds 1 to 16. The
    search kept the inner loops below 20 rad/s (60 deg of phase margin with the servos' lag), and each outer loop below
    a third of the bandwidth of the loop inside it.
    """

    type: Literal["pid"] = "pid"
    airspeed_kp: NonNegative = 0.7
    airspeed_ki: NonNegative = 0.03
    """[1/s2]"""
    u_dot_max: Positive = 4.0
    """Largest acceleration that airspeed may ask for [m/s2]. With 0.7, airspeed is lost in a climb through sinking air."""
    altitude_kp: NonNegative = 1.5
    altitude_ki: NonNegative = 0.03
    """[rad/(m s)]"""
    climb_max: Positive = 2.0
    """Largest climb rate that altitude may ask for [m/s]."""
    pitch_kp: NonNegative = 6.0
    q_kp: NonNegative = 20.0
    heading_kp: NonNegative = 1.5
    heading_ki: NonNegative = 0.15
    """[1/s2]"""
    roll_kp: NonNegative = 1.5
    """Yaw rate for an error of bank: yawing causes sideslip, and with dihedral sideslip causes roll."""
    roll_max_deg: Positive = 30.0
    r_kp: NonNegative = 20.0


class IndiSettings(ControllerSettings):
    """Incremental nonlinear dynamic inversion: uses measured rates in place of the model's; no estimates, no monitor."""

    type: Literal["indi"] = "indi"
    filter_rad_s: NonNegative = 20.0
    """Corner of two equal first-order lags, on measured rates and on modelled actuators alike [rad/s]; 0 is none."""


class OracleSettings(ControllerSettings):
    """The law of `adaptive_inversion`, told the true effectiveness and failures at once: the bound of any diagnosis."""

    type: Literal["oracle"] = "oracle"
    threshold: Fraction = 0.05
    """An actuator with this true effectiveness or less is given up as failed."""


TABLE: dict[str, type[ControllerSettings]] = {
    "adaptive_inversion": AdaptiveInversionSettings,
    "fixed_inversion": FixedInversionSettings,
    "pid": PidSettings,
    "indi": IndiSettings,
    "oracle": OracleSettings,
}
"""Settings by the `type` of a scenario's `controller`; `make.CONSTRUCTORS` has the class that flies them."""

if TYPE_CHECKING:
    AnyController = ControllerSettings
else:
    AnyController = Annotated[Union[tuple(TABLE.values())], Field(discriminator="type")]  # noqa: UP007
