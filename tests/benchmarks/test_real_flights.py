"""The reading of a flying wing, on one that is made here; the real data is not in the project."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from enac_filter import moments_of
from enac_logs import STEP_S, Flight, check
from enac_reading import (
    CLASSES,
    Regression,
    Settings,
    drops,
    errors,
    fitted,
    flags,
    matthews,
    raised,
    reachable,
    regression,
    told,
    true_class,
    window_errors,
)

from testbed.inputs.problems import BadInput

COUNT = 6000
JUDGED = (5.0, 590.0)


def _wing(level: np.ndarray, gain: float, seed: int, gusts: float = 0.02) -> Flight:
    """p and q are first order, and answer to both elevons; `level` [rows, 2] is what is left of these."""
    rng = np.random.default_rng(seed)
    commands = np.cumsum(rng.normal(size=(COUNT, 2)), axis=0)
    commands = 0.1 * np.sin(0.2 * commands) + [0.15, -0.2]
    moved = level * np.stack([commands.sum(axis=1), commands[:, 1] - commands[:, 0]], axis=1)
    rates = np.zeros((COUNT, 3))
    for k in range(COUNT - 1):
        effect = gain * np.array([moved[k, 0] - moved[k, 1] - 0.3, moved[k].sum() + 0.4])
        rates[k + 1, :2] = 0.7 * rates[k, :2] + effect + gusts * rng.normal(size=2)
    return Flight(STEP_S * np.arange(COUNT), rates, commands)


@pytest.mark.nightly
@pytest.mark.parametrize("number", range(1, len(CLASSES)))
def test_a_weak_elevon_is_named_in_another_flight(number: int) -> None:
    """With the model of one flight, another with 10 % more gain: class, effectiveness, a flag in time and none before."""
    healthy, level = np.ones((COUNT, 2)), np.ones((COUNT, 2))
    level[3000:4500] = CLASSES[number]
    home = _wing(healthy, 1.0, 1)
    model = fitted(home, healthy, np.ones(COUNT, dtype=bool))
    moments = moments_of(errors(regression(home, 0.0, healthy, model, JUDGED)))
    data = regression(_wing(level, 1.1, number), 0.0, level, model, JUDGED)
    reading = told(data, moments, Settings(6.0, 8.0, 0.98))
    truth = true_class(reading.truth)
    assert matthews(truth, reading.told) > 0.95
    in_flight = np.abs(CLASSES[reading.told_in_flight] - reading.truth).max(axis=1)
    assert np.mean(in_flight < 0.11) > 0.98  # the gain is not known: 1.1 times 0.6 is between two classes
    assert np.abs(window_errors(reading)).max() < 0.1
    sudden = int(CLASSES[number].min() < 0.45)
    assert len(drops(reading.truth)) == sudden
    for flagged in (reading.flagged, reading.flagged_in_flight):
        said = flags(reading.time_s, reading.truth, flagged)
        assert (int(np.sum(said.delays_s <= 3.0)), said.wrong, said.false) == (sudden, 0, 0)


def test_the_model_of_a_flight_is_that_of_the_wing_and_leaves_its_gusts() -> None:
    """Rates, constants, and the elevons at once; of a wing with twice the gain it leaves more."""
    healthy = np.ones((COUNT, 2))
    home, strong = _wing(healthy, 1.0, 1), _wing(healthy, 2.0, 2)
    model = fitted(home, healthy, np.ones(COUNT, dtype=bool))
    wing = [[0.7, 0.0], [0.0, 0.7], [0.0, 0.0], [-0.3, 0.4], [1.0, 1.0], [-1.0, 1.0], *[[0.0, 0.0]] * 6]
    np.testing.assert_allclose(model, wing, atol=0.1)
    left = []
    for flight in (home, strong):
        data = regression(flight, 0.0, healthy, model, JUDGED)
        left.append(np.std(errors(data)))
    assert left[0] == pytest.approx(0.02, rel=0.05) and left[1] > 2.0 * left[0]


def test_a_flag_stays_until_weakness_is_unlikely() -> None:
    """From 0.98 on, until below 0.1, of each elevon by itself."""
    right = [0.5, 0.97, 0.99, 0.2, 0.05, 0.9]
    flagged = raised(np.column_stack([right, np.zeros(6)]), 0.98)
    assert flagged[:, 0].tolist() == [False, False, True, True, False, False] and not flagged[:, 1].any()


@pytest.mark.nightly
def test_gusts_are_no_failures() -> None:
    """Errors three times those of the flight that the model is of: the size that was learnt there would make them failures."""
    healthy = np.ones((COUNT, 2))
    home, gusty = _wing(healthy, 1.0, 1), _wing(healthy, 1.0, 3, 0.06)
    model = fitted(home, healthy, np.ones(COUNT, dtype=bool))
    moments = moments_of(errors(regression(home, 0.0, healthy, model, JUDGED)))
    reading = told(regression(gusty, 0.0, healthy, model, JUDGED), moments, Settings(6.0, 8.0, 0.98))
    assert not reading.flagged.any() and not reading.flagged_in_flight.any()


def test_what_can_be_reached() -> None:
    """White noise s, and a drop by .7 of a column c in 30 samples: Phi(.7 c sqrt(30) / s - 2.935), 1/600 being false in 3 s."""
    rng = np.random.default_rng(1)
    truth, phi = np.ones((COUNT, 2)), np.zeros((COUNT, 2, 2))
    for at in range(700, 5300, 500):
        truth[at : at + 100, 0] = 0.3
    phi[:, 0, 0] = rng.choice([-1.0, 1.0], COUNT) * 3.0 / (0.7 * np.sqrt(30.0))
    for size, expected in ((1.0, 0.526), (2.0, 0.0757)):
        z = np.einsum("kri,ki->kr", phi, truth) + size * rng.normal(size=(COUNT, 2))
        chance = reachable(Regression(STEP_S * np.arange(COUNT), z, phi, truth), 1.0)
        assert len(chance) == 10 and np.mean(chance) == pytest.approx(expected, abs=0.05)


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
