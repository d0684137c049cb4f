"""Linear models of the truth about a steady flight: A, B, C, D by central differences in JSBSim itself; for analysis."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from testbed.aircraft.changes import ChangedAircraft, load_with_changes
from testbed.aircraft.description import Aircraft, Servo
from testbed.aircraft.propulsors import EngineMap
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.plant.identification import stored
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import accelerations
from testbed.plant.thrust_stand import stand_physics_hz
from testbed.plant.trim import Trim, command_steps, trim

STATES = {
    "airspeed": "m/s", "alpha": "rad", "beta": "rad", "p": "rad/s", "q": "rad/s", "r": "rad/s",
    "roll": "rad", "pitch": "rad", "heading": "rad", "altitude": "m",
}  # fmt: skip
"""States of the airframe and their units, in the order of A."""
RATES = {"p_dot": "rad/s^2", "q_dot": "rad/s^2", "r_dot": "rad/s^2", "u_dot": "m/s^2", "climb_rate": "m/s"}
"""What a controller is given besides the states, which is further outputs."""
_STEPS = {"airspeed": 0.05, "alpha": 1e-3, "beta": 1e-3, "altitude": 5.0}
_STEP = 1e-3  # of the others [rad, rad/s]
_COMMAND_STEPS = {"servo": 2e-3, "motor": 5e-3, "engine": 0.02}  # [rad or throttle]


@dataclass(frozen=True, eq=False)
class LinearModel:
    """x' = A x + B u, y = C x + D u, all as differences from the steady flight.

    Attributes:
        A, B, C, D: [states, states], [states, actuators], [outputs, states], [outputs, actuators].
        states: name and unit of each state: those of the airframe, then each actuator NAME_position as the command that it has
            followed so far [rad or throttle].
        inputs: name and unit of each actuator's command [rad or throttle].
        outputs: name and unit of each output: the states of the airframe, then RATES.
        trim: value of each state of the airframe and of each input in the steady flight.
        lags: corner of the first-order lag of each actuator [rad/s].
    """

    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray
    states: Mapping[str, str]
    inputs: Mapping[str, str]
    outputs: Mapping[str, str]
    trim: Mapping[str, float]
    lags: Mapping[str, float]

    def state_space(self) -> Any:
        """The same as python-control's StateSpace, with the names; needs `pip install 'testbed[linear]'`, else raises BadInput."""
        names = {"states": list(self.states), "inputs": list(self.inputs), "outputs": list(self.outputs)}
        return python_control().ss(self.A, self.B, self.C, self.D, **names)


def python_control() -> Any:
    """The package; raises BadInput where it is not installed."""
    try:
        import control
    except ImportError:
        what = "is not installed"
        raise BadInput([Problem(what, "python-control", expected="pip install 'testbed[linear]'")]) from None
    return control


def linearise(
    aircraft: str | ChangedAircraft | Aircraft, condition: Mapping[str, float] | None = None
) -> LinearModel:
    """The linear model of an aircraft's truth about a trimmed flight.

    Slopes are those of the flight dynamics with the propulsion steady at its throttle. An actuator follows its command by a
    first-order lag, without the rate limit and the stops. The controller's design model is another model, which holds thrusts:
    `Setup.model`.

    Args:
        aircraft: name or folder of an aircraft, or one with changes to its truth.
        condition: airspeed_m_s and altitude_m; what is not given is the aircraft's reference.

    Raises:
        BadInput: there is no such aircraft or condition, or (NoTrim) no steady flight at it.
    """
    loaded = aircraft if isinstance(aircraft, Aircraft) else load_with_changes(aircraft)
    known = loaded.reference.model_dump(include={"airspeed_m_s", "altitude_m"})
    for name in condition or {}:
        if name not in known:
            raise BadInput([Problem(f"unknown key {name!r}", "condition", None, "", *guess(name, known))])
    at = {**known, **(condition or {})}
    plant = Plant(loaded, stand_physics_hz(loaded))
    level = trim(plant, at["airspeed_m_s"], at["altitude_m"])
    return _model(plant, level)


