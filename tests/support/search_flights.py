"""Made-up flights whose failures are known, for a search to fly: a module of its own, as each worker imports it."""

from __future__ import annotations

import math
import os
import time
from dataclasses import replace

import numpy as np
from sweep_flights import COLUMNS

from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import Scenario

BETA = 2.5
"""Distance of the failures of `gusty`, in standard deviations of the wind: a wind along (3, 4) that is too strong."""
DESIGN = (0.6 * BETA, 0.8 * BETA)


def gusty(scenario: Scenario) -> Flight:
    """A flight made up from its wind, which is in standard deviations of 2 m/s."""
    north, east, _ = scenario.atmosphere.wind_m_s
    left = BETA - (0.6 * north + 0.8 * east) / 2.0
    rows = 20
    time_s = np.arange(rows) * (scenario.duration_s / rows)
    data = np.column_stack([time_s, *[np.full(rows, 300.0)] * (len(COLUMNS) - 1)])
    verdict = {
        "name": "held",
        "passed": left >= 0,
        "value": 1 - left,
        "limit": "at most 1",
        "margin": left,
        "robustness": left,
    }
    metrics = {"altitude_error_max_m": 1.0 - left, "detection_delay_s": math.nan}
    return Flight(scenario, Outcome.completed, scenario.duration_s, COLUMNS, data, (), metrics, (verdict,))


def simulated(scenario: Scenario) -> Flight:
    """A flight of the simulator."""
    from testbed import simulation  # here, because workers with made-up flights need none of it

    return simulation.fly(scenario)


def slow(scenario: Scenario) -> Flight:
    """The same, taking its time."""
    time.sleep(0.01)
    return gusty(scenario)


def unbreakable(scenario: Scenario) -> Flight:
    """A flight whose requirement is met in any wind."""
    flight = gusty(scenario)
    verdict = {**flight.requirements[0], "passed": True, "margin": 9.0, "robustness": 9.0}
    return Flight(
        scenario, flight.outcome, flight.end_time_s, COLUMNS, flight.data, (), flight.metrics, (verdict,)
    )


def broken_downwards(scenario: Scenario) -> Flight:
    """A flight that does not bear any wind downwards."""
    flight = gusty(scenario)
    down = scenario.atmosphere.wind_m_s[2]
    left = flight.requirements[0]["robustness"] - 5.0 * down
    return replace(
        flight, requirements=({**flight.requirements[0], "passed": left >= 0, "robustness": left},)
    )


def lost(scenario: Scenario) -> Flight:
    """No flight at all."""
    raise ValueError("it went wrong")


def in_its_process(scenario: Scenario) -> Flight:
    """A flight whose metrics tell which process flew it."""
    flight = gusty(scenario)
    return replace(flight, metrics={"process": float(os.getpid())})
