"""What a controller is given before a flight: the design model and the designer's choices, never the plant.

One controller is an exception: `informed_inversion` is told the truth about the actuators (`Setup.truth`).
"""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np

from testbed.aircraft.control_design import ControlDesign
from testbed.aircraft.description import Aircraft, AnyActuator
from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.propulsors import EngineMap, Propulsor
from testbed.common.signals import RATES
from testbed.controllers.config import ControllerSettings
from testbed.controllers.released_axes import released_from_start
from testbed.controllers.scaling import scaled

S = TypeVar("S", bound=ControllerSettings)
_MOST_KEPT = 100_000_000  # bytes of a controller's own files
_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}")


@dataclass(frozen=True)
class ActuatorData:
    """What a controller is told of one actuator.

    Attributes:
        scale: size of one scaled unit [rad or N].
        low, high: stops [rad or N].
        lag_rad_s: corner of the first-order lag of the servo, rotor or engine.
        rate: rate limit [rad/s or N/s].
    """

    scale: float
    low: float
    high: float
    lag_rad_s: float
    rate: float


class ActuatorTruth(NamedTuple):
    """What is true of the n actuators in the present control step.

    Attributes:
        effectiveness: [n] of each, 1 healthy, 0 lost.
        follows: [n] whether the actuator follows its command.
        position: [n] as if fully effective [rad or N].
    """

    effectiveness: Sequence[float]
    follows: Sequence[bool]
    position: Sequence[float]


@dataclass(frozen=True)
class FlightPlan:
    """What a controller outside of the program may need to know of the flight.

    Attributes:
        seed: of the flight's random numbers.
        scenario: as its file would hold it, without what goes wrong in it: failures, faults of sensors, changes of the truth.
    """

    seed: int
    scenario: Mapping[str, Any]

    @cached_property
    def folder(self) -> Path:
        """An empty folder for files of the controller's own, for the time of the flight; made when it is first asked for."""
        return Path(self._made.name)

    @cached_property
    def _made(self) -> tempfile.TemporaryDirectory[str]:
        return tempfile.TemporaryDirectory(prefix="testbed-controller-")

    @property
    def has_folder(self) -> bool:
        """Whether the folder was asked for."""
        return "_made" in self.__dict__

    def files(self) -> dict[str, bytes]:
        """Name and contents of the files in the folder, as long as they are at most 100 MB in all; empty ones are left out."""
        found, left = {}, _MOST_KEPT
        for path in sorted(self.folder.iterdir()):
            if path.is_symlink() or not path.is_file() or not _NAME.fullmatch(path.name):
                continue
            left -= path.stat().st_size
            if left >= 0 and (content := path.read_bytes()):
                found[path.name] = content
        return found


@dataclass(frozen=True)
class Setup:
    """All that a controller knows when the flight begins.

    Attributes:
        aircraft: its name, for messages.
        model: f_m and B_m, with the scenario's `model_error` applied.
        control: the designer's priorities and gains for this aircraft; those that are not given become the ones that suit it.
        actuators: [n] in the order of `model.actuators`.
        dt_s: duration of a control step [s].
        trim_commands, trim_positions: [n] commands (rad, throttle) and positions (rad, N) at the start.
        trim_pitch: pitch angle [rad] at the start.
        settings: the scenario's `controller` block.
        released: axes that are given up while no actuator is flagged as failed, in the order of `signals.RATES`.
        parameters: those of a controller of the user's own: what its class declares, with the scenario's values.
        plan: what a controller outside of the program may need to know of the flight; None where nothing is flown.
        truth: for `informed_inversion` alone, a function that tells the truth about the actuators; None for every other controller.
    """

    aircraft: str
    model: DesignModel
    control: ControlDesign
    actuators: Sequence[ActuatorData]
    dt_s: float
    trim_commands: Sequence[float]
    trim_positions: Sequence[float]
    trim_pitch: float
    settings: ControllerSettings
    released: tuple[str, ...] = ()
    parameters: Mapping[str, Any] = field(default_factory=dict)
    plan: FlightPlan | None = None
    truth: Callable[[], ActuatorTruth] | None = None

    def __post_init__(self) -> None:
        limits = np.array([(a.low, a.high) for a in self.actuators])
        lags = [a.lag_rad_s for a in self.actuators]
        control = scaled(self.control, self.model, limits, lags, self.released)
        object.__setattr__(self, "control", control)

    @property
    def scale(self) -> np.ndarray:
        """[n] rad or N of one scaled unit."""
        return np.array([a.scale for a in self.actuators])

    @property
    def limits(self) -> np.ndarray:
        """[n, 2] lowest and highest scaled position."""
        return np.array([(a.low / a.scale, a.high / a.scale) for a in self.actuators])

    @property
    def lags(self) -> np.ndarray:
        """[n] first-order lags of servos and rotors [rad/s]."""
        return np.array([a.lag_rad_s for a in self.actuators])

    @property
    def turns(self) -> np.ndarray:
        """[n] the servos, and what gives thrust that shows more in the rates of rotation than in u_dot, each over its noise."""
        noise = np.array([getattr(self.control.disturbance, rate) for rate in RATES])
        shown = (np.array(self.model.input_matrix)[:4] * self.scale / noise[:, None]) ** 2
        return (np.array(self.model.kinds) == "servo") | (shown[:3].sum(axis=0) > shown[3])

    def settings_as(self, kind: type[S]) -> S:
        """The scenario's settings if they are of this kind.

        They are not when another controller is flown in place of the scenario's. Then this kind's defaults, with the
        scenario's `released` and `model_error`.
        """
        if isinstance(self.settings, kind):
            return self.settings
        return kind.model_validate(self.settings.model_dump(include={"released", "model_error"}))


