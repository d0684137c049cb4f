"""Settings of the controllers in a scenario: one class for each type of controller, listed in TABLE."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any, Literal, Union

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    StrictBool,
    ValidationInfo,
    field_validator,
    model_validator,
)

from testbed.aircraft.control_design import DERIVED, Axis, ControlDesign
from testbed.aircraft.design_model import NOT_GYROSCOPIC, DesignModel
from testbed.inputs.base import NonNegative, Number, Positive, Settings, refuse

Fraction = Annotated[Number, Field(ge=0, le=1)]


def _above_min(lambda_max: float, info: ValidationInfo) -> float:
    lambda_min = info.data.get("lambda_min", 0.0)
    if lambda_max <= lambda_min:
        raise refuse(f"{lambda_max:g} is not above lambda_min", f"more than {lambda_min:g}")
    return lambda_max


Highest = Annotated[Positive, AfterValidator(_above_min)]
"""A `lambda_max`, which is above the `lambda_min` before it."""


class PerKind(Settings):
    """One number for each kind of actuator; a plain number stands for both. That of a motor is for engines too."""

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
        return self.servo if kind == "servo" else self.motor


class ControllerSettings(Settings):
    """What all controllers share."""

    type: str
    released: tuple[Axis, ...] | None = None
    """Axes that are given up while no actuator is flagged as failed. Without this key, or with `auto`, they are derived from the
    aircraft's design model: those that gusts disturb by more than its actuators can give (see `testbed identify`)."""
    model_error: dict[str, Number] = {}  # noqa: RUF012  (pydantic copies it)
    """Factors on coefficients of the design model, such as `Cm_alpha: 1.2`, to study model error (the paper's section 4)."""
    parameters: dict[str, Any] = {}  # noqa: RUF012
    """Parameters for a controller of your own (`--controller`), by the names that its class declares. No other takes any."""

    @field_validator("released", mode="before")
    @classmethod
    def _automatic(cls, released: Any) -> Any:
        return None if released == "auto" else released

    def applied_to(self, control: ControlDesign) -> ControlDesign:
        """The aircraft's control design as this controller uses it."""
        return control

    def believed(self, model: DesignModel) -> DesignModel:
        """The aircraft's design model as this controller believes it."""
        return model.with_error(self.model_error)


_DEFAULTS_OF_NEWTON = {
    "threshold": 0.1,
    "recovery": 0.6,
    "filter_rad_s": 0.0,
    "lambda_min": 0.05,
    "lambda_max": 1.1,
}
_DEFAULTS_OF_PAPER = {"preset": "paper", "estimation": "newton", "released": ()}
_OF_NEWTON_ALONE = {"gamma", "epsilon"}

Part = Literal[
    "estimate",
    "monitor",
    "model_error",
    "speed_rule",
    "jam_test",
    "offset_test",
    "lateness",
    "actuator_model",
    "probing",
    "sensor_guard",
]
"""A part of the default law that can be switched off by `ablate`."""


