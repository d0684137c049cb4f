"""The closed loop of the paper's controller about level flight, linear: is it stable with a wrong input matrix?

The aircraft is the design model itself, the controller has one with errors (`DesignModel.with_error`). Outer loops, inversion
and adaptation are those of the paper. Actuators have a first-order lag each, to which sampling adds; the torque that accelerates
a rotor acts at once, and the load of the tail in the slipstream late. The equations are written out here in continuous time and
differentiated numerically: the flying law is sampled, and compiled.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from paper.input_matrix import modified_inverse

from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.propulsors import Propulsor
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.setup import Setup

MOTION, ACTUATORS, INTEGRALS, SLIPSTREAM, ESTIMATES = (
    slice(0, 10), slice(10, 14), slice(14, 18), slice(18, 22), slice(22, 26),
)  # fmt: skip
"""u v w p q r roll pitch heading height; positions; integrals of airspeed, pitch, heading, sideslip; the positions whose
slipstream is at the tail; log(lam_hat)."""
_STEP = 1e-5
_SERVO_STEPS, _ROTOR_STEPS = 0.5, 1.5
"""Delay of an actuator [control steps]: a command is held for one step, and JSBSim's rotors have that of the step before."""


@dataclass(frozen=True)
class Slipstream:
    """What of the propellers' effect reaches the aircraft by the tail, and so late.

    Attributes:
        effect: [6, n] part of the input matrix, by `design_model.ROWS` [per rad or N].
        corner_rad_s: of its first-order lag.
    """

    effect: np.ndarray
    corner_rad_s: float


class LinearLoop:
    """Level flight of an aircraft with four actuators, all of it known but for the errors of one model.

    Args:
        setup: of a flight of that aircraft; its model is the truth.
        slipstream: of that aircraft.
        gamma, epsilon: of (13), (14).
    """

    def __init__(
        self, setup: Setup, slipstream: Slipstream, gamma: float = 4.0, epsilon: float = 0.05
    ) -> None:
        self._truth, self._loops = setup.model, setup.control.loops
        self._scale, self._lags = setup.scale, _corners(setup)
        self._late, self._wash = slipstream.effect * setup.scale, slipstream.corner_rad_s
        self._gamma, self._epsilon = gamma, epsilon
        self._servo = np.array([kind == "servo" for kind in setup.model.kinds])
        self._inertia = rotor_inertia(setup.model) * self._scale
        self.trim = np.zeros(26)
        alpha, airspeed = setup.model.alpha_rad, setup.model.airspeed_m_s
        self.trim[:3] = airspeed * math.cos(alpha), 0.0, airspeed * math.sin(alpha)
        self.trim[7] = self.trim[15] = alpha
        self.trim[ACTUATORS] = self.trim[SLIPSTREAM] = np.array(setup.model.trim) / self._scale

    def growth(self, factors: Mapping[str, float], *, adapts: bool, exact_state: bool = False) -> float:
        """Largest real part of the eigenvalues [1/s] with these errors of the model; below zero the flight is stable.

        Args:
            factors: as for `DesignModel.with_error`.
            adapts: with (13); else the estimates stay 1.
            exact_state: the state function is inverted without error, only the desired rates with the wrong matrix.
        """
        model, n = self._truth.with_error(factors), 26 if adapts else 22
        columns = [
            (
                self._rate(self.trim + step, model, exact_state)
                - self._rate(self.trim - step, model, exact_state)
            )
            / (2.0 * _STEP)
            for step in _STEP * np.eye(26)[:n]
        ]
        return float(np.linalg.eigvals(np.array(columns)[:, :n].T).real.max())

    def _rate(self, s: np.ndarray, model: DesignModel, exact_state: bool) -> np.ndarray:
        u, v, w, p, q, r, roll, pitch, _, _ = s[MOTION]
        airspeed = math.sqrt(u * u + v * v + w * w)
        x = {"airspeed": airspeed, "alpha": math.atan2(w, u), "beta": math.asin(v / airspeed),
             "p": p, "q": q, "r": r, "roll": roll, "pitch": pitch}  # fmt: skip
        pressure = (airspeed / model.airspeed_m_s) ** 2
        factor = np.where(self._servo, pressure, 1.0)
        a, lam_hat = s[ACTUATORS], np.exp(s[ESTIMATES])
        b, b_real = (np.array(each.input_matrix)[:4] * self._scale for each in (model, self._truth))
        offsets, torques = np.array(model.offset_matrix)[:4], np.array(model.torque_matrix)[:4]
        f = model.rates(x, np.zeros(4), np.zeros(4))[
            :4
        ]  # without the constant part of the propellers' torque
        desired, integrals = self._outer(s, x)
        to_cancel = f + offsets.sum(axis=1) * pressure
        cancelling = np.linalg.solve(b_real if exact_state else b, to_cancel)
        reference = (np.linalg.solve(b, desired) - cancelling) / factor
        moving = self._lags * (reference / lam_hat - a)
        torque = self._inertia * moving
        accelerations = self._truth.rates(x, a * self._scale, np.ones(4)) + self._truth.torque_matrix @ torque
        accelerations += self._late @ (s[SLIPSTREAM] - a)
        e = accelerations[:4] - f - (b * factor * a + offsets + torques * torque) @ lam_hat
        estimates = (
            self._gamma * np.linalg.solve(b, e) / factor * modified_inverse(a, self._epsilon) / lam_hat
        )
        turning = q * math.sin(roll) + r * math.cos(roll)
        attitude = (
            p + math.tan(pitch) * turning,
            q * math.cos(roll) - r * math.sin(roll),
            turning / math.cos(pitch),
            u * math.sin(pitch) - math.cos(pitch) * (v * math.sin(roll) + w * math.cos(roll)),
        )
        motion = (*accelerations[3:], *accelerations[:3], *attitude)
        washing = self._wash * (a - s[SLIPSTREAM])
        return np.concatenate([motion, moving, integrals, washing, estimates])

    def _outer(self, s: np.ndarray, x: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray]:
        """Desired p_dot, q_dot, r_dot, u_dot of the outer loops, and the rates of their integrals."""
        k, airspeed, turn = self._loops, x["airspeed"], GRAVITY_M_S2 / x["airspeed"]
        of_speed, of_pitch, of_heading, of_sideslip = s[INTEGRALS]
        heading, height = s[8], s[9]
        slow = self._truth.airspeed_m_s - airspeed
        pitch = of_pitch - k.altitude_kp * height / airspeed
        q = k.pitch_kp * (pitch - x["pitch"]) + turn * math.tan(x["roll"]) * math.sin(x["roll"])
        bank = math.atan((of_heading - k.heading_kp * heading) / turn)
        r = turn * math.sin(x["roll"]) * math.cos(x["pitch"]) + k.sideslip_kp * x["beta"] + of_sideslip
        desired = (
            k.p_kp * (k.roll_kp * (bank - x["roll"]) - x["p"]),
            k.q_kp * (q - x["q"]),
            k.r_kp * (r - x["r"]),
            k.airspeed_kp * slow + of_speed,
        )
        integrals = (
            k.airspeed_ki * slow,
            -k.altitude_ki * height,
            -k.heading_ki * heading,
            k.sideslip_ki * x["beta"],
        )
        return np.array(desired), np.array(integrals)


