"""Steady straight flights of the design model, many at once: the states and positions at which nothing accelerates.

A flight is steady when the six rates are zero and the climb rate is that of its path angle: seven equations. The unknowns are
alpha, beta, roll and pitch, the positions of the actuators that remain, and, where these are too few, the airspeed. Where
there are more unknowns than equations, the Gauss-Newton steps are those of least norm, in units of `_ANGLE`, `_SPEED` and one
scaled position. So redundant actuators share the work, and an aircraft that is its own mirror image flies symmetrically.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from testbed.aircraft.design_model import ROWS, DesignModel
from testbed.controllers.inversion.forward_force import forward_curvature
from testbed.controllers.inversion.modes import Mode
from testbed.controllers.records import AIRSPEED, ALPHA, BETA, PITCH, REGULATOR_STATE, ROLL
from testbed.controllers.setup import Setup

_ANGLE, _SPEED = 0.2, 3.0  # rad and m/s that count as one scaled position
_ITERATIONS = 12
_LARGEST_STEP = 1.0  # of an unknown in one iteration, in its unit
_DIFFERENCE = 1e-6  # of the central differences, in each unknown's unit
_RESIDUAL_MAX = 1e-7  # largest rate that may remain [rad/s2, m/s2, m/s]
_DAMPING = 1e-10  # of the Gauss-Newton steps, so that too few actuators are no error
_THRUST_AIRSPEEDS = np.linspace(0.3, 2.1, 73)
"""Airspeeds of the thrust table of a jammed motor, in units of the reference airspeed: more than are searched for a trim."""


@dataclass(frozen=True)
class DegradedAircraft:
    """The aircraft after failures: its design model, and the actuators that remain.

    Attributes:
        scale: [n] rad or N of one scaled unit.
        limits: [n, 2] scaled stops.
        available: [n] 1 for actuators that are used.
        effective: [n] effectiveness: 1 for available and for jammed actuators, 0 for the others.
        positions: [n] scaled positions: where a jammed actuator is jammed, a motor or engine at the reference airspeed; for the
            others that of the reference trim, which is the first guess for those that are available.
        thrusts: [73] scaled thrust of each jammed motor or engine by `_THRUST_AIRSPEEDS`, by its index. Its throttle stays, and so
            its thrust falls with airspeed.
    """

    model: DesignModel
    scale: np.ndarray
    limits: np.ndarray
    available: np.ndarray
    effective: np.ndarray
    positions: np.ndarray
    thrusts: Mapping[int, np.ndarray] = field(default_factory=dict)

    @classmethod
    def after(cls, setup: Setup, mode: Mode, jammed: Mapping[int, float]) -> DegradedAircraft:
        """The aircraft in a mode, with the scaled positions of jammed actuators."""
        model, scale, at = setup.model, setup.scale, setup.model.airspeed_m_s
        available = np.array([float(name not in mode.failed) for name in model.actuators])
        effective, positions = available.copy(), np.array(model.trim) / scale
        for i, position in jammed.items():
            effective[i], positions[i] = 1.0, position
        thrusts = {
            i: propulsor.at_same_throttle(
                position * scale[i], at, at * _THRUST_AIRSPEEDS, model.density_kg_m3
            )
            / scale[i]
            for i, position in jammed.items()
            if (propulsor := model.propulsors[i]) is not None
        }
        return cls(model, scale, setup.limits, available, effective, positions, thrusts)

    @property
    def used(self) -> np.ndarray:
        """Indices of the available actuators."""
        return np.flatnonzero(self.available)

    @property
    def unused(self) -> list[int]:
        """Indices of the actuators that are not available."""
        return np.flatnonzero(self.available == 0.0).tolist()

    @property
    def servos(self) -> np.ndarray:
        """[n] which actuators move a surface."""
        return np.array([kind == "servo" for kind in self.model.kinds])

    @property
    def jammed(self) -> bool:
        """Whether an actuator that is not available has a force."""
        return bool(np.any(self.effective > self.available))

    def bounds(self, airspeeds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """[m, n] least and largest scaled position at each of m airspeeds [m/s], whatever the stops: of motors and engines the thrust
        of a windmilling propeller and that at full throttle; of servos infinite."""
        least = np.full((len(airspeeds), len(self.scale)), -np.inf)
        most, density = -least, self.model.density_kg_m3
        for i, propulsor in enumerate(self.model.propulsors):
            if propulsor is not None:
                least[:, i] = propulsor.least_thrust(airspeeds, density) / self.scale[i]
                most[:, i] = propulsor.most_thrust(airspeeds, density) / self.scale[i]
        return least, most

    def with_thrust(self, x: np.ndarray, a: np.ndarray) -> np.ndarray:
        """Scaled positions a [..., n] with those of jammed motors and engines at the airspeed of the state x [..., 10]."""
        positions = np.array(a)
        for i, thrust in self.thrusts.items():
            positions[..., i] = np.interp(
                x[..., AIRSPEED], self.model.airspeed_m_s * _THRUST_AIRSPEEDS, thrust
            )
        return positions

    def motion(self, x: np.ndarray, a: np.ndarray) -> np.ndarray:
        """[..., 10] derivatives of the state x [..., 10] with actuators at scaled positions a [..., n]."""
        return motion(self.model, x, self.with_thrust(x, a) * self.scale, self.effective, self.curvature)

    @cached_property
    def curvature(self) -> float:
        """`forward_curvature` [m/s2 per rad^2] where drag decides, without a motor that could make up for it; else 0."""
        powered = bool(np.any((self.available > 0.0) & ~self.servos))
        return 0.0 if powered else forward_curvature(self.model)


class SteadyFlight(NamedTuple):
    """A steady flight, or m of them: state [10] or [m, 10] by `records.REGULATOR_STATE`, and scaled positions [n] or [m, n]."""

    state: np.ndarray
    positions: np.ndarray

    def only(self, which: np.ndarray | int | None) -> SteadyFlight:
        """Those flights, or that flight, of m; with None (a new axis), one flight as one of m = 1."""
        return SteadyFlight(self.state[which], self.positions[which])


def at_path_angles(
    degraded: DegradedAircraft, airspeeds: np.ndarray, path_angles: np.ndarray
) -> SteadyFlight:
    """The steady flights at [m] airspeeds [m/s] and path angles [rad]; those without a solution are omitted."""
    climbs = airspeeds * np.sin(path_angles)
    return _solved(degraded, airspeeds, lambda climb: climb - climbs, with_airspeed=False)


def level(degraded: DegradedAircraft, airspeeds: np.ndarray) -> SteadyFlight:
    """The level flights with the airspeed as an unknown; `airspeeds` [m] are its first guesses [m/s]."""
    return _solved(degraded, airspeeds, lambda climb: climb, with_airspeed=True)


def at_airspeeds(degraded: DegradedAircraft, airspeeds: np.ndarray) -> SteadyFlight:
    """The steady flights at [m] airspeeds [m/s], at path angles that are unknown."""
    return _solved(degraded, airspeeds, None, with_airspeed=False)


def _solved(
    degraded: DegradedAircraft,
    airspeeds: np.ndarray,
    climb_error: Callable[[np.ndarray], np.ndarray] | None,
    with_airspeed: bool,
) -> SteadyFlight:
    m, used = len(airspeeds), degraded.used
    states = [ALPHA, BETA, ROLL, PITCH, *([AIRSPEED] if with_airspeed else [])]
    sizes = np.array([_SPEED if i == AIRSPEED else _ANGLE for i in states] + [1.0] * len(used))
    state = np.zeros((m, len(REGULATOR_STATE)))
    state[:, AIRSPEED], state[:, ALPHA], state[:, PITCH] = (
        airspeeds,
        degraded.model.alpha_rad,
        degraded.model.alpha_rad,
    )
    positions = np.tile(degraded.positions, (m, 1))

    def flights(z: np.ndarray) -> SteadyFlight:
        x, a = state.copy(), positions.copy()
        x[:, states] += z[:, : len(states)] * sizes[: len(states)]
        a[:, used] += z[:, len(states) :]
        return SteadyFlight(x, degraded.with_thrust(x, a))

    def residuals(z: np.ndarray) -> np.ndarray:
        x, a = flights(z)
        rates = _rates(degraded.model, x, a * degraded.scale, degraded.effective, degraded.curvature)
        if climb_error is None:
            return rates
        return np.column_stack([rates, climb_error(_climb_rate(x))])

    z = gauss_newton(residuals, np.zeros((m, len(sizes))))
    return flights(z).only(np.abs(residuals(z)).max(axis=1) < _RESIDUAL_MAX)


def gauss_newton(residuals: Callable[[np.ndarray], np.ndarray], z: np.ndarray) -> np.ndarray:
    """[m, k] zeros of m independent problems: `residuals` maps [m, k] to [m, e]; from first guesses z, by steps of least norm."""
    for _ in range(_ITERATIONS):
        r, columns = residuals(z), []
        if np.abs(r).max() < 0.01 * _RESIDUAL_MAX:
            break
        for i in range(z.shape[1]):
            step = np.zeros(z.shape[1])
            step[i] = _DIFFERENCE
            columns.append((residuals(z + step) - residuals(z - step)) / (2.0 * _DIFFERENCE))
        J = np.stack(columns, axis=-1)
        JT = J.transpose(0, 2, 1)
        gram = J @ JT + _DAMPING * np.eye(r.shape[1])
        step = (JT @ np.linalg.solve(gram, r[..., None]))[..., 0]
        largest = np.abs(step).max(axis=1, keepdims=True)
        z = z - step * np.minimum(1.0, _LARGEST_STEP / np.maximum(largest, 1e-12))
    return z


def motion(
    model: DesignModel, x: np.ndarray, a: np.ndarray, effectiveness: np.ndarray, curvature: float = 0.0
) -> np.ndarray:
    """[..., 10] time derivatives of the state on the design model (flat earth, body axes).

    Args:
        x: [..., 10] state by `records.REGULATOR_STATE`.
        a: [..., n] actuator positions [rad, N].
        effectiveness: [n] of each actuator, 1 healthy, 0 lost.
        curvature: half the second derivative of u_dot by alpha at the reference airspeed [m/s2 per rad^2].
    """
    speed, alpha, beta, p, q, r, roll, pitch, _, _ = np.moveaxis(x, -1, 0)
    p_dot, q_dot, r_dot, u_dot, v_dot, w_dot = np.moveaxis(
        _rates(model, x, a, effectiveness, curvature), -1, 0
    )
    u, v, w = _velocity(speed, alpha, beta)
    speed_dot = (u * u_dot + v * v_dot + w * w_dot) / speed
    alpha_dot = (u * w_dot - w * u_dot) / (u * u + w * w)
    beta_dot = (v_dot - np.sin(beta) * speed_dot) / (speed * np.cos(beta))
    turn = q * np.sin(roll) + r * np.cos(roll)
    roll_dot, pitch_dot = p + np.tan(pitch) * turn, q * np.cos(roll) - r * np.sin(roll)
    heading_dot = turn / np.cos(pitch)
    rates = (speed_dot, alpha_dot, beta_dot, p_dot, q_dot, r_dot, roll_dot, pitch_dot, heading_dot)
    return np.stack([*rates, _climb_rate(x)], axis=-1)


def path_angles(flights: SteadyFlight) -> np.ndarray:
    """[m] path angle of each of m flights [rad]."""
    angles: np.ndarray = np.arcsin(_climb_rate(flights.state) / flights.state[:, AIRSPEED])
    return angles


def _velocity(speed: np.ndarray, alpha: np.ndarray, beta: np.ndarray) -> tuple[np.ndarray, ...]:
    """u, v, w [m/s]."""
    return speed * np.cos(alpha) * np.cos(beta), speed * np.sin(beta), speed * np.sin(alpha) * np.cos(beta)


def _climb_rate(x: np.ndarray) -> np.ndarray:
    """[...] climb rate [m/s] in still air."""
    roll, pitch = x[..., ROLL], x[..., PITCH]
    u, v, w = _velocity(x[..., AIRSPEED], x[..., ALPHA], x[..., BETA])
    climb: np.ndarray = u * np.sin(pitch) - (v * np.sin(roll) + w * np.cos(roll)) * np.cos(pitch)
    return climb


def _rates(
    model: DesignModel, x: np.ndarray, a: np.ndarray, effectiveness: np.ndarray, curvature: float
) -> np.ndarray:
    columns = np.moveaxis(x, -1, 0)
    rates = model.rates(dict(zip(REGULATOR_STATE[:8], columns, strict=False)), a, effectiveness)
    pressure_ratio = np.square(x[..., AIRSPEED] / model.airspeed_m_s)
    # Only beyond the trim: at smaller angles the tangent has more drag than the parabola, which is the safe side.
    beyond = np.maximum(x[..., ALPHA] - model.alpha_rad, 0.0)
    rates[..., ROWS.index("u_dot")] += curvature * pressure_ratio * np.square(beyond)
    return rates
