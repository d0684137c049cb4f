"""The trim of a control mode: steady flight on the design model with the actuators that are left."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import NamedTuple

import numpy as np
from scipy.optimize import root

from testbed.aircraft.control_design import Loops
from testbed.aircraft.design_model import DesignModel
from testbed.common.frames import level_pitch
from testbed.controllers.inversion.modes import Mode
from testbed.controllers.records import AIRSPEED, ALPHA, BETA, REGULATOR_STATE
from testbed.controllers.setup import Setup

_BEYOND_STOPS = 1.3
"""Factor on the stops within which a trim is accepted as a last resort. A model with errors of 20 % can place a trim that far
off, and regulating about a trim near the true one is better than having none."""
_ALPHA_MAX, _BETA_MAX, _SLOWEST = 0.25, 0.4, 0.5
"""Angle of attack and sideslip [rad], and share of the reference airspeed, beyond which a solution is no plausible trim:
the design model is linear there, the aircraft is not."""
_DESCENT = -0.08  # rad, first guess of the path angle
_SYMMETRY = np.diag([-1.0, 1.0, -1.0, 1.0])
"""Turns an actuator's effect on the rates (`signals.RATES`) into that of its mirror image: p_dot and r_dot change sign."""

_EVERYTHING = ("airspeed", "altitude", "heading")


class NoSteadyFlight(ValueError):
    """With these actuators the design model has no steady flight, or none that can be stabilised."""


@dataclass(frozen=True)
class Remaining:
    """What there is to fly with after failures.

    Attributes:
        scale: [n] rad or N of one scaled unit.
        limits: [n, 2] scaled stops.
        available: [n] 1 for actuators that are used.
        effective: [n] effectiveness: 1 for available and for jammed actuators, 0 for the others.
        positions: [n] scaled positions: where a jammed actuator is jammed; for the others that of the reference trim, which is
            the first guess for those that are available.
    """

    model: DesignModel
    scale: np.ndarray
    limits: np.ndarray
    available: np.ndarray
    effective: np.ndarray
    positions: np.ndarray

    @classmethod
    def after(cls, setup: Setup, mode: Mode, jammed: Mapping[int, float]) -> Remaining:
        """What remains in a mode, with the scaled positions of jammed actuators."""
        model, scale = setup.model, setup.scale
        available = np.array([float(name not in mode.failed) for name in model.actuators])
        effective, positions = available.copy(), np.array(model.trim) / scale
        for i, position in jammed.items():
            effective[i], positions[i] = 1.0, position
        return cls(model, scale, setup.limits, available, effective, positions)

    @cached_property
    def unknowns(self) -> tuple[np.ndarray, list[tuple[int, int]]]:
        """Indices of the actuators whose positions are solved for, and pairs (follower, leader) that move together.

        Six accelerations determine alpha, beta, roll and three actuators. If more are available, they are paired until three
        are left: surfaces before motors, and first the two that are most nearly mirror images of each other. So the aircraft
        flies symmetrically.
        """
        free = [int(i) for i in np.flatnonzero(self.available)]
        ganged: list[tuple[int, int]] = []
        for follower, leader in sorted(combinations(free, 2), key=self._mirror_distance):
            if len(free) - len(ganged) <= 3:
                break
            if not {follower, leader} & {i for pair in ganged for i in pair}:
                ganged.append((follower, leader))
        followers = [follower for follower, _ in ganged]
        return np.array([i for i in free if i not in followers]), ganged

    def _mirror_distance(self, pair: tuple[int, int]) -> tuple[bool, float]:
        """Sort key of a pair of actuators: surfaces first, then by how far their effects are from mirror images."""
        b, kinds = np.array(self.model.input_matrix)[:4] * self.scale, self.model.kinds
        i, j = pair
        surfaces = kinds[i] == kinds[j] == "servo"
        return not surfaces, float(np.linalg.norm(_SYMMETRY @ b[:, i] - b[:, j]))

    def motion(self, x: np.ndarray, a: np.ndarray) -> np.ndarray:
        """[10] derivatives of the state x [10] with actuators at scaled positions a [n]."""
        return motion(self.model, x, a * self.scale, self.effective)