def _corners(setup: Setup) -> np.ndarray:
    """[n] corner of each actuator's lag with its delay by sampling [rad/s].

    A rotor's is that at the trim, with the propeller's load: (K_t / (K_v R) + dQ/dn) / (2 pi J). `Setup.lags` has that of the
    motor alone, half as fast.
    """
    model, found = setup.model, []
    for i, (propulsor, lag) in enumerate(zip(model.propulsors, setup.lags, strict=True)):
        corner, steps = float(lag), _SERVO_STEPS
        if isinstance(propulsor, Propulsor):
            corner, steps = _rotor_corner(model, i, propulsor), _ROTOR_STEPS
        found.append(1.0 / (1.0 / corner + steps * setup.dt_s))
    return np.array(found)


def _rotor_corner(model: DesignModel, i: int, propulsor: Propulsor) -> float:
    axial, thrust, density = (
        model.airspeed_m_s * math.cos(model.alpha_rad),
        model.trim[i],
        model.density_kg_m3,
    )
    _, per_newton = propulsor.torque_at(thrust, axial, density)
    slow, fast = (propulsor.speed_at(f * thrust, axial, density) for f in (0.98, 1.02))
    load = per_newton * 0.04 * thrust / (fast - slow)
    motor = propulsor.torque_constant_n_m_a / (propulsor.velocity_constant_rps_v * propulsor.resistance_ohm)
    return (motor + load) / (2.0 * math.pi * propulsor.rotor_inertia_kg_m2)


def rotor_inertia(model: DesignModel) -> np.ndarray:
    """[n] torque that accelerates a rotor, per rate of change of its thrust at the trim [N m per N/s]; 0 for servos."""
    found, axial = np.zeros(len(model.kinds)), model.airspeed_m_s * math.cos(model.alpha_rad)
    for i, (propulsor, thrust) in enumerate(zip(model.propulsors, model.trim, strict=True)):
        if isinstance(propulsor, Propulsor):
            slow, fast = (propulsor.speed_at(f * thrust, axial, model.density_kg_m3) for f in (0.98, 1.02))
            found[i] = 2.0 * math.pi * propulsor.rotor_inertia_kg_m2 * (fast - slow) / (0.04 * thrust)
    return found