def setup_for(
    aircraft: Aircraft,
    model: DesignModel,
    settings: ControllerSettings,
    dt_s: float,
    commands: Sequence[float],
    positions: Sequence[float],
    pitch: float,
) -> Setup:
    """The set-up of a flight of this aircraft.

    Args:
        model: the identified design model; the settings' `model_error` is applied here.
        commands: [n] actuator commands at the start, in rad and as throttle.
        positions: [n] actuator positions at the start, in each actuator's `unit` (deg, N).
        pitch: pitch angle at the start [rad].
    """
    units = [_unit(a.kind) for a in aircraft.actuators.values()]
    return Setup(
        aircraft=aircraft.name,
        model=settings.believed(model),
        control=settings.applied_to(own_axes(aircraft)),
        actuators=[_told(*each) for each in zip(aircraft.actuators.values(), model.propulsors, strict=True)],
        dt_s=dt_s,
        trim_commands=commands,
        trim_positions=[position * unit for position, unit in zip(positions, units, strict=True)],
        trim_pitch=pitch,
        settings=settings,
        released=_released(aircraft, model, settings),
    )


def own_axes(aircraft: Aircraft) -> ControlDesign:
    """The aircraft's control design, with the priorities of the axes that it has."""
    priorities = tuple(axis for axis in aircraft.control.priorities if axis in aircraft.axes)
    return aircraft.control.model_copy(update={"priorities": priorities})


def _told(actuator: AnyActuator, propulsor: Propulsor | EngineMap | None) -> ActuatorData:
    """What a controller is told of one actuator. The lag of an engine is the identified one, and its thrust is not used below
    where the propeller begins to windmill."""
    unit = _unit(actuator.kind)
    low, high = actuator.limits
    lag = propulsor.small_lag_rad_s if isinstance(propulsor, EngineMap) else actuator.lag_rad_s
    if lag is None:
        raise ValueError(f"the design model has no map of an engine that the aircraft has: {actuator.prefix}")
    if isinstance(propulsor, EngineMap):
        low = max(low, propulsor.least_useful_n)
    return ActuatorData(actuator.scale * unit, low * unit, high * unit, lag, actuator.rate_limit * unit)


def _released(aircraft: Aircraft, model: DesignModel, settings: ControllerSettings) -> tuple[str, ...]:
    """The axes that the settings release, and those that the aircraft does not have.

    Derived ones go by the model without `model_error`, so that a study of model error does not change what is controlled.
    """
    if settings.released is not None:
        released: Sequence[str] = settings.released
    else:
        released = released_from_start(model, stops(aircraft), own_axes(aircraft).priorities)
    return tuple(axis for axis in RATES if axis in released or axis not in aircraft.axes)


def stops(aircraft: Aircraft) -> np.ndarray:
    """[n, 2] lowest and highest position of each actuator [rad or N]."""
    return np.array([np.multiply(a.limits, _unit(a.kind)) for a in aircraft.actuators.values()])


def _unit(kind: str) -> float:
    """Size of the unit of an actuator's limits: a degree [rad] for a servo, a newton for a motor."""
    return math.radians(1.0) if kind == "servo" else 1.0
