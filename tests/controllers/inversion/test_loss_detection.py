"""The monitor: what flags an actuator as lost, and what takes a flag back."""

from __future__ import annotations

import pytest
from vtail_setup import WEATHER, records_of, vtail_setup

from testbed.controllers.inversion.evidence import SLOW_S
from testbed.controllers.inversion.loss_detection import monitor

SETUP = vtail_setup()
MODEL = SETUP.model


def test_only_an_estimate_that_is_certain_flags() -> None:
    m, c, _, s, _ = records_of(vtail_setup(WEATHER))
    s.lambda_hat[0] = 0.05
    for variance, failed in ((0.16**2, 0), (0.14**2, 1)):
        s.P[0, 0] = variance
        changed = [monitor(m, c, s) for _ in range(41)]
        assert s.failed[0] == failed and sum(changed) == failed
    assert s.jammed[0] == 0


@pytest.mark.parametrize(
    ("before", "others", "failed"),
    [
        (0.15, (1.0, 1.0, 1.0), 1),
        (0.15, (1.0, 0.7, 1.0), 0),  # another one has changed more
        (0.15, (1.2, 1.0, 1.0), 0),  # another one is at its limit
        (0.9, (1.2, 0.7, 1.0), 1),  # so much is lost at once by a failure alone
    ],
)
def test_a_weak_actuator_is_flagged_only_if_it_is_to_blame(
    before: float, others: tuple[float, ...], failed: int
) -> None:
    m, c, _, s, _ = records_of(vtail_setup(WEATHER))
    s.lambda_slow[0], s.lambda_hat[0], s.lambda_hat[1:] = before, 0.05, others
    s.lambda_slow[1] = others[0]
    changed = [monitor(m, c, s) for _ in range(22)]
    assert s.failed[0] == failed and sum(changed) == failed


def test_a_flag_that_came_early_and_was_taken_back_comes_again_only_after_a_wait() -> None:
    m, c, _, s, _ = records_of(vtail_setup(WEATHER))
    s.lambda_hat[0] = 0.03
    first = [monitor(m, c, s) for _ in range(100)].index(1)
    assert first == round(c.persistence / c.dt) and s.early[0] == 1
    s.failed[0] = 0
    s.lambda_hat[0] = c.threshold + 0.01
    assert not any(monitor(m, c, s) for _ in range(1000))
    s.lambda_hat[0] = c.threshold - 0.01
    second = [monitor(m, c, s) for _ in range(1000)].index(1)
    assert second == round(SLOW_S / c.dt) and s.failed[0] == 1 and s.early[0] == 0


def test_a_flag_is_taken_back_after_the_recovery_time() -> None:
    m, c, _, s, _ = records_of(SETUP)
    s.failed[2], s.lambda_hat[2] = 1, 0.7
    changed = [monitor(m, c, s) for _ in range(300)]
    assert changed.index(1) == round(c.recovery_time / c.dt)
    assert s.failed[2] == 0 and s.since_flag[2] == pytest.approx((300 - 201) * c.dt)


@pytest.mark.parametrize(
    ("estimate", "deviation", "recovered"), [(0.5, 0.1, True), (0.5, 0.3, False), (0.07, 0.01, False)]
)
def test_what_is_above_the_threshold_beyond_doubt_is_used_again(
    estimate: float, deviation: float, recovered: bool
) -> None:
    """A healthy engine whose drag the model had wrong seemed to give half, and was given up for as long."""
    m, c, _, s, _ = records_of(vtail_setup(WEATHER))
    s.failed[0], s.lambda_hat[0], s.P[0, 0] = 1, estimate, deviation**2
    assert any(monitor(m, c, s) for _ in range(300)) == recovered
    assert s.failed[0] == (not recovered)


def test_a_jammed_actuator_is_not_monitored() -> None:
    m, c, _, s, _ = records_of(SETUP)
    s.jammed[1], s.failed[1], s.lambda_hat[1] = 1, 1, 2.0
    assert not any(monitor(m, c, s) for _ in range(1000))
    assert s.failed[1] == 1
