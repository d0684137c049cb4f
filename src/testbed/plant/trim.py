"""Trim: the commands and angles of steady flight, found in JSBSim itself through the real servos, motors and engines.

JSBSim's own FGTrim has one throttle and three controls, and drives a brushless motor out of its range. Here any number of
unknowns can be chosen freely, which an aircraft with a lost actuator needs. With more unknowns than the six accelerations,
the trim is the one with the least use of the actuators, as fractions of their travel, and with throttles as equal as can be.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from testbed.aircraft.description import Aircraft, AnyActuator, Servo
from testbed.common.angles import level_pitch
from testbed.common.cache import Cache
from testbed.common.roots import SMALLEST, NearestRoot
from testbed.inputs.problems import BadInput, Problem
from testbed.plant.first_load import property_catalog
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import STEADY, accelerations, settle_at

# Units by which the unknown angles and speeds are scaled [rad, m/s], so that the root-finder works with numbers near one, and
# the largest scaled one that it may try.
_SIZES = {"alpha": 0.1, "beta": 0.1, "roll": 0.1, "airspeed": 5.0, "path_angle": 0.1}
_FARTHEST = 20.0
_WEIGHTS = {"alpha": 0.01, "beta": 1.0, "roll": 1.0, "airspeed": 0.01, "path_angle": 0.01}
"""How unwanted a unit of each is, compared with half the travel of an actuator."""
_FIRST_ANGLES = {"alpha": 0.05, "beta": 0.0, "roll": 0.0, "path_angle": 0.0}
_FIRST_THROTTLE = 0.6  # of the range
_ENGINES_ENOUGH = 1e-7
"""An engine that is as steady as `STEADY` leaves accelerations of this order: a search that goes on finds noise."""


_NEAR_GROUND_M = 50.0
"""Lowest altitude at which no aircraft's wheels reach the ground."""
_GLANCE_S = 0.005
"""Step of a look at the wheels, in which the airframe is held."""


class NoTrim(BadInput):
    """No steady flight was found."""


@dataclass(frozen=True)
class Trim:
    """A steady flight condition of the truth.

    Attributes:
        state: airspeed, altitude, alpha, beta, roll, pitch, heading, path_angle [m/s, m, rad].
        commands: [n] servos in radians, else throttles.
        positions: [n] servo positions [deg] and thrusts [N], as if fully effective.
        residual: largest remaining acceleration [m/s2 or rad/s2].
    """

    state: Mapping[str, float]
    commands: tuple[float, ...]
    positions: tuple[float, ...]
    residual: float


@dataclass(frozen=True)
class Search:
    """How a trim is searched for.

    Attributes:
        near: a steady flight to begin at; without one the search begins with surfaces in their middle.
        residual_max: largest acceleration that may remain [m/s2 or rad/s2].
        steady: what steady means for engines, as `settling.STEADY`.
        enough: change of the scaled unknowns with which the search ends.
        thorough: whether to search on where Newton's method does not lead to a trim.
    """

    near: Trim | None = None
    residual_max: float = 1e-6
    steady: float = STEADY
    enough: float = SMALLEST
    thorough: bool = True

    def rough(self, thorough: bool = True) -> Search:
        """The same search, a thousand times coarser: it shows at a fraction of the time whether there is a trim."""
        return replace(self, residual_max=1e-3, steady=1e-4, enough=1e-3, thorough=thorough)


def command_range(actuator: AnyActuator) -> tuple[float, float]:
    """Lowest and highest command of an actuator [rad or throttle]."""
    if isinstance(actuator, Servo):
        return math.radians(actuator.limits[0]), math.radians(actuator.limits[1])
    return actuator.throttle


def command_steps(actuator: AnyActuator, at: float, size: float) -> tuple[float, float]:
    """Changes of a command, up and down, between which its effect is measured: this large, or less where its range ends."""
    low, high = command_range(actuator)
    return min(size, high - at), max(-size, low - at)


