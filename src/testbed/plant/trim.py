"""Trim: our own root-find over all six accelerations, through the real servos, motors and rotors.

JSBSim's FGTrim knows one throttle and three controls and throws a brushless motor out of its range; this one solves
for any choice of unknowns, which is what an aircraft with a lost actuator needs.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import root

from testbed.common.frames import level_pitch
from testbed.inputs.problems import BadInput, Problem
from testbed.plant.jsbsim import ACCELERATIONS, Plant

_SETTLE_S = 1.5  # more than 40 time constants of rotors and servos
_ROOT_TOLERANCE = 1e-9
# Sizes of the unknowns, so that the root-find sees numbers near one.
_SIZES = {"alpha": 0.1, "beta": 0.1, "roll": 0.1, "airspeed": 5.0, "path_angle": 0.1}
_COMMAND_SIZE = 0.2


class NoTrim(BadInput):
    """No level (or asked-for) steady flight was found from any starting point."""


@dataclass(frozen=True)
class Trim:
    """A steady flight condition of the truth.

    Attributes:
        state: airspeed, altitude, alpha, beta, roll, pitch, heading, path_angle [SI, rad].
        commands: [n] servos in radians, motors as throttle 0 to 1.
        positions: [n] servo positions and thrusts, in the aircraft's units, as if fully effective.
        residual: largest remaining acceleration [m/s2 or rad/s2].
    """

    state: Mapping[str, float]
    commands: tuple[float, ...]
    positions: tuple[float, ...]
    residual: float


def accelerations(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], settle_s: float = _SETTLE_S
) -> np.ndarray:
    """[6] u, v, w, p, q, r rates [m/s2, rad/s2] of the held state once servos and rotors are steady."""
    plant.command(commands)
    plant.place(state)
    plant.settle(round(settle_s / plant.dt_s))
    return np.array([plant[name] * factor for name, factor in ACCELERATIONS])


def trim(
    plant: Plant,
    airspeed_m_s: float,
    altitude_m: float,
    heading_rad: float = math.pi / 2,
    held: Mapping[int, float] | None = None,
    free: Collection[str] = ("alpha", "roll"),
    starts: Sequence[Mapping[str, float]] = ({},),
) -> Trim:
    """Find the commands and angles at which nothing accelerates.

    Args:
        plant: at any state; it is left in the trimmed one, at rest. Effectiveness is as set on it.
        held: actuator index to the command at which it stays; the other actuators are unknowns.
        free: unknown angles and speeds; with the free actuators they must be six.
        starts: values to start from, first that converges wins.

    Raises:
        NoTrim: no start converged.
    """
    held = dict(held or {})
    actuators = list(plant.aircraft.actuators.values())
    unknown = [i for i in range(len(actuators)) if i not in held]
    names = list(free)
    if len(unknown) + len(names) != len(ACCELERATIONS):
        raise ValueError(f"{len(unknown) + len(names)} unknowns for {len(ACCELERATIONS)} accelerations")
    sizes = np.array([_SIZES[n] for n in names] + [_COMMAND_SIZE] * len(unknown))
    fixed = {"airspeed": airspeed_m_s, "altitude": altitude_m, "heading": heading_rad}

    def condition(x: np.ndarray) -> tuple[dict[str, float], list[float]]:
        values = x * sizes
        state = {"alpha": 0.05, "beta": 0.0, "roll": 0.0, "path_angle": 0.0, **fixed}
        state.update(zip(names, map(float, values), strict=False))
        state["pitch"] = level_pitch(state["alpha"], state["beta"], state["roll"], state["path_angle"])
        commands = [held.get(i, 0.0) for i in range(len(actuators))]
        for i, value in zip(unknown, values[len(names) :], strict=True):
            commands[i] = float(value)
        return state, commands

    def residual(x: np.ndarray) -> np.ndarray:
        if not np.all(np.abs(x) < 20.0):
            return np.full(len(x), 1e3)
        return accelerations(plant, *condition(x))

    defaults = {"alpha": 0.05, "airspeed": airspeed_m_s}
    for start in starts:
        first = [start.get(n, defaults.get(n, 0.0)) for n in names]
        first += [start.get(i, 0.05 if actuators[i].kind == "servo" else 0.6) for i in unknown]  # type: ignore[call-overload]
        solution = root(residual, np.array(first) / sizes, method="hybr", options={"xtol": _ROOT_TOLERANCE})
        state, commands = condition(solution.x)
        worst = float(np.max(np.abs(residual(solution.x))))
        if worst < 1e-6 and _attainable(actuators, commands):
            plant.place(state)
            return Trim(state, tuple(commands), _positions(plant), worst)
    what = f"no steady flight of {plant.aircraft.name} was found at {airspeed_m_s:g} m/s, {altitude_m:g} m"
    how = f"with {', '.join(names)} free and {1.0 / plant.dt_s:g} physics steps a second"
    raise NoTrim([Problem(f"{what}, {how}")])


def _positions(plant: Plant) -> tuple[float, ...]:
    n = len(plant.aircraft.actuators)
    return tuple(float(v) for v in plant.read()[-2 * n : -n])


def _attainable(actuators: Sequence, commands: Sequence[float]) -> bool:
    for actuator, command in zip(actuators, commands, strict=True):
        low, high = (math.radians(x) for x in actuator.limits) if actuator.kind == "servo" else (0.0, 1.0)
        if not low <= command <= high:
            return False
    return True
