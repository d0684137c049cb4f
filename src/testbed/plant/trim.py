"""Trim: the commands and angles of steady flight, found in JSBSim itself through the real servos, motors and rotors.

JSBSim's own FGTrim knows one throttle and three controls, and drives a brushless motor out of its range. This one solves
for any choice of six unknowns, which is what an aircraft with a lost actuator needs.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import root

from testbed.aircraft.description import Aircraft, Servo
from testbed.common.cache import Cache
from testbed.common.frames import level_pitch
from testbed.inputs.problems import BadInput, Problem
from testbed.plant.jsbsim import Plant
from testbed.plant.properties import ACCELERATIONS

SETTLE_S = 1.5
"""More than 40 time constants of rotors and servos: after it they are steady."""
_ROOT_TOLERANCE = 1e-9
_RESIDUAL_MAX = 1e-6  # m/s2 or rad/s2 that may remain
# Sizes of the unknowns, so that the root-finder sees numbers near one, and how far from zero it may look.
_SIZES = {"alpha": 0.1, "beta": 0.1, "roll": 0.1, "airspeed": 5.0, "path_angle": 0.1}
_COMMAND_SIZE, _FARTHEST = 0.2, 20.0
# Where the root-finder begins: a small angle of attack, tails a little down, motors above half throttle.
_FIRST_ANGLES = {"alpha": 0.05, "beta": 0.0, "roll": 0.0, "path_angle": 0.0}
_FIRST_SERVO_RAD, _FIRST_THROTTLE = 0.05, 0.6


class NoTrim(BadInput):
    """No steady flight was found."""


@dataclass(frozen=True)
class Trim:
    """A steady flight condition of the truth.

    Attributes:
        state: airspeed, altitude, alpha, beta, roll, pitch, heading, path_angle [m/s, m, rad].
        commands: [n] servos in radians, motors as throttle 0 to 1.
        positions: [n] servo positions and thrusts, in the aircraft's units, as if fully effective.
        residual: largest remaining acceleration [m/s2 or rad/s2].
    """

    state: Mapping[str, float]
    commands: tuple[float, ...]
    positions: tuple[float, ...]
    residual: float


def settle_at(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], settle_s: float = SETTLE_S
) -> None:
    """Hold the airframe in a state until servos and rotors have followed the commands (see `Trim` for both)."""
    plant.command(commands)
    plant.place(state)
    plant.settle(round(settle_s * plant.physics_hz))


def accelerations(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], settle_s: float = SETTLE_S
) -> np.ndarray:
    """[6] rates of u, v, w, p, q, r [m/s2, rad/s2] in a state that is held until servos and rotors are steady."""
    settle_at(plant, state, commands, settle_s)
    return np.array([plant[name] * factor for name, factor in ACCELERATIONS])


@dataclass(frozen=True)
class TrimProblem:
    """Six accelerations as functions of six unknowns: some angles and speeds, and the commands that are not held.

    Attributes:
        plant: what accelerates; effectiveness as it is set there.
        given: airspeed, altitude, heading [m/s, m, rad] where they are not unknown.
        angles: the unknown angles and speeds, names of `Trim.state`.
        held: command of each actuator that is held, by its index; those of the others are unknown.
    """

    plant: Plant
    given: Mapping[str, float]
    angles: tuple[str, ...]
    held: Mapping[int, float]

    def __post_init__(self) -> None:
        unknowns = len(self.angles) + len(self.free_actuators)
        if unknowns != len(ACCELERATIONS):
            raise ValueError(f"{unknowns} unknowns for {len(ACCELERATIONS)} accelerations")

    @property
    def free_actuators(self) -> list[int]:
        """Indices of the actuators whose commands are unknown."""
        return [i for i in range(len(self.plant.aircraft.actuators)) if i not in self.held]

    @property
    def sizes(self) -> np.ndarray:
        """[6] one scaled unit of each unknown."""
        return np.array([_SIZES[n] for n in self.angles] + [_COMMAND_SIZE] * len(self.free_actuators))

    def first_guess(self) -> np.ndarray:
        """[6] where to begin, scaled."""
        actuators = list(self.plant.aircraft.actuators.values())
        known = {**_FIRST_ANGLES, **self.given}
        commands = [
            _FIRST_SERVO_RAD if isinstance(actuators[i], Servo) else _FIRST_THROTTLE
            for i in self.free_actuators
        ]
        return np.array([known[name] for name in self.angles] + commands) / self.sizes

    def condition(self, unknowns: np.ndarray) -> tuple[dict[str, float], list[float]]:
        """State and commands that [6] scaled unknowns mean, on the flight path that they ask for."""
        values = list(map(float, unknowns * self.sizes))
        state = {**_FIRST_ANGLES, **self.given, **dict(zip(self.angles, values, strict=False))}
        state["pitch"] = level_pitch(state["alpha"], state["beta"], state["roll"], state["path_angle"])
        free = dict(zip(self.free_actuators, values[len(self.angles) :], strict=True))
        commands = {**self.held, **free}
        return state, [commands[i] for i in range(len(commands))]

    def residual(self, unknowns: np.ndarray) -> np.ndarray:
        """[6] accelerations, or very large ones where the unknowns mean no flight any more."""
        if not np.all(np.abs(unknowns) < _FARTHEST):
            return np.full(len(unknowns), 1e3)
        return accelerations(self.plant, *self.condition(unknowns))

    def solution(self) -> Trim | None:
        """The steady flight, within what the actuators can do, or None; the plant is left in it."""
        found = root(self.residual, self.first_guess(), method="hybr", options={"xtol": _ROOT_TOLERANCE}).x
        state, commands = self.condition(found)
        worst = float(np.max(np.abs(self.residual(found))))
        if worst >= _RESIDUAL_MAX or not _within_stops(self.plant.aircraft, commands):
            return None
        self.plant.place(state)
        return Trim(state, tuple(commands), _positions(self.plant), worst)


def trim(
    plant: Plant,
    airspeed_m_s: float,
    altitude_m: float,
    heading_rad: float = math.pi / 2,
    held: Mapping[int, float] | None = None,
    free: Collection[str] = ("alpha", "roll"),
) -> Trim:
    """Find the commands and angles at which nothing accelerates; the flight is level unless `path_angle` is free.

    Args:
        plant: in any state; it is left in the trimmed one. Effectiveness is as set on it.
        held: command of each actuator that is not to be solved for, by its index.
        free: unknown angles and speeds, of `alpha beta roll airspeed path_angle`; with the free actuators, six.

    Raises:
        NoTrim: none was found.
        ValueError: the unknowns are not six.
    """
    given = {"airspeed": airspeed_m_s, "altitude": altitude_m, "heading": heading_rad}
    found = TrimProblem(plant, given, tuple(free), held or {}).solution()
    if found is None:
        what = (
            f"no steady flight of {plant.aircraft.name} was found at {airspeed_m_s:g} m/s, {altitude_m:g} m"
        )
        how = f"with {', '.join(free)} free and {plant.physics_hz:g} physics steps a second"
        raise NoTrim([Problem(f"{what}, {how}")])
    return found


_starts: Cache[Trim] = Cache(32)


def trimmed_start(
    aircraft: Aircraft, physics_hz: float, airspeed_m_s: float, altitude_m: float, heading_rad: float
) -> Trim:
    """Level flight to begin with; raises NoTrim. Found on a plant of its own, so that it depends on nothing else.

    Kept: the flights of a sweep share it, and finding it takes as long as some seconds of flight.
    """
    return _starts.get(
        (aircraft.fingerprint(), physics_hz, airspeed_m_s, altitude_m, heading_rad),
        lambda: trim(Plant(aircraft, physics_hz), airspeed_m_s, altitude_m, heading_rad),
    )


def begin_at(plant: Plant, start: Trim) -> None:
    """Put a plant into steady flight, servos and rotors steady: the first instant of a flight."""
    settle_at(plant, start.state, start.commands)
    plant.place(start.state)  # the Earth has turned while rotors settled: back to the start


def _positions(plant: Plant) -> tuple[float, ...]:
    n = len(plant.aircraft.actuators)
    return tuple(float(v) for v in plant.read()[-2 * n : -n])


def _within_stops(aircraft: Aircraft, commands: Sequence[float]) -> bool:
    """Whether each servo is within its stops [rad] and each throttle from 0 to 1."""
    for actuator, command in zip(aircraft.actuators.values(), commands, strict=True):
        low, high = map(math.radians, actuator.limits) if isinstance(actuator, Servo) else (0.0, 1.0)
        if not low <= command <= high:
            return False
    return True
