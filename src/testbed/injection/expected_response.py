"""Actuators as their block of properties in the JSBSim model says they work, in Python; for receipts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from testbed.common.units import DEGREES_PER_RADIAN

SERVO = (
    "command-rad", "command-scale", "command-bias-rad", "override-active", "override-rad",
    "servo-lag-rad_sec", "servo-rate-rad_sec", "servo-min-rad", "servo-max-rad", "servo/malfunction/fail_stuck",
    "linkage-bias-rad", "float-active", "float-gain", "incidence-rad", "effectiveness",
)  # fmt: skip
MOTOR = (
    "command-norm", "command-scale", "command-bias-norm", "override-active", "override-norm",
    "throttle-min-norm", "throttle-max-norm", "power-lost", "effectiveness",
)  # fmt: skip

Values = Mapping[str, float]
"""Properties of an actuator's block by their names there; for a motor also `rpm` and `thrust_N` of its rotor."""


class Model(Protocol):
    """An actuator as its block of properties says it works."""

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        """Far end of the actuator after one control step with these property values."""
        ...


class ServoModel:
    """JSBSim's actuator component, in its order: lag (Tustin), rate limit, stuck, stops; then linkage, float, loss."""

    def __init__(self, demand: float, position: float) -> None:
        self._input, self._lagged, self._output = demand, position, position

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        demand = v["command-rad"] * v["command-scale"] + v["command-bias-rad"]
        if v["override-active"]:
            demand = v["override-rad"]
        if not v["servo/malfunction/fail_stuck"]:
            for _ in range(substeps):
                self._follow(demand, v["servo-lag-rad_sec"] * dt_s, v["servo-rate-rad_sec"] * dt_s)
        position = min(max(self._output, v["servo-min-rad"]), v["servo-max-rad"]) + v["linkage-bias-rad"]
        if v["float-active"]:
            position = -v["float-gain"] * v["incidence-rad"]
        return {"effective_deg": v["effectiveness"] * position * DEGREES_PER_RADIAN}

    def _follow(self, demand: float, lag: float, rate: float) -> None:
        lagged = (lag * (demand + self._input) + (2.0 - lag) * self._lagged) / (2.0 + lag)
        self._output += min(max(lagged - self._output, -rate), rate)
        self._input, self._lagged = demand, lagged


class MotorModel:
    """Throttle is algebraic; without power it is what the motor generates. The rotor is the plant's own."""

    def __init__(self, rpm_at_full: float) -> None:
        self._full = rpm_at_full

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        throttle = v["command-norm"] * v["command-scale"] + v["command-bias-norm"]
        if v["override-active"]:
            throttle = v["override-norm"]
        throttle = max(v["throttle-min-norm"], min(v["throttle-max-norm"], throttle))
        if v["power-lost"]:
            throttle = v["rpm"] / self._full
        return {"throttle": throttle, "thrust_N": v["effectiveness"] * v["thrust_N"]}
