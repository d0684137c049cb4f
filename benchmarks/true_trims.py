"""Which missions can be flown at all: steady flights of the broken aircraft, looked for on JSBSim itself.

    python benchmarks/true_trims.py --missions jam,hardover

For each airspeed, in steps of 1/36 of the reference airspeed (0.5 m/s for the v-tail), the angles and the commands of the
working actuators are solved for (least squares with bounds, several starts) with every failure of the mission in force. Where
there is no level one, flights that climb or descend are looked for. What no trim exists for, no controller can hold; the
design model plays no part in this.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from mission_list import BASE, MISSIONS, Condition, Mission, chosen
from scipy.optimize import least_squares

from testbed.aircraft.description import Aircraft, Servo, load_aircraft
from testbed.common.angles import level_pitch
from testbed.failures import Capture, Failure
from testbed.inputs.yaml_source import parse
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import accelerations
from testbed.plant.trim import command_range, trim
from testbed.studies.drawing.builder import Builder, Task, Variant

SLOWEST, FASTEST, STEP = 22 / 36, 54 / 36, 1 / 36
"""Airspeeds that are tried, in units of the reference airspeed. Twice the step misses a level flight from 16.5 to 17 m/s."""
PATH_ANGLES_DEG = (0, 3, -3, 6, -6)
"""Level first; the others are tried only if there is no level flight."""
RESIDUAL_MAX = 1e-3  # m/s2, rad/s2
_SETTLE_S = 0.6  # for servos and rotors, before accelerations are read
_ANGLES_MAX = np.radians([12.0, 20.0, 34.0])  # alpha (linear lift up to here), beta, roll
_STARTS = ((0.05, 0.0, 0.0), (0.12, 0.1, 0.1), (0.12, -0.1, -0.1), (0.02, 0.1, 0.1), (0.02, -0.1, -0.1))


@dataclass(frozen=True)
class Steady:
    """A steady flight: airspeed, path angle, and the least distance of a working actuator from a stop, of half its travel."""

    airspeed_m_s: float
    path_angle_deg: float
    margin: float


def steady_flights(
    aircraft: str, failures: Sequence[Failure], airspeeds: Sequence[float] | None = None
) -> list[Steady]:
    """Steady flights with these failures in force: all level ones, or else all of the first path angle that has any."""
    known = load_aircraft(aircraft)
    if airspeeds is None:
        airspeeds = (np.arange(SLOWEST, FASTEST + 0.5 * STEP, STEP) * known.reference.airspeed_m_s).tolist()
    search = _Search(known, failures)
    for path_angle in PATH_ANGLES_DEG:
        if found := list(search.at(path_angle, airspeeds)):
            return found
    return []


class _Search:
    def __init__(self, aircraft: Aircraft, failures: Sequence[Failure]) -> None:
        self._plant = Plant(aircraft, 200.0)
        begin = trim(self._plant, aircraft.reference.airspeed_m_s, aircraft.reference.altitude_m)
        self._altitude, self._actuators = aircraft.reference.altitude_m, list(aircraft.actuators.values())
        stuck = {failure.actuator for failure in failures if not failure.follows_command}
        commands = enumerate(zip(aircraft.actuators, begin.commands, strict=True))
        self._held = {i: command for i, (name, command) in commands if name in stuck}
        self._free = [i for i in range(len(self._actuators)) if i not in self._held]
        for failure in failures:
            for name, value in failure.properties(aircraft).items():
                # One that keeps what it has when it starts is held by its command instead.
                if not isinstance(value, Capture) and not name.endswith("fail_stuck"):
                    self._plant[name] = value
            if any(isinstance(value, Capture) for value in failure.properties(aircraft).values()):
                self._plant[f"{aircraft.actuators[str(failure.actuator)].prefix}/override-active"] = 0.0
        ranges = np.array([command_range(self._actuators[i]) for i in self._free]).reshape(-1, 2)
        self._low = np.concatenate([-_ANGLES_MAX, ranges[:, 0]])
        self._high = np.concatenate([_ANGLES_MAX, ranges[:, 1]])

    def at(self, path_angle_deg: float, airspeeds: Sequence[float]) -> Iterator[Steady]:
        """The steady flights with this path angle."""
        before: np.ndarray | None = None
        for airspeed in airspeeds:
            before = self._solve(airspeed, math.radians(path_angle_deg), before)
            if before is not None:
                commands, low, high = before[3:], self._low[3:], self._high[3:]
                margin = float(np.min(np.minimum(commands - low, high - commands) / (0.5 * (high - low))))
                yield Steady(airspeed, path_angle_deg, margin)

    def _solve(self, airspeed: float, path_angle: float, near: np.ndarray | None) -> np.ndarray | None:
        middle = [0.0 if isinstance(self._actuators[i], Servo) else 0.5 for i in self._free]
        starts = [np.array([*angles, *middle]) for angles in _STARTS]
        for start in starts if near is None else [near, *starts]:
            inside = np.clip(start, self._low + 1e-6, self._high - 1e-6)
            found = least_squares(
                lambda x: self._residual(x, airspeed, path_angle), inside, bounds=(self._low, self._high),
                x_scale=[0.1] * 3 + [0.2] * len(self._free), diff_step=1e-4, max_nfev=25,
            )  # fmt: skip
            if np.max(np.abs(found.fun)) < RESIDUAL_MAX:
                solution: np.ndarray = found.x
                return solution
        return None

    def _residual(self, x: np.ndarray, airspeed: float, path_angle: float) -> np.ndarray:
        alpha, beta, roll = map(float, x[:3])
        state = {
            "airspeed": airspeed, "altitude": self._altitude, "alpha": alpha, "beta": beta, "roll": roll, "heading": 0.0,
            "pitch": level_pitch(alpha, beta, roll, path_angle),
        }  # fmt: skip
        commands = {**self._held, **dict(zip(self._free, map(float, x[3:]), strict=True))}
        return accelerations(self._plant, state, [commands[i] for i in range(len(commands))], _SETTLE_S)


def words(found: Sequence[Steady]) -> str:
    """`level, 12 to 17 m/s, margin 0.21`, or `none`. The margin is the largest over these airspeeds."""
    if not found:
        return "none"
    speeds, margin = [flight.airspeed_m_s for flight in found], max(flight.margin for flight in found)
    angle = found[0].path_angle_deg
    how = (
        "level"
        if angle == 0
        else f"climbing at {angle:g} deg"
        if angle > 0
        else f"descending at {-angle:g} deg"
    )
    return f"{how}, {min(speeds):.3g} to {max(speeds):.3g} m/s, margin {margin:.2f}"


def failures_of(mission: Mission) -> Sequence[Failure]:
    """The mission's failures, checked."""
    builder = Builder(parse(BASE, "mission"), (Variant("", {}),))
    return builder.scenario(Task(0, 0, 1, Condition(w20_ft_s=0.0).values(mission, 1))).failures


def table(missions: Sequence[Mission], aircraft: str) -> Mapping[str, list[Steady]]:
    """Steady flights of each mission after its last failure; missions with the same failures share one search."""
    known: dict[str, list[Steady]] = {}
    found = {}
    for mission in missions:
        key = repr([{**failure, "at_s": 0} for failure in mission.failures])
        if key not in known:
            known[key] = steady_flights(aircraft, failures_of(mission))
        found[mission.name] = known[key]
    return found


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--missions", metavar="A,B", help="only missions with these words in their names")
    parser.add_argument("--aircraft", default="vtail")
    options = parser.parse_args(arguments)
    print("| mission | steady flight on JSBSim |\n| --- | --- |")
    for mission in chosen(MISSIONS, options.missions):
        print(f"| {mission.name} | {words(table([mission], options.aircraft)[mission.name])} |", flush=True)


if __name__ == "__main__":
    main()
