"""Identify the design model (`aircraft.design_model`) before flight: trim, then central differences of accelerations.

The airframe is held in a state while servos and rotors settle, as on a test stand, and its accelerations are read. The
result is stored in `aircraft/<name>/design_model.json`. Of the plant a controller is told this model, the aircraft's YAML and
the trim in which the flight begins (`testbed.controllers.setup`), and nothing else.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import (
    COLUMNS,
    DESIGN_MODEL,
    PROPELLER_POINTS,
    DesignModel,
    Propulsor,
    kinematics,
    load_design_model,
)
from testbed.common.cache import Cache
from testbed.common.units import METRES_PER_FOOT, NEWTON_METRES_PER_FOOT_POUND, NEWTONS_PER_POUND
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, accelerations, trim

_PHYSICS_HZ = 200.0
_SLUG_FT3 = 515.378818393  # kg/m3 in one slug/ft3
_ANGLE_STEP, _RATE_STEP, _THROTTLE_STEP = 0.005, 0.01, 0.01  # of the central differences: rad, rad/s, 1
# Operating points at which a propeller's tables are measured: fractions of the reference airspeed, throttles.
_STAND_SPEEDS, _STAND_THROTTLES = (0.6, 0.8, 1.0, 1.2), np.linspace(0.3, 1.0, 36)
_STAND_THRUST_MIN_N = -2.2  # points with less thrust (strong windmilling) are left out of the tables
_ROW_ORDER = [3, 4, 5, 0, 1, 2]  # accelerations come as u v w p q r; the model's rows are p q r u v w


def identify(aircraft: Aircraft) -> DesignModel:
    """Identify f_m and B_m of equation (2) at the aircraft's reference condition; raises NoTrim if there is no
    level flight at it."""
    plant = Plant(aircraft, _PHYSICS_HZ)
    level = trim(plant, aircraft.reference.airspeed_m_s, aircraft.reference.altitude_m)
    kinds = tuple(a.kind for a in aircraft.actuators.values())
    positions = [math.radians(p) if k == "servo" else p for p, k in zip(level.positions, kinds, strict=True)]
    density = plant["atmosphere/rho-slugs_ft3"] * _SLUG_FT3
    n = len(kinds)
    inputs, torques = np.zeros((6, n)), np.zeros((6, n))
    for i, kind in enumerate(kinds):
        inputs[:, i] = _input_column(plant, level, i, kind)
        if kind == "motor":
            torques[:, i] = _torque_column(plant, level, i)
    slopes = np.column_stack([_state_column(plant, level, name) for name in COLUMNS])
    at_trim = _rates(plant, level.state, level.commands)
    propulsors = tuple(_propulsor(plant, level, i) for i in range(n))
    offsets = _torque_offsets(inputs, torques, propulsors, positions, level, density)
    bias = at_trim - kinematics(_with_rates(level.state)) - inputs @ positions - offsets.sum(axis=1)
    return DesignModel(
        airspeed_m_s=aircraft.reference.airspeed_m_s,
        altitude_m=aircraft.reference.altitude_m,
        alpha_rad=level.state["alpha"],
        density_kg_m3=density,
        actuators=tuple(aircraft.actuators),
        kinds=kinds,
        trim=tuple(positions),
        bias=tuple(map(float, bias)),
        derivatives=tuple(tuple(map(float, row)) for row in slopes),
        input_matrix=tuple(tuple(map(float, row)) for row in inputs),
        torque_matrix=tuple(tuple(map(float, row)) for row in torques),
        offset_matrix=tuple(tuple(map(float, row)) for row in offsets),
        propulsors=propulsors,
        identified_from=aircraft.fingerprint(),
    )


_models: Cache[DesignModel] = Cache(8)


def stored(aircraft: Aircraft) -> DesignModel:
    """The design model stored beside the aircraft; identified again if there is none, or if the aircraft's files have changed.

    Raises:
        BadInput: there is a file, but it is not a design model.
        NoTrim: a model has to be identified, and no level flight was found at the aircraft's reference.
    """
    file = aircraft.folder / DESIGN_MODEL
    text = file.read_bytes() if file.is_file() else None
    fingerprint = aircraft.fingerprint()

    def read_or_identify() -> DesignModel:
        if text is not None:
            model = load_design_model(file)
            if model.identified_from == fingerprint and model.actuators == tuple(aircraft.actuators):
                return model
        return identify(aircraft)

    return _models.get((fingerprint, text), read_or_identify)


def _rates(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], settle_s: float = 1.5
) -> np.ndarray:
    """[6] accelerations by `design_model.ROWS` [rad/s2, m/s2], with the airframe held in a state for `settle_s` [s]."""
    return accelerations(plant, state, commands, settle_s)[_ROW_ORDER]


def _with_rates(state: Mapping[str, float]) -> dict[str, float]:
    return {"p": 0.0, "q": 0.0, "r": 0.0, **state}


def _changed(commands: Sequence[float], i: int, by: float) -> list[float]:
    """The commands, with that of actuator i changed by this much [rad or throttle]."""
    return [c + by if j == i else c for j, c in enumerate(commands)]


def _input_column(plant: Plant, level: Trim, i: int, kind: str) -> np.ndarray:
    """[6] rates per rad of servo or per N of thrust: central difference of two steady states."""
    step = _ANGLE_STEP if kind == "servo" else _THROTTLE_STEP
    rates, positions = [], []
    for sign in (1.0, -1.0):
        rates.append(_rates(plant, level.state, _changed(level.commands, i, sign * step)))
        positions.append(plant.position(i))
    return (rates[0] - rates[1]) / (positions[0] - positions[1])


def _torque_column(plant: Plant, level: Trim, i: int) -> np.ndarray:
    """[6] rates per N m of motor torque: the effect of a throttle step after one physics step, before the rotor's speed changes."""
    motor = list(plant.aircraft.actuators.values())[i]
    assert motor.kind == "motor"
    name = f"propulsion/engine[{motor.engine}]/propeller-torque-ftlb"
    steady = _rates(plant, level.state, level.commands)
    before = abs(plant[name])
    stepped = _rates(plant, level.state, _changed(level.commands, i, _THROTTLE_STEP), settle_s=plant.dt_s)
    return (stepped - steady) / ((abs(plant[name]) - before) * NEWTON_METRES_PER_FOOT_POUND)


