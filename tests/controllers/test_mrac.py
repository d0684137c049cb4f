"""Model-reference adaptive control: what it learns of an unknown rate, its bound, and that it makes up for a wrong model."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from short_flights import scenario, worst_errors
from vtail_setup import vtail_setup

from testbed.controllers.augmentation import adapt_theta_row, mrac, theta_effect
from testbed.controllers.config import MracSettings
from testbed.simulation import fly

DT = 0.005


def learnt(unknown_rate: float, seconds: float, **settings: float) -> Any:
    """The adaptive part after a constant unknown p_dot [rad/s2] with only the regressor 1: p is measured, x_ref follows (b)."""
    h = mrac(vtail_setup(MracSettings(**settings)))._records[-1][0]
    h.phi[:] = 0.0
    h.phi[0], p = 1.0, 0.0
    for _ in range(round(seconds / DT)):
        h.e[0] = p - h.x_ref[0]
        h.x_ref[0] += DT * (theta_effect(0, h) + h.l[0] * h.e[0])
        adapt_theta_row(0, DT, h)
        p += DT * unknown_rate
    return h


def test_an_unknown_rate_is_found() -> None:
    h = learnt(2.0, 10.0, e_modification=0.0)
    assert theta_effect(0, h) == pytest.approx(2.0, abs=0.01)
    assert not h.Theta[1:].any()


def test_without_adaptation_it_is_not() -> None:
    """Negative control: the reference model's error alone does not tell."""
    assert abs(theta_effect(0, learnt(2.0, 10.0, adaptation=1e-9))) < 1e-3


def test_parameters_stay_within_their_bound() -> None:
    h = learnt(10.0, 20.0, e_modification=0.0)
    assert 0.9 * h.bound[0] < np.linalg.norm(h.Theta[0]) <= 1.001 * h.bound[0]


def test_the_e_modification_leaks() -> None:
    """In an oscillation about zero, parameters that nothing supports fade with it, and stay without."""
    fades, stays = (mrac(vtail_setup(MracSettings(e_modification=x)))._records[-1][0] for x in (1.0, 1e-9))
    for h in (fades, stays):
        h.Theta[0, 3], h.phi[:] = 1.0, 0.0
        for i in range(2000):
            h.e[0] = 0.1 * (-1) ** i
            adapt_theta_row(0, DT, h)
    assert fades.Theta[0, 3] < 0.5
    assert stays.Theta[0, 3] == pytest.approx(1.0)


def test_it_makes_up_for_a_weak_tail(tmp_path: Path) -> None:
    """It learns what the tail no longer does; a fixed inversion leaves it to the outer loops."""
    weak = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0.3}]"
    adaptive, fixed = (
        worst_errors(fly(scenario(tmp_path, c, 25, weak))) for c in ("mrac", "fixed_inversion")
    )
    assert adaptive[0] < fixed[0]
    assert adaptive[1] < 0.7 * fixed[1]