class AdaptiveInversionSettings(ControllerSettings):
    """The paper's controller, inversion (6), (29), adaptation (13) and monitor, and what weather and real sensors add to it."""

    type: Literal["adaptive_inversion"] = "adaptive_inversion"
    preset: Literal["default", "paper"] = "default"
    """`default` is the law for calm air and weather. `paper` is the paper's alone, for calm air and ideal sensors: `estimation:
    newton`, and no axis given up while nothing has failed. It is also what `estimation: newton`, `gamma` or `epsilon` choose."""
    estimation: Literal["weighted", "newton"] = "weighted"
    """`weighted` is a Kalman filter for weather and real sensors: the more gusts disturb a rate, the less weight it has. `newton`
    is the paper's (13). With `newton` these defaults differ: threshold 0.1, recovery 0.6, filter_rad_s 0,
    lambda_min 0.05, lambda_max 1.1."""
    gamma: PerKind = PerKind(servo=4.0, motor=4.0)
    """Adaptation rate of (13) [1/s], for `newton`."""
    epsilon: PerKind = PerKind(servo=0.05, motor=0.05)
    """Half-width of g in (14), in units of the actuator's `scale`, for `newton`."""
    threshold: Fraction = 0.06
    """An actuator whose estimate stays below this is flagged as failed."""
    propeller_threshold: Fraction | None = None
    """In place of `threshold` for a motor or engine, whose estimate is more certain than a surface's. With neither given it is
    0.12 for `weighted`; else it is `threshold`."""
    recovery: Fraction = Field(default=0.8, validate_default=True)
    """A flagged actuator whose estimate stays above this is no longer flagged."""
    persistence_s: NonNegative = 0.1
    """How long the estimate must stay below the threshold [s]."""
    recovery_s: NonNegative = 1.0
    """How long the estimate must stay above `recovery` [s]."""
    flag_std_max: Positive = 0.15
    """Largest standard deviation of an estimate at which its actuator may be flagged, for `weighted`."""
    process_noise_per_root_s: Positive = 0.1
    """Process noise of effectiveness, which `weighted` models as a random walk [1/sqrt(s)]."""
    filter_rad_s: NonNegative = 20.0
    """Corner of two equal first-order lags on both sides of the regression, for noisy sensors [rad/s]; 0 is none."""
    lambda_min: Number = -1.2
    """Lowest estimate. `newton` integrates the logarithm of an estimate, so its `lambda_min` must be above zero."""
    lambda_max: Highest = Field(default=1.2, validate_default=True)
    """Highest estimate."""
    ablate: tuple[Part, ...] = ()
    """Parts of the law to switch off, to measure what each brings: `estimate` (references are not divided by the estimates),
    `monitor` (nothing is flagged for a low estimate), `model_error` (the model's own error is neither estimated nor inverted),
    `speed_rule` (no other airspeed after a failure, no altitude given up for it), `jam_test` (no jam or reversal is looked for),
    `offset_test` (an offset is taken for a jam), `lateness` (actuators are
    taken to act in time), `actuator_model` (actuators are taken to be where they are commanded, at once and without stops: the
    paper's (10)), `probing` (what is given up stands still at its trim position), `sensor_guard` (stuck sensors are believed)."""

    def applied_to(self, control: ControlDesign) -> ControlDesign:
        """See `ControllerSettings.applied_to`."""
        if "speed_rule" not in self.ablate:
            return control
        without = {"slow_descent_s": 0.0, "lost_thrust_faster_m_s": 0.0}
        return control.model_copy(update={"loops": control.loops.model_copy(update=without)})

    def believed(self, model: DesignModel) -> DesignModel:
        """The paper's model of an aircraft has no gyroscopic moments."""
        model = super().believed(model)
        return replace(model, gyroscopic=NOT_GYROSCOPIC) if self.preset == "paper" else model

    @model_validator(mode="before")
    @classmethod
    def _defaults(cls, value: Any) -> Any:
        """Defaults that depend on the preset and on the estimation."""
        if not isinstance(value, dict):
            return value
        if value.get("preset", "paper" if _asks_for_newton(value) else "") == "paper":
            value = {**_DEFAULTS_OF_PAPER, **value}
        if value.get("estimation") == "newton":
            value = {**_DEFAULTS_OF_NEWTON, **value}
        elif "threshold" not in value:
            value = {"propeller_threshold": 0.12, **value}
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


def _asks_for_newton(value: dict[str, Any]) -> bool:
    """Whether a `controller` block without a preset means the paper's law, by its estimation or by settings of that alone."""
    if "estimation" in value:
        return bool(value["estimation"] == "newton")
    return bool(_OF_NEWTON_ALONE & value.keys())


class FixedInversionSettings(ControllerSettings):
    """Inversion (6) with all actuators taken as healthy: no adaptation, no monitor."""

    type: Literal["fixed_inversion"] = "fixed_inversion"


