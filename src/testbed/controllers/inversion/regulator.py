"""The outer loop of a mode with released axes: a linear-quadratic regulator about the mode's own trim.

The remaining actuators no longer decouple the axes, so the regulator feeds back all states. It is designed on the design model,
when the mode is first entered, in three steps: the trim (`mode_trim`), the linear plant about it (`linearise`), and the gains
(`lq_gains`). Natural stability, such as the weathercock effect and damping, is kept: `outer_loops.regulate` adds nu to f_m, and
does not cancel f_m.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_continuous_are
from threadpoolctl import threadpool_limits

from testbed.aircraft.control_design import RegulatorWeights
from testbed.common.cache import Cache
from testbed.common.signals import RATES
from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft
from testbed.controllers.inversion.mode_trim import (
    AirspeedRange,
    NoSteadyFlight,
    airspeed_range,
    steady_flight,
)
from testbed.controllers.inversion.modes import Mode
from testbed.controllers.inversion.steady_flights import SteadyFlight, jacobian
from testbed.controllers.records import AIRSPEED, ALPHA, ALTITUDE, INTEGRALS, PITCH, REGULATOR_STATE, Q
from testbed.controllers.setup import Setup

_JAM_STEPS = 10
"""Steps in a scaled unit to which a jammed actuator's position is rounded for its design; the integrals make up for the rest."""


@dataclass(frozen=True)
class Regulator:
    """Trim and gains of a mode: nu = -K dx - K_actuator da - K_integral integral, with dx and da deviations from the trim.

    Attributes:
        x_trim: [10] state by `records.REGULATOR_STATE`.
        r_trim: [n] scaled actuator positions at that trim, as if fully effective.
        trim_effect: [n] r_trim, that of surfaces times the trim's (V/V_0)^2.
        K, K_actuator, K_integral: [4, 10], [4, n], [4, 3] gains on state, modelled actuators and integrals.
        eigenvalues: of the designed loop [rad/s].
        held: outputs that follow their references with integral action: some of airspeed, altitude, heading.
        airspeeds: at which the mode may be flown.
    """

    x_trim: np.ndarray
    r_trim: np.ndarray
    trim_effect: np.ndarray
    K: np.ndarray
    K_actuator: np.ndarray
    K_integral: np.ndarray
    eigenvalues: np.ndarray
    held: tuple[str, ...]
    airspeeds: AirspeedRange


_regulators: Cache[Regulator | str] = Cache(256)


def regulator_for(setup: Setup, mode: Mode, jammed: Mapping[int, float]) -> Regulator:
    """As `design_regulator`, cached: a design takes longer than the simulation of a second of flight, and is the same in every
    flight. That a mode has no steady flight is cached too.

    Positions of jammed actuators are rounded by `_JAM_STEPS`, so that the flights of a sweep share designs.
    """
    rounded = {i: round(position * _JAM_STEPS) / _JAM_STEPS for i, position in jammed.items()}
    arrays = (setup.scale, mode.inverse, setup.limits, setup.lags)
    control = setup.control.model_dump_json()
    key = (
        setup.model,
        mode.failed,
        mode.released,
        tuple(rounded.items()),
        control,
        *(a.tobytes() for a in arrays),
    )

    def designed() -> Regulator | str:
        try:
            return design_regulator(setup, mode, rounded)
        except NoSteadyFlight as reason:
            return str(reason)

    regulator = _regulators.get(key, designed)
    if isinstance(regulator, str):
        raise NoSteadyFlight(regulator)
    return regulator


def design_regulator(setup: Setup, mode: Mode, jammed: Mapping[int, float]) -> Regulator:
    """Linear-quadratic regulator for a mode, with weights by Bryson's rule (Bryson and Ho, sec. 5.2).

    Args:
        jammed: scaled position of each jammed actuator, by its index; the trim balances its effect.

    Raises:
        NoSteadyFlight: no steady flight within the stops, or none that can be stabilised.
    """
    degraded = DegradedAircraft.after(setup, mode, jammed)
    flight, held = steady_flight(degraded, setup.control.loops, mode.title)
    A, B = linearise(degraded, setup.lags, flight, held)
    # Inputs are nu. The law divides positions of surfaces by (V/V_0)^2, so that their effect is what nu demands.
    pressure_ratio = (flight.state[AIRSPEED] / setup.model.airspeed_m_s) ** 2
    effect_ratio = np.where(degraded.servos, pressure_ratio, 1.0)
    inverse = mode.inverse / effect_ratio[:, None]
    B = B @ inverse
    if not degraded.pitch_controlled and degraded.servos[degraded.used].any():
        _take_apart(A, B, degraded, held)
    states = _fed_back(degraded, held)
    kept = [i for i, axis in enumerate(RATES) if axis not in mode.released]
    Q, R = _weights(setup.control.regulator, degraded, held, inverse[:, kept])
    try:
        K, eigenvalues = lq_gains(A[np.ix_(states, states)], B[np.ix_(states, kept)], np.diag(Q[states]), R)
    except ValueError:  # LinAlgError is one
        what = "what is left cannot stabilise the aircraft about its trim"
        raise NoSteadyFlight(f"{mode.title}: {what}") from None
    gains = np.zeros((4, len(A)))
    gains[np.ix_(kept, states)] = K
    trim_effect, airspeeds = flight.positions * effect_ratio, airspeed_range(degraded, flight, held)
    return Regulator(*flight, trim_effect, *_by_part(gains, held), eigenvalues, held, airspeeds)


