"""Vanes and airspeed without their noise, for an identification: what is measured with noise makes its own coefficient too small.

Klein and Morelli (Aircraft System Identification, 2006, section 5.1) smooth what is measured, without delay, before it is taken for
known. How much is said by the log: what is white above `WHITE_HZ`, where no aircraft moves its vanes, is noise below it too.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.signal import welch

from testbed.common.signals import STATE
from testbed.logs.flight_log import FlightLog

WHITE_HZ = 8.0
_VANES = ("alpha", "beta", "airspeed")
_WINDOW_S = 4.0  # of the spectra


def smoothed_vanes(log: FlightLog) -> FlightLog:
    """The log with what Wiener's filter, which has no delay, leaves of its vanes and its airspeed; without noise they stay."""
    states = log.states.copy()
    for column in (STATE.index(name) for name in _VANES):
        if np.all(np.isfinite(states[:, column])):
            states[:, column] = without_white_noise(states[:, column], log.step_s)
    return replace(log, states=states)


def without_white_noise(values: np.ndarray, step_s: float) -> np.ndarray:
    """[rows] what a signal [rows] has beyond its white noise, at even times."""
    width = min(round(_WINDOW_S / step_s), len(values))
    hz, power = welch(values, fs=1.0 / step_s, nperseg=width)
    if hz[-1] <= WHITE_HZ:
        return values
    share = np.clip(1.0 - np.median(power[hz > WHITE_HZ]) / (power + 1e-300), 0.0, 1.0)
    share[0] = 1.0
    share = np.minimum.accumulate(share)  # a peak of noise alone does not pass
    edge = width - 1
    ends = (2.0 * values[0] - values[edge:0:-1], 2.0 * values[-1] - values[-2 : -edge - 2 : -1])
    whole = np.concatenate([ends[0], values, ends[1]])
    found = np.fft.rfft(whole) * np.interp(np.fft.rfftfreq(len(whole), step_s), hz, share)
    return np.asarray(np.fft.irfft(found, len(whole))[edge : edge + len(values)])
