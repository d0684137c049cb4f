"""Identify the design model (`aircraft.design_model`) before flight: trim, then central differences of accelerations.

The airframe is held in a state while servos and rotors settle, as on a test stand, and its accelerations are read. The
result is stored in `aircraft/<name>/design_model.json`. Of the plant a controller is told this model, the aircraft's YAML and
the trim in which the flight begins (`testbed.controllers.setup`), and nothing else.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from testbed.aircraft.description import Aircraft, MotorActuator
from testbed.aircraft.design_model import (
    COLUMNS,
    DESIGN_MODEL,
    NOT_GYROSCOPIC,
    PRODUCTS,
    DesignModel,
    kinematics,
    load_design_model,
    rows_of,
)
from testbed.aircraft.model_files.check import in_yaml
from testbed.aircraft.propulsors import EngineMap, Propulsor
from testbed.common.cache import Cache
from testbed.common.units import NEWTON_METRES_PER_FOOT_POUND
from testbed.inputs.problems import BadInput, Issue
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import accelerations
from testbed.plant.thrust_stand import air_density, changed, propulsors_of, stand_physics_hz
from testbed.plant.trim import Search, Trim, command_steps, trim

_ANGLE_STEP, _RATE_STEP = 0.005, 0.01  # of the central differences [rad, rad/s]
_COMMAND_STEPS = {"servo": 0.005, "motor": 0.01, "engine": 0.05}  # [rad or throttle]
_STALL_STEP, _ALPHA_MAX = 0.01, 0.6  # of the search for the stall [rad]
_ROW_ORDER = [3, 4, 5, 0, 1, 2]  # accelerations come as u v w p q r; the model's rows are p q r u v w


def identify(aircraft: Aircraft, near: Trim | None = None) -> DesignModel:
    """Identify f_m and B_m of equation (2) at the aircraft's reference condition.

    Args:
        near: a trim at which the search for that flight begins.

    Raises:
        NoTrim: there is no level flight at it.
        BadInput: an actuator's position does not follow its command.
    """
    plant = Plant(aircraft, stand_physics_hz(aircraft))
    at = aircraft.reference
    level = trim(plant, at.airspeed_m_s, at.altitude_m, search=Search(near))
    kinds = tuple(a.kind for a in aircraft.actuators.values())
    positions = [math.radians(p) if k == "servo" else p for p, k in zip(level.positions, kinds, strict=True)]
    density = air_density(plant)
    n = len(kinds)
    inputs, torques = input_matrix(plant, level), np.zeros((6, n))
    for i, kind in enumerate(kinds):
        if kind == "motor":
            torques[:, i] = _torque_column(plant, level, i)
    slopes = np.column_stack([_state_column(plant, level, name) for name in COLUMNS])
    at_trim = _rates(plant, level.state, level.commands)
    propulsors = propulsors_of(plant, level)
    offsets = _torque_offsets(torques, propulsors, positions, level, density)
    for i, kind in enumerate(kinds):
        if kind == "engine":
            offsets[:, i] = _engine_offset(plant, level, i, inputs[:, i] * positions[i])
    bias = at_trim - kinematics(level.state) - inputs @ positions - offsets.sum(axis=1)
    return DesignModel(
        airspeed_m_s=aircraft.reference.airspeed_m_s,
        altitude_m=aircraft.reference.altitude_m,
        alpha_rad=level.state["alpha"],
        density_kg_m3=density,
        actuators=tuple(aircraft.actuators),
        kinds=kinds,
        trim=tuple(positions),
        bias=tuple(map(float, bias)),
        derivatives=rows_of(slopes),
        input_matrix=rows_of(inputs),
        torque_matrix=rows_of(torques),
        offset_matrix=rows_of(offsets),
        propulsors=propulsors,
        identified_from=aircraft.fingerprint(),
        stall_alpha_rad=_stall_angle(plant, level),
        span_m=plant.span_m or None,
        sideslip=_sideslip(plant, level, slopes),
        gyroscopic=_gyroscopic(plant),
    )


_models: Cache[DesignModel] = Cache(8)


def stored(aircraft: Aircraft) -> DesignModel:
    """The design model stored beside the aircraft; identified again if there is none, if the aircraft's files have changed, or
    if it is of a version that did not know of gyroscopic moments, which every aircraft has.

    Raises:
        BadInput: there is a file, but it is not a design model; or a model has to be identified, and cannot be.
    """
    file = aircraft.folder / DESIGN_MODEL
    text = file.read_bytes() if file.is_file() else None
    fingerprint = aircraft.fingerprint()

    def read_or_identify() -> DesignModel:
        if text is not None:
            model = load_design_model(file)
            of_these = model.identified_from == fingerprint and model.actuators == tuple(aircraft.actuators)
            if of_these and model.gyroscopic != NOT_GYROSCOPIC:
                return model
        return identify(aircraft)

    return _models.get((fingerprint, text), read_or_identify)


def _rates(
    plant: Plant, state: Mapping[str, float], commands: Sequence[float], for_s: float | None = None
) -> np.ndarray:
    """[6] accelerations by `design_model.ROWS` [rad/s2, m/s2], with the airframe held in a state (see `settle_at`)."""
    return accelerations(plant, state, commands, for_s)[_ROW_ORDER]


def _stall_angle(plant: Plant, level: Trim) -> float:
    """Angle of attack [rad] at which lift grows with half the slope that it has at the trim, at most `_ALPHA_MAX`.

    The slope is that of w_dot, between steps of `_STALL_STEP`. Beyond this angle the design model is no model of the aircraft.
    """
    alphas = np.arange(level.state["alpha"], _ALPHA_MAX, _STALL_STEP)
    rates = [
        _rates(plant, {**level.state, "alpha": float(alpha)}, level.commands, plant.dt_s)[-1]
        - kinematics({**level.state, "alpha": float(alpha)})[-1]
        for alpha in alphas
    ]
    slopes = np.diff(rates)
    (stalled,) = np.nonzero(slopes / slopes[0] < 0.5)
    return float(alphas[stalled[0]]) if len(stalled) else _ALPHA_MAX


def _sideslip(plant: Plant, level: Trim, slopes: np.ndarray) -> tuple[float, ...]:
    """[6] rates per rad of |beta|, in the rows where that outweighs the slopes by alpha and beta together, else zero.

    Some models have drag or moments that go with |beta|, and so have a kink where the other derivatives are taken. The even part
    of a rate is a |beta| + b beta^2 about zero sideslip; its values at two steps give a. Where a matters less, as where a table
    has a point at zero, the linear model is the better one at larger angles.
    """

    def rates(beta: float) -> np.ndarray:
        state = {**level.state, "beta": level.state["beta"] + beta}
        return _rates(plant, state, level.commands) - kinematics(state)

    middle = rates(0.0)
    near, far = (0.5 * (rates(h) + rates(-h)) - middle for h in (_ANGLE_STEP, 2.0 * _ANGLE_STEP))
    kinks = (4.0 * near - far) / (2.0 * _ANGLE_STEP)
    linear = np.hypot(slopes[:, COLUMNS.index("alpha")], slopes[:, COLUMNS.index("beta")])
    return tuple(map(float, np.where(np.abs(kinks) > linear, kinks, 0.0)))


def _gyroscopic(plant: Plant) -> tuple[tuple[float, ...], ...]:
    """[3, 6] p_dot, q_dot and r_dot by products of rates of rotation, by `PRODUCTS`: Euler's -J^-1 (w x J w).

    The moments of inertia J are known before flight. Second differences of the truth would have the kinks of propellers too.
    """
    xx, yy, zz, xy, xz, yz = (
        plant[f"inertia/i{axes}-slugs_ft2"] for axes in ("xx", "yy", "zz", "xy", "xz", "yz")
    )
    inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])  # JSBSim's products are the elements of J

    def moments(*about: int) -> np.ndarray:
        rates = np.eye(3)[list(about)].sum(axis=0)
        return -np.linalg.solve(inertia, np.cross(rates, inertia @ rates))

    axes = [("pqr".index(one), "pqr".index(other)) for one, other in PRODUCTS]
    columns = [moments(i) if i == j else moments(i, j) - moments(i) - moments(j) for i, j in axes]
    return rows_of(np.column_stack(columns) + 0.0)  # no -0


def input_matrix(plant: Plant, level: Trim) -> np.ndarray:
    """[6, n] B of the truth about a flight condition: rates by `design_model.ROWS`, per rad of servo and per N of thrust."""
    return np.column_stack([_input_column(plant, level, i) for i in range(len(level.commands))])


def _input_column(plant: Plant, level: Trim, i: int) -> np.ndarray:
    """[6] rates per rad of servo or per N of thrust: difference of two steady states."""
    rates, positions = [], []
    actuator = list(plant.aircraft.actuators.values())[i]
    for step in command_steps(actuator, level.commands[i], _COMMAND_STEPS[actuator.kind]):
        rates.append(_rates(plant, level.state, changed(level.commands, i, step)))
        positions.append(plant.position(i))
    if positions[0] == positions[1]:
        what = "its position in the model does not follow its command"
        path = ("actuators", list(plant.aircraft.actuators)[i])
        raise BadInput(in_yaml(plant.aircraft, [Issue(path, what)]))
    return (rates[0] - rates[1]) / (positions[0] - positions[1])


def _torque_column(plant: Plant, level: Trim, i: int) -> np.ndarray:
    """[6] rates per N m of motor torque: the effect of a throttle step after one physics step, before the rotor's speed changes."""
    motor = list(plant.aircraft.actuators.values())[i]
    assert isinstance(motor, MotorActuator)
    name = f"propulsion/engine[{motor.engine}]/propeller-torque-ftlb"
    steady = _rates(plant, level.state, level.commands)
    before = abs(plant[name])
    stepped = _rates(
        plant, level.state, changed(level.commands, i, _COMMAND_STEPS[motor.kind]), for_s=plant.dt_s
    )
    return (stepped - steady) / ((abs(plant[name]) - before) * NEWTON_METRES_PER_FOOT_POUND)


