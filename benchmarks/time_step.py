"""How far a flight is from one with much smaller physics steps: the order of the time step. For docs/explanation/pure_function.md.

    python benchmarks/time_step.py

The control rate stays 200 Hz; only JSBSim's own steps become smaller. The default law flies a hard turn with a climb in calm
air, and the shipped loss of a tail.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from blocks import write

from testbed import fly
from testbed.flight.flight import Flight
from testbed.scenario.load import load_scenario

PAGE = Path(__file__).parents[1] / "docs" / "explanation" / "pure_function.md"
RATES_HZ, FINEST_HZ = (200, 400, 800, 1600), 6400
TURN = [
    "failures=[]",
    "requirements=[]",
    "controller={type: adaptive_inversion}",
    "duration_s=30",
    "command_rates={heading_deg_s: 8, altitude_m_s: 2}",
    "commands=[{at_s: 2, heading_deg: 180, altitude_m: 310}, {at_s: 15, heading_deg: 90, altitude_m: 300}]",
]
CASES = {"hard turn with a climb": TURN, "`left_tail_fail.yaml`": []}


def flown(changes: list[str], physics_hz: int) -> Flight:
    """The flight with these physics steps."""
    return fly(load_scenario("scenarios/left_tail_fail.yaml", [*changes, f"physics_hz={physics_hz}"]))


def largest(flight: Flight, finest: Flight, column: str) -> float:
    """Largest difference of an angle [deg] over the flights."""
    difference = flight.log[column].to_numpy() - finest.log[column].to_numpy()
    return float(np.abs((difference + 180.0) % 360.0 - 180.0).max())


def main() -> None:
    """Fly both cases with each step and write the table."""
    lines = ["| flight | differs in | " + " | ".join(f"{rate} Hz" for rate in RATES_HZ) + " |"]
    lines.append("| --- | --- |" + " --- |" * len(RATES_HZ))
    for name, changes in CASES.items():
        finest, flights = flown(changes, FINEST_HZ), [flown(changes, rate) for rate in RATES_HZ]
        for what, column in (("heading", "heading_deg"), ("bank", "roll_deg")):
            cells = (f"{largest(flight, finest, column):.3f} deg" for flight in flights)
            lines.append(f"| {name} | {what} | {' | '.join(cells)} |")
    write(PAGE, "time step", "\n".join(lines))


if __name__ == "__main__":
    main()
