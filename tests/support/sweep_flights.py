"""Functions that fly in the simulator's place, given to a sweep by its own interface: quick ones, and bad
ones.
"""

from __future__ import annotations

import os
import signal
import time

import numpy as np

from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import Scenario

COLUMNS = (
    "time_s", "altitude_m", "altitude_command_m", "heading_deg", "heading_command_deg",
    "airspeed_m_s", "airspeed_command_m_s", "roll_deg", "pitch_deg", "beta_deg",
)  # fmt: skip


def quick(scenario: Scenario) -> Flight:
    """A flight made up from the scenario and nothing else: it passes when more than half of an actuator is
    left.
    """
    value, rows = scenario.failures[0].value, 50  # type: ignore[attr-defined]
    time_s = np.arange(rows) * (scenario.duration_s / rows)
    data = np.column_stack([time_s, 300 + value * time_s, *[np.full(rows, 300.0)] * (len(COLUMNS) - 2)])
    verdict = {"name": "half", "passed": value > 0.5, "value": value, "limit": "", "margin": value - 0.5}
    metrics = {"altitude_error_max_m": 1.0 / (0.1 + value), "detection_delay_s": float("nan")}
    end = scenario.duration_s
    return Flight(scenario, Outcome.completed, end, COLUMNS, data, (), metrics, (verdict,))


def slow(scenario: Scenario) -> Flight:
    """The same, taking its time."""
    time.sleep(0.02)
    return quick(scenario)


def lost(scenario: Scenario) -> Flight:
    """Raises, with an address and more words than a record keeps."""
    raise ValueError("at 0x7f00deadbeef " + "x" * 1000)


def hungry(scenario: Scenario) -> Flight:
    """Asks for more memory than there is."""
    np.ones(2**50)
    return quick(scenario)


def bad(scenario: Scenario) -> Flight:
    """Raises, hangs, or kills its process, as the effectiveness left says; flies otherwise."""
    value = scenario.failures[0].value  # type: ignore[attr-defined]
    if value == 0.1:
        raise ValueError("the flight went wrong")
    if value == 0.2:
        while True:
            time.sleep(1.0)
    if value == 0.3:
        os.kill(os.getpid(), signal.SIGKILL)
    if value == 0.4:
        os._exit(7)
    return quick(scenario)
