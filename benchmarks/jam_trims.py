"""Which jams have a trim: a search on JSBSim itself, beside what the controller's design chooses. Writes docs/results/jam_trims.md.

    python benchmarks/jam_trims.py            # every position of every actuator of the v-tail: ten minutes
    python benchmarks/jam_trims.py --quick    # three positions each

For every position of a jammed surface (steps of 5 deg) and every throttle of a stuck propeller (steps of 0.1), steady straight
flight is searched with bounded least squares from several starts, over airspeeds, level and along paths up and down. The unknowns
are alpha, beta, bank and the commands that remain. Nothing of the controller takes part in that search.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

from testbed.aircraft.description import Aircraft, Servo, load_aircraft
from testbed.common.angles import level_pitch
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft
from testbed.controllers.inversion.mode_trim import NoSteadyFlight, steady_flight
from testbed.controllers.inversion.modes import enumerate_modes
from testbed.controllers.inversion.steady_flights import SteadyFlight, path_angles
from testbed.controllers.records import AIRSPEED
from testbed.controllers.setup import Setup, setup_for
from testbed.plant.identification import stored
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import accelerations
from testbed.plant.trim import command_range, trimmed_start

RESIDUAL_MAX = 1e-4
"""Largest acceleration that may remain [m/s2, rad/s2]."""
STARTS = [(0.05, 0.0, 0.0), (0.12, -0.1, 0.0), (0.12, 0.1, 0.0)]
"""First guesses of alpha, beta and bank [rad]."""
PATH_ANGLES_DEG = (-6, -4, -2, 2, 4, 6, 8)
"""Searched where no level flight is within the stops."""
LIMITS = ((-0.12, 0.6), (-0.35, 0.35), (-0.6, 0.6))  # of alpha (up to the stall), beta and bank [rad]


@dataclass(frozen=True)
class Found:
    """A steady flight of the truth.

    Attributes:
        margin: scaled distance of the nearest actuator that remains to its stop; negative for a thrust that a throttle gives,
            but that is beyond the aircraft's `limits`.
    """

    airspeed_m_s: float
    path_deg: float
    alpha_deg: float
    beta_deg: float
    positions: tuple[float, ...]
    margin: float


class TruthSearch:
    """Steady flights of JSBSim with one actuator's command held."""

    def __init__(self, aircraft: Aircraft, jammed: int, command: float) -> None:
        self.plant, self.jammed, self.command = Plant(aircraft, 200.0), jammed, command
        self.actuators = list(aircraft.actuators.values())
        self.free = [i for i in range(len(self.actuators)) if i != jammed]
        self.altitude_m = aircraft.reference.altitude_m
        stall = stored(aircraft).stall_alpha_rad
        commands = np.array([command_range(self.actuators[i]) for i in self.free])
        self.bounds = np.vstack([[(LIMITS[0][0], stall), *LIMITS[1:]], commands]).T

    def over_airspeeds(self, airspeeds: Sequence[float], path_deg: float) -> list[Found]:
        """The flight at each airspeed [m/s] that has one; each search begins at the last one's solution too."""
        flights: list[Found] = []
        last: list[np.ndarray] = []
        middle = self.bounds.mean(axis=0)[3:]
        for airspeed in airspeeds:
            for start in [*last, *(np.concatenate([angles, middle]) for angles in STARTS)]:
                solution = self._from(start, airspeed, math.radians(path_deg))
                last = [] if solution is None else [solution]
                if solution is not None:
                    flights.append(self._found(solution, airspeed, path_deg))
                    break
        return flights

    def _from(self, start: np.ndarray, airspeed: float, path: float) -> np.ndarray | None:
        low, high = self.bounds
        inside = np.clip(start, low + 1e-4, high - 1e-4)

        def residuals(unknowns: np.ndarray) -> np.ndarray:
            alpha, beta, bank = unknowns[:3]
            pitch = level_pitch(alpha, beta, bank, path)
            state = {"airspeed": airspeed, "altitude": self.altitude_m, "alpha": alpha, "beta": beta}
            commands = np.insert(unknowns[3:], self.jammed, self.command)
            return accelerations(
                self.plant, {**state, "roll": bank, "pitch": pitch}, list(map(float, commands))
            )

        sizes = np.array([0.1] * 3 + [0.2] * len(self.free))
        found = least_squares(
            residuals, inside, bounds=(low, high), x_scale=sizes, diff_step=1e-4, max_nfev=15, xtol=1e-10
        )
        return found.x if np.abs(residuals(found.x)).max() < RESIDUAL_MAX else None

    def _found(self, unknowns: np.ndarray, airspeed: float, path_deg: float) -> Found:
        """The plant is in this flight."""
        n = len(self.actuators)
        positions = self.plant.read()[-2 * n : -n]
        margins = [
            min(positions[i] - a.limits[0], a.limits[1] - positions[i]) / a.scale
            for i, a in enumerate(self.actuators)
            if i != self.jammed
        ]
        alpha, beta = np.degrees(unknowns[:2])
        return Found(
            airspeed, path_deg, float(alpha), float(beta), tuple(map(float, positions)), min(margins)
        )


