"""Noise with given coefficients: still white, the rest unchanged, and each part from its own stream."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import kstest

from testbed.air.config import PARTS, Noise
from testbed.air.turbulence import cosine, white_noise

RATE, STEPS = 100, 400


def test_cosines_are_orthonormal() -> None:
    for length in (1, 7, 50):
        basis = np.array([cosine(i, length) for i in range(length)])
        np.testing.assert_allclose(basis @ basis.T, np.eye(length), atol=1e-12)


def test_given_coefficients_are_those_of_the_noise_and_no_other_changes() -> None:
    given = Noise(from_s=1.0, until_s=3.0, w=(0.5, -2.0, 0.0))
    plain, made = white_noise(None, RATE, STEPS, 7), white_noise(given, RATE, STEPS, 7)
    basis = np.array([cosine(i, 200) for i in range(200)])
    before, after = basis @ plain[100:300, 2], basis @ made[100:300, 2]
    np.testing.assert_allclose(after[:3], [0.5, -2.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(after[3:], before[3:], atol=1e-12)
    made[100:300, 2] = plain[100:300, 2]
    assert made.tobytes() == plain.tobytes()


def test_noise_of_normal_coefficients_is_white() -> None:
    draw = np.random.default_rng(3)
    rows = [
        white_noise(Noise(u=tuple(draw.standard_normal(20))), RATE, STEPS, seed)[:, 0] for seed in range(300)
    ]
    samples = np.array(rows)
    assert kstest(samples[:, ::40].ravel(), "norm").pvalue > 0.01
    correlated = np.corrcoef(samples[:, :40].T) - np.eye(40)
    assert np.max(np.abs(correlated)) < 5.0 / np.sqrt(300)


def test_parts_are_independent_and_from_the_seed() -> None:
    rows = white_noise(None, RATE, 100_000, 7)
    assert rows.tobytes() == white_noise(None, RATE, 100_000, 7).tobytes()
    together = np.corrcoef(rows.T, white_noise(None, RATE, 100_000, 8).T) - np.eye(2 * len(PARTS))
    assert np.max(np.abs(together)) < 5.0 / np.sqrt(100_000)


@pytest.mark.parametrize(
    ("window", "steps"),
    [({}, (0, 400)), ({"from_s": 1.0}, (100, 400)), ({"from_s": 0.5, "until_s": 9.0}, (50, 900))],
)
def test_window(window: dict[str, float], steps: tuple[int, int]) -> None:
    """It may end after the flight."""
    assert Noise(**window).window(RATE, STEPS) == steps


def test_a_shorter_flight_has_the_beginning_of_the_noise_of_a_longer_one() -> None:
    """With coefficients for the same window, which the shorter one does not reach the end of."""
    given = Noise(from_s=1.0, until_s=3.0, w=(0.5, -2.0, 0.0))
    assert white_noise(given, RATE, 250, 7).tobytes() == white_noise(given, RATE, 400, 7)[:250].tobytes()
