"""The plant as a test stand for propulsion: thrust and torque of motors and engines, with the airframe held."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from testbed.aircraft.description import Aircraft, Engine, MotorActuator
from testbed.aircraft.propulsors import (
    ENGINE_SPEEDS,
    ENGINE_THROTTLES,
    PROPELLER_POINTS,
    EngineMap,
    Propulsor,
)
from testbed.common.units import METRES_PER_FOOT, NEWTON_METRES_PER_FOOT_POUND, NEWTONS_PER_POUND
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import accelerations, settle_at, wait_for_engines
from testbed.plant.trim import Trim

_SLUG_FT3 = 515.378818393  # kg/m3 in one slug/ft3
PROPELLER_SPEEDS = (0.6, 0.8, 1.0, 1.2)
"""Fractions of the reference airspeed at which a propeller's tables are measured."""
_PROPELLER_THROTTLES = np.linspace(0.3, 1.0, 36)
_WINDMILLING = 0.045
"""Points with a thrust that is further below the lowest limit than this share of the travel are left out of the tables."""
_ENGINE_SPEEDS = np.linspace(0.6, 1.4, ENGINE_SPEEDS)  # fractions of the reference airspeed
_MAP_STEADY, _RESPONSE_STEADY = 1e-4, 1e-2  # what steady means on the stand, as `settling.STEADY`
_SAMPLE_HZ, _RESPONSE_S, _STEP = 20, 15.0, 0.1
"""Rate at which the response to a step of throttle is sampled, its longest duration, the smaller step [of the range]."""
_ENGINES_HZ, _MOTORS_HZ = 120.0, 200.0
"""Least physics steps per second on the stand, of an aircraft with engines and of any other."""
FASTEST_RAD_S, FASTEST_1_S = 30.0, 10.0
"""Lag and rate of an engine whose thrust follows its throttle at once."""


def changed(commands: Sequence[float], i: int, by: float) -> list[float]:
    """The commands, with that of actuator i changed by this much [rad or throttle]."""
    return [c + by if j == i else c for j, c in enumerate(commands)]


def air_density(plant: Plant) -> float:
    """Density of the air [kg/m3]."""
    return plant["atmosphere/rho-slugs_ft3"] * _SLUG_FT3


def propulsors_of(plant: Plant, level: Trim) -> tuple[Propulsor | EngineMap | None, ...]:
    """Motor and propeller, or engine, of each actuator about a trim; None for servos."""
    engines = engine_maps(plant, level)
    return tuple(
        propeller(plant, level, i, a) if isinstance(a, MotorActuator) else engines.get(i)
        for i, a in enumerate(plant.aircraft.actuators.values())
    )


# Electric motors ------------------------------------------------------------------------------------------------


def propeller(plant: Plant, level: Trim, i: int, actuator: MotorActuator) -> Propulsor:
    """Thrust and torque coefficients over the advance ratio, measured with the airframe held, and the motor."""
    engine, motor = f"propulsion/engine[{actuator.engine}]", actuator.motor
    density = air_density(plant)
    sense = plant[f"{engine}/propeller-sense"]  # the airframe feels the opposite torque
    least = actuator.limits[0] - _WINDMILLING * (actuator.limits[1] - actuator.limits[0])
    rows = []
    for speed in PROPELLER_SPEEDS:
        state = {**level.state, "airspeed": speed * level.state["airspeed"]}
        for throttle in _PROPELLER_THROTTLES:
            accelerations(plant, state, changed(level.commands, i, throttle - level.commands[i]))
            n = plant[f"{engine}/propeller-rpm"] / 60.0
            thrust = plant[f"{engine}/thrust-lbs"] * NEWTONS_PER_POUND
            torque = -sense * plant[f"{engine}/propeller-torque-ftlb"] * NEWTON_METRES_PER_FOOT_POUND
            axial = plant["velocities/u-aero-fps"] * METRES_PER_FOOT
            d, pressure = motor.diameter_m, density * n * n * motor.diameter_m**4
            if thrust < least:
                continue
            rows.append((axial / (n * d), thrust / pressure, torque / (pressure * d)))
    j, thrust_c, torque_c = np.array(sorted(rows)).T
    grid = np.linspace(j[0], j[-1], PROPELLER_POINTS)
    return Propulsor(
        advance=(float(j[0]), float(j[-1])),
        thrust=tuple(map(float, np.interp(grid, j, thrust_c))),
        torque=tuple(map(float, np.interp(grid, j, torque_c))),
        diameter_m=motor.diameter_m,
        rotor_inertia_kg_m2=motor.rotor_inertia_kg_m2,
        max_volts=motor.max_volts,
        velocity_constant_rps_v=motor.velocity_constant_rpm_v / 60.0,
        torque_constant_n_m_a=60.0 / (2.0 * math.pi * motor.velocity_constant_rpm_v),
        resistance_ohm=motor.resistance_ohm,
        no_load_current_a=motor.no_load_current_a,
    )


# Engines --------------------------------------------------------------------------------------------------------


