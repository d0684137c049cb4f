"""Steady straight flights of the design model, many at once: the states and positions at which nothing accelerates.

A flight is steady when the six rates are zero and the climb rate is that of its path angle: seven equations. The unknowns are
alpha, beta, roll and pitch, the positions of the actuators that remain, and, where these are too few, the airspeed. Where
there are more unknowns than equations, the Gauss-Newton steps are those of least norm, in units of `_ANGLE`, `_SPEED` and one
scaled position. So redundant actuators share the work, and an aircraft that is its own mirror image flies symmetrically.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft, climb_rate
from testbed.controllers.records import AIRSPEED, ALPHA, BETA, PITCH, REGULATOR_STATE, ROLL

_ANGLE, _SPEED = 0.2, 3.0  # rad and m/s that count as one scaled position
_ITERATIONS = 12  # Gauss-Newton steps for a trim, at most
_LARGEST_STEP = 1.0  # of an unknown in one iteration, in its unit
_DIFFERENCE = 1e-6  # of the central differences, in the unit of each unknown, state or scaled position
_RESIDUAL_MAX = 1e-7  # largest rate that may remain [rad/s2, m/s2, m/s]
_DAMPING = 1e-10  # of the Gauss-Newton steps, so that too few actuators are no error


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
        rates = degraded.rates(x, a)
        if climb_error is None:
            return rates
        return np.column_stack([rates, climb_error(climb_rate(x))])

    z = gauss_newton(residuals, np.zeros((m, len(sizes))))
    return flights(z).only(np.abs(residuals(z)).max(axis=1) < _RESIDUAL_MAX)


def gauss_newton(residuals: Callable[[np.ndarray], np.ndarray], z: np.ndarray) -> np.ndarray:
    """[m, k] zeros of m independent problems: `residuals` maps [m, k] to [m, e]; from first guesses z, by steps of least norm."""
    for _ in range(_ITERATIONS):
        r = residuals(z)
        if np.abs(r).max() < 0.01 * _RESIDUAL_MAX:
            break
        J = np.ascontiguousarray(jacobian(residuals, z))
        JT = J.transpose(0, 2, 1)
        gram = J @ JT + _DAMPING * np.eye(r.shape[1])
        step = (JT @ np.linalg.solve(gram, r[..., None]))[..., 0]
        largest = np.abs(step).max(axis=1, keepdims=True)
        z = z - step * np.minimum(1.0, _LARGEST_STEP / np.maximum(largest, 1e-12))
    return z


def jacobian(function: Callable[[np.ndarray], np.ndarray], x: np.ndarray) -> np.ndarray:
    """[..., m, n] derivatives of a function with values [..., m], at x [..., n], by central differences."""
    columns = []
    for step in _DIFFERENCE * np.eye(x.shape[-1]):
        columns.append((function(x + step) - function(x - step)) / (2.0 * _DIFFERENCE))
    return np.moveaxis(np.array(columns), 0, -1)


def path_angles(flights: SteadyFlight) -> np.ndarray:
    """[m] path angle of each of m flights [rad]."""
    angles: np.ndarray = np.arcsin(climb_rate(flights.state) / flights.state[:, AIRSPEED])
    return angles