class PidSettings(ControllerSettings):
    """A conventional autopilot: cascaded loops, and an allocation from the design model, scheduled with dynamic pressure.

    With `p_dot` released, bank is controlled by yawing (`roll_kp`), else by rolling (`bank_kp`, `p_kp`). What is not given suits
    the aircraft (`controllers.pid`). Gains are in 1/s unless another unit is given.
    """

    type: Literal["pid"] = "pid"
    airspeed_kp: NonNegative = DERIVED
    """Acceleration for an error of airspeed."""
    airspeed_ki: NonNegative = DERIVED
    """Acceleration for the integral of that error [1/s2]."""
    airspeed_error_max_m_s: Positive = DERIVED
    """The airspeed error is limited to this [m/s]."""
    u_dot_max: Positive = DERIVED
    """Largest acceleration that airspeed may ask for, besides that for the climb [m/s2]."""
    altitude_kp: NonNegative = DERIVED
    """Climb rate for an error of altitude."""
    altitude_ki: NonNegative = DERIVED
    """Pitch for the integral of that error [rad/(m s)]."""
    altitude_error_max_m: Positive = DERIVED
    """The altitude error is limited to this [m]."""
    climb_max: Positive = DERIVED
    """Largest climb rate that altitude may ask for [m/s]."""
    pitch_kp: NonNegative = DERIVED
    """Pitch rate for an error of pitch."""
    q_kp: NonNegative = DERIVED
    """Pitch acceleration for an error of pitch rate."""
    heading_kp: NonNegative = DERIVED
    """Turn rate for an error of heading."""
    heading_ki: NonNegative = DERIVED
    """Turn rate for the integral of that error [1/s2]."""
    roll_kp: NonNegative = DERIVED
    """Yaw rate for an error of bank: yawing causes sideslip, and with dihedral sideslip causes roll."""
    bank_kp: NonNegative = DERIVED
    """Roll rate for an error of bank."""
    p_kp: NonNegative = DERIVED
    """Roll acceleration for an error of roll rate."""
    roll_max_deg: Positive = DERIVED
    """Largest bank that heading may ask for [deg]."""
    r_kp: NonNegative = DERIVED
    """Yaw acceleration for an error of yaw rate."""


class RegressionSettings(ControllerSettings):
    """What the controllers share that compare measured rates with modelled actuators."""

    filter_rad_s: NonNegative = 20.0
    """Corner of two equal first-order lags on both, for noisy sensors [rad/s]; 0 is none."""


class IndiSettings(RegressionSettings):
    """Incremental nonlinear dynamic inversion: uses measured rates in place of the model's; no estimates."""

    type: Literal["indi"] = "indi"
    monitor: StrictBool = False
    """Diagnose failures as `adaptive_inversion` does by default, and switch modes as it does."""


class AdaptiveIndiSettings(RegressionSettings):
    """`indi` that learns its input matrix in flight by least mean squares, and diagnoses nothing."""

    type: Literal["adaptive_indi"] = "adaptive_indi"
    learning_filter_rad_s: Positive = 50.0
    """Corner of the same for learning [rad/s]. With a low one, actuators seem weak: the commands that answer a gust are taken for
    its cause."""
    mu_s: NonNegative = 0.1
    """Adaptation constant [s]: an actuator that moves at one of its units (`scale`) per second is learnt at this rate [1/s]."""
    factor_max: Annotated[Number, Field(gt=1)] = 2.0
    """How many times its first value an element of the input matrix may become, or how many times less."""


class MracSettings(ControllerSettings):
    """Inversion (6) with a model-reference adaptive part that makes up for what the model leaves out; diagnoses nothing."""

    type: Literal["mrac"] = "mrac"
    error_rad_s: Positive = 8.0
    """Rate at which the error of p, q and r against the reference model decays [rad/s]; that of airspeed a tenth of it."""
    adaptation: Positive = 0.25
    """Adaptation rate: the stiffness of that error that a regressor of size 1 makes, in units of `error_rad_s` squared. With
    0.25 it is critically damped."""
    e_modification: NonNegative = 0.5
    """Leakage of the parameters, in proportion to the error [1]."""
    authority_max: Positive = 1.0
    """Bound of the parameters of each rate, in units of what the actuators give with one `scale` of each."""


class L1InversionSettings(RegressionSettings):
    """Inversion with a fast estimator, a low-pass filter in the control channel, and a separate, slow monitor."""

    type: Literal["l1_inversion"] = "l1_inversion"
    fast_gamma: Positive = 20.0
    """Rate of the fast estimator [1/s]."""
    control_rad_s: Positive = 10.0
    """Corner of the low-pass filter in the control channel [rad/s]: how fast commands follow the fast estimates."""
    epsilon: Positive = 0.05
    """Half-width of g in (14), in units of the actuator's `scale`."""
    lambda_min: Positive = 0.05
    """Lowest fast estimate."""
    lambda_max: Highest = Field(default=2.0, validate_default=True)
    """Highest fast estimate."""
    monitor: StrictBool = True
    """Diagnose failures as `adaptive_inversion` does by default, and switch modes as it does."""


