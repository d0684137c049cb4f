"""Dryden's formulas against figures and integrals of the specifications, and the filters against the spectra."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import quad

from testbed.air.turbulence import (
    EXCEEDED_FT,
    EXCEEDED_FT_S,
    across,
    along,
    intensities_and_lengths,
    rolling_intensity,
    slope,
)

FT = 0.3048
W20 = 7.62
LIGHT = np.array([EXCEEDED_FT, EXCEEDED_FT_S[3]])


def in_feet(height_ft: float) -> np.ndarray:
    """sigma_u, sigma_w [ft/s], length_u, length_w [ft], for W20 = 25 ft/s."""
    return np.array(intensities_and_lengths(height_ft * FT, W20, LIGHT)) / FT


@pytest.mark.parametrize("height_ft", [10.0, 20.0, 200.0, 984.0, 1000.0])
def test_low_altitude(height_ft: float) -> None:
    """MIL-F-8785C 3.7.3.4: figures 10 and 11."""
    f = 0.177 + 0.000823 * height_ft
    expected = [2.5 / f**0.4, 2.5, height_ft / f**1.2, height_ft]
    np.testing.assert_allclose(in_feet(height_ft), expected, rtol=1e-12)


def test_altitudes_between_and_beyond() -> None:
    np.testing.assert_allclose(in_feet(3.0), in_feet(10.0), rtol=1e-15)
    np.testing.assert_allclose(in_feet(1000.0), [2.5, 2.5, 1000.0, 1000.0], rtol=1e-12)
    np.testing.assert_allclose(in_feet(7500.0), [6.7, 6.7, 1750.0, 1750.0], rtol=1e-12)
    np.testing.assert_allclose(in_feet(11250.0), [5.65, 5.65, 1750.0, 1750.0], rtol=1e-12)
    assert in_feet(90_000.0)[0] == 0.0
    np.testing.assert_allclose(in_feet(1500.0), (in_feet(1000.0) + in_feet(2000.0)) / 2.0, rtol=1e-12)


def phi_u(length: float, omega: float) -> float:
    return 2.0 * length / math.pi / (1.0 + (length * omega) ** 2)


def phi_v_8785c(length: float, omega: float) -> float:
    x = (length * omega) ** 2
    return length / math.pi * (1.0 + 3.0 * x) / (1.0 + x) ** 2


def phi_v_1797b(length: float, omega: float) -> float:
    x = (length * omega) ** 2
    return 2.0 * length / math.pi * (1.0 + 12.0 * x) / (1.0 + 4.0 * x) ** 2


@pytest.mark.parametrize("height_ft", [200.0, 1000.0, 5000.0])
def test_both_specifications_say_the_same(height_ft: float) -> None:
    """With the lengths that each gives: 1797B has 2 L_v = L_u and 2 L_w = h, above 2000 ft L_u = 2 L_v = 2 L_w = 1750 ft."""
    *_, length_u, length_w = in_feet(height_ft)
    for omega in np.geomspace(1e-5, 1.0, 20):
        for length in (length_u, length_w):
            assert phi_v_8785c(length, omega) == pytest.approx(phi_v_1797b(length / 2.0, omega), rel=1e-12)
    assert phi_v_8785c(length_w, 0.1) > 1.9 * phi_v_1797b(length_w, 0.1)


def response(filter: Callable[..., float], step: float, states: int, samples: int = 200_000) -> np.ndarray:
    """What a filter answers to one sample of noise."""
    state = np.zeros(states)
    return np.array([filter(step, float(k == 0), state) for k in range(samples)])


@pytest.mark.parametrize(
    ("filter", "states", "spectrum", "correlation"),
    [
        (along, 1, phi_u, lambda x: np.exp(-x)),
        (across, 2, phi_v_8785c, lambda x: np.exp(-x) * (1.0 - x / 2.0)),
    ],
    ids=["along", "across"],
)
def test_filters_have_spectrum_variance_and_correlation(
    filter: Callable[..., float],
    states: int,
    spectrum: Callable[[float, float], float],
    correlation: Callable[[np.ndarray], np.ndarray],
) -> None:
    """Of the response to one sample, without any sampling error. A length L of 200 steps; noise that is held loses (step)^2 / 12
    of the variance, and bends the spectrum by sinc^2: 1 % at a tenth of Nyquist, with what is folded back."""
    step = 1.0 / 200.0
    answer = response(filter, step, states, 2**15)
    power = np.abs(np.fft.rfft(answer, 2**16)) ** 2
    assert np.sum(answer**2) == pytest.approx(1.0, abs=step**2)
    omega = np.linspace(0.0, math.pi, len(power))  # [rad per sample]
    for i in np.unique(np.geomspace(1, 0.1 * len(power), 40).astype(int)):
        expected = spectrum(1.0, omega[i] / step) * math.pi / step  # L = 1; per [rad per sample], one-sided
        assert power[i] == pytest.approx(expected, rel=0.01)
    lags = np.arange(0, 1000, 50)
    found = [float(answer[: len(answer) - lag] @ answer[lag:]) for lag in lags]
    np.testing.assert_allclose(found, correlation(lags * step), atol=1e-4)


def test_a_filter_that_is_run_faster_has_the_same_length() -> None:
    """Twice the steps, each half as long: the correlation over one length is the same."""
    for step in (0.02, 0.01):
        answer, lag = response(across, step, 2, 5000), round(1.0 / step)
        assert float(answer[:-lag] @ answer[lag:]) == pytest.approx(0.5 * math.exp(-1.0), abs=1e-4)


def test_intensity_of_rolling_is_the_integral_of_its_spectrum() -> None:
    sigma, length, span = 0.76, 300.0, 2.2
    constant = 0.8 * sigma**2 / length * (math.pi * length / (4.0 * span)) ** (1.0 / 3.0)
    area, _ = quad(lambda omega: constant / (1.0 + (4.0 * span * omega / math.pi) ** 2), 0.0, math.inf)
    assert rolling_intensity(sigma, length, span) == pytest.approx(math.sqrt(area), rel=1e-9)


@pytest.mark.parametrize("waves_per_length", [0.02, 0.2, 1.0])
def test_slope_is_a_lagged_derivative(waves_per_length: float) -> None:
    """Amplitude of the answer to a sine of Omega: Omega / sqrt(1 + (length Omega)^2)."""
    length, step = 2.8, 0.002
    omega = 2.0 * math.pi * waves_per_length / length
    state = np.zeros(1)
    distance = np.arange(200_000) * step * length
    found = np.array([slope(step, length, gust, state) for gust in np.sin(omega * distance)])
    expected = omega / math.sqrt(1.0 + (length * omega) ** 2)
    assert np.max(found[100_000:]) == pytest.approx(expected, rel=0.01)
