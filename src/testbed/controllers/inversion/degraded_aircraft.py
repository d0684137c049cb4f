"""The aircraft after failures: the design model with the actuators that remain, and its motion."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from testbed.aircraft.design_model import COLUMNS, ROWS, DesignModel
from testbed.controllers.inversion.modes import Mode
from testbed.controllers.records import AIRSPEED, ALPHA, BETA, PITCH, REGULATOR_STATE, ROLL
from testbed.controllers.setup import Setup

_THRUST_AIRSPEEDS = np.linspace(0.3, 2.1, 73)
"""Airspeeds of the thrust table of a jammed motor, in units of the reference airspeed: more than are searched for a trim."""
_X, _Z, _ALPHA = ROWS.index("u_dot"), ROWS.index("w_dot"), COLUMNS.index("alpha")


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
        pitch_controlled: whether the mode keeps q_dot, so that no sideslip is needed to balance pitch.
    """

    model: DesignModel
    scale: np.ndarray
    limits: np.ndarray
    available: np.ndarray
    effective: np.ndarray
    positions: np.ndarray
    thrusts: Mapping[int, np.ndarray] = field(default_factory=dict)
    pitch_controlled: bool = True

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
        kept = "q_dot" not in mode.released
        return cls(model, scale, setup.limits, available, effective, positions, thrusts, kept)

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
        """[m, n] least and largest scaled position at each of m airspeeds [m/s], whatever the stops: of motors and engines the
        thrust of a windmilling propeller and that at full throttle; of servos infinite."""
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

    def rates(self, x: np.ndarray, a: np.ndarray) -> np.ndarray:
        """[..., 6] rates of `design_model.ROWS` at the state x [..., 10], with actuators at scaled positions a [..., n]."""
        return _rates(self.model, x, a * self.scale, self.effective, self.curvature)

    @cached_property
    def curvature(self) -> float:
        """`forward_curvature` [m/s2 per rad^2] where drag decides, without a motor that could make up for it; else 0."""
        powered = bool(np.any((self.available > 0.0) & ~self.servos))
        return 0.0 if powered else forward_curvature(self.model)


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
    return np.stack([*rates, climb_rate(x)], axis=-1)


def climb_rate(x: np.ndarray) -> np.ndarray:
    """[...] climb rate [m/s] in still air."""
    roll, pitch = x[..., ROLL], x[..., PITCH]
    u, v, w = _velocity(x[..., AIRSPEED], x[..., ALPHA], x[..., BETA])
    climb: np.ndarray = u * np.sin(pitch) - (v * np.sin(roll) + w * np.cos(roll)) * np.cos(pitch)
    return climb


def _velocity(speed: np.ndarray, alpha: np.ndarray, beta: np.ndarray) -> tuple[np.ndarray, ...]:
    """u, v, w [m/s]."""
    return speed * np.cos(alpha) * np.cos(beta), speed * np.sin(beta), speed * np.sin(alpha) * np.cos(beta)


def _rates(
    model: DesignModel, x: np.ndarray, a: np.ndarray, effectiveness: np.ndarray, curvature: float
) -> np.ndarray:
    columns = np.moveaxis(x, -1, 0)
    rates = model.rates(dict(zip(REGULATOR_STATE[:8], columns, strict=False)), a, effectiveness)
    pressure_ratio = np.square(x[..., AIRSPEED] / model.airspeed_m_s)
    # Only beyond the trim, where a glide is. At smaller angles the tangent is kept: it has more drag, which is the safe side.
    beyond = np.maximum(x[..., ALPHA] - model.alpha_rad, 0.0)
    rates[..., _X] += curvature * pressure_ratio * np.square(beyond)
    return rates


def forward_curvature(model: DesignModel) -> float:
    """Half the second derivative of u_dot by alpha at the reference trim [m/s2 per rad^2], without thrust.

    `DesignModel.rates` leaves it out; f_m of the law has it (`law.beyond_tangent`). Along the body's x axis,
    X = L sin(alpha) - D cos(alpha). Both lift L and the sine grow with the angle, so X is about a parabola of it. Its tangent at
    the trim gives an aircraft that glides slower far too much drag.

    Lift is taken as linear in alpha, and drag as a parabola of lift, D = D_0 + k L^2 (Etkin and Reid, Dynamics of Flight,
    sec. 2.1). Then D'' = D' L' / L, where ' is the derivative by alpha, and

        X'' = 2 L' cos(alpha) - L sin(alpha) - D'' cos(alpha) + 2 D' sin(alpha) + D cos(alpha).

    L, D, L' and D' at the trim, all per mass, follow from the model's X and Z. A model whose lift does not grow has no such polar:
    0.
    """
    servos = np.array([kind == "servo" for kind in model.kinds])
    surfaces = np.array(model.input_matrix)[:, servos] @ np.array(model.trim)[servos]
    force, slope = np.array(model.bias) + surfaces, np.array(model.derivatives)[:, _ALPHA]
    x, z, x_alpha, z_alpha = force[_X], force[_Z], slope[_X], slope[_Z]
    sin, cos = math.sin(model.alpha_rad), math.cos(model.alpha_rad)
    lift, drag = x * sin - z * cos, -x * cos - z * sin
    lift_slope = (x_alpha + z) * sin + (x - z_alpha) * cos
    drag_slope = (x - z_alpha) * sin - (x_alpha + z) * cos
    if min(lift, lift_slope) <= 0.0:
        return 0.0
    drag_curvature = max(drag_slope, 0.0) * lift_slope / lift
    leaning = 2.0 * lift_slope * cos - lift * sin
    return float(0.5 * (leaning - drag_curvature * cos + 2.0 * drag_slope * sin + drag * cos))