class SteadyFlight(NamedTuple):
    """A trim: state [10] by `records.REGULATOR_STATE`, and scaled positions [n]."""

    state: np.ndarray
    positions: np.ndarray


@dataclass(frozen=True)
class TrimProblem:
    """Steady straight flight on the design model: the alpha, beta, roll and three actuators at which all accelerations are zero.

    Attributes:
        remaining: what there is to fly with.
        freed: "" for level flight at a given airspeed. With two actuators one more unknown is needed: "airspeed" for level
            flight, or "path_angle" for a given airspeed.
        stop_factor: a trim is accepted within the stops times this.
    """

    remaining: Remaining
    freed: str = ""
    stop_factor: float = 1.0

    def solve(self, airspeeds: Sequence[float]) -> SteadyFlight | None:
        """The first trim found at these airspeeds [m/s], or None. If airspeed is an unknown, they are its first guesses."""
        for airspeed in airspeeds:
            for beta in (0.0, 0.08, -0.08):  # first guesses [rad]
                flight = self._solve_from(airspeed, beta)
                if flight is not None:
                    return flight
        return None

    def _solve_from(self, airspeed: float, beta: float) -> SteadyFlight | None:
        left = self.remaining
        used, _ = left.unknowns
        start = [left.model.alpha_rad, beta, 0.0]
        if self.freed:
            start.append(airspeed if self.freed == "airspeed" else _DESCENT)

        def accelerations(unknowns: np.ndarray) -> np.ndarray:
            state, a = self._flight(unknowns, airspeed)
            return _rates(left.model, state, a * left.scale, left.effective)

        found = root(accelerations, np.array([*start, *left.positions[used]]), method="hybr")
        flight = self._flight(found.x, airspeed)
        return flight if found.success and self._plausible(flight) else None

    def _flight(self, unknowns: np.ndarray, airspeed: float) -> SteadyFlight:
        """State and positions for the unknowns: alpha, beta, roll, the `freed` one if any, positions of the solved actuators."""
        used, ganged = self.remaining.unknowns
        alpha, beta, roll = unknowns[:3]
        values = {"airspeed": airspeed, "path_angle": 0.0}
        if self.freed:
            values[self.freed] = unknowns[3]
        a = self.remaining.positions.copy()
        a[used] = unknowns[3 + bool(self.freed) :]
        for follower, leader in ganged:
            a[follower] = a[leader]
        pitch = level_pitch(alpha, beta, roll, values["path_angle"])
        return SteadyFlight(
            np.array([values["airspeed"], alpha, beta, 0.0, 0.0, 0.0, roll, pitch, 0.0, 0.0]), a
        )

    def _plausible(self, flight: SteadyFlight) -> bool:
        """Whether a solution is within the stops and near ordinary flight: the equations have spurious solutions far from it."""
        limits, state = self.stop_factor * self.remaining.limits, flight.state
        airspeed, alpha, beta = state[AIRSPEED], state[ALPHA], state[BETA]
        inside = np.all((flight.positions >= limits[:, 0] - 1e-9) & (flight.positions <= limits[:, 1] + 1e-9))
        slowest = _SLOWEST * self.remaining.model.airspeed_m_s
        return bool(inside and abs(alpha) < _ALPHA_MAX and abs(beta) < _BETA_MAX and airspeed > slowest)