def _torque_offsets(
    torques: np.ndarray,
    propulsors: Sequence[Propulsor | EngineMap | None],
    positions: Sequence[float],
    level: Trim,
    density: float,
) -> np.ndarray:
    """[6, n] rates by the part of each propeller's torque that does not vary with thrust: Q_0 of Q = Q_0 + k T, at the trim."""
    offsets = np.zeros_like(torques)
    axial = level.state["airspeed"] * math.cos(level.state["alpha"])
    for i, propulsor in enumerate(propulsors):
        if not isinstance(propulsor, Propulsor):
            continue
        torque, slope = propulsor.torque_at(positions[i], axial, density)
        offsets[:, i] = torques[:, i] * (torque - slope * positions[i])
    return offsets


def _engine_offset(plant: Plant, level: Trim, i: int, linear: np.ndarray) -> np.ndarray:
    """[6] rates that an engine adds to B u at the trim, `linear`: what is lost with all of its effectiveness, less that."""
    effectiveness = f"{list(plant.aircraft.actuators.values())[i].prefix}/effectiveness"
    healthy = _rates(plant, level.state, level.commands)
    plant[effectiveness] = 0.0
    lost = _rates(plant, level.state, level.commands)
    plant[effectiveness] = 1.0
    return np.asarray(healthy - lost - linear)


def _state_column(plant: Plant, level: Trim, name: str) -> np.ndarray:
    """[6] aerodynamic rates per rad or per rad/s of a state; the terms of gravity and of rotating axes are subtracted."""
    step = _ANGLE_STEP if name in ("alpha", "beta") else _RATE_STEP
    rates = []
    for sign in (1.0, -1.0):
        state = dict(level.state)
        state[name] = state.get(name, 0.0) + sign * step
        rates.append(_rates(plant, state, level.commands) - kinematics(state))
    return (rates[0] - rates[1]) / (2.0 * step)
