"""Trim: the commands and angles of steady flight, found in JSBSim itself through the real servos, motors and rotors.

JSBSim's own FGTrim has one throttle and three controls, and drives a brushless motor out of its range. Here the six unknowns
can be chosen freely, which an aircraft with a lost actuator needs.
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
"""Time after which rotors and servos are taken to be steady [s]: more than 40 time constants of the v-tail's."""
_ROOT_TOLERANCE = 1e-9
_RESIDUAL_MAX = 1e-6  # largest acceleration that may remain [m/s2 or rad/s2]
# Units by which the unknowns are scaled, so that the root-finder works with numbers near one [rad, m/s; rad or throttle for
# commands], and the largest scaled unknown that it may try.
_SIZES = {"alpha": 0.1, "beta": 0.1, "roll": 0.1, "airspeed": 5.0, "path_angle": 0.1}
_COMMAND_SIZE, _FARTHEST = 0.2, 20.0
# First guess: a small angle of attack, trailing edges a little down, motors above half throttle.
_FIRST_ANGLES = {"alpha": 0.05, "beta": 0.0, "roll": 0.0, "path_angle": 0.0}
_FIRST_SERVO_RAD, _FIRST_THROTTLE = 0.05, 0.6


class NoTrim(BadInput):
    """No steady flight was found."""


@dataclass(frozen=True)
class Trim:
    """A steady flight condition of the truth.

    Attributes:
        state: airspeed, altitude, alpha, beta, roll, pitch, heading, path_angle [m/s, m, rad].
        commands: [n] servos in radians, motors as throttle from 0 to 1.
        positions: [n] servo positions [deg] and thrusts [N], as if fully effective.
        residual: largest remaining acceleration [m/s2 or rad/s2].
    """

    state: Mapping[str, float]
    commands: tuple[float, ...]
    positions: tuple[float, ...]
    residual: float


def settle_at(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], settle_s: float = SETTLE_S
) -> None:
    """Hold the airframe in a state while servos and rotors follow the commands for `settle_s` [s]; units as in `Trim`."""
    plant.command(commands)
    plant.place(state)
    plant.settle(round(settle_s * plant.physics_hz))


def accelerations(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], settle_s: float = SETTLE_S
) -> np.ndarray:
    """[6] rates of u, v, w, p, q, r [m/s2, rad/s2] in a state that is held for `settle_s` [s]; arguments as in `settle_at`."""
    settle_at(plant, state, commands, settle_s)
    return np.array([plant[name] * factor for name, factor in ACCELERATIONS])


@dataclass(frozen=True)
class TrimProblem:
    """Six accelerations as functions of six unknowns: some angles and speeds, and the commands that are not held.

    Attributes:
        plant: the aircraft, with the effectiveness that is set in it.
        given: airspeed, altitude, heading [m/s, m, rad]; for an unknown one its first guess.
        angles: names in `Trim.state` of the unknown angles and speeds.
        held: command of each actuator that is held [rad or throttle], by its index. The other commands are unknown.
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
        """[6] units by which the unknowns are scaled [rad, m/s; rad or throttle for commands]."""
        return np.array([_SIZES[n] for n in self.angles] + [_COMMAND_SIZE] * len(self.free_actuators))

    def first_guess(self) -> np.ndarray:
        """[6] first guess of the scaled unknowns."""
        actuators = list(self.plant.aircraft.actuators.values())
        known = {**_FIRST_ANGLES, **self.given}
        commands = [
            _FIRST_SERVO_RAD if isinstance(actuators[i], Servo) else _FIRST_THROTTLE
            for i in self.free_actuators
        ]
        return np.array([known[name] for name in self.angles] + commands) / self.sizes

    def condition(self, unknowns: np.ndarray) -> tuple[dict[str, float], list[float]]:
        """State and commands that [6] scaled unknowns stand for; pitch follows from the path angle, alpha, beta and roll."""
        values = list(map(float, unknowns * self.sizes))
        state = {**_FIRST_ANGLES, **self.given, **dict(zip(self.angles, values, strict=False))}
        state["pitch"] = level_pitch(state["alpha"], state["beta"], state["roll"], state["path_angle"])
        free = dict(zip(self.free_actuators, values[len(self.angles) :], strict=True))
        commands = {**self.held, **free}
        return state, [commands[i] for i in range(len(commands))]

    def residual(self, unknowns: np.ndarray) -> np.ndarray:
        """[6] accelerations [m/s2, rad/s2], or very large ones where the unknowns are too large for any flight."""
        if not np.all(np.abs(unknowns) < _FARTHEST):
            return np.full(len(unknowns), 1e3)
        return accelerations(self.plant, *self.condition(unknowns))

    def solution(self) -> Trim | None:
        """The steady flight, or None if none was found within the stops. The plant is left in it."""
        found = root(self.residual, self.first_guess(), method="hybr", options={"xtol": _ROOT_TOLERANCE}).x
        state, commands = self.condition(found)
        worst = float(np.max(np.abs(self.residual(found))))
        if not worst < _RESIDUAL_MAX or not _within_stops(self.plant.aircraft, commands):
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
    """Find the commands and angles at which all accelerations are zero; the flight is level unless `path_angle` is free.

    Args:
        plant: in any state, with the effectiveness that is set in it; it is left in the trimmed state.
        held: command [rad or throttle] of each actuator that is not to be solved for, by its index.
        free: unknown angles and speeds, some of `alpha beta roll airspeed path_angle`. With the unknown commands they must be
            six.

    Raises:
        NoTrim: no trim was found.
        ValueError: there are not six unknowns.
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
    """Level flight in which a flight begins; raises NoTrim. It is found on a new plant, so that it depends on nothing else.

    Cached: the flights of a sweep share it, and to find it takes as long as to simulate some seconds of flight.
    """
    return _starts.get(
        (aircraft.fingerprint(), physics_hz, airspeed_m_s, altitude_m, heading_rad),
        lambda: trim(Plant(aircraft, physics_hz), airspeed_m_s, altitude_m, heading_rad),
    )


def begin_at(plant: Plant, start: Trim) -> None:
    """Put a plant into a trim, with servos and rotors steady: the first instant of a flight."""
    settle_at(plant, start.state, start.commands)
    plant.place(start.state)  # JSBSim's Earth has turned while the rotors settled: back to the start


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
