"""Dryden turbulence of MIL-F-8785C and MIL-HDBK-1797B: intensities, lengths, and forming filters driven by white noise.

One-sided spectra over the spatial frequency Omega [rad/m], of the gusts u along and v, w across the path (MIL-F-8785C 3.7.1.2):

    Phi_u = sigma_u^2 2 L_u / pi / (1 + (L_u Omega)^2)
    Phi_v = sigma_v^2 L_v / pi (1 + 3 (L_v Omega)^2) / (1 + (L_v Omega)^2)^2, and the same for w

MIL-HDBK-1797B has 2 L_v in the place of L_v, and gives half of the length: below 1000 ft 2 L_v = L_u and 2 L_w = h, above 2000 ft
2 L_v = 2 L_w = L_u = 1750 ft. So the gusts of both have the same spectra. Lengths here are those of MIL-F-8785C.

The gust is not the same over the whole aircraft, which with its span b feels it as air that rotates (MIL-F-8785C 3.7.5):

    Phi_p = 0.8 sigma_w^2 / L_w (pi L_w / 4 b)^(1/3) / (1 + (4 b Omega / pi)^2), independent of the others
    q = -dw/dx through a lag of the length 4 b / pi; r = dv/dx through a lag of the length 3 b / pi

Flown through at the airspeed V, the turbulence has the frequency V Omega. The filters are, with T = L / V and white noise n of
spectral density 1,

    u / sigma = sqrt(2 T) / (1 + T s) n                  v / sigma = sqrt(T) (1 + sqrt(3) T s) / (1 + T s)^2 n

They are discretised exactly for noise that is held over a control step, with the airspeed and the altitude of that step.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import compiled
from testbed.common.units import METRES_PER_FOOT

LOW_FT, HIGH_FT = 1000.0, 2000.0
"""Altitudes above ground up to which the low-altitude model, and from which the high-altitude model holds; linear between."""
LEAST_FT = 10.0
"""Lowest altitude of the low-altitude model."""
HIGH_LENGTH_FT = 1750.0

EXCEEDED_FT = np.array([500.0, 1750, 3750, 7500, 15000, 25000, 35000, 45000, 55000, 65000, 75000, 80000])
EXCEEDED_FT_S = {
    3: np.array([6.6, 6.9, 7.4, 6.7, 4.6, 2.7, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0]),
    4: np.array([8.6, 9.6, 10.6, 10.1, 8.0, 6.6, 5.0, 4.2, 2.7, 0.0, 0.0, 0.0]),
    6: np.array([15.6, 17.6, 23.0, 23.6, 22.1, 20.0, 16.0, 15.1, 12.1, 7.9, 6.2, 5.1]),
}
"""Intensity [ft/s] at these altitudes, by the index of `config.severity`: MIL-F-8785C figure 7, as JSBSim reads it off."""

ROOT_3, ROOT_HALF = math.sqrt(3.0), math.sqrt(0.5)


@compiled
def intensities_and_lengths(altitude_m, w20_m_s, exceeded):
    """Intensities of u, v and of w [m/s], and lengths of u, v and of w [m].

    Args:
        altitude_m: above the ground.
        w20_m_s: wind at 20 ft.
        exceeded: [2, 12] altitudes [ft] and intensities [ft/s] of the high-altitude model.
    """
    h = max(altitude_m / METRES_PER_FOOT, LEAST_FT)
    low = min(h, LOW_FT)
    f = 0.177 + 0.000823 * low
    sigma_w, length_w = 0.1 * w20_m_s, low
    sigma_u, length_u = sigma_w / math.pow(f, 0.4), low / math.pow(f, 1.2)
    if h > LOW_FT:
        share = min((h - LOW_FT) / (HIGH_FT - LOW_FT), 1.0)
        high = METRES_PER_FOOT * _interpolated(max(h, HIGH_FT), exceeded)
        sigma_u += share * (high - sigma_u)
        sigma_w += share * (high - sigma_w)
        length_u += share * (HIGH_LENGTH_FT - length_u)
        length_w += share * (HIGH_LENGTH_FT - length_w)
    return sigma_u, sigma_w, length_u * METRES_PER_FOOT, length_w * METRES_PER_FOOT


@compiled
def _interpolated(x, table):
    """The second row of a table [2, n] at x of the first, constant beyond its ends."""
    last = table.shape[1] - 1
    if x <= table[0, 0]:
        return table[1, 0]
    for i in range(last):
        if x < table[0, i + 1]:
            share = (x - table[0, i]) / (table[0, i + 1] - table[0, i])
            return table[1, i] + share * (table[1, i + 1] - table[1, i])
    return table[1, last]


@compiled
def along(step, noise, state):
    """Next gust u / sigma: first order, exact for noise held over the step.

    Args:
        step: V dt / L_u.
        noise: standard normal.
        state: [1] of the filter, updated.
    """
    kept = math.exp(-step)
    state[0] = kept * state[0] + (1.0 - kept) * math.sqrt(2.0 / step) * noise
    return state[0]


@compiled
def across(step, noise, state):
    """Next gust v / sigma or w / sigma: `along` with a second lag of the same T behind it.

    (1 + sqrt(3) T s) / (1 + T s)^2 is sqrt(3) / (1 + T s) + (1 - sqrt(3)) / (1 + T s)^2.
    """
    kept = math.exp(-step)
    held = math.sqrt(2.0 / step) * noise
    state[1] = kept * (state[1] + step * state[0]) + (1.0 - kept - step * kept) * held
    state[0] = kept * state[0] + (1.0 - kept) * held
    return ROOT_HALF * (ROOT_3 * state[0] + (1.0 - ROOT_3) * state[1])


@compiled
def rolling_intensity(sigma_w, length_w, span):
    """Intensity of p [rad/s] for a wing of this span [m]: the integral of Phi_p."""
    shape = math.pow(0.25 * math.pi * length_w / span, 1.0 / 3.0)
    return sigma_w * math.sqrt(0.1 * math.pi * math.pi / (length_w * span) * shape)


@compiled
def slope(step, length, gust, state):
    """Derivative of a gust along the path [1/s] through a lag, exact for a gust that is held over the step.

    Args:
        step: V dt over the length of the lag.
        length: of the lag [m].
        gust: [m/s].
        state: [1] the lagged gust, updated.
    """
    derivative = (gust - state[0]) / length
    state[0] += (1.0 - math.exp(-step)) * (gust - state[0])
    return derivative
