"""False alarms of the monitor under white noise: the Markov chain against the flying law on its ideal plant."""

from __future__ import annotations

import math

import numpy as np
import pytest
from paper.ideal import IdealLoop, IdealPlant, Tuning
from paper.noise import shape_for

from paper import noise
from testbed.gains.false_alarms import POSITION, REFERENCE, false_alarm_rate

GAMMA, DT, R = 2.0, 0.005, 0.5


def alarms(nu: float, threshold: float, persistence_s: float, held: int, seconds: float) -> np.ndarray:
    """Alarms of the flying monitor in each of the actuators' runs; a flag is removed at once when the estimate is back."""
    tuning = Tuning(GAMMA, 0.01, DT, threshold=threshold, recovery=threshold, persistence_s=persistence_s)
    loop = IdealLoop(IdealPlant(np.eye(4)), tuning)
    loop._settings["recovery_time"] = 0.0
    if held == POSITION:
        for name in ("low", "high"):
            loop._models[name] = R
    s = 2.0 * R * R / (GAMMA * nu)
    rng = np.random.default_rng(3)
    steps = round(seconds / DT / 20)
    count = np.zeros(4)
    for _ in range(20):
        flown = loop.fly(np.full((steps, 4), R), 1.0, math.sqrt(s / DT) * rng.normal(size=(steps, 4)))
        count += (np.diff(flown.failed, axis=0) > 0).sum(axis=0)
    return count


@pytest.mark.nightly
@pytest.mark.parametrize("held", [REFERENCE, POSITION])
@pytest.mark.parametrize(("threshold", "persistence_s"), [(0.7, 0.0), (0.7, 0.1)])
def test_the_chain_predicts_the_flying_monitor(held: int, threshold: float, persistence_s: float) -> None:
    """Within four standard errors of a Poisson count, and the cells' 3 %; more than 400 alarms, so that this decides."""
    nu, seconds = 20.0, 2000.0
    count = alarms(nu, threshold, persistence_s, held, seconds).sum()
    wanted = false_alarm_rate(nu, GAMMA, DT, persistence_s, threshold, held) * 4.0 * seconds
    assert count > 400
    assert abs(count - wanted) <= 4.0 * math.sqrt(2.0 * wanted) + 0.03 * wanted


@pytest.mark.nightly
def test_the_chain_has_the_stationary_law() -> None:
    """Without persistence the alarms are the entries below the threshold; more noise, a higher threshold and less persistence
    give more."""
    for held in (REFERENCE, POSITION):
        rates = [false_alarm_rate(nu, GAMMA, DT, 0.1, 0.6, held) for nu in (10.0, 20.0, 40.0)]
        assert rates[0] > rates[1] > rates[2] > 0.0
        assert false_alarm_rate(20.0, GAMMA, DT, 0.1, 0.5, held) < rates[1]
        assert false_alarm_rate(20.0, GAMMA, DT, 0.2, 0.6, held) < rates[1]
    assert false_alarm_rate(math.inf, GAMMA, DT, 0.1, 0.6) == 0.0


@pytest.mark.nightly
def test_shape_for_inverts_the_rate() -> None:
    """The nu for one alarm in ten hours: to 1 % the least, and more where the position is held."""
    tolerated = 1.0 / 36000.0
    for persistence_s in (0.1,):
        found = shape_for(tolerated, GAMMA, DT, persistence_s, 0.3, REFERENCE)
        assert false_alarm_rate(found, GAMMA, DT, persistence_s, 0.3, REFERENCE) <= tolerated
        assert false_alarm_rate(0.97 * found, GAMMA, DT, persistence_s, 0.3, REFERENCE) > tolerated
    assert shape_for(tolerated, GAMMA, DT, 0.1, 0.3, POSITION) > found
    assert noise.deviation(found) < 1.0
