"""What each coefficient of a design model adds to the rates of a log: the columns of an identification."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from testbed.aircraft.design_model import COLUMNS, coefficient_names
from testbed.common.signals import RATES, STATE
from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import NOMINAL
from testbed.logs.regression import regression

_LEAST = 1e-6  # of what adds most to a rate; what adds less is a zero that was rounded


@dataclass(frozen=True)
class Row:
    """Of one rate: what the model leaves [bins], what each coefficient and the constant add [bins, names + 1], and the rate."""

    names: tuple[str, ...]
    left: np.ndarray
    columns: np.ndarray
    rate: np.ndarray


@dataclass(frozen=True)
class Rows:
    """Of one log: a row for each of RATES, time, p q r [bins, 3], airspeed over the model's, and where everything is known."""

    rates: list[Row]
    time_s: np.ndarray
    turning: np.ndarray
    speed: np.ndarray
    known: np.ndarray


def rows_of(log: FlightLog, setup: Setup, bin_s: float) -> Rows:
    """The rows of a log, averaged over bins of this length."""
    data, model = regression(log, setup, bin_s), setup.model
    width = max(round(bin_s / log.step_s), 1)
    count = len(data.time_s)
    x = {n: log.states[: count * width, i].reshape(count, width).mean(axis=1) for i, n in enumerate(STATE)}
    x = {n: np.nan_to_num(v, nan=model.alpha_rad if n == "alpha" else 0.0) for n, v in x.items()}
    speed = x["airspeed"] / model.airspeed_m_s
    scaled = {"alpha": speed**2 * (x["alpha"] - model.alpha_rad), "beta": speed**2 * x["beta"]}
    scaled |= {name: speed * x[name] for name in "pqr"}
    every, beta = coefficient_names(model.actuators), COLUMNS.index("beta")
    made, each = [], len(COLUMNS) + len(model.actuators)
    for number, rate in enumerate(RATES):
        states = [model.derivatives[number][i] * scaled[name] for i, name in enumerate(COLUMNS)]
        states[beta] = states[beta] + model.sideslip[number] * speed**2 * np.abs(x["beta"])
        columns = np.column_stack([*states, data.phi[NOMINAL][:, number], speed**2])
        left = data.z[:, number] - data.phi[NOMINAL][:, number].sum(axis=1)
        made.append(Row(tuple(every[number * each : (number + 1) * each]), left, columns, x[rate]))
    return Rows(made, data.time_s, np.stack([x[name] for name in "pqr"], axis=1), speed, data.known)


def joined(rows: Sequence[Row]) -> Row:
    """The row of several logs, without coefficients that add nothing in any."""
    columns = np.concatenate([row.columns for row in rows])
    sizes = np.sqrt(np.mean(columns**2, axis=0))
    there = [i for i in range(len(sizes) - 1) if sizes[i] > _LEAST * sizes.max()]
    left, rate = (np.concatenate([getattr(row, name) for row in rows]) for name in ("left", "rate"))
    return Row(tuple(rows[0].names[i] for i in there), left, columns[:, [*there, -1]], rate)
