"""Short flights of the healthy v-tail, for tests of what flies it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from testbed.flight.flight import Flight
from testbed.metrics import readings
from testbed.scenario.load import Scenario, load_scenario

BASE = """
name: healthy
aircraft: vtail
duration_s: {seconds}
initial: {{altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}}
controller: {{type: {controller}}}
commands:
  - {{at_s: 0.4, heading_deg: 120}}
  - {{at_s: 0.8, altitude_m: 305}}
"""


def scenario(folder: Path, controller: str = "pid", seconds: float = 25, *settings: str) -> Scenario:
    """A turn of 30 deg and a climb of 5 m in calm air, with `--set` settings."""
    file = folder / "healthy.yaml"
    file.write_text(BASE.format(controller=controller, seconds=seconds))
    return load_scenario(file, settings)


def worst_errors(flight: Flight, from_s: float = 0.0) -> tuple[float, float, float]:
    """Worst altitude, heading and airspeed [m, deg, m/s] from a time on."""
    log = readings(flight)
    row = log.row_at(from_s)
    altitude, heading, airspeed = (
        float(np.abs(log.error(q)[row:]).max()) for q in ("altitude", "heading", "airspeed")
    )
    return altitude, heading, airspeed