def engine_maps(plant: Plant, level: Trim) -> dict[int, EngineMap]:
    """The map of each engine, by the actuator's index. All are measured at the same time: they do not act on each other."""
    engines = {i: a for i, a in enumerate(plant.aircraft.actuators.values()) if isinstance(a, Engine)}
    if not engines:
        return {}
    grids = {i: throttle_grid(actuator.throttle, level.commands[i]) for i, actuator in engines.items()}
    thrusts = np.array([_thrusts_at(plant, level, grids, share) for share in _ENGINE_SPEEDS])
    axial = level.state["airspeed"] * math.cos(level.state["alpha"])
    followed, responses = _responses(plant, level, engines)
    found = {}
    for row, (i, actuator) in enumerate(engines.items()):
        static = EngineMap(
            throttles=tuple(map(float, grids[i])),
            speeds=tuple(map(float, axial * _ENGINE_SPEEDS)),
            thrust=tuple(tuple(map(float, each)) for each in thrusts[:, :, row]),
            lag_rad_s=FASTEST_RAD_S,
            rise_s=FASTEST_1_S,
            fall_s=FASTEST_1_S,
        )
        found[i] = _fitted(static, axial, followed[row], responses[row], level.commands[i], actuator)
    return found


def throttle_grid(throttle: tuple[float, float], trim: float) -> np.ndarray:
    """[`ENGINE_THROTTLES`] equal steps over the range, but for the one nearest to the trim's throttle, which is that."""
    grid = np.linspace(*throttle, ENGINE_THROTTLES)
    nearest = 1 + int(np.argmin(np.abs(grid[1:-1] - trim)))
    if grid[nearest - 1] < trim < grid[nearest + 1]:
        grid[nearest] = trim
    return grid


def _thrusts_at(plant: Plant, level: Trim, grids: dict[int, np.ndarray], share: float) -> np.ndarray:
    """[throttles, engines] steady thrusts [N] at a fraction of the trim's airspeed."""
    state = {**level.state, "airspeed": share * level.state["airspeed"]}
    settle_at(plant, state, level.commands, steady=_MAP_STEADY)
    rows = []
    for k in range(ENGINE_THROTTLES):
        plant.command([grids[i][k] if i in grids else c for i, c in enumerate(level.commands)])
        wait_for_engines(plant, _MAP_STEADY)
        rows.append([plant.position(i) for i in grids])
    return np.array(rows)


def _fitted(
    static: EngineMap,
    axial_m_s: float,
    throttles: np.ndarray,
    thrusts: np.ndarray,
    start: float,
    actuator: Engine,
) -> EngineMap:
    """The map with the lag and the rates that describe an engine's response best; a lag in the aircraft's YAML is kept.

    Args:
        throttles, thrusts: commanded throttle and thrust [N] of each sample, as of `_responses`.
        start: the throttle before the first step.
    """
    from scipy.optimize import (
        least_squares,  # here, because it is slow to import, and this is done once for an aircraft
    )

    row = np.array([static.thrust_at(t, axial_m_s) for t in static.throttles])

    def misfit(logs: np.ndarray) -> np.ndarray:
        lag, rise, fall = map(float, np.exp(logs))
        followed = follow(throttles, start, lag, rise, fall, 1.0 / _SAMPLE_HZ)
        return (np.interp(followed, static.throttles, row) - thrusts) / actuator.scale

    fastest = np.log([FASTEST_RAD_S, FASTEST_1_S, FASTEST_1_S])
    slowest = np.log([0.05, 0.01, 0.01])
    corners, rates = (0.3, 1.0, 3.0, 10.0, 29.0), (0.05, 0.1, 0.2, 0.4, 0.8, 9.0)
    starts = [np.log(each) for each in product(corners, rates, rates)]
    best = min(starts, key=lambda logs: float(np.sum(misfit(logs) ** 2)))
    found = least_squares(
        misfit, best, bounds=(slowest - 1e-3, fastest + 1e-3), diff_step=[1e-2] * 3, max_nfev=40
    )
    lag, rise, fall = map(float, np.exp(np.clip(found.x, slowest, fastest)))
    return replace(static, lag_rad_s=actuator.lag_rad_s or lag, rise_s=rise, fall_s=fall)


def follow(
    throttles: np.ndarray, start: float, lag: float, rise: float, fall: float, dt: float
) -> np.ndarray:
    """The throttle that an engine follows from `start` on: first-order lag [rad/s] with limited rates [1/s], steps of dt [s]."""
    followed, gain, now = np.empty_like(throttles), 1.0 - math.exp(-lag * dt), start
    for k, throttle in enumerate(throttles):
        followed[k] = now
        now += min(max(gain * (throttle - now), -fall * dt), rise * dt)
    return followed


def _responses(plant: Plant, level: Trim, engines: dict[int, Engine]) -> tuple[np.ndarray, np.ndarray]:
    """[engines, samples] throttles and thrusts [N] after steps of all throttles: a little up, a little down, to the top, to the
    bottom."""
    settle_at(plant, level.state, level.commands, steady=_RESPONSE_STEADY)
    throttles, thrusts = [], []
    chunk = round(plant.physics_hz / _SAMPLE_HZ)
    for step in (_STEP, -_STEP, math.inf, -math.inf):
        command = list(level.commands)
        for i, actuator in engines.items():
            low, high = actuator.throttle
            command[i] = min(max(command[i] + step * (high - low), low), high)
        plant.command(command)
        for _ in range(round(_RESPONSE_S * _SAMPLE_HZ)):
            throttles.append([command[i] for i in engines])
            thrusts.append([plant.position(i) for i in engines])
            plant.settle(chunk)
    return np.array(throttles).T, np.array(thrusts).T


def stand_physics_hz(aircraft: Aircraft) -> float:
    """Physics steps per second with which an aircraft is identified: four in a time constant of the fastest actuator.

    Engines are waited for, a minute at a time, and what is found is steady: they need no more than JSBSim's usual rate.
    """
    least = _ENGINES_HZ if aircraft.has_engines else _MOTORS_HZ
    return max(least, math.ceil(4.0 * max(a.lag_rad_s or 0.0 for a in aircraft.actuators.values())))
