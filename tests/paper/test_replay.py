"""A replayed estimate is that of the flying law."""

from __future__ import annotations

import numpy as np
import pytest
from paper.bandwidth import late_extreme
from paper.ideal import UNLIMITED, IdealLoop, IdealPlant, Tuning
from paper.replay import Behind, replay

DT = 0.005


@pytest.mark.parametrize(("modelled", "rate"), [(0.0, UNLIMITED), (12.0, UNLIMITED), (0.0, 9.0), (12.0, 2.0)])
def test_eq_13_replayed_is_what_the_flying_law_does(modelled: float, rate: float) -> None:
    """One actuator by itself, plain and with a wrong model of its servo, a moving reference and a loss: the same estimates."""
    steps, lag = 1500, 8.0
    r = 0.4 + 0.5 * np.sin(0.02 * np.arange(steps))
    truth = np.where(np.arange(steps) < 500, 1.0, 0.3)
    loop = IdealLoop(IdealPlant(np.eye(4), lag=lag, rate=rate), Tuning(4.0, 0.05, DT), 1.0)
    loop._models["lag"][0], loop._models["rate"][0] = modelled, UNLIMITED
    loop.start_at(np.full(4, r[0]))
    flown = loop.fly(np.tile(r[:, None], (1, 4)), np.tile(truth[:, None], (1, 4))).lambda_hat[1:, 0]
    replayed = replay(r, truth, Behind(lag, modelled, rate=rate), 4.0, 0.05, DT)
    assert replayed == pytest.approx(flown, rel=1e-9)
    free = replay(r, truth, Behind(lag, modelled), 4.0, 0.05, DT)
    assert bool(np.abs(free - flown).max() > 1e-3) is (rate < UNLIMITED)


def test_late_rates_are_replayed_as_the_delay_that_they_are() -> None:
    gamma, steps = 0.5, 20
    truth = np.where(np.arange(1500) < 10, 1.0, 0.2)
    found = replay(np.ones(1500), truth, Behind(age=steps * DT), gamma / (steps * DT), 1e-9, DT)
    assert found.min() == pytest.approx(late_extreme(1.0, 0.2, gamma, steps), rel=1e-9)
