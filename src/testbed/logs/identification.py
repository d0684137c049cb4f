"""A design model from logs of healthy flight: factors on the coefficients of an aircraft's own model, by equation error.

The rates that the model leaves are regressed on what each coefficient adds to them, with white errors (Klein and Morelli, Aircraft
System Identification, 2006, chapter 5). A factor of 1 is the aircraft's own model; one that is not within two standard deviations
of 1 is what the log contradicts. Coefficients that are zero stay so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import lfilter

from testbed.aircraft.design_model import COLUMNS, DesignModel, coefficient_names
from testbed.common.signals import RATES, STATE
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import NOMINAL
from testbed.logs.noise import noise_of, settled
from testbed.logs.regression import BIN_S, regression

KEPT_BACK = 0.3
"""Share of each log, at its end, that is not used but to validate."""
LARGEST_STD = 0.3
"""Standard deviation of a factor beyond which the coefficient is not identifiable from these logs."""
COLLINEAR = 10.0
"""Inflation of a factor's variance by the others from which on they cannot be told apart."""
WINDOW_S = 10.0
_ROUNDS, _LAGS = 2, 20
_LEAST = 1e-6  # of what adds most to a rate; what adds less is a zero that was rounded


@dataclass(frozen=True)
class Factor:
    """What logs say of a coefficient: factor on the model's value, its standard deviation, the inflation of its variance by the
    others, whether it is identifiable, and when [s] in which log the 10 s were that told most."""

    name: str
    value: float
    std: float
    inflation: float
    known: bool
    log: int
    from_s: float

    @property
    def contradicted(self) -> bool:
        """Whether the aircraft's own value is not within two standard deviations."""
        return self.known and abs(self.value - 1.0) > 2.0 * self.std


@dataclass(frozen=True)
class Validation:
    """Of a rate, on the part of the logs that was not used.

    Without what is constant: `fit` is 1 - rms error / rms, before and after; `theil` Theil's inequality coefficient, 0 perfect and
    1 worst; `coloured` the share of the residual's first 20 correlations that are beyond what white noise has in 95 %.
    """

    rate: str
    fit_before: float
    fit: float
    theil: float
    coloured: float


@dataclass(frozen=True)
class Identified:
    """A design model from logs, and how far it can be believed."""

    model: DesignModel
    factors: tuple[Factor, ...]
    validation: tuple[Validation, ...]


@dataclass(frozen=True)
class _Row:
    """Of one rate in all logs: what the model leaves, what each coefficient and the constant add, what was measured [bins]."""

    names: tuple[str, ...]
    left: np.ndarray
    columns: np.ndarray
    rate: np.ndarray


def identified(logs: Sequence[FlightLog], setups: Sequence[Setup]) -> Identified:
    """The design model that logs of healthy flight give, from that of their `setups`, whose trim and condition it keeps."""
    parts, setup = [_parts(log, each) for log, each in zip(logs, setups, strict=True)], setups[0]
    which = np.concatenate([np.full(len(known), i) for i, (_, _, known) in enumerate(parts)])
    time_s, known = (np.concatenate([part[i] for part in parts]) for i in (1, 2))
    used = known & np.concatenate([np.arange(len(k)) < (1.0 - KEPT_BACK) * len(k) for _, _, k in parts])
    c = settings_record(setup, AdaptiveInversionSettings())[0]
    factors: list[Factor] = []
    validation: list[Validation] = []
    bias = np.array(setup.model.bias)
    for number, rate in enumerate(RATES):
        rows = [part[0][number] for part in parts]
        whole = _Row(
            rows[0].names,
            *(np.concatenate([getattr(r, f) for r in rows]) for f in ("left", "columns", "rate")),
        )
        if not np.any(whole.rate):
            continue
        found, constant, filtered = _fitted(
            whole, used, float(c.model_error_std[number]), 1.0 / c.model_error_rate
        )
        bias[number] += constant
        factors += [_factor(whole.names, i, found, filtered, which, time_s) for i in range(len(whole.names))]
        change = np.append(found.value - 1.0, constant)
        validation.append(_validated(rate, whole, change, known & ~used))
    model = setup.model.with_error({each.name: each.value for each in factors})
    return Identified(replace(model, bias=tuple(map(float, bias))), tuple(factors), tuple(validation))


