"""The flying functions of `l1_inversion` and of the paper's law have the speed and the variance of their poles."""

from __future__ import annotations

import math

import numpy as np
import pytest
from paper.l1_plant import l1_effects, measured

from paper import decoupling


@pytest.mark.parametrize(
    ("gamma", "k", "measure"),
    [
        (2.0, None, decoupling.PAPER),
        (2.0, 2.0, decoupling.cascade(2.0, 2.0)),
        (20.0, 2.0, decoupling.cascade(20.0, 2.0)),
    ],
)
def test_eq_32_speed_times_variance_is_that_of_the_poles(
    gamma: float, k: float | None, measure: float
) -> None:
    """960 s with a correlation time of about half a second: 4 standard errors of the variance are 4 sqrt(2 / 960)."""
    time, variance = measured(gamma, k)
    assert time * variance == pytest.approx(measure, rel=4.0 * math.sqrt(2.0 / 960.0))


def test_equal_poles_beat_the_paper_by_more_than_the_error_of_the_measurement() -> None:
    """What decoupling can gain is a fifth: 1.19 beside 1.50, at the same noise."""
    equal, alone = measured(2.0, 2.0), measured(2.0, None)
    assert equal[0] * equal[1] < 0.87 * alone[0] * alone[1]


def test_a_loss_is_made_up_for_as_slowly_as_little_is_left() -> None:
    """After a loss to 0.2 the effect comes back with the time constant 1 / (k lambda), five times later than after a small one."""
    dt, k = 0.001, 5.0
    truth = np.where(np.arange(8000) < 10, 1.0, 0.2)
    effect = l1_effects(400.0, k, truth, np.zeros((8000, 4)), dt)[:, 0]
    time = np.flatnonzero(np.abs(effect[10:] - 1.0) > 0.05)[-1] * dt
    # The channel begins with an effect of 0.2 and ends at 1: 0.8 exp(-k lambda t) is 0.05 after ln 16 time constants.
    assert time == pytest.approx(math.log(0.8 / 0.05) / (k * 0.2), rel=0.02)
