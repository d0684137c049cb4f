"""Modes of motion of an aircraft about its reference trim, from its design model."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from testbed.aircraft.design_model import DesignModel
from testbed.controllers.inversion.degraded_aircraft import motion
from testbed.controllers.inversion.regulator import jacobian
from testbed.controllers.records import REGULATOR_STATE

_LONGITUDINAL, _LATERAL = ("airspeed", "alpha", "q", "pitch"), ("beta", "p", "r", "roll")
_NO_MOTION = 1e-9


@dataclass(frozen=True)
class Motion:
    """One mode: its name, and its eigenvalue, with the positive imaginary part of a pair [1/s]."""

    name: str
    eigenvalue: complex

    def __str__(self) -> str:
        """In words: `short period: 4.1 rad/s, damping 0.61`, or a time constant, or the time in which it doubles."""
        real, size = self.eigenvalue.real, abs(self.eigenvalue)
        doubles = f", doubles in {math.log(2.0) / real:.3g} s" if real > _NO_MOTION else ""
        if self.eigenvalue.imag:
            return f"{self.name}: {size:.3g} rad/s, damping {-real / size:.2f}{doubles}"
        if size < _NO_MOTION:
            return f"{self.name}: neutral"
        return f"{self.name}: time constant {1.0 / size:.3g} s{doubles}"


def modes_of(model: DesignModel, path_angle: float = 0.0) -> list[Motion]:
    """The longitudinal and lateral modes with surfaces and thrust held, fastest first.

    Args:
        path_angle: of the trim [rad].
    """
    return [
        *_named(_eigenvalues(model, _LONGITUDINAL, path_angle), ("short period", "phugoid"), "pitch"),
        *_named(_eigenvalues(model, _LATERAL, path_angle), ("dutch roll", "roll and spiral"), "roll"),
    ]


def _named(eigenvalues: list[complex], pairs: tuple[str, str], first: str) -> list[Motion]:
    """Names: of pairs by their speed; of single ones roll or pitch, then spiral or what is left of a pair that has none."""
    found, waiting = [], list(pairs)
    singles = (
        f"{first} mode",
        "spiral" if first == "roll" else "second pitch mode",
        "third mode",
        "fourth mode",
    )
    alone = iter(singles)
    if first == "pitch" and len(eigenvalues) == 3 and abs(eigenvalues[0].imag) == 0.0:
        waiting = [pairs[1]]
    for value in eigenvalues:
        found.append(Motion(waiting.pop(0) if value.imag and waiting else next(alone), value))
    return found


def _eigenvalues(model: DesignModel, states: tuple[str, ...], path_angle: float) -> list[complex]:
    """One of each pair, fastest first, of the motion in these states with the others at the trim."""
    positions, effectiveness = np.array(model.trim), np.ones(len(model.trim))
    at_trim = {
        "airspeed": model.airspeed_m_s,
        "alpha": model.alpha_rad,
        "pitch": model.alpha_rad + path_angle,
    }
    x = np.array([at_trim.get(name, 0.0) for name in REGULATOR_STATE])
    rows = [REGULATOR_STATE.index(name) for name in states]
    matrix = jacobian(lambda x: motion(model, x, positions, effectiveness), x)[np.ix_(rows, rows)]
    upper = [complex(value) for value in np.linalg.eigvals(matrix) if value.imag >= 0.0]
    return sorted(upper, key=abs, reverse=True)