@dataclass(frozen=True)
class TrimProblem:
    """Six accelerations as functions of some angles and speeds, and of the commands that are not held.

    Attributes:
        plant: the aircraft, with the effectiveness that is set in it.
        given: airspeed, altitude, heading [m/s, m, rad]; for an unknown one its first guess.
        angles: names in `Trim.state` of the unknown angles and speeds.
        held: command of each actuator that is held [rad or throttle], by its index. The other commands are unknown.
        search: how exactly, and from where.
    """

    plant: Plant
    given: Mapping[str, float]
    angles: tuple[str, ...]
    held: Mapping[int, float]
    search: Search = Search()

    @property
    def free(self) -> dict[int, AnyActuator]:
        """The actuators whose commands are unknown, by their indices."""
        return {i: a for i, a in enumerate(self.plant.aircraft.actuators.values()) if i not in self.held}

    @property
    def sizes(self) -> np.ndarray:
        """Units by which the unknowns are scaled [rad, m/s; rad or throttle for commands: half the travel]."""
        ranges = [command_range(actuator) for actuator in self.free.values()]
        return np.array([_SIZES[n] for n in self.angles] + [0.5 * (high - low) for low, high in ranges])

    def first_guess(self) -> np.ndarray:
        """First guess of the scaled unknowns: those of `search.near`, else surfaces at mid-travel and throttles above it."""
        near = self.search.near
        known = {**_FIRST_ANGLES, **self.given, **(near.state if near else {})}
        commands = [near.commands[i] for i in self.free] if near else list(map(_first, self.free.values()))
        return np.array([known[name] for name in self.angles] + commands) / self.sizes

    def condition(self, unknowns: np.ndarray) -> tuple[dict[str, float], list[float]]:
        """State and commands that the scaled unknowns stand for; pitch follows from the path angle, alpha, beta and roll."""
        values = list(map(float, unknowns * self.sizes))
        state = {**_FIRST_ANGLES, **self.given, **dict(zip(self.angles, values, strict=False))}
        state["pitch"] = level_pitch(state["alpha"], state["beta"], state["roll"], state["path_angle"])
        free = dict(zip(self.free, values[len(self.angles) :], strict=True))
        commands = {**self.held, **free}
        return state, [commands[i] for i in range(len(commands))]

    def residual(self, unknowns: np.ndarray) -> np.ndarray:
        """[6] accelerations [m/s2, rad/s2]."""
        return accelerations(self.plant, *self.condition(unknowns), steady=self.search.steady)

    def solution(self) -> Trim | None:
        """The steady flight, or None if none was found within the stops. The plant is left in it."""
        most = self.search.residual_max
        found = self._root().find(self.first_guess(), most, self.search.thorough)
        state, commands = self.condition(found)
        worst = float(np.max(np.abs(self.residual(found))))
        if not worst < most:
            return None
        self.plant.place(state)
        n = len(commands)
        positions = tuple(float(v) for v in self.plant.read()[-2 * n : -n])
        return Trim(state, tuple(commands), positions, worst)

    def _root(self) -> NearestRoot:
        ranges, angles = (
            np.array([command_range(a) for a in self.free.values()]).reshape(-1, 2),
            len(self.angles),
        )
        # The scaled airspeed of a fast aircraft may be beyond `_FARTHEST` at the first guess already.
        far = np.maximum(_FARTHEST, 2.0 * np.abs(self.first_guess()[:angles]))
        low, high = (
            np.concatenate([far * s, ranges[:, k] / self.sizes[angles:]]) for s, k in ((-1, 0), (1, 1))
        )
        weight = np.array([_WEIGHTS[name] for name in self.angles] + [1.0] * len(self.free))
        exact = NearestRoot(self.residual, low, high, weight, self._preferred, self.search.enough)
        return self._with_rough_start(exact) if self.plant.aircraft.has_engines else exact

    def _with_rough_start(self, exact: NearestRoot) -> NearestRoot:
        """An engine takes long to become as steady as an exact trim asks for: most of the search does without."""
        rough = replace(self, search=self.search.rough(self.search.thorough))
        enough, noise = max(self.search.enough, _ENGINES_ENOUGH), self.search.steady
        exact = replace(exact, enough=enough, noise=noise)
        if rough.search == self.search:
            return exact
        enough, noise = rough.search.enough, rough.search.steady
        coarse = replace(exact, function=rough.residual, enough=enough, noise=noise)
        return replace(exact, coarse=(coarse, rough.search.residual_max))

    def _preferred(self, unknowns: np.ndarray) -> np.ndarray:
        """The unknowns with the least use: no deflection, and of each throttle the mean of all."""
        throttles = [
            len(self.angles) + i for i, a in enumerate(self.free.values()) if not isinstance(a, Servo)
        ]
        preferred = np.zeros(len(unknowns))
        preferred[: len(self.angles)] = self.first_guess()[: len(self.angles)]
        if throttles:
            preferred[throttles] = np.mean(unknowns[throttles])
        return preferred