def _take_apart(A: np.ndarray, B: np.ndarray, degraded: DegradedAircraft, held: Sequence[str]) -> None:
    """Leave out, in place, what couples motion in the plane of symmetry, which thrust is left to control, with that across it,
    which surfaces control.

    At a trim with a degree of bank the coupling is small, and gains that use it are large: ailerons were thrown from stop to stop
    for an error of pitch, 950 1/s2, and a T-37 without an elevator rolled over within five seconds."""
    along = np.array(
        [
            *(i in (AIRSPEED, ALPHA, Q, PITCH, ALTITUDE) for i in range(len(REGULATOR_STATE))),
            *~degraded.servos,
            *(name != "heading" for name in held),
        ]
    )
    A[along[:, None] != along] = 0.0
    B[along[:, None] != [rate in ("q_dot", "u_dot") for rate in RATES]] = 0.0


def _fed_back(degraded: DegradedAircraft, held: Sequence[str]) -> list[int]:
    """Indices of the states of `linearise` that are fed back: all but the actuators that are not used.

    In a descent altitude is not fed back: it is the energy that keeps the airspeed up, and cannot be held.
    """
    nx, n = len(REGULATOR_STATE), len(degraded.scale)
    unused = {nx + i for i in degraded.unused} | (set() if "altitude" in held else {ALTITUDE})
    return [i for i in range(nx + n + len(held)) if i not in unused]


def _weights(
    weights: RegulatorWeights, degraded: DegradedAircraft, held: Sequence[str], into: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Bryson's weights: [10 + n + number held] diagonal of Q, and [kept, kept] R, one over the squares of acceptable deviations.

    Args:
        into: [n, kept] from nu to scaled positions, r = into nu: the weights of R are on actuator positions.
    """
    states = [getattr(weights.states, name) for name in REGULATOR_STATE]
    integrals = [getattr(weights.integrals, name) for name in held]
    Q = 1.0 / np.square(np.array([*states, *[weights.actuator] * len(degraded.scale), *integrals]))
    return Q, into.T @ np.diag(degraded.available / weights.actuator**2) @ into


def _by_part(gains: np.ndarray, held: Sequence[str]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """K, K_actuator and K_integral of `Regulator` from the [4, 10 + n + number held] gains on the states of `linearise`."""
    nx, first_integral = len(REGULATOR_STATE), gains.shape[1] - len(held)
    K_integral = np.zeros((4, len(INTEGRALS)))
    K_integral[:, [INTEGRALS.index(name) for name in held]] = gains[:, first_integral:]
    return gains[:, :nx], gains[:, nx:first_integral], K_integral


def linearise(
    degraded: DegradedAircraft, lags: np.ndarray, flight: SteadyFlight, held: Sequence[str]
) -> tuple[np.ndarray, np.ndarray]:
    """Matrices A, B of the plant about a trim: states z = (x [10], a [n], integrals of the held outputs), inputs r [n].

    Args:
        degraded: the aircraft with the actuators that remain.
        lags: [n] corner of each actuator's first-order lag, a' = lag (r - a) [rad/s].
        flight: the trim.
        held: names of the outputs whose errors are integrated.
    """
    nx, n = len(REGULATOR_STATE), len(lags)
    x0, a0 = flight
    rows = [REGULATOR_STATE.index(name) for name in held]

    def plant(z: np.ndarray, r: np.ndarray) -> np.ndarray:
        x, a = z[:nx], z[nx : nx + n]
        return np.concatenate([degraded.motion(x, a), lags * (r - a), x[rows] - x0[rows]])

    z0 = np.concatenate([x0, a0, np.zeros(len(held))])
    return jacobian(lambda z: plant(z, a0), z0), jacobian(lambda r: plant(z0, r), a0)


def lq_gains(A: np.ndarray, B: np.ndarray, Q: np.ndarray, R: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gains K of u = -K x that minimise the integral of x'Qx + u'Ru, and the eigenvalues of A - B K
    (Bryson and Ho, Applied Optimal Control, sec. 5.2).

    Raises:
        numpy.linalg.LinAlgError: no gains stabilise the plant, as it has an unstable mode that B cannot reach.
        ValueError: none are found, as the equation is ill-conditioned.
    """
    with threadpool_limits(1):  # the number of BLAS threads changes the last bits, and so a flight's bytes
        K = np.linalg.solve(R, B.T @ solve_continuous_are(A, B, Q, R))
        return K, np.linalg.eigvals(A - B @ K)
