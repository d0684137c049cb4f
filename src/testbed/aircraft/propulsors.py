"""What the design model knows of propulsion: an electric motor with its propeller, or an engine of any other kind."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from testbed.common.roots import bracketed_root
from testbed.inputs.problems import BadInput, Problem

PROPELLER_POINTS = 41
"""Number of points in each table of a propeller."""
ENGINE_THROTTLES, ENGINE_SPEEDS = 17, 5
"""Number of throttles and of airspeeds in the map of an engine."""
_CLIFF = 3.0
_BISECTIONS = 40  # to the last digits of a rotor speed


@dataclass(frozen=True)
class Propulsor:
    """One motor with its propeller as the design model knows it.

    Coefficients are tables over equal steps of advance ratio J = V_axial / (n D), from the first to the last value of `advance`
    (at the last, the propeller windmills): T = rho n^2 D^4 C_T(J), Q = rho n^2 D^5 C_Q(J), n in rev/s.
    Motor: current I = (voltage - n/K_v)/R, torque Q_motor = K_t (I - i_0).
    """

    advance: tuple[float, float]
    thrust: tuple[float, ...]
    torque: tuple[float, ...]
    diameter_m: float
    rotor_inertia_kg_m2: float
    max_volts: float
    velocity_constant_rps_v: float
    torque_constant_n_m_a: float
    resistance_ohm: float
    no_load_current_a: float

    def speed_at(self, thrust_n: float, axial_m_s: float, density_kg_m3: float) -> float:
        """Rotor speed [rev/s] at which the propeller gives this thrust."""
        slowest = axial_m_s / (self.diameter_m * self.advance[1])
        top = self.max_volts * self.velocity_constant_rps_v
        least, most = (self._loads(n, axial_m_s, density_kg_m3)[0] for n in (slowest, top))
        if not least <= thrust_n <= most:
            what = f"the propeller cannot give {thrust_n:.3g} N at {axial_m_s:.3g} m/s"
            raise BadInput(
                [Problem(what, expected=f"{least:.3g} to {most:.3g} N by its tables and its motor")]
            )
        return bracketed_root(
            lambda n: float(self._loads(n, axial_m_s, density_kg_m3)[0]) - thrust_n, slowest, top
        )

    def least_thrust(self, axial_m_s: float | np.ndarray, density_kg_m3: float) -> float | np.ndarray:
        """Thrust [N] at the last advance ratio of the tables, the least that the model knows at an airspeed."""
        diameters_per_s = axial_m_s / self.advance[1]
        return density_kg_m3 * diameters_per_s**2 * self.diameter_m**2 * self.thrust[-1]

    def most_thrust(self, axial_m_s: np.ndarray, density_kg_m3: float) -> np.ndarray:
        """Steady thrust [N] at full throttle."""
        return self._thrust_with(self.max_volts, axial_m_s, density_kg_m3)

    def at_same_throttle(
        self, thrust_n: float, axial_m_s: float, others_m_s: np.ndarray, density_kg_m3: float
    ) -> np.ndarray:
        """[m] steady thrust [N] at other airspeeds of the throttle that gives a thrust at one airspeed. A thrust that no throttle
        gives is that of the nearest throttle, and a constant."""
        here = np.array([axial_m_s])
        least, most = self.least_thrust(axial_m_s, density_kg_m3), self.most_thrust(here, density_kg_m3)[0]
        within = float(np.clip(thrust_n, least + 1e-9 * (most - least), most))
        n = self.speed_at(within, axial_m_s, density_kg_m3)
        torque = self._loads(n, axial_m_s, density_kg_m3)[1]
        current = torque / self.torque_constant_n_m_a + self.no_load_current_a
        volts = float(n / self.velocity_constant_rps_v + self.resistance_ohm * current)
        shift = thrust_n - self._thrust_with(volts, here, density_kg_m3)[0]
        return self._thrust_with(volts, others_m_s, density_kg_m3) + shift

    def _thrust_with(self, volts: float, axial_m_s: np.ndarray, density_kg_m3: float) -> np.ndarray:
        """Steady thrust [N] at a voltage, by bisection for the rotor speed at which the motor's torque is the propeller's."""
        top = self.max_volts * self.velocity_constant_rps_v
        low = np.minimum(axial_m_s / (self.diameter_m * self.advance[1]), top)
        high = np.full(low.shape, top)
        for _ in range(_BISECTIONS):
            n = 0.5 * (low + high)
            current = (volts - n / self.velocity_constant_rps_v) / self.resistance_ohm
            torque = self.torque_constant_n_m_a * (current - self.no_load_current_a)
            quickens = torque > self._loads(n, axial_m_s, density_kg_m3)[1]
            low, high = np.where(quickens, n, low), np.where(quickens, high, n)
        return self._loads(low, axial_m_s, density_kg_m3)[0]

    def torque_at(self, thrust_n: float, axial_m_s: float, density_kg_m3: float) -> tuple[float, float]:
        """Steady torque [N m] at a thrust and axial airspeed, and its derivative by thrust, dQ/dT [m], at this airspeed."""
        n = self.speed_at(thrust_n, axial_m_s, density_kg_m3)
        # The step is wide enough to average over the corners of the piecewise linear tables.
        (t0, q0), (_, q), (t1, q1) = (
            self._loads(n * factor, axial_m_s, density_kg_m3) for factor in (0.98, 1.0, 1.02)
        )
        if t1 == t0:
            what = f"the propeller's thrust does not change with its speed at {axial_m_s:.3g} m/s"
            raise BadInput([Problem(what, expected="a table of thrust whose values are not all 0")])
        return q, (q1 - q0) / (t1 - t0)

    def _loads(
        self, n: float | np.ndarray, axial_m_s: float | np.ndarray, density_kg_m3: float
    ) -> tuple[Any, Any]:
        """Thrust [N] and torque [N m] at rotor speeds [rev/s] and axial airspeeds; numbers for numbers, arrays for arrays."""
        pressure = density_kg_m3 * n * n * self.diameter_m**4
        j = axial_m_s / (n * self.diameter_m)
        grid = np.linspace(*self.advance, len(self.thrust))
        thrust, torque = np.interp(j, grid, self.thrust), np.interp(j, grid, self.torque)
        return pressure * thrust, pressure * self.diameter_m * torque


@dataclass(frozen=True)
class EngineMap:
    """Thrust of one engine as the design model knows it, measured on a stand.

    Steady thrust is a table over throttle and axial airspeed, linear in between. In time, thrust is that of a throttle which
    follows the commanded one with a first-order lag and at limited rates: the engine's speed in units of throttle.

    Attributes:
        throttles: [`ENGINE_THROTTLES`] ascending.
        speeds: [`ENGINE_SPEEDS`] axial airspeeds, ascending [m/s].
        thrust: one row for each airspeed, one column for each throttle [N].
        lag_rad_s: corner of the lag.
        rise_s, fall_s: fastest increase and decrease of the followed throttle [1/s].
    """

    throttles: tuple[float, ...]
    speeds: tuple[float, ...]
    thrust: tuple[tuple[float, ...], ...]
    lag_rad_s: float
    rise_s: float
    fall_s: float

    @cached_property
    def rising(self) -> np.ndarray:
        """[speeds, throttles] the largest monotone table at or below `thrust` [N]: what a throttle is looked up in.

        Where thrust falls with throttle, as that of a windmilling propeller may, no lower throttle is chosen than the one of
        the least thrust.
        """
        return np.minimum.accumulate(np.array(self.thrust)[:, ::-1], axis=1)[:, ::-1]

    def thrust_at(self, throttle: float, axial_m_s: float) -> float:
        """Steady thrust [N]."""
        return float(np.interp(throttle, self.throttles, self._row(np.array(self.thrust), axial_m_s)))

    def throttle_for(self, thrust_n: float, axial_m_s: float) -> float:
        """The lowest throttle with this steady thrust; the nearest where there is none."""
        row = self._row(self.rising, axial_m_s)
        climbs = np.concatenate([np.diff(row) > 0.0, [True]])  # of a level stretch only its end is needed
        return float(np.interp(thrust_n, row[climbs], np.array(self.throttles)[climbs]))

    def least_thrust(self, axial_m_s: float | np.ndarray, density_kg_m3: float) -> float | np.ndarray:
        """Thrust at the lowest throttle that is used at an airspeed [N]."""
        return np.interp(axial_m_s, self.speeds, self.rising[:, 0])

    def most_thrust(self, axial_m_s: np.ndarray, density_kg_m3: float) -> np.ndarray:
        """Thrust at full throttle at an airspeed [N]."""
        return np.interp(axial_m_s, self.speeds, self.rising[:, -1])

    def at_same_throttle(
        self, thrust_n: float, axial_m_s: float, others_m_s: np.ndarray, density_kg_m3: float
    ) -> np.ndarray:
        """As `Propulsor.at_same_throttle`."""
        throttle = self.throttle_for(thrust_n, axial_m_s)
        shift = thrust_n - self.thrust_at(throttle, axial_m_s)
        return np.array([self.thrust_at(throttle, airspeed) for airspeed in others_m_s]) + shift

    @cached_property
    def least_useful_n(self) -> float:
        """Thrust at the middle airspeed below which the map is a cliff [N]: where a small change of throttle would change thrust
        by more than three times as much as above it, as when a governed propeller begins to windmill. The search begins in the
        middle of the map's rise."""
        row, throttles = self.rising[len(self.speeds) // 2], np.array(self.throttles)
        slopes = np.diff(row) / np.diff(throttles)
        middle = int(np.argmin(np.abs(row - 0.5 * (row[0] + row[-1]))))
        for k in range(middle - 1, -1, -1):
            if slopes[k] > _CLIFF * max((row[-1] - row[k + 1]) / (throttles[-1] - throttles[k + 1]), 1e-9):
                return float(row[k + 1])
        return float(row[0])

    @property
    def small_lag_rad_s(self) -> float:
        """Corner of the lag with which a change of a twentieth of the throttle's range is followed, rate limit included."""
        change = 0.05 * (self.throttles[-1] - self.throttles[0])
        return 1.0 / (1.0 / self.lag_rad_s + 0.63 * change / min(self.rise_s, self.fall_s))

    def _row(self, table: np.ndarray, axial_m_s: float) -> np.ndarray:
        at = np.clip(
            np.interp(axial_m_s, self.speeds, np.arange(len(self.speeds))), 0.0, len(self.speeds) - 1.0
        )
        left = min(int(at), len(self.speeds) - 2)
        return np.asarray(table[left] + (at - left) * (table[left + 1] - table[left]))