class RlsInversionSettings(RegressionSettings):
    """Inversion (6) with effectiveness by recursive least squares with forgetting: it adapts, and diagnoses nothing."""

    type: Literal["rls_inversion"] = "rls_inversion"
    forgetting_s: Positive = 2.0
    """Time constant with which old measurements are forgotten [s]."""
    lambda_min: Positive = 0.1
    """Lowest estimate."""
    lambda_max: Highest = Field(default=1.2, validate_default=True)
    """Highest estimate."""


class ImmInversionSettings(RegressionSettings):
    """Inversion with an interacting multiple-model estimator: one model for each failure, and a mode for the likeliest."""

    type: Literal["imm_inversion"] = "imm_inversion"
    failure_rate_per_s: Positive = 0.01
    """Rate at which a model is expected to give way to another [1/s]."""
    probability: Annotated[Number, Field(gt=0.5, lt=1)] = 0.9
    """An actuator is flagged as failed while the model of its loss is more probable than this for `persistence_s`."""
    persistence_s: NonNegative = 0.2
    """How long it must be as probable as that [s]."""


class InformedSettings(RegressionSettings):
    """The law of `adaptive_inversion`, told the true effectiveness and failures at once."""

    type: Literal["informed_inversion"] = "informed_inversion"
    threshold: Fraction = 0.05
    """An actuator with this true effectiveness or less is given up as failed."""
    patience_s: NonNegative = 0.0
    """How long an actuator must have been lost or stuck before it is given up [s]: what comes back sooner is waited for."""
    keeps_axes: StrictBool = False
    """Give up no axis, neither from the start nor after a failure: the actuators that remain share all of them."""
    increments: StrictBool = False
    """Take what is measured of the rates and not explained by the model from the demand, as `indi` does."""

    @model_validator(mode="before")
    @classmethod
    def _keeps(cls, value: Any) -> Any:
        if isinstance(value, dict) and value.get("keeps_axes") is True:
            return {"released": (), **value}
        return value


TABLE: dict[str, type[ControllerSettings]] = {
    "adaptive_inversion": AdaptiveInversionSettings,
    "fixed_inversion": FixedInversionSettings,
    "pid": PidSettings,
    "indi": IndiSettings,
    "adaptive_indi": AdaptiveIndiSettings,
    "mrac": MracSettings,
    "l1_inversion": L1InversionSettings,
    "rls_inversion": RlsInversionSettings,
    "imm_inversion": ImmInversionSettings,
    "informed_inversion": InformedSettings,
}
"""Settings by the `type` of a scenario's `controller`; `make.CONSTRUCTORS` has the class that flies them."""

ESTIMATES, FLAGS = "effectiveness_estimate", "failed"
"""What a controller may say of its actuators, by the ends of the log's columns."""
_SAYS = {
    "adaptive_indi": {ESTIMATES},
    "rls_inversion": {ESTIMATES},
    "imm_inversion": {ESTIMATES, FLAGS},
    "informed_inversion": {ESTIMATES, FLAGS},
}


def says(settings: ControllerSettings) -> set[str]:
    """ESTIMATES, FLAGS, both or none: what a shipped controller says with these settings. The rest cannot be judged."""
    if isinstance(settings, AdaptiveInversionSettings):
        return {ESTIMATES, FLAGS} if {"monitor", "jam_test"} - set(settings.ablate) else {ESTIMATES}
    if getattr(settings, "monitor", False):
        return {ESTIMATES, FLAGS}
    return _SAYS.get(settings.type, set())


OLD_NAMES = {"oracle": "informed_inversion"}
"""Types that are still accepted by the names that they had."""


def settings_of(kind: object) -> type[ControllerSettings] | None:
    """The settings of a `type` of controller, also by an old name; None if there is no such type."""
    return TABLE.get(OLD_NAMES.get(str(kind), str(kind)))


def _renamed(value: Any) -> Any:
    """A `controller` block with the present name of its type; an old one is said once, as a warning."""
    kind = value.get("type") if isinstance(value, dict) else None
    if isinstance(kind, str) and kind in OLD_NAMES:
        now = OLD_NAMES[kind]
        warnings.warn(f"the controller {kind} is called {now} now", FutureWarning, stacklevel=2)
        return {**value, "type": now}
    return value


if TYPE_CHECKING:
    AnyController = ControllerSettings
else:
    AnyController = Annotated[
        Union[tuple(TABLE.values())],  # noqa: UP007
        Field(discriminator="type"),
        BeforeValidator(_renamed),
    ]
