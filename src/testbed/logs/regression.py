"""The law's regression (10) of a whole log, averaged over bins of a tenth of a second: z = x_c_dot - f_m, and Phi; its
errors; and what each coefficient of a design model adds to the rates: the columns of an identification.

The compiled functions of the law run over the log. Their letters: y measured state, m design model, s memory, f working memory;
fields, shapes and units are in `controllers.records`.

The errors of z = the actuators' columns + error are coloured noise, which an autoregression of each rate makes white. They have
gusts, noise of sensors that was differentiated, and what the design model leaves out. The same filter goes over every column, so
that a constant error of the model has little weight, and a sudden change has all of it.

What is measured with noise makes its own coefficient too small. Klein and Morelli (Aircraft System Identification, 2006, section
5.1) smooth it, without delay, before it is taken for known. How much is said by the log: what is white above `WHITE_HZ`, where no
aircraft moves its vanes, is noise below it too.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import solve_toeplitz
from scipy.signal import lfilter, welch

from testbed.aircraft.design_model import COLUMNS, DesignModel, coefficient_names
from testbed.common.jit import compiled
from testbed.common.signals import RATES, STATE, as_records
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.inversion.law import pressure_ratio_of, regressor, state_function
from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import NOMINAL, VARIANTS, Variant

BIN_S = 0.1
"""Long enough for the noise of sensors that was differentiated to cancel, and short against what a failure does."""
_SETTLE = 2.0  # s, of the actuators' model, with the first command


@dataclass(frozen=True)
class Regression:
    """Both sides of (10) in bins.

    Attributes:
        time_s: [bins] beginning of each.
        z: [bins, 4] x_c_dot - f_m.
        phi: [bins, 4, n] what each actuator adds if it works, for each of `VARIANTS`.
        unit: [bins, 4, n] what one scaled unit of its position adds.
        known: [bins] where the log has everything.
    """

    time_s: np.ndarray
    z: np.ndarray
    phi: dict[Variant, np.ndarray]
    unit: np.ndarray
    known: np.ndarray


def regression(
    log: FlightLog, setup: Setup, bin_s: float, variants: tuple[Variant, ...] = VARIANTS, block: int = 1
) -> Regression:
    """The regression of a log, with the design model of `setup`, in whole blocks of so many bins.

    A rate that the log has not is zero on both sides. What is missing of the state is filled with what does no harm.
    """
    usual = {"alpha": setup.model.alpha_rad, "airspeed": setup.model.airspeed_m_s}
    states = np.where(np.isfinite(log.states), log.states, [usual.get(name, 0.0) for name in STATE])
    width = max(round(bin_s / log.step_s), 1)
    rows = len(states) // width // block * block * width

    def binned(values: np.ndarray) -> np.ndarray:
        return np.asarray(values[:rows].reshape(-1, width, *values.shape[1:]).mean(axis=1))

    rates = ~np.isnan(log.states[:, [STATE.index(rate) for rate in RATES]]).all(axis=0)
    phi = {}
    for variant in variants:
        z, columns = _replayed(log, states, setup, variant)  # z is that of each
        phi[variant] = binned(columns) * rates[:, None]
    m = model_record(setup)[0]
    pressure = binned((states[:, STATE.index("airspeed")] / m.airspeed) ** 2)
    unit = m.B[None] * np.where(m.servo, pressure[:, None], 1.0)[:, None, :] * rates[:, None]
    known = binned(log.known.astype(float)) > 0.999
    return Regression(binned(log.time_s), binned(z) * rates, phi, unit, known)


def _replayed(
    log: FlightLog, states: np.ndarray, setup: Setup, variant: Variant
) -> tuple[np.ndarray, np.ndarray]:
    """z [rows, 4] and Phi [rows, 4, n], with the actuators' model as a variant has it."""
    m, s, n = model_record(setup), trimmed_memory(setup), len(setup.actuators)
    m[0].lag[:] *= variant.lag
    m[0].rate[:] *= variant.rate
    late = round(variant.delay_s / log.step_s)
    commands = np.where(np.isfinite(log.commands), log.commands, 0.0) / np.where(
        log.as_positions, setup.scale, 1.0
    )
    commands = np.concatenate([np.repeat(commands[:1], late, axis=0), commands])[: len(commands)]
    before = round(_SETTLE / log.step_s)
    rows = np.concatenate([np.arange(before) * 0, np.arange(len(states))])
    z, phi = np.zeros((len(rows), 4)), np.zeros((len(rows), 4, n))
    _replay(
        as_records(np.ascontiguousarray(states[rows]), STATE), np.ascontiguousarray(commands[rows]),
        log.as_positions.astype(float), log.step_s, m[0], s[0], np.zeros(4), z, phi,
    )  # fmt: skip
    return z[before:], phi[before:]