def _torque_offsets(
    inputs: np.ndarray,
    torques: np.ndarray,
    propulsors: Sequence[Propulsor | None],
    positions: Sequence[float],
    level: Trim,
    density: float,
) -> np.ndarray:
    """[6, n] rates by the part of each propeller's torque that does not vary with thrust: Q_0 of Q = Q_0 + k T, at the trim."""
    offsets = np.zeros_like(torques)
    axial = level.state["airspeed"] * math.cos(level.state["alpha"])
    for i, propulsor in enumerate(propulsors):
        if propulsor is None:
            continue
        torque, slope = propulsor.torque_at(positions[i], axial, density)
        offsets[:, i] = torques[:, i] * (torque - slope * positions[i])
    return offsets


def _state_column(plant: Plant, level: Trim, name: str) -> np.ndarray:
    """[6] aerodynamic rates per rad or per rad/s of a state; the terms of gravity and of rotating axes are subtracted."""
    step = _ANGLE_STEP if name in ("alpha", "beta") else _RATE_STEP
    rates = []
    for sign in (1.0, -1.0):
        state = _with_rates(dict(level.state))
        state[name] = state.get(name, 0.0) + sign * step
        rates.append(_rates(plant, state, level.commands) - kinematics(state))
    return (rates[0] - rates[1]) / (2.0 * step)


def _propulsor(plant: Plant, level: Trim, i: int) -> Propulsor | None:
    """Thrust and torque coefficients over the advance ratio, measured with the airframe held, and the motor; None for a servo."""
    actuator = list(plant.aircraft.actuators.values())[i]
    if actuator.kind == "servo":
        return None
    engine, motor = f"propulsion/engine[{actuator.engine}]", actuator.motor
    density = plant["atmosphere/rho-slugs_ft3"] * _SLUG_FT3
    sense = plant[f"{engine}/propeller-sense"]  # the airframe feels the opposite torque
    rows = []
    for speed in _STAND_SPEEDS:
        state = {**level.state, "airspeed": speed * level.state["airspeed"]}
        for throttle in _STAND_THROTTLES:
            accelerations(plant, state, _changed(level.commands, i, throttle - level.commands[i]))
            n = plant[f"{engine}/propeller-rpm"] / 60.0
            thrust = plant[f"{engine}/thrust-lbs"] * NEWTONS_PER_POUND
            torque = -sense * plant[f"{engine}/propeller-torque-ftlb"] * NEWTON_METRES_PER_FOOT_POUND
            axial = plant["velocities/u-aero-fps"] * METRES_PER_FOOT
            d, pressure = motor.diameter_m, density * n * n * motor.diameter_m**4
            if thrust < _STAND_THRUST_MIN_N:
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
