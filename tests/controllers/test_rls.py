"""Recursive least squares: against the batch solution, and in flight."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario
from vtail_setup import records_of, vtail_setup

from testbed.controllers.config import RlsInversionSettings
from testbed.controllers.estimators import forget
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, UNKNOWN_VARIANCE, update_by_rate
from testbed.metrics import readings
from testbed.simulation import fly

SETUP = vtail_setup(RlsInversionSettings())


def test_it_is_the_weighted_least_squares_solution_with_forgetting() -> None:
    """Recursion and normal equations agree: weights exp(-age/T) dt/noise^2, and the initial estimate as prior."""
    _, c, _, s, w = records_of(SETUP)
    c.forgetting_time, n, steps = 0.5, 4, 60
    random = np.random.default_rng(1)
    phi, z = random.normal(0.0, 30.0, (steps, 4, n)), random.normal(0.0, 30.0, (steps, 4))
    for k in range(steps):
        forget(c, s)
        for row in range(4):
            update_by_rate(row, z[k, row], phi[k, row], w.P_h, c, s)
    factor = math.exp(-c.dt / c.forgetting_time)
    information = np.eye(n) * factor**steps / HEALTHY_VARIANCE
    right = information @ np.ones(n)
    for k in range(steps):
        for row in range(4):
            weight = factor ** (steps - 1 - k) * c.dt / c.noise[row] ** 2
            information += weight * np.outer(phi[k, row], phi[k, row])
            right += weight * z[k, row] * phi[k, row]
    assert s.lambda_hat == pytest.approx(np.linalg.solve(information, right), rel=1e-6)
    assert s.P[:n, :n] == pytest.approx(np.linalg.inv(information), rel=1e-6, abs=1e-12)
    assert not s.b.any()  # it does not estimate the model's own error


def test_without_excitation_variances_stay_bounded_and_p_definite() -> None:
    _, c, _, s, _ = records_of(SETUP)
    c.forgetting_time = 0.1
    s.P[0, 1] = s.P[1, 0] = 0.009
    for _ in range(1000):
        forget(c, s)
    assert s.P.diagonal()[:4] == pytest.approx(UNKNOWN_VARIANCE)
    assert np.linalg.eigvalsh(s.P[:4, :4]).min() > 0.0
    assert s.P[0, 1] == pytest.approx(0.9)


def test_it_finds_a_weak_tail_and_flags_nothing(tmp_path: Path) -> None:
    weak = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0.3}]"
    log = readings(fly(scenario(tmp_path, "rls_inversion", 20, weak)))
    assert log.survived
    assert np.abs(log.log["left_ruddervator_effectiveness_estimate"][log.row_at(12.0) :] - 0.3).max() < 0.15
    assert all(np.isnan(log.log[f"{actuator}_failed"]).all() for actuator in log.actuators)