def steady_flight(left: Remaining, loops: Loops, title: str) -> tuple[SteadyFlight, tuple[str, ...]]:
    """Steady flight with the actuators that remain, and the outputs that can be held in it.

    With three actuators or more, the flight is level at the reference airspeed, or faster if there is no trim at that. If one
    motor of several is left, the search begins `lost_thrust_faster_m_s` higher. Airspeed, altitude and heading are held.

    With two, of which at least one is a motor, the flight is level at an unknown airspeed; altitude and heading are held. With
    no motor, or if there is no such trim, the flight descends; airspeed and heading are held.

    Args:
        title: what failed, for the message.

    Raises:
        NoSteadyFlight: fewer than two actuators are left, or none of these flights has a trim.
    """
    if left.available.sum() < 2:
        raise NoSteadyFlight(f"{title}: one actuator cannot hold altitude and heading")
    for problem, airspeeds, held in _attempts(left, loops):
        flight = problem.solve(airspeeds)
        if flight is not None:
            return flight, held
    raise NoSteadyFlight(f"{title}: no steady flight within the stops, level or descending")


def _attempts(left: Remaining, loops: Loops) -> Iterator[tuple[TrimProblem, list[float], tuple[str, ...]]]:
    """Trim problems in the order in which they are tried, each with the airspeeds to try [m/s] and the outputs that it holds."""
    airspeed, motors = left.model.airspeed_m_s, _available_motors(left)
    if left.available.sum() >= 3:
        # An aircraft that has only one motor by design has lost none.
        lost_thrust = len(motors) > 1 and sum(motors) == 1
        first = loops.lost_thrust_faster_m_s if lost_thrust else 0.0
        faster = [airspeed + change for change in (first, first + 1.0, first + 2.0, first + 4.0, first + 8.0)]
        for stop_factor in (1.0, _BEYOND_STOPS):
            yield TrimProblem(left, stop_factor=stop_factor), faster, _EVERYTHING
        return
    around = [airspeed + change for change in (0.0, -2.0, 2.0, -4.0, 4.0, 8.0)]
    if any(motors):
        yield TrimProblem(left, "airspeed"), around, ("altitude", "heading")
    yield TrimProblem(left, "path_angle"), around, ("airspeed", "heading")


def _available_motors(left: Remaining) -> list[bool]:
    return [bool(left.available[i]) for i, kind in enumerate(left.model.kinds) if kind == "motor"]


def motion(model: DesignModel, x: np.ndarray, a: np.ndarray, effectiveness: np.ndarray) -> np.ndarray:
    """[10] time derivatives of the state on the design model (flat earth, body axes).

    Args:
        x: [10] state by `records.REGULATOR_STATE`.
        a: [n] actuator positions [rad, N].
        effectiveness: [n] of each actuator, 1 healthy, 0 lost.
    """
    speed, alpha, beta, p, q, r, roll, pitch, _, _ = x
    p_dot, q_dot, r_dot, u_dot, v_dot, w_dot = _rates(model, x, a, effectiveness)
    ca, sa, cb, sb = math.cos(alpha), math.sin(alpha), math.cos(beta), math.sin(beta)
    u, v, w = speed * ca * cb, speed * sb, speed * sa * cb
    speed_dot = (u * u_dot + v * v_dot + w * w_dot) / speed
    alpha_dot = (u * w_dot - w * u_dot) / (u * u + w * w)
    beta_dot = (v_dot - sb * speed_dot) / (speed * cb)
    turn = q * math.sin(roll) + r * math.cos(roll)
    roll_dot, pitch_dot = p + math.tan(pitch) * turn, q * math.cos(roll) - r * math.sin(roll)
    heading_dot = turn / math.cos(pitch)
    climb = u * math.sin(pitch) - (v * math.sin(roll) + w * math.cos(roll)) * math.cos(pitch)
    return np.array(
        [speed_dot, alpha_dot, beta_dot, p_dot, q_dot, r_dot, roll_dot, pitch_dot, heading_dot, climb]
    )


def _rates(model: DesignModel, x: np.ndarray, a: np.ndarray, effectiveness: np.ndarray) -> np.ndarray:
    return model.rates(dict(zip(REGULATOR_STATE[:8], map(float, x[:8]), strict=True)), a, effectiveness)