def truth(aircraft: Aircraft, jammed: int, command: float) -> tuple[list[Found], list[Found]]:
    """All level flights, and those along paths; the latter only where no level one is within the stops."""
    search, v = TruthSearch(aircraft, jammed, command), aircraft.reference.airspeed_m_s
    level = search.over_airspeeds(np.arange(math.ceil(0.6 * v), 1.5 * v + 0.01).tolist(), 0.0)
    if any(flight.margin > 0.0 for flight in level):
        return level, []
    sloping = [
        search.over_airspeeds(np.arange(0.7 * v, 1.2 * v, 1.0).tolist(), path) for path in PATH_ANGLES_DEG
    ]
    return level, [flight for flights in sloping for flight in flights]


def jams(aircraft: Aircraft, quick: bool) -> Iterator[tuple[int, str, float, str]]:
    """Index and name of an actuator, the command at which it is jammed [rad or throttle], and that in words."""
    for i, (name, actuator) in enumerate(aircraft.actuators.items()):
        low, high = (
            np.degrees(command_range(actuator)) if isinstance(actuator, Servo) else command_range(actuator)
        )
        step = 5.0 if isinstance(actuator, Servo) else 0.1
        inner = step * np.arange(math.ceil(low / step), math.floor(high / step) + 1)
        values = [low, 0.5 * (low + high), high] if quick else np.unique(np.round([low, *inner, high], 9))
        for value in values:
            if isinstance(actuator, Servo):
                yield i, name, math.radians(value), f"{value:.1f} deg"
            else:
                yield i, name, float(value), f"throttle {value:.1f}"


def design(setup: Setup, jammed: int, position: float) -> str:
    """What the controller chooses for a jam at a scaled position."""
    modes = enumerate_modes(setup.model, setup.scale, setup.control, setup.released)
    degraded = DegradedAircraft.after(setup, modes[(jammed,)], {jammed: position})
    try:
        flight, held = steady_flight(degraded, setup.control.loops, "")
    except NoSteadyFlight:
        return "none"
    (path,) = np.degrees(path_angles(SteadyFlight(flight.state[None], flight.positions[None])))
    slope = "level" if "altitude" in held else f"path {path:+.0f} deg"
    return f"{slope}, {flight.state[AIRSPEED]:.1f} m/s"


def row(setup: Setup, aircraft: Aircraft, jammed: int, command: float, words: str) -> str:
    """A row of the table, but for the actuator's name: of those that mirror each other it is the same."""
    level, sloping = truth(aircraft, jammed, command)
    inside = [flight for flight in level if flight.margin > 0.0]
    best = max(inside or level + sloping, key=lambda flight: flight.margin, default=None)
    speeds = f"{inside[0].airspeed_m_s:.0f} to {inside[-1].airspeed_m_s:.0f}" if inside else "none"
    beyond = (
        ""
        if inside or not level
        else f"; with less thrust than the limit {level[0].airspeed_m_s:.0f} to {level[-1].airspeed_m_s:.0f}"
    )
    if best is None:
        return f"{words} | {speeds}{beyond} | none | | |"
    actuator = list(aircraft.actuators.values())[jammed]
    position = math.degrees(command) if isinstance(actuator, Servo) else best.positions[jammed]
    chosen = design(setup, jammed, position / actuator.scale)
    slope = "level" if best.path_deg == 0.0 else f"path {best.path_deg:+.0f} deg"
    what = f"{slope}, {best.airspeed_m_s:.0f} m/s"
    return f"{words} | {speeds}{beyond} | {what} | {best.margin:.2f} | {chosen} |"


HEAD = """# Which jams have a trim

<!-- Written by python benchmarks/jam_trims.py: change that, not this. -->

This page says at which airspeeds the v-tail can fly with a jammed actuator. It searches on JSBSim itself,
with bounded least squares from several starts and nothing of the controller, and shows beside it
what the controller's design chooses on its own linear model. Margin is the distance of the nearest actuator that remains to its
stop, in units of its `scale`. Where none is level, the best path is shown; at 20 deg the design is wrong.
A stuck propeller's design is given the thrust at the truth's best airspeed.

| jammed | at | level flight exists at [m/s] | most margin on the truth | margin | design's choice |
| --- | --- | --- | --- | --- | --- |"""


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--aircraft", default="vtail")
    parser.add_argument("--only", help="one actuator")
    parser.add_argument("--quick", action="store_true", help="both stops and the middle")
    parser.add_argument(
        "--out", type=Path, default=Path(__file__).parents[1] / "docs" / "results" / "jam_trims.md"
    )
    options = parser.parse_args(arguments)
    aircraft = load_aircraft(options.aircraft)
    at = aircraft.reference
    start = trimmed_start(aircraft, 200.0, at.airspeed_m_s, at.altitude_m, 0.0)
    settings = AdaptiveInversionSettings()
    setup = setup_for(
        aircraft, stored(aircraft), settings, 0.005, start.commands, start.positions, start.state["pitch"]
    )
    rows: dict[str, list[str]] = {}
    for i, name, command, words in jams(aircraft, options.quick):
        if options.only in (None, name):
            found = row(setup, aircraft, i, command, words)
            rows.setdefault(found, []).append(name)
            print(f"| {name} | {found}", flush=True)
    lines = [HEAD, *(f"| {' or '.join(names)} | {found}" for found, names in rows.items())]
    options.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"wrote {options.out}")


if __name__ == "__main__":
    main()
