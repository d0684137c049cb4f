"""What each coefficient of a design model adds to the rates of logs: the columns of an identification.

What is measured with noise makes its own coefficient too small. Klein and Morelli (Aircraft System Identification, 2006, section
5.1) smooth it, without delay, before it is taken for known. How much is said by the log: what is white above `WHITE_HZ`, where no
aircraft moves its vanes, is noise below it too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import welch

from testbed.aircraft.design_model import COLUMNS, DesignModel, coefficient_names
from testbed.common.signals import RATES, STATE
from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import NOMINAL
from testbed.logs.regression import regression

WHITE_HZ = 8.0
_VANES = ("alpha", "beta", "airspeed")
_WINDOW_S = 4.0  # of the spectra
_LEAST = 1e-6  # of what adds most to a rate; what adds less is a zero that was rounded


@dataclass(frozen=True)
class Row:
    """One rate of `RATES` in logs.

    Attributes:
        names: of its coefficients that are not zero.
        left: [bins] what the model leaves of it.
        columns: [bins, names + 1] what each coefficient and the constant add.
        measured: [bins] the rate.
        slopes: [3] of it by p, q and r, of the model at its airspeed.
        at: [3] the coefficient that each slope is, or -1.
    """

    rate: str
    names: tuple[str, ...]
    left: np.ndarray
    columns: np.ndarray
    measured: np.ndarray
    slopes: np.ndarray
    at: tuple[int, ...]


@dataclass(frozen=True)
class Rows:
    """Of logs, one after another: a row for each of RATES, the log's number [bins], time, p q r [bins, 3], airspeed over the
    model's, and where everything is known."""

    rates: list[Row]
    log: np.ndarray
    time_s: np.ndarray
    turning: np.ndarray
    speed: np.ndarray
    known: np.ndarray


def rows_of(logs: Sequence[FlightLog], setup: Setup, bin_s: float) -> Rows:
    """The rows of logs, averaged over bins of this length."""
    each = [_of_log(log, setup, bin_s) for log in logs]
    time_s, turning, speed, known, left, columns, measured = map(np.concatenate, zip(*each, strict=True))
    number = np.repeat(np.arange(len(each)), [len(part[0]) for part in each])
    rates = [_row(setup.model, i, left[:, i], columns[:, i], measured[:, i]) for i in range(len(RATES))]
    return Rows(rates, number, time_s, turning, speed, known)


def _of_log(log: FlightLog, setup: Setup, bin_s: float) -> tuple[np.ndarray, ...]:
    """Time, p q r, speed, known, and by RATES what the model leaves, what each coefficient adds, and the rates."""
    data, model = regression(log, setup, bin_s, (NOMINAL,)), setup.model
    width = max(round(bin_s / log.step_s), 1)
    count = len(data.time_s)
    x = {n: log.states[: count * width, i].reshape(count, width).mean(axis=1) for i, n in enumerate(STATE)}
    x = {n: np.nan_to_num(v, nan=model.alpha_rad if n == "alpha" else 0.0) for n, v in x.items()}
    speed = x["airspeed"] / model.airspeed_m_s
    scaled = {"alpha": speed**2 * (x["alpha"] - model.alpha_rad), "beta": speed**2 * x["beta"]}
    scaled |= {name: speed * x[name] for name in "pqr"}
    columns = []
    for number in range(len(RATES)):
        states = {name: model.derivatives[number][i] * scaled[name] for i, name in enumerate(COLUMNS)}
        states["beta"] = states["beta"] + model.sideslip[number] * speed**2 * np.abs(x["beta"])
        columns.append(np.column_stack([*states.values(), data.phi[NOMINAL][:, number], speed**2]))
    turning, rates = (np.stack([x[name] for name in names], axis=1) for names in ("pqr", RATES))
    left = data.z - data.phi[NOMINAL].sum(axis=2)
    return data.time_s, turning, speed, data.known, left, np.stack(columns, axis=1), rates


def _row(model: DesignModel, number: int, left: np.ndarray, columns: np.ndarray, measured: np.ndarray) -> Row:
    """Without coefficients that add nothing."""
    count = len(COLUMNS) + len(model.actuators)
    names = coefficient_names(model.actuators)[number * count : (number + 1) * count]
    sizes = np.sqrt(np.mean(columns**2, axis=0))
    there = [i for i in range(count) if sizes[i] > _LEAST * sizes.max()]
    turning = [COLUMNS.index(name) for name in "pqr"]
    return Row(
        RATES[number], tuple(names[i] for i in there), left, columns[:, [*there, -1]], measured,
        np.array(model.derivatives[number])[turning], tuple(there.index(i) if i in there else -1 for i in turning),
    )  # fmt: skip


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