def _model(plant: Plant, level: Trim) -> LinearModel:
    aircraft, nx = plant.aircraft, len(STATES)
    about, commands = np.array([level.state.get(name, 0.0) for name in STATES]), np.array(level.commands)
    sizes = [_STEPS.get(name, _STEP) for name in STATES]
    slopes = _slopes(lambda x: _motion(plant, x, commands), about, [(s, -s) for s in sizes])
    of_each = zip(aircraft.actuators.values(), commands, strict=True)
    steps = [command_steps(actuator, at, _COMMAND_STEPS[actuator.kind]) for actuator, at in of_each]
    effects = _slopes(lambda u: _motion(plant, about, u), commands, steps)
    lags = _lags(aircraft)
    n = len(lags)
    corner = np.diag(list(lags.values()))
    units = {name: "rad" if isinstance(a, Servo) else "throttle" for name, a in aircraft.actuators.items()}
    return LinearModel(
        A=np.block([[slopes[:nx], effects[:nx]], [np.zeros((n, nx)), -corner]]),
        B=np.vstack([np.zeros((nx, n)), corner]),
        C=np.block([[np.eye(nx), np.zeros((nx, n))], [slopes[nx:], effects[nx:]]]),
        D=np.zeros((nx + len(RATES), n)),
        states={**STATES, **{f"{name}_position": unit for name, unit in units.items()}},
        inputs=units,
        outputs={**STATES, **RATES},
        trim=dict(zip([*STATES, *units], map(float, [*about, *commands]), strict=True)),
        lags=lags,
    )


def _slopes(function: Any, about: np.ndarray, steps: Sequence[tuple[float, float]]) -> np.ndarray:
    """[m, len(about)] slopes of a function with m values, each between two steps of its argument."""
    columns = []
    for i, pair in enumerate(steps):
        high, low = (function(about + step * np.eye(len(about))[i]) for step in pair)
        columns.append((high - low) / (pair[0] - pair[1]))
    return np.column_stack(columns)


def _motion(plant: Plant, x: np.ndarray, commands: np.ndarray) -> np.ndarray:
    """[10 + 5] rates of STATES, then RATES, with the airframe held in a state and the actuators steady
    (Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., table 2.5-1)."""
    v, alpha, beta, p, q, r, roll, pitch, _, _ = x
    state = dict(zip(STATES, map(float, x), strict=True))
    u_dot, v_dot, w_dot, p_dot, q_dot, r_dot = accelerations(plant, state, tuple(map(float, commands)))
    ca, sa, cb, sb = math.cos(alpha), math.sin(alpha), math.cos(beta), math.sin(beta)
    airspeed_dot = ca * cb * u_dot + sb * v_dot + sa * cb * w_dot
    alpha_dot = (ca * w_dot - sa * u_dot) / (v * cb)
    beta_dot = (-ca * sb * u_dot + cb * v_dot - sa * sb * w_dot) / v
    cr, sr, cp, sp = math.cos(roll), math.sin(roll), math.cos(pitch), math.sin(pitch)
    turn = (q * sr + r * cr) / cp
    climb = v * (ca * cb * sp - (sb * sr + sa * cb * cr) * cp)
    kinematics, rates = (p + sp * turn, q * cr - r * sr, turn, climb), (p_dot, q_dot, r_dot)
    return np.array([airspeed_dot, alpha_dot, beta_dot, *rates, *kinematics, *rates, u_dot, climb])


def _lags(aircraft: Aircraft) -> dict[str, float]:
    """Corner of the first-order lag of each actuator [rad/s]; that of an engine is identified."""
    known = zip(aircraft.actuators.items(), stored(aircraft.nominal).propulsors, strict=True)
    return {
        name: float((p.small_lag_rad_s if isinstance(p, EngineMap) else a.lag_rad_s) or 0.0)
        for (name, a), p in known
    }
