"""How soon a loss is found in flight without noise: in JSBSim, in calm air, with ideal sensors.

What an aircraft does after a loss moves its actuators, and so decides how much its estimators see. A formula for constant forces
is too slow for the default law by a factor of up to six, and too quick where a demanded force passes zero.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from testbed.flight.flight import Flight
from testbed.scenario.load import Scenario, changed
from testbed.simulation import fly

_LOST_AT_S, _AFTER_S = 5.0, 25.0
_FOUND = 1.0 - math.exp(-1.0)
_HALF = 0.5


@dataclass(frozen=True)
class Found:
    """How soon the loss of one actuator is found.

    Attributes:
        convergence_s: three times the time in which 63 % of a loss of half are found; NaN if they never are.
        detection_s: from a total loss to its flag; NaN if it is not flagged.
    """

    convergence_s: float
    detection_s: float


def found_after_loss(scenario: Scenario, controller: Mapping[str, Any], actuator: str) -> Found:
    """Fly the loss of half of an actuator, and its total loss, from the scenario's initial flight, without noise.

    Args:
        controller: changed settings of the scenario's `controller`.
    """
    half, lost = (
        fly(changed(scenario, _settings(scenario, controller, actuator, left))) for left in (_HALF, 0.0)
    )
    flags = [event for event in lost.events if event["kind"] == "detection" and event["actuator"] == actuator]
    return Found(_convergence_s(half, actuator), float(flags[0]["delay_s"]) if flags else math.nan)


def _settings(
    scenario: Scenario, controller: Mapping[str, Any], actuator: str, left: float
) -> dict[str, Any]:
    at = scenario.initial
    level = {
        "at_s": 0,
        "altitude_m": at.altitude_m,
        "airspeed_m_s": at.airspeed_m_s,
        "heading_deg": at.heading_deg,
    }
    return {
        **{f"controller.{key}": value for key, value in controller.items()},
        "controller.ablate": [],
        "commands": [level],
        "failures": [{"type": "effectiveness", "actuator": actuator, "at_s": _LOST_AT_S, "value": left}],
        "sensors": "ideal",
        "atmosphere": {},
        "requirements": [],
        "duration_s": _LOST_AT_S + _AFTER_S,
        "log_hz": scenario.rate_hz,
    }


def _convergence_s(flight: Flight, actuator: str) -> float:
    log = flight.log
    after = log.loc[log.time_s >= _LOST_AT_S, f"{actuator}_effectiveness_estimate"].to_numpy()
    found = after <= 1.0 - _HALF * _FOUND
    return 3.0 * float(np.argmax(found) + 1) / flight.scenario.rate_hz if found.any() else math.nan
