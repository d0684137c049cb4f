"""What a controller is given before a flight: the design model and the designer's choices, never the plant."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from testbed.aircraft.design_model import DesignModel
from testbed.controllers.gains import ControlDesign


@dataclass(frozen=True)
class ActuatorData:
    """What a controller is told of one actuator [rad or N]: size of one scaled unit, stops, lag and rate."""

    scale: float
    low: float
    high: float
    lag_rad_s: float
    rate: float


@dataclass(frozen=True)
class Setup:
    """All that a controller knows when the flight begins.

    Attributes:
        model: f_m and B_m, with the error that the scenario gave it.
        trim_commands, trim_positions: [n] commands (rad, throttle) and positions (rad, N) at the start.
        trim_pitch: pitch angle [rad] at the start.
        settings: the scenario's `controller` block, by name.
    """

    model: DesignModel
    control: ControlDesign
    actuators: Sequence[ActuatorData]
    dt_s: float
    trim_commands: Sequence[float]
    trim_positions: Sequence[float]
    trim_pitch: float
    settings: Mapping[str, Any] = field(default_factory=dict)
