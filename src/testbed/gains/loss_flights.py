"""How soon a loss is found: in JSBSim, in the scenario's own weather, with its own sensors.

What an aircraft does after a loss moves its actuators, and so decides how much its estimators see. A formula for constant forces
is too slow for the default law by a factor of up to six, and too quick where a demanded force passes zero. Noise moves an
actuator about, too: it may bring a position into epsilon, or out of it, and flags come up to three times as late as without.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from testbed.flight.flight import Flight
from testbed.gains.errors import without_chance
from testbed.scenario.load import Scenario, changed
from testbed.simulation import fly

SEEDS = range(1001, 1006)
"""Seeds of the flights of each loss in weather or with sensors that err; else one flight says all."""
_LOST_AT_S, _AFTER_S = 15.0, 25.0
_FOUND = 1.0 - math.exp(-1.0)
_HALF = 0.5


def detection_s(scenario: Scenario, controller: Mapping[str, Any], actuator: str) -> list[float]:
    """From the total loss of an actuator to its flag, of each flight from the scenario's initial one; infinite for never.

    Args:
        controller: changed settings of the scenario's `controller`.
    """
    found = []
    for flight in _flights(scenario, controller, actuator, 0.0):
        flags = [e for e in flight.events if e["kind"] == "detection" and e["actuator"] == actuator]
        found.append(float(flags[0]["delay_s"]) if flags else math.inf)
    return found


def convergence_s(scenario: Scenario, controller: Mapping[str, Any], actuator: str) -> float:
    """Three times the time in which 63 % of a loss of half are found: median of flights as in `detection_s`, infinite for never."""
    times = []
    for flight in _flights(scenario, controller, actuator, _HALF):
        log = flight.log
        after = log.loc[log.time_s >= _LOST_AT_S, f"{actuator}_effectiveness_estimate"].to_numpy()
        found = after <= 1.0 - _HALF * _FOUND
        times.append(3.0 * float(np.argmax(found) + 1) / scenario.rate_hz if found.any() else math.inf)
    return float(np.median(times))


def level_flight(scenario: Scenario) -> dict[str, Any]:
    """Settings with which a scenario is flown straight and level as it begins, with nothing broken and nothing required."""
    level = {"at_s": 0, **scenario.initial.model_dump()}
    return {"commands": [level], "failures": [], "requirements": [], "log_hz": scenario.rate_hz}


def _flights(
    scenario: Scenario, controller: Mapping[str, Any], actuator: str, left: float
) -> Iterator[Flight]:
    """The flights of one loss, one for each seed."""
    settings = {
        **level_flight(scenario),
        **{f"controller.{key}": value for key, value in controller.items()},
        "controller.ablate": [],
        "failures": [{"type": "effectiveness", "actuator": actuator, "at_s": _LOST_AT_S, "value": left}],
        "duration_s": _LOST_AT_S + _AFTER_S,
    }
    differ = scenario.atmosphere.most_w20_m_s or scenario.sensors != without_chance(scenario).sensors
    for seed in SEEDS if differ else SEEDS[:1]:
        yield fly(changed(scenario, {**settings, "seed": seed}))
