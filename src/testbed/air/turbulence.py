"""Dryden turbulence in flight: in each control step the gusts at the present airspeed and altitude, turned to the ground's axes."""
# mypy: allow-untyped-defs

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from testbed.air import dryden
from testbed.air.config import Atmosphere, Noise, severity
from testbed.air.dryden import across, along, intensities_and_lengths, rolling_intensity, slope
from testbed.air.noise import white_noise
from testbed.common.jit import bound, compiled
from testbed.common.signals import STATE, longer

if TYPE_CHECKING:
    from testbed.plant.jsbsim import Plant

_ALTITUDE, _AIRSPEED, _HEADING = map(STATE.index, ("altitude", "airspeed", "heading"))
_LEAST_AIRSPEED_M_S = 1.0
"""Below this the turbulence passes by as at this airspeed."""
_RECORD = np.dtype(
    [
        ("w20", float),  # [m/s]
        ("dt", float),  # control step [s]
        ("span", float),  # [m]
        ("exceeded", float, (2, len(dryden.EXCEEDED_FT))),  # see `dryden.intensities_and_lengths`
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
        record.exceeded = dryden.EXCEEDED_FT, dryden.EXCEEDED_FT_S[severity(w20)]
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
