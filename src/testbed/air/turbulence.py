"""Dryden turbulence of MIL-F-8785C and MIL-HDBK-1797B: in each control step the gusts at the present airspeed and altitude, from
forming filters driven by white noise, turned to the ground's axes.

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

The noise is from the flight's seed, with its first coefficients given if so asked. A flight has thousands of samples of it, too
many for a search to move one by one. Some of it moves together if the noise in a window of N samples is written as a sum of
orthonormal cosines,

    n_k = sum over i of c_i phi_i(k), phi_i(k) = sqrt(2/N) cos(pi i (k + 1/2) / N), phi_0(k) = sqrt(1/N)

The c_i of white noise are independent standard normals again. Cosine i has the frequency i / (2 D) in a window of D seconds.
Cosines are the Karhunen-Loeve basis of a stationary process in a long window, the lowest first: those that give most of
a gust's variance come first, because its spectrum falls with frequency.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from testbed.air.config import PARTS, Atmosphere, Noise, severity
from testbed.common.jit import bound, compiled
from testbed.common.random_streams import generator
from testbed.common.signals import STATE, longer
from testbed.common.units import METRES_PER_FOOT

if TYPE_CHECKING:
    from testbed.plant.jsbsim import Plant

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
_ALTITUDE, _AIRSPEED, _HEADING = map(STATE.index, ("altitude", "airspeed", "heading"))
_LEAST_AIRSPEED_M_S = 1.0
"""Below this the turbulence passes by as at this airspeed."""
_RECORD = np.dtype(
    [
        ("w20", float),  # [m/s]
        ("dt", float),  # control step [s]
        ("span", float),  # [m]
        ("exceeded", float, (2, len(EXCEEDED_FT))),  # see `intensities_and_lengths`
        ("factors", float, len(STATE)),  # of the plant
        ("air_factors", float, 6),
        ("states", float, 8),  # of the filters
        ("mean_wind", float, 3),  # wind without turbulence [m/s, north, east, down]
        ("air", float, 6),  # what the plant is told
    ]
)


class Turbulence:
    """Gusts of one flight, which build up from zero.

    u is along the heading, v to its right, w down: horizontal axes, as MIL-F-8785C has them at low altitude.

    Attributes:
        wind: [steps, 3] velocity of the air at the beginning of each step, which was set in the step before
            [m/s, north, east, down].
    """

    def __init__(self, settings: Atmosphere, plant: Plant, rate_hz: int, steps: int, seed: int) -> None:
        self._plant, self._blow = plant, plant.blow
        self._rate_hz, self._seed = rate_hz, seed
        w20 = settings.turbulence_w20_m_s
        self._record = np.zeros(1, _RECORD).view(np.recarray)
        (record,) = self._record
        record.w20, record.dt, record.span = w20, 1.0 / rate_hz, plant.span_m
        record.exceeded = EXCEEDED_FT, EXCEEDED_FT_S[severity(w20)]
        record.factors, record.air_factors = plant.factors[: len(STATE)], plant.air_factors
        self._mean, self._air = record.mean_wind, record.air
        self._values = memoryview(self._air)  # its items are floats, which numpy's are not
        self.wind = np.zeros((0, 3))
        self.lengthen(settings.noise, steps)
        self._fill = bound(blow, 0, self._arrays)

    def lengthen(self, noise: Noise | None, steps: int) -> None:
        """Take more control steps. Noise and wind so far stay as they are, if the window of the noise given has an end."""
        self.wind = longer(self.wind, steps)
        drawn = white_noise(noise, self._rate_hz, steps, self._seed)
        self._arrays = (self._plant.raw, drawn, self._record, self.wind)

    def begin(self, mean_m_s: np.ndarray) -> None:
        """Sample the plant that was placed, on whose state the first gust depends; then as `over`."""
        self._plant.sample()
        self.over(mean_m_s)
        self.wind[:1] = mean_m_s

    def over(self, mean_m_s: np.ndarray) -> None:
        """Take a new mean wind, on which the turbulence is added [m/s, north, east, down]."""
        self._mean[:] = mean_m_s

    def step(self, k: int) -> None:
        """Set the air of control step k."""
        self._fill(k, self._arrays)
        self._blow(self._values)


def white_noise(settings: Noise | None, rate_hz: int, steps: int, seed: int) -> np.ndarray:
    """[steps, 4] standard normals for `PARTS`, each from its own stream, with the coefficients of the settings in their window.

    The noise of a longer flight begins with that of a shorter one, if the window is the same.
    """
    window = slice(0, 0) if settings is None else slice(*settings.window(rate_hz, steps))
    rows = np.empty((max(steps, window.stop), len(PARTS)))
    for i, part in enumerate(PARTS):
        rows[:, i] = generator(seed, f"gust {part}").standard_normal(len(rows))
        if settings is not None:
            rows[window, i] = with_coefficients(rows[window, i], getattr(settings, part))
    return rows[:steps]


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


@compiled
def blow(k, arrays):
    """Fill the motion of the air in step k: its velocity north, east, down, and its rotation p, q, r, in the plant's units.

    Args:
        k: the control step.
        arrays: raw of the plant; noise [steps, 4]; the record [1] of `_RECORD`, of which `states` are updated and `air` is
            filled; and wind [steps, 3], of which row k + 1 is filled.
    """
    raw, noise, records, wind = arrays
    of = records[0]
    sigma_u, sigma_w, length_u, length_w = intensities_and_lengths(
        raw[_ALTITUDE] * of.factors[_ALTITUDE], of.w20, of.exceeded
    )
    flown = max(raw[_AIRSPEED] * of.factors[_AIRSPEED], _LEAST_AIRSPEED_M_S) * of.dt
    states = of.states
    u = sigma_u * along(flown / length_u, noise[k, 0], states[0:1])
    v = sigma_u * across(flown / length_u, noise[k, 1], states[1:3])
    w = sigma_w * across(flown / length_w, noise[k, 2], states[3:5])
    length_q, length_r = 4.0 * of.span / math.pi, 3.0 * of.span / math.pi
    sigma_p = rolling_intensity(sigma_w, length_w, of.span)
    heading = raw[_HEADING] * of.factors[_HEADING]
    cos, sin = math.cos(heading), math.sin(heading)
    air = of.air
    air[0] = of.mean_wind[0] + cos * u - sin * v
    air[1] = of.mean_wind[1] + sin * u + cos * v
    air[2] = of.mean_wind[2] + w
    air[3] = sigma_p * along(flown / length_q, noise[k, 3], states[5:6])
    air[4] = -slope(flown / length_q, length_q, w, states[6:7])
    air[5] = slope(flown / length_r, length_r, v, states[7:8])
    if k + 1 < len(wind):
        for i in range(3):  # numba would allocate a copy of a slice
            wind[k + 1, i] = air[i]
    for i in range(len(air)):
        air[i] *= of.air_factors[i]


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