def _first(actuator: AnyActuator) -> float:
    """First guess of a command [rad or throttle]."""
    low, high = command_range(actuator)
    return low + (0.5 if isinstance(actuator, Servo) else _FIRST_THROTTLE) * (high - low)


def trim(
    plant: Plant,
    airspeed_m_s: float,
    altitude_m: float,
    heading_rad: float = math.pi / 2,
    held: Mapping[int, float] | None = None,
    free: Collection[str] = (),
    search: Search | None = None,
) -> Trim:
    """Find the commands and angles at which all accelerations are zero; the flight is level unless `path_angle` is free.

    Args:
        plant: in any state, with the effectiveness that is set in it; it is left in the trimmed state.
        held: command [rad or throttle] of each actuator that is not to be solved for, by its index.
        free: unknown angles and speeds, some of `alpha beta roll airspeed path_angle`. If it is empty they are alpha and roll,
            the path angle of an aircraft without propulsion, and sideslip where the unknowns would be fewer than six.
        search: how exactly, and from where.

    Raises:
        NoTrim: no trim was found.
        BadInput: JSBSim cannot go on with the model.
    """
    given = {"airspeed": airspeed_m_s, "altitude": altitude_m, "heading": heading_rad}
    angles = tuple(free) or _free_angles(plant.aircraft, held or {})
    with plant.in_words():
        found = TrimProblem(plant, given, angles, held or {}, search or Search()).solution()
    if found is None:
        what = (
            f"no steady flight of {plant.aircraft.name} was found at {airspeed_m_s:g} m/s, {altitude_m:g} m"
        )
        how = f"with {', '.join(angles)} free and {plant.physics_hz:g} physics steps a second"
        raise NoTrim([Problem(f"{what}, {how}")])
    return found


def _free_angles(aircraft: Aircraft, held: Mapping[int, float]) -> tuple[str, ...]:
    free = [a for i, a in enumerate(aircraft.actuators.values()) if i not in held]
    angles = ["alpha", "roll"]
    if all(isinstance(a, Servo) for a in free):
        angles.append("path_angle")
    if len(angles) + len(free) < 6:
        angles.insert(1, "beta")
    return tuple(angles)


_starts: Cache[Trim] = Cache(32)


def trimmed_start(
    aircraft: Aircraft, physics_hz: float, airspeed_m_s: float, altitude_m: float, heading_rad: float
) -> Trim:
    """Steady flight in which a flight begins. It is found on a new plant, so that it depends on nothing else.

    Raises NoTrim, also where the aircraft would touch the ground. Cached: the flights of a sweep share it, and to find it takes
    as long as to simulate some seconds of flight.
    """

    def found() -> Trim:
        if altitude_m < _NEAR_GROUND_M:
            _refuse_on_ground(aircraft, airspeed_m_s, altitude_m)
        return trim(Plant(aircraft, physics_hz), airspeed_m_s, altitude_m, heading_rad)

    return _starts.get((aircraft.fingerprint(), physics_hz, airspeed_m_s, altitude_m, heading_rad), found)


def _refuse_on_ground(aircraft: Aircraft, airspeed_m_s: float, altitude_m: float) -> None:
    """Raise NoTrim if a wheel or another contact point of the model is in the ground at this altitude."""
    contacts = [name for name in property_catalog(aircraft) if name.endswith("/WOW")]
    if not contacts:
        return
    plant = Plant(aircraft, 1.0 / _GLANCE_S)
    alpha = _FIRST_ANGLES["alpha"]
    plant.place({"airspeed": airspeed_m_s, "altitude": altitude_m, "alpha": alpha, "pitch": alpha})
    plant.settle(1)
    if any(plant[name] for name in contacts):
        raise NoTrim(
            [Problem(f"{aircraft.name} touches the ground at {altitude_m:g} m", expected="a higher one")]
        )


def begin_at(plant: Plant, start: Trim) -> None:
    """Put a plant into a trim, with servos, rotors and engines steady: the first instant of a flight.

    JSBSim's Earth turns while they settle. Without engines the airframe is put back to the start. A turboprop would fall to
    idle with that, so an aircraft with engines is held once more, from a place that the Earth's turning brings to the start.
    """
    time_s = settle_at(plant, start.state, start.commands)
    if not plant.aircraft.has_engines:
        plant.place(start.state)
        return
    steps = round(time_s * plant.physics_hz)
    plant.place(start.state, turning_s=steps * plant.dt_s)
    plant.settle(steps)
