"""The plant as a test stand: the airframe is held in a state while servos, rotors and engines follow their commands."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from testbed.aircraft.description import Aircraft, Engine, Servo
from testbed.inputs.problems import BadInput, Problem
from testbed.plant.jsbsim import Plant
from testbed.plant.properties import ACCELERATIONS

_TIME_CONSTANTS = 43.0
"""Time constants of the slowest servo or rotor after which all are taken to be steady: e^-43 is less than rounding."""
_SLOWEST_RAD_S = 0.7
"""Lag of the slowest servo or rotor: a trim waits some fifty times until all are steady, a minute of flight each time."""
_ENGINE_WINDOW_S, _ENGINES_WITHIN_S = 0.5, 120.0
STEADY = 1e-8
"""Engines are steady when their thrust is expected to change by no more than this, as a fraction of their `scale`."""


def settle_s(aircraft: Aircraft) -> float:
    """Time in which servos and rotors become steady [s], a whole number of tenths; engines are waited for.

    Raises BadInput for an actuator so slow that looking for a trim would take minutes.
    """
    lags = [a.lag_rad_s for a in aircraft.actuators.values() if not isinstance(a, Engine)]
    for name, actuator in aircraft.actuators.items():
        if not isinstance(actuator, Engine) and 0.0 < actuator.lag_rad_s < _SLOWEST_RAD_S:
            what = f"follows its command at {actuator.lag_rad_s:.2g} rad/s"
            expected = f"at least {_SLOWEST_RAD_S:g} rad/s, by its lag or its rotor's inertia"
            raise BadInput([Problem(what, str(aircraft.folder), path=f"actuators.{name}", expected=expected)])
    return math.ceil(10.0 * _TIME_CONSTANTS / min(lag for lag in lags if lag)) / 10.0 if lags else 0.5


def servos_settle_s(aircraft: Aircraft, steady: float) -> float:
    """Time in which the servos of an aircraft with engines become as steady as its engines are asked to be [s].

    A servo that crosses half its travel at its rate limit, and then approaches its command by its lag, is within a hundredth of
    `steady` of it.
    """
    settled = settle_s(aircraft)
    servos = [a for a in aircraft.actuators.values() if isinstance(a, Servo)]
    crossing = max((0.5 * (a.limits[1] - a.limits[0]) / a.rate_limit for a in servos), default=0.0)
    return min(settled, crossing + settled * math.log(100.0 / steady) / _TIME_CONSTANTS)


def settle_at(
    plant: Plant,
    state: Mapping[str, float],
    commands: Sequence[float],
    for_s: float | None = None,
    steady: float = STEADY,
) -> float:
    """Hold the airframe in a state while the actuators follow the commands; returns for how long [s].

    Args:
        plant: in any state.
        state: as in `Plant.place`.
        commands: [n] servos in radians, else throttles.
        for_s: how long [s]; None for until all are steady.
        steady: what steady means for engines, as `STEADY`.
    """
    plant.command(commands)
    plant.place(state)
    if for_s is None and plant.aircraft.has_engines:
        return wait_for_engines(plant, steady, at_least_s=servos_settle_s(plant.aircraft, steady))
    time_s = settle_s(plant.aircraft) if for_s is None else for_s
    plant.settle(round(time_s * plant.physics_hz))
    return time_s


def wait_for_engines(plant: Plant, steady: float, at_least_s: float = 0.0) -> float:
    """Run until the thrust of each engine is steady (see `settle_at`), or for `_ENGINES_WITHIN_S`; returns for how long [s].

    Servos need `at_least_s`, in which the engines settle too.
    """
    steps = round(_ENGINE_WINDOW_S * plant.physics_hz)
    thrusts = [_thrusts(plant)]
    for count in range(1, round(_ENGINES_WITHIN_S / _ENGINE_WINDOW_S)):
        plant.settle(steps)
        thrusts.append(_thrusts(plant))
        if count < max(3.0, at_least_s / _ENGINE_WINDOW_S):
            continue
        if np.all(_left_to_change(*thrusts[-3:]) <= steady):
            break
    return count * steps * plant.dt_s


def _thrusts(plant: Plant) -> np.ndarray:
    """Thrust of each engine, as a fraction of its `scale`."""
    engines = [(i, a) for i, a in enumerate(plant.aircraft.actuators.values()) if isinstance(a, Engine)]
    return np.array([plant.position(i) / a.scale for i, a in engines])


def _left_to_change(first: np.ndarray, second: np.ndarray, third: np.ndarray) -> np.ndarray:
    """How far three equally spaced values of a decaying change are from its end: a geometric series (Aitken); infinite where the
    change does not decay."""
    before, now = np.abs(second - first), np.abs(third - second)
    rest = np.divide(now * now, before - now, out=np.full_like(now, np.inf), where=before > now)
    return np.where(np.maximum(before, now) < 1e-12, 0.0, rest)


def accelerations(
    plant: Plant,
    state: Mapping[str, float],
    commands: Sequence[float],
    for_s: float | None = None,
    steady: float = STEADY,
) -> np.ndarray:
    """[6] rates of u, v, w, p, q, r [m/s2, rad/s2] in a state that is held; arguments as in `settle_at`."""
    settle_at(plant, state, commands, for_s, steady)
    return np.array([plant[name] * factor for name, factor in ACCELERATIONS])
