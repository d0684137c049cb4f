"""Interacting multiple models: the bank by hand, and what it finds in flight."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from short_flights import scenario
from vtail_setup import records_of, vtail_setup

from testbed.controllers.config import ImmInversionSettings
from testbed.controllers.estimators import LOST, PARTIAL, RECOVERED, bank_dtype, begin, conclude, mix, update
from testbed.metrics import readings
from testbed.simulation import fly

SETUP = vtail_setup(ImmInversionSettings())
PHI = np.array(
    [[9.0, -8.0, 1.0, -1.0], [-30.0, -30.0, 0.5, 0.5], [12.0, -12.0, 2.0, -2.0], [0.1, 0.1, 0.8, 0.8]]
)


def bank() -> tuple[Any, Any, Any]:
    """Settings, memory and a bank at its beginning."""
    _, c, _, s, _ = records_of(SETUP)
    h = np.zeros(1, bank_dtype(4))[0]
    h.probability_min, h.persistence, h.failure_rate = 0.9, 0.2, 0.01
    s.model_error_variance[:] = 0.01
    begin(c, s, h)
    return c, s, h


def run(c: Any, s: Any, h: Any, effectiveness: list[float], seconds: float) -> float | None:
    """Give the bank noisy rates of these true values; returns the time of the first change of a flag, or None."""
    random = np.random.default_rng(3)
    for k in range(round(seconds / c.dt)):
        z = PHI @ effectiveness + random.normal(size=4) * c.noise / np.sqrt(c.dt)
        mix(c, h)
        update(z, PHI, c, s, h)
        if conclude(c, s, h):
            return k * float(c.dt)
    return None


def test_the_models_are_as_it_is_and_each_actuator_changed() -> None:
    c, s, h = bank()
    assert h.probability.sum() == pytest.approx(1.0)
    assert h.effectiveness[0].tolist() == [1.0] * 4
    assert [h.effectiveness[1 + 2 * i, i] for i in range(4)] == [LOST] * 4
    assert [h.effectiveness[2 + 2 * i, i] for i in range(4)] == [PARTIAL] * 4
    s.failed[2] = 1
    begin(c, s, h)
    assert h.effectiveness[0].tolist() == [1.0, 1.0, LOST, 1.0]
    assert h.effectiveness[1, 2] == LOST  # a second failure is looked for on top of the first
    assert h.effectiveness[1 + 2 * 2, 2] == RECOVERED


def test_mixing_by_hand() -> None:
    """Two models share all probability: the mixture's mean, its spread, and probabilities that stay normalised."""
    c, _, h = bank()
    h.probability[:] = 0.0
    h.probability[0], h.probability[1] = 0.25, 0.75
    h.b[0], h.b[1], h.variance[:] = 1.0, 2.0, 0.1
    h.failure_rate = 1.0 / 9.0 / c.dt  # every model gives way to each of the nine alike
    mix(c, h)
    assert h.expected == pytest.approx(np.full(9, 1.0 / 9.0))
    assert h.mixed_b == pytest.approx(np.full((9, 4), 1.75))
    assert h.mixed_variance == pytest.approx(np.full((9, 4), 0.1 + 0.25 * 0.75**2 + 0.75 * 0.25**2))


def test_it_flags_the_actuator_that_is_lost_and_no_other() -> None:
    for lost in range(4):
        c, s, h = bank()
        assert run(c, s, h, [1.0] * 4, 5.0) is None
        delay = run(c, s, h, [float(i != lost) for i in range(4)], 5.0)
        assert delay is not None
        assert s.failed.tolist() == [int(i == lost) for i in range(4)]


def test_it_estimates_a_partial_loss_without_a_flag_and_takes_back_a_flag() -> None:
    c, s, h = bank()
    assert run(c, s, h, [PARTIAL, 1.0, 1.0, 1.0], 5.0) is None
    assert s.lambda_hat == pytest.approx([PARTIAL, 1.0, 1.0, 1.0], abs=0.1)
    c, s, h = bank()
    s.failed[0] = 1
    begin(c, s, h)
    assert run(c, s, h, [1.0] * 4, 5.0) is not None
    assert not s.failed.any()


def test_it_flags_a_lost_propeller_in_flight(tmp_path: Path) -> None:
    lost = "failures=[{type: effectiveness, actuator: left_propeller, at_s: 5, value: 0}]"
    flight = fly(scenario(tmp_path, "imm_inversion", 20, lost))
    log = readings(flight)
    assert log.survived
    assert flight.metrics["false_alarms"] == 0
    assert flight.metrics["detection_delay_s"] < 3.0
    assert not log.log["left_propeller_failed"][: log.row_at(5.0)].any()
