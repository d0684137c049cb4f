"""Margins of a control mode: what error of its input matrix is certified, and how large the error is at each airspeed."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.util import find_spec

import numpy as np

from testbed.controllers.inversion.modes import Mode
from testbed.controllers.setup import Setup
from testbed.margins.bounds import error_bound, mismatch, remaining_limit
from testbed.margins.matrix_classes import diagonal_stability, jacobi_radius, normalised, spectral_radius


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
