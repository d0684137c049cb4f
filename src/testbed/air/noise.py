"""The white noise that drives turbulence: from the flight's seed, with its first coefficients given if so asked.

A flight has thousands of samples of noise, too many for a search to move one by one. Some of it moves together if the noise
in a window of N samples is written as a sum of orthonormal cosines,

    n_k = sum over i of c_i phi_i(k), phi_i(k) = sqrt(2/N) cos(pi i (k + 1/2) / N), phi_0(k) = sqrt(1/N)

The c_i of white noise are independent standard normals again. Cosine i has the frequency i / (2 T) in a window of T seconds.
Cosines are the Karhunen-Loeve basis of a stationary process in a long window, the lowest first: those that give most of
a gust's variance come first, because its spectrum falls with frequency.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from testbed.air.config import PARTS, Noise
from testbed.common.random_streams import generator
from testbed.common.signals import first_step_at


def white_noise(settings: Noise | None, rate_hz: int, steps: int, seed: int) -> np.ndarray:
    """[steps, 4] standard normals for `PARTS`, each from its own stream, with the coefficients of the settings in their window.

    The noise of a longer flight begins with that of a shorter one, if the window is the same.
    """
    window = slice(0, 0) if settings is None else slice(*window_of(settings, rate_hz, steps))
    rows = np.empty((max(steps, window.stop), len(PARTS)))
    for i, part in enumerate(PARTS):
        rows[:, i] = generator(seed, f"gust {part}").standard_normal(len(rows))
        if settings is not None:
            rows[window, i] = with_coefficients(rows[window, i], getattr(settings, part))
    return rows[:steps]


def window_of(settings: Noise, rate_hz: int, steps: int) -> tuple[int, int]:
    """First control step of the window, and the step after its last, which may be after the flight's end."""
    end = steps if settings.until_s is None else first_step_at(settings.until_s, rate_hz)
    return first_step_at(settings.from_s, rate_hz), end


def cosine(i: int, length: int) -> np.ndarray:
    """[length] phi_i."""
    phase = np.pi * i * (np.arange(length) + 0.5) / length
    return np.cos(phase) * np.sqrt((2.0 if i else 1.0) / length)


def with_coefficients(noise: np.ndarray, coefficients: Sequence[float]) -> np.ndarray:
    """[N] the noise, of which the first coefficients have these values; the others stay as they are."""
    made = np.array(noise)
    for i, wanted in enumerate(coefficients):
        basis = cosine(i, len(made))
        # not @, whose last bit depends on the number of threads
        made += (wanted - np.sum(basis * made)) * basis
    return made
