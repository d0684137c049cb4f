"""Incremental inversion that learns its input matrix: the update by hand, and that it learns in flight."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario, worst_errors
from vtail_setup import records_of, vtail_setup

from testbed.controllers.config import AdaptiveIndiSettings
from testbed.controllers.indi import adaptive_indi, learn, weigh
from testbed.controllers.inversion.modes import allocation_of
from testbed.metrics import readings
from testbed.simulation import fly

DT = 0.005
WEATHER = ("sensors=mems", "atmosphere.turbulence_w20_m_s=7.62", "seed=2")


def learnt(true: np.ndarray, steps: int, **settings: float) -> tuple[np.ndarray, np.ndarray]:
    """G in units of its first value, and effectiveness, after so many steps with random increments of rates by `true` times B."""
    setup = vtail_setup(AdaptiveIndiSettings(**settings))
    m, _, _, s, _ = records_of(setup)
    h = adaptive_indi(setup)._records[-1][0]
    generator = np.random.default_rng(1)
    for _ in range(steps):
        h.moved[:] = generator.normal(size=4)
        h.change[:] = (true * h.B) @ h.moved
        learn(DT, m, s, h)
    nonzero = np.abs(h.B) > 1e-9
    return np.where(nonzero, m.B / np.where(nonzero, h.B, 1.0), true), np.array(s.lambda_hat)


def test_increments_tell_the_input_matrix() -> None:
    """Half the left tail, 1.5 of a propeller: found to 1 %, and logged as effectiveness."""
    true = np.tile([0.6, 1.0, 1.5, 1.0], (4, 1))
    factors, effectiveness = learnt(true, 4000, mu_s=1.0)
    assert factors == pytest.approx(true, abs=0.01)
    assert effectiveness == pytest.approx(true[0], abs=0.01)


def test_without_adaptation_nothing_is_learnt() -> None:
    """Negative control of the test above."""
    assert learnt(np.full((4, 4), 0.6), 100, mu_s=0.0)[1] == pytest.approx(np.ones(4))


def test_no_element_leaves_its_bounds() -> None:
    """A lost one, one of five times the effect, and a reversed one: half or twice the first value, and no other sign."""
    factors, _ = learnt(np.tile([0.0, 5.0, -1.0, 1.0], (4, 1)), 4000, mu_s=1.0, factor_max=2.0)
    pitch = 1  # a row in which every actuator has an effect
    assert factors[pitch, :3] == pytest.approx([0.5, 2.0, 0.5])


def test_the_allocation_is_that_of_what_is_learnt() -> None:
    setup = vtail_setup(AdaptiveIndiSettings())
    controller = adaptive_indi(setup)
    m, _, k, _, _ = records_of(setup)
    m.B[:] *= 0.7
    weigh(m, k, controller._records[-1][0])
    assert k.hessian == pytest.approx(allocation_of(m.B, setup.released, setup.control.allocation)[1])


def test_a_weak_tail_is_learnt_in_flight(tmp_path: Path) -> None:
    weak = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0.4}]"
    flight = fly(scenario(tmp_path, "adaptive_indi", 40, weak, *WEATHER))
    log = readings(flight).log
    left, right = (
        float(log[f"{tail}_effectiveness_estimate"][-1]) for tail in ("left_ruddervator", "right_ruddervator")
    )
    assert left < 0.75 < right
    altitude, heading, _ = worst_errors(flight)
    assert (altitude < 5.0, heading < 15.0) == (True, True), (altitude, heading)
