"""What an actuator is expected to do with the properties of its block in the JSBSim model, computed in Python.

The receipts of injections compare the plant with it (`testbed.injection.receipt`). An actuator's block is all
properties under its prefix, such as `fcs/left-ruddervator/`; the aircraft's XML has to work as the classes here say.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from testbed.common.units import DEGREES_PER_RADIAN

SERVO = (
    "command-rad", "command-scale", "command-bias-rad", "override-active", "override-rad",
    "servo-lag-rad_sec", "servo-rate-rad_sec", "servo-min-rad", "servo-max-rad", "servo/malfunction/fail_stuck",
    "linkage-bias-rad", "float-active", "float-gain", "incidence-rad", "effectiveness",
)  # fmt: skip
"""Properties of a servo's block that its response depends on."""
MOTOR = (
    "command-norm", "command-scale", "command-bias-norm", "override-active", "override-norm",
    "throttle-min-norm", "throttle-max-norm", "power-lost", "effectiveness",
)  # fmt: skip
"""Properties of a motor's block that its response depends on."""

Values = Mapping[str, float]
"""Properties of an actuator's block by their names in it; for a motor also `rpm` and `thrust_N` of its rotor."""


class Model(Protocol):
    """Expected response of one actuator; it remembers the control steps that it has made."""

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        """Make one control step of `substeps` physics steps of `dt_s` [s] each with these property values.

        Returns what reaches the air, by quantity: see the classes.
        """
        ...


class ServoModel:
    """A servo and its surface: {effective_deg: deflection times effectiveness [deg]}.

    In the order of JSBSim's actuator component: lag (Tustin), rate limit, stuck, stops. Behind the servo the linkage's
    bias is added, a floating surface follows the local flow instead, and effectiveness scales what is left.
    """

    def __init__(self, demand: float, position: float) -> None:
        """Of the servo at present: what it is asked for and where it is [rad]."""
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
        """One physics step; `lag` is the lag's corner frequency times the step [-], `rate` the farthest move [rad]."""
        lagged = (lag * (demand + self._input) + (2.0 - lag) * self._lagged) / (2.0 + lag)
        self._output += min(max(lagged - self._output, -rate), rate)
        self._input, self._lagged = demand, lagged


class MotorModel:
    """A motor and its propeller: {throttle [0 to 1], thrust_N: what reaches the airframe [N]}.

    Throttle follows the command at once. Without power it is what the windmilling motor generates. Speed and thrust of
    the rotor are the plant's own: they are not computed here.
    """

    def __init__(self, rpm_at_full: float) -> None:
        """Speed without load at full voltage [rpm]."""
        self._full = rpm_at_full

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        throttle = v["command-norm"] * v["command-scale"] + v["command-bias-norm"]
        if v["override-active"]:
            throttle = v["override-norm"]
        throttle = max(v["throttle-min-norm"], min(v["throttle-max-norm"], throttle))
        if v["power-lost"]:
            throttle = v["rpm"] / self._full
        return {"throttle": throttle, "thrust_N": v["effectiveness"] * v["thrust_N"]}
