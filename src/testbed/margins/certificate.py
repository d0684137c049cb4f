"""The certificate of an aircraft's input matrix, as its controller has it: margins of each mode over the flight envelope, and the
bias of the estimates for the references that a scenario flies. The mathematics is in `bounds` and `matrix_classes`.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib.util import find_spec

import numpy as np

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.description import Aircraft
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.inversion.modes import Mode, enumerate_modes
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput
from testbed.margins.bounds import (
    ActuatorBias,
    biases,
    entry_limits,
    error_bound,
    flown,
    mismatch,
    remaining_limit,
    sector_limit,
)
from testbed.margins.matrix_classes import diagonal_stability, jacobi_radius, normalised, spectral_radius
from testbed.plant.identification import input_matrix
from testbed.plant.jsbsim import Plant
from testbed.plant.thrust_stand import PROPELLER_SPEEDS, stand_physics_hz
from testbed.plant.trim import NoTrim, trim
from testbed.scenario.load import Scenario
from testbed.simulation import fly, start_and_setup


@dataclass(frozen=True)
class ModeMargin:
    """What a mode tolerates.

    Attributes:
        title: what failed and what is released.
        available: actuators that are left.
        estimates: largest relative error of all entries at once with which the estimates of those are certified.
        inversion: the same for the mode's inversion (29): up to it, B_c B_hat^-1 is certainly H+ on the kept axes.
        refused: why the mode is not flown, or empty.
    """

    title: str
    available: tuple[str, ...]
    estimates: float
    inversion: float
    refused: str


@dataclass(frozen=True)
class Condition:
    """M of one mode in level flight of the truth at one airspeed, for the actuators that are left.

    Attributes:
        mode: its title.
        effectiveness: diagonal of M: column scale, which the estimates follow and which is no error.
        coupling: largest off-diagonal entry of M with a diagonal of 1.
        radius: its `jacobi_radius`; below 1 it is H+.
        remaining: relative error of all entries, about this truth, that is certified besides.
        margin: its `diagonal_stability`; None without cvxpy.
    """

    mode: str
    airspeed_m_s: float
    effectiveness: tuple[float, ...]
    coupling: float
    radius: float
    remaining: float
    margin: float | None


def actuators_left(mode: Mode, setup: Setup) -> np.ndarray:
    """Indices of the actuators that have not failed in a mode."""
    return np.array([i for i, name in enumerate(setup.model.actuators) if name not in mode.failed])


def mode_margin(b: np.ndarray, mode: Mode, setup: Setup) -> ModeMargin:
    """What a mode tolerates.

    The estimates are those of the nominal model in each mode. A lost actuator acts on nothing, so what is left of M is a principal
    submatrix.

    Args:
        b: [4, n] scaled input matrix of the design model.
    """
    left = actuators_left(mode, setup)
    inversion = spectral_radius(np.abs(mode.inverse) @ np.abs(b))
    return ModeMargin(
        title=mode.title,
        available=tuple(setup.model.actuators[i] for i in left),
        estimates=1.0 / spectral_radius(error_bound(b, np.abs(b))[np.ix_(left, left)]),
        inversion=1.0 / inversion if inversion else 0.0,
        refused=mode.refused,
    )


def condition(mode: Mode, setup: Setup, airspeed: float, b: np.ndarray, b_c: np.ndarray) -> Condition:
    """M of a mode at one airspeed [m/s].

    Args:
        b, b_c: [4, n] scaled input matrix of the design model, and of the truth at this airspeed.
    """
    left = actuators_left(mode, setup)
    part = np.ix_(left, left)
    m, e = mismatch(b, b_c)[part], error_bound(b, np.abs(b_c))[part]
    off = np.abs(normalised(m)) * (1.0 - np.eye(len(m)))
    return Condition(
        mode=mode.title,
        airspeed_m_s=airspeed,
        effectiveness=tuple(map(float, np.diag(m))),
        coupling=float(off.max()),
        radius=float(jacobi_radius(m)),
        remaining=remaining_limit(m, e),
        margin=diagonal_stability(m)[0] if find_spec("cvxpy") else None,
    )


_AIRSPEEDS = 7


@dataclass(frozen=True)
class Certificate:
    """What is certified of the input matrix of a scenario's aircraft and controller.

    Attributes:
        error: relative error of all entries for which the bias is given.
        entries: [4, n] limit of the relative error of each entry alone.
        modes: the mode in force, and the mode after each loss.
        conditions: of each mode at each airspeed at which there is level flight.
        no_flight: airspeeds of the envelope at which there is none [m/s].
        biases: of each actuator.
        sector_limit: relative error of all entries up to which every estimate is bounded over the whole flight, however its
            references move.
        exact_law: whether the scenario flies (13), of which all of this holds. With another estimation, the margins of the
            inversion hold, and the bias once e is zero.
    """

    aircraft: str
    scenario: str
    error: float
    actuators: tuple[str, ...]
    entries: np.ndarray
    modes: tuple[ModeMargin, ...]
    conditions: tuple[Condition, ...]
    no_flight: tuple[float, ...]
    biases: tuple[ActuatorBias, ...]
    sector_limit: float
    exact_law: bool


def certify(scenario: Scenario, error: float = 0.1) -> Certificate:
    """The certificate of the input matrix of a scenario's aircraft and controller; the scenario is flown once.

    Args:
        error: relative error of all entries of the input matrix for which the bias of the estimates is bounded.

    Raises:
        BadInput: the controller estimates no effectiveness, its input matrix has not full column rank, or it cannot be flown.
    """
    settings = _estimation(scenario)
    aircraft = load_with_changes(scenario.aircraft)
    _, setup = start_and_setup(scenario)
    b = np.array(setup.model.input_matrix)[:4] * setup.scale
    n, rank = b.shape[1], int(np.linalg.matrix_rank(b))
    if rank < n:
        what = (
            f"the controlled rates of {aircraft.name} tell {rank} of {n} actuators apart, and (13) needs all"
        )
        raise BadInput([scenario.source.problem(("aircraft",), what)])
    table = enumerate_modes(setup.model, setup.scale, setup.control, setup.released)
    modes = [table[failed] for failed in ((), *((i,) for i in range(n)))]
    truths, no_flight = _envelope(aircraft, setup)
    references = flown(fly(scenario))
    return Certificate(
        aircraft=aircraft.name,
        scenario=scenario.name,
        error=error,
        actuators=setup.model.actuators,
        entries=entry_limits(b),
        modes=tuple(mode_margin(b, mode, setup) for mode in modes),
        conditions=tuple(condition(mode, setup, v, b, b_c) for mode in modes for v, b_c in truths),
        no_flight=no_flight,
        biases=biases(b, references, setup.model.actuators, _thresholds(settings, setup), error),
        sector_limit=sector_limit(b, references),
        exact_law=settings.estimation == "newton",
    )


def _estimation(scenario: Scenario) -> AdaptiveInversionSettings:
    settings = scenario.controller
    if not isinstance(settings, AdaptiveInversionSettings):
        what = f"{settings.type} has no estimates to certify"
        raise BadInput([scenario.source.problem(("controller", "type"), what, "adaptive_inversion")])
    return settings


def _thresholds(settings: AdaptiveInversionSettings, setup: Setup) -> np.ndarray:
    """[n] the monitor's threshold for each actuator."""
    other = settings.propeller_threshold
    return np.array(
        [settings.threshold if kind == "servo" or other is None else other for kind in setup.model.kinds]
    )


def _envelope(aircraft: Aircraft, setup: Setup) -> tuple[list[tuple[float, np.ndarray]], tuple[float, ...]]:
    """Scaled input matrix [4, n] of the truth in level flight, at each airspeed of the design model; airspeeds without any."""
    plant = Plant(aircraft, stand_physics_hz(aircraft))
    found, missing = [], []
    for share in np.linspace(PROPELLER_SPEEDS[0], PROPELLER_SPEEDS[-1], _AIRSPEEDS):
        airspeed = float(share * setup.model.airspeed_m_s)
        try:
            level = trim(plant, airspeed, setup.model.altitude_m)
        except NoTrim:
            missing.append(airspeed)
        else:
            found.append((airspeed, input_matrix(plant, level)[:4] * setup.scale))
    return found, tuple(missing)
