"""The reading of a flying wing, on one that is made here; the real data is not in the project."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from enac_logs import STEP_S, Flight, check
from enac_reading import (
    CLASSES,
    Settings,
    fitted,
    flags,
    matthews,
    noise,
    regression,
    told,
    true_class,
    window_errors,
)

from testbed.inputs.problems import BadInput

COUNT = 6000
JUDGED = (5.0, 590.0)


def _wing(level: np.ndarray, gain: float, seed: int) -> Flight:
    """p and q are first order, and answer to both elevons; `level` [rows, 2] is what is left of these."""
    rng = np.random.default_rng(seed)
    commands = np.cumsum(rng.normal(size=(COUNT, 2)), axis=0)
    commands = 0.1 * np.sin(0.2 * commands) + [0.15, -0.2]
    moved = level * np.stack([commands.sum(axis=1), commands[:, 1] - commands[:, 0]], axis=1)
    rates = np.zeros((COUNT, 3))
    for k in range(COUNT - 1):
        effect = gain * np.array([moved[k, 0] - moved[k, 1] - 0.3, moved[k].sum() + 0.4])
        rates[k + 1, :2] = 0.7 * rates[k, :2] + effect + 0.02 * rng.normal(size=2)
    return Flight(STEP_S * np.arange(COUNT), rates, commands)


@pytest.mark.parametrize("number", range(1, len(CLASSES)))
def test_a_weak_elevon_is_named_in_another_flight(number: int) -> None:
    """With the model of one flight, another with 10 % more gain: class, effectiveness, a flag in time and none before."""
    healthy, level = np.ones((COUNT, 2)), np.ones((COUNT, 2))
    level[3000:4500] = CLASSES[number]
    home = _wing(healthy, 1.0, 1)
    model = fitted(home, healthy, np.ones(COUNT, dtype=bool))
    colour = noise(regression(home, 0.0, healthy, model, JUDGED), 0.002)
    reading = told(
        regression(_wing(level, 1.1, number), 0.0, level, model, JUDGED), colour, Settings(0.002, 1.0, 14.0)
    )
    assert matthews(true_class(reading), reading.told) > 0.95
    assert np.abs(window_errors(reading)).max() < 0.1
    said = flags(reading, reading.told)
    assert (said.in_time, said.wrong, said.false) == (said.drops, 0, 0)
    assert said.drops == int(CLASSES[number].min() < 0.6)


def test_matthews() -> None:
    """1 for all right; 0 for one class said always; two classes as in Matthews (1975): (6 * 3 - 1 * 2) / sqrt(7 * 8 * 4 * 5)."""
    truth = np.repeat([0, 1], [8, 4])
    assert matthews(truth, truth) == pytest.approx(1.0)
    said = np.repeat([0, 1, 0, 1], [6, 2, 1, 3])
    assert matthews(truth, said) == pytest.approx((6 * 3 - 1 * 2) / np.sqrt(7 * 8 * 4 * 5))
    assert np.isnan(matthews(truth, np.zeros(12, dtype=int)))


def test_another_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="is missing"):
        check(tmp_path)