@compiled
def _replay(states, commands, thrusts, dt, m, s, f, z, phi):
    """Fill z [rows, 4] and Phi [rows, 4, n] of states [rows] and commands [rows, n].

    Commands are rad or throttle; where `thrusts` [n] is set, the commanded position in scaled units.
    """
    for k in range(len(states)):
        y = states[k]
        if k > 0:
            advance_actuators(dt, axial_speed(y), m, s)
        for i in range(len(s.u)):
            s.u[i] = commands[k, i]
        command_actuators(axial_speed(y), m, s)
        for i in range(len(s.u)):
            if not thrusts[i]:
                s.command[i] = commands[k, i]
        pressure_ratio = pressure_ratio_of(y, m)
        state_function(y, m, f)
        z[k, 0], z[k, 1], z[k, 2], z[k, 3] = y.p_dot - f[0], y.q_dot - f[1], y.r_dot - f[2], y.u_dot - f[3]
        for i in range(
            4
        ):  # both f and Phi contain the constant part of the propellers' torque: count it once
            z[k, i] += m.offset[i] * pressure_ratio
        regressor(pressure_ratio, m, s, phi[k])


ORDER = 20
"""Of the autoregression: 2 s."""
QUIET_SHARE, QUIET_S = 0.4, 5.0
"""The first fit is of the quietest windows, because a failure may fill most of a log: their share, and the length of one [s]."""


@dataclass(frozen=True)
class Noise:
    """An autoregression of each rate, and the covariance of its innovations.

    Attributes:
        filters: [rates, ORDER + 1] coefficients, the first is 1.
        mixing: [rates, rates] inverse of the Cholesky factor of the innovations' covariance.
    """

    filters: np.ndarray
    mixing: np.ndarray

    def white(self, columns: np.ndarray) -> np.ndarray:
        """[bins, rates, ...] in which the error has unit variance, of columns of this shape."""
        parts = [lfilter(each, [1.0], columns[:, row], axis=0) for row, each in enumerate(self.filters)]
        return np.einsum("ij,tj...->ti...", self.mixing, np.stack(parts, axis=1))


def noise_of(
    errors: np.ndarray, known: np.ndarray, model_std: np.ndarray, model_time_s: float, bin_s: float
) -> Noise:
    """Fit the noise by the Yule-Walker equations.

    Args:
        errors: [bins, rates] of the regression; those that are not `known` [bins] are left out.
        model_std: [rates] standard deviation of the design model's error. It is in the noise whether the errors show it or not,
            as in the law's `estimator`, with the correlation time `model_time_s`.
    """
    clean = np.where(known[:, None], errors, 0.0)
    lags = np.arange(ORDER + 1)
    pairs = np.array([max(int(np.sum(known[lag:] & known[: len(known) - lag])), 1) for lag in lags])
    filters = np.eye(1, ORDER + 1).repeat(clean.shape[1], axis=0)
    for row, x in enumerate(clean.T):
        covariance = np.array([x[lag:] @ x[: len(x) - lag] for lag in lags]) / pairs
        covariance += model_std[row] ** 2 * np.exp(-lags * bin_s / model_time_s)
        covariance[0] *= 1.0001  # where hardly anything is random the equations stay well conditioned
        filters[row, 1:] = -solve_toeplitz(covariance[:-1], covariance[1:])
    innovations = np.stack([lfilter(f, [1.0], x) for f, x in zip(filters, clean.T, strict=True)], axis=1)
    of_model = np.diag(model_std**2 * 2.0 * bin_s / model_time_s)  # the innovation of the model's error
    spread = np.atleast_2d(np.cov(innovations[settled(known)].T)) + of_model
    return Noise(filters, np.linalg.inv(np.linalg.cholesky(spread)))


def settled(known: np.ndarray) -> np.ndarray:
    """[bins] whether a bin and the ORDER before it are known, so that the filter has forgotten a gap."""
    count = np.convolve(known.astype(float), np.ones(ORDER + 1))[: len(known)]
    return np.asarray(count > ORDER + 0.5)


def quiet(errors: np.ndarray, known: np.ndarray, bin_s: float) -> np.ndarray:
    """[bins] those in the quietest windows, by the size of the errors relative to their medians."""
    width = max(int(QUIET_S / bin_s), 2 * ORDER)
    count = max(len(errors) // width, 1)
    size = np.median(np.abs(errors[known]), axis=0) + 1e-9
    energy = np.where(known, np.sum((errors / size) ** 2, axis=1), np.inf)
    means = [float(np.mean(energy[i * width : (i + 1) * width])) for i in range(count)]
    chosen = np.argsort(means)[: max(round(QUIET_SHARE * count), 1)]
    mask = np.isin(np.arange(len(errors)) // width, chosen) & known
    return mask if np.sum(settled(mask)) > 2 * ORDER else known


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