def _parts(log: FlightLog, setup: Setup) -> tuple[list[_Row], np.ndarray, np.ndarray]:
    """(a row for each rate, [bins] time, [bins] whether everything is known)."""
    data, model = regression(log, setup), setup.model
    width = max(round(BIN_S / log.step_s), 1)
    count = len(data.time_s)
    x = {n: log.states[: count * width, i].reshape(count, width).mean(axis=1) for i, n in enumerate(STATE)}
    x = {n: np.nan_to_num(v, nan=model.alpha_rad if n == "alpha" else 0.0) for n, v in x.items()}
    speed = x["airspeed"] / model.airspeed_m_s
    scaled = {"alpha": speed**2 * (x["alpha"] - model.alpha_rad), "beta": speed**2 * x["beta"]}
    scaled |= {name: speed * x[name] for name in "pqr"}
    every = coefficient_names(model.actuators)
    made, each = [], len(COLUMNS) + len(model.actuators)
    for number, rate in enumerate(RATES):
        states = [model.derivatives[number][i] * scaled[name] for i, name in enumerate(COLUMNS)]
        states[COLUMNS.index("beta")] = states[COLUMNS.index("beta")] + model.sideslip[
            number
        ] * speed**2 * np.abs(x["beta"])
        columns = np.column_stack([*states, data.phi[NOMINAL][:, number], speed**2])
        sizes = np.sqrt(np.mean(columns**2, axis=0))
        there = [i for i in range(each) if sizes[i] > _LEAST * sizes.max()]
        names = tuple(every[number * each + i] for i in there)
        measured = x[rate] if rate in x else np.zeros(count)
        left = data.z[:, number] - data.phi[NOMINAL][:, number].sum(axis=1)
        made.append(_Row(names, left, columns[:, [*there, each]], measured))
    return made, data.time_s, data.known


@dataclass(frozen=True)
class _Found:
    value: np.ndarray
    std: np.ndarray
    inflation: np.ndarray
    known: np.ndarray


def _fitted(
    row: _Row, used: np.ndarray, model_std: float, model_time_s: float
) -> tuple[_Found, float, np.ndarray]:
    """(factors, constant, [bins, coefficients] white columns where they are used)."""
    count = len(row.names)
    free, change = np.ones(count + 1, dtype=bool), np.zeros(count + 1)
    for _ in range(_ROUNDS):
        errors = (row.left - row.columns @ change)[:, None]
        noise = noise_of(errors, used, np.array([model_std]), model_time_s, BIN_S)
        at = settled(used)
        columns = (lfilter(noise.filters[0], [1.0], row.columns, axis=0) * noise.mixing[0, 0])[at]
        left = (lfilter(noise.filters[0], [1.0], row.left) * noise.mixing[0, 0])[at]
        information = columns.T @ columns + 1e-12 * np.eye(count + 1)
        covariance = np.linalg.inv(information)
        std = np.sqrt(np.diagonal(covariance))
        free[:count] = std[:count] < LARGEST_STD
        change = np.zeros(count + 1)
        change[free] = np.linalg.lstsq(columns[:, free], left, rcond=None)[0]
    inflation = np.diagonal(covariance) * np.diagonal(information)
    white = np.zeros_like(row.columns)
    white[at] = columns
    found = _Found(1.0 + change[:count], std[:count], inflation[:count], free[:count])
    return found, float(change[count]), white


def _factor(
    names: tuple[str, ...], i: int, found: _Found, white: np.ndarray, which: np.ndarray, time_s: np.ndarray
) -> Factor:
    told = np.convolve(white[:, i] ** 2, np.ones(round(WINDOW_S / BIN_S)), "valid")
    best = int(np.argmax(told)) if len(told) else 0
    value, std, inflation = float(found.value[i]), float(found.std[i]), float(found.inflation[i])
    return Factor(
        names[i], value, std, inflation, bool(found.known[i]), int(which[best]), float(time_s[best])
    )


def _validated(rate: str, row: _Row, change: np.ndarray, kept: np.ndarray) -> Validation:
    signals = (row.rate[kept], row.left[kept], row.left[kept] - row.columns[kept] @ change)
    measured, before, after = (each - each.mean() for each in signals)
    spread = float(np.sqrt(np.mean(measured**2))) + 1e-12
    sizes = [float(np.sqrt(np.mean(each**2))) for each in (before, after, measured, measured - after)]
    centred = after - after.mean()
    correlations = [
        float(centred[lag:] @ centred[:-lag] / (centred @ centred)) for lag in range(1, _LAGS + 1)
    ]
    beyond = np.abs(correlations) > 1.96 / np.sqrt(len(after))
    theil = sizes[1] / (sizes[2] + sizes[3] + 1e-12)
    return Validation(rate, 1.0 - sizes[0] / spread, 1.0 - sizes[1] / spread, theil, float(np.mean(beyond)))
