"""Modes of motion of an aircraft about its reference trim, from its design model."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from testbed.aircraft.design_model import DesignModel

_STEPS = {
    "u": 0.1, "v": 0.1, "w": 0.1, "p": 0.01, "q": 0.01, "r": 0.01, "roll": 0.01, "pitch": 0.01,
}  # fmt: skip
"""Of the differences by each state [m/s, rad/s, rad]."""
_LONGITUDINAL, _LATERAL = ("u", "w", "q", "pitch"), ("v", "p", "r", "roll")
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
    """One of each pair, fastest first."""
    values = np.linalg.eigvals(_system_matrix(model, states, path_angle))
    upper = [complex(v) for v in values if v.imag >= 0.0]
    return sorted(upper, key=abs, reverse=True)


def _system_matrix(model: DesignModel, states: tuple[str, ...], path_angle: float) -> np.ndarray:
    """[4, 4] derivatives of the rates of some states by these states."""
    columns = []
    for name in states:
        ends = [_rates(model, {name: sign * _STEPS[name]}, path_angle) for sign in (1.0, -1.0)]
        columns.append([(ends[0][row] - ends[1][row]) / (2.0 * _STEPS[name]) for row in states])
    return np.array(columns).T


def _rates(model: DesignModel, change: dict[str, float], path_angle: float) -> dict[str, float]:
    """Rates of all states with a change from the trim."""
    alpha, speed = model.alpha_rad, model.airspeed_m_s
    x = {"u": speed * math.cos(alpha), "v": 0.0, "w": speed * math.sin(alpha), "p": 0.0, "q": 0.0, "r": 0.0}
    x |= {"roll": 0.0, "pitch": alpha + path_angle}
    for name, by in change.items():
        x[name] += by
    airspeed = math.sqrt(x["u"] ** 2 + x["v"] ** 2 + x["w"] ** 2)
    seen = {
        **x,
        "airspeed": airspeed,
        "alpha": math.atan2(x["w"], x["u"]),
        "beta": math.asin(x["v"] / airspeed),
    }
    p_dot, q_dot, r_dot, u_dot, v_dot, w_dot = model.rates(seen, model.trim, np.ones(len(model.trim)))
    tilt = math.tan(x["pitch"])
    return {
        "u": u_dot, "v": v_dot, "w": w_dot, "p": p_dot, "q": q_dot, "r": r_dot,
        "roll": x["p"] + tilt * (x["q"] * math.sin(x["roll"]) + x["r"] * math.cos(x["roll"])),
        "pitch": x["q"] * math.cos(x["roll"]) - x["r"] * math.sin(x["roll"]),
    }  # fmt: skip
