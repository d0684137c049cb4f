"""The response that an actuator should have to the properties of its block in the JSBSim model, computed in Python.

`testbed.injection.receipt` compares the plant with this response. An actuator's block is all properties under its prefix,
such as `actuator/NAME/`. The aircraft's XML must implement the response that the classes here describe.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

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
"""Properties of a motor's or an engine's block that its response depends on."""

Values = Mapping[str, float]
"""Values of the properties of an actuator's block, by name without the prefix; for a motor also `rpm` and `thrust_N` of its
rotor, for an engine its `thrust_N`."""


class ServoModel:
    """A servo and its surface: {effective_deg: deflection times effectiveness [deg]}.

    The servo has lag (Tustin), rate limit, the malfunction stuck and stops, in the order of JSBSim's actuator component. Behind
    the servo, the bias of the linkage is added. A floating surface follows the local flow instead. Effectiveness scales the
    result.
    """

    def __init__(self, demand: float, position: float) -> None:
        """`demand` and `position` [rad] are those of the servo at present."""
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
        """One physics step; `lag` is the lag's corner frequency times the step [1], `rate` the rate limit times the step [rad]."""
        lagged = (lag * (demand + self._input) + (2.0 - lag) * self._lagged) / (2.0 + lag)
        self._output += min(max(lagged - self._output, -rate), rate)
        self._input, self._lagged = demand, lagged


@dataclass(frozen=True)
class MotorModel:
    """A motor with its propeller, or an engine: {throttle [0 to 1], thrust_N: what reaches the airframe [N]}, and of an engine
    {running: 1, or 0 without ignition or fuel}.

    The throttle follows the command at once. Of a motor without power it is the voltage that the windmilling motor generates, over
    full voltage. Speed and thrust of the rotor are not computed here: they are read from the plant.
    """

    rpm_at_full: float | None
    """The motor's speed without load at full voltage [rpm]; None for an engine."""

    def advance(self, v: Values, dt_s: float, substeps: int) -> dict[str, float]:
        thrust = {"thrust_N": v["effectiveness"] * v["thrust_N"]}
        if self.rpm_at_full is None:
            return {"throttle": _throttle(v), "running": 0.0 if v["power-lost"] else 1.0, **thrust}
        return {"throttle": v["rpm"] / self.rpm_at_full if v["power-lost"] else _throttle(v), **thrust}


Model = ServoModel | MotorModel
"""Expected response of one actuator. `advance` makes one control step of `substeps` physics steps of `dt_s` [s] each, and returns
what acts on the airframe by the name of the quantity: see the classes."""


def _throttle(v: Values) -> float:
    """What a motor or engine is asked for, after scale, bias, override and stops."""
    throttle = v["command-norm"] * v["command-scale"] + v["command-bias-norm"]
    if v["override-active"]:
        throttle = v["override-norm"]
    return max(v["throttle-min-norm"], min(v["throttle-max-norm"], throttle))
