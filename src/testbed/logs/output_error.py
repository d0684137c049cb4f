"""Factors on a design model's coefficients by output error: the turning rates that it predicts over stretches of a log, simulated.

What the rates are differentiated for in equation error is integrated here, so noise of gyros does not bias a factor (Jategaonkar,
Flight Vehicle System Identification, 2nd ed. 2015, chapter 4). Angles and airspeed are those that were measured, so that a stretch
begins anew with three unknowns alone, and an aircraft that is unstable does not run away.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import toeplitz

from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.regression import Row, Rows, rows_of

STRETCH_S = 5.0
BIN_S = 0.02
"""Short against the damping of roll, 1/26 s."""
_ROUNDS = 5
_SHARE = 0.03
"""What each coefficient adds is known no better than this: vanes lag, and gusts act elsewhere than where they are read."""
_STEP = 0.5
"""Largest change of a factor in a round: beyond, a damping may turn its sign, and what is simulated runs away."""
_LEAST = 4
"""Stretches, below which nothing is said."""
Residuals = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Of stretches that were simulated: time [stretches, bins], p q r measured [stretches, bins, 3], and simulated minus measured."""


@dataclass(frozen=True)
class Output:
    """Factors with their standard deviations by name; the constants of p_dot, q_dot and r_dot by number; and fits.

    A fit is 1 - rms error / rms of p, q or r, simulated over the part that was kept back: by the aircraft's own model, and by the
    one that was found. `kept` is what the one that was found leaves there, the logs one after another in time. `covariance` is that
    of the factors, in their order.
    """

    factors: Mapping[str, tuple[float, float]]
    constants: Mapping[int, float]
    fits: Mapping[int, tuple[float, float]]
    kept: Residuals
    covariance: np.ndarray


def identified(logs: Sequence[FlightLog], setup: Setup, free: Mapping[str, bool], kept_back: float) -> Output:
    """Fit the coefficients of the turning rates that are `free`, by name; empty where the logs have too few whole stretches."""
    rows = rows_of(logs, setup, BIN_S)
    used, kept = _stretches(rows, kept_back)
    parts, speed, there = rows.rates[:3], rows.speed, rows.turning[kept]
    names = [name for part in parts for name in (*part.names, "")]
    chosen = np.array([free.get(name, True) for name in names])
    if len(used) < _LEAST:
        return Output({}, {}, {}, (BIN_S * kept[:0], there[:0], there[:0]), np.zeros((0, 0)))
    change, covariance = fitted(parts, speed, used, chosen)
    std = np.full(len(names), np.nan)
    std[chosen] = np.sqrt(np.diagonal(covariance))
    factors = {n: (1.0 + float(change[i]), float(std[i])) for i, n in enumerate(names) if n and chosen[i]}
    own = np.array([bool(name) for name in names])
    among = np.ix_(own[chosen], own[chosen])
    constants = dict(enumerate(map(float, change[~own])))
    errors = [simulated(parts, speed, kept, c)[0] for c in (0.0 * change, change)]
    fits = zip(*(_fits(error, there) for error in errors), strict=True)
    return Output(
        factors, constants, dict(enumerate(fits)), (BIN_S * kept, there, errors[1]), covariance[among]
    )


def residuals(log: FlightLog, setup: Setup) -> Residuals:
    """What the model leaves if all actuators work."""
    rows = rows_of([log], setup, BIN_S)
    still = np.zeros((len(rows.time_s), 1))
    parts = [replace(row, names=(), columns=still, at=(-1, -1, -1)) for row in rows.rates[:3]]
    used, _ = _stretches(rows, 0.0)
    error, _, _ = simulated(parts, rows.speed, used, np.zeros(3))
    return rows.time_s[used], rows.turning[used], error


def _stretches(rows: Rows, kept_back: float) -> tuple[np.ndarray, np.ndarray]:
    """[stretches, bins of one] bins of all logs in which everything is known: those used, and those kept back."""
    width = round(STRETCH_S / BIN_S)
    made: tuple[list[np.ndarray], list[np.ndarray]] = ([], [])
    for number in np.unique(rows.log):
        own = np.flatnonzero(rows.log == number)
        until = round((1.0 - kept_back) * len(own))
        for start in range(0, len(own) - width, width):
            stretch = own[start : start + width]
            if np.all(rows.known[stretch]) and not start < until < start + width:
                made[start >= until].append(stretch)
    used, kept = (np.array(each, dtype=int).reshape(-1, width) for each in made)
    return used, kept


def _fits(error: np.ndarray, there: np.ndarray) -> list[float]:
    """1 - rms of what is simulated wrongly / rms, of p, q and r."""
    if not len(there):
        return [math.nan] * 3
    sizes = np.sqrt(np.mean((there - there.mean(axis=(0, 1))) ** 2, axis=(0, 1)))
    return [float(x) for x in 1.0 - np.sqrt(np.mean(error**2, axis=(0, 1))) / (sizes + 1e-12)]


def fitted(
    parts: Sequence[Row], speed: np.ndarray, rows: np.ndarray, free: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(changes of all coefficients and constants from the model's, covariance of the free ones), by Gauss and Newton.

    Args:
        parts: of p, q and r.
        speed: [bins] airspeed over that of the model.
        rows: [stretches, bins of one] where to simulate.
        free: [coefficients] those that are found; the others stay.
    """
    change, weight = np.zeros(len(free)), np.ones(3)
    for _ in range(_ROUNDS):
        error, by_change, by_start = simulated(parts, speed, rows, change)
        weighted = (error * weight, by_change[..., free] * weight[:, None], by_start * weight[:, None])
        columns = _free(*weighted[1:])
        information = np.einsum("skip,skiq->spq", columns, weighted[1])
        total = information.sum(axis=0) + 1e-9 * np.eye(int(free.sum()))
        step = np.linalg.solve(total, np.einsum("skip,ski->sp", columns, weighted[0]).sum(axis=0))
        step *= min(1.0, _STEP / np.abs(step).max())
        change[free] -= step
        left = error - by_change[..., free] @ step
        weight = 1.0 / (np.std(left, axis=(0, 1)) + 1e-9)
    inverse = np.linalg.inv(total)
    middle = _coloured(columns, left * weight)
    for i, factor in enumerate(1.0 + change[free]):
        middle += _coloured(columns, _SHARE * factor * columns[..., i])
    return change, inverse @ middle @ inverse


def _coloured(columns: np.ndarray, left: np.ndarray) -> np.ndarray:
    """Covariance of the sum of all scores when what is left is coloured, by gusts above all (Klein and Morelli 2006, eq. 5.25).

    Args:
        columns: [stretches, bins, 3, factors] derivatives, weighted, without what the beginnings explain.
        left: [stretches, bins, 3] weighted.
    """
    _, each, _, size = columns.shape
    made = np.zeros((size, size))
    for i in range(3):
        power = np.mean(np.abs(np.fft.rfft(left[:, :, i], 2 * each, axis=1)) ** 2, axis=0)
        correlation = np.fft.irfft(power)[:each] / each
        D = columns[:, :, i]
        made += np.einsum("skp,kl,slq->pq", D, toeplitz(correlation), D, optimize=True)
    return made


def simulated(
    parts: Sequence[Row], speed: np.ndarray, rows: np.ndarray, change: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Simulated minus measured rates, [stretches, bins, 3], each with the beginning that leaves least of it.

    Also their derivatives by each change [..., changes], and by the beginning [..., 3].
    """
    begun = np.zeros((len(rows), 3))
    for _ in range(2):  # first from what was measured
        error, by_change, by_start = _run(parts, speed, rows, change, begun)
        square = np.einsum("skia,skib->sab", by_start, by_start)
        towards = np.einsum("skia,ski->sa", by_start, error)
        begun = begun - np.linalg.solve(square, towards[..., None])[..., 0]
    return error, by_change, by_start


def _run(
    parts: Sequence[Row], speed: np.ndarray, rows: np.ndarray, change: np.ndarray, begun: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    ends = np.cumsum([0, *(len(part.names) + 1 for part in parts)])
    A = np.stack([part.slopes for part in parts])
    for i, part in enumerate(parts):
        for j, at in enumerate(part.at):
            A[i, j] *= 1.0 + change[ends[i] + at] if at >= 0 else 1.0
    count, each = rows.shape
    columns = np.zeros((count, each, 3, ends[-1]))
    for i, part in enumerate(parts):
        columns[:, :, i, ends[i] : ends[i + 1]] = part.columns[rows]
    forced = columns @ change - np.stack([part.left for part in parts], axis=1)[rows]
    half = 0.5 * BIN_S * speed[rows][..., None, None] * A
    e, S, F = begun, np.zeros((count, 3, ends[-1])), np.broadcast_to(np.eye(3), (count, 3, 3))
    made = [(e, S, F)]
    for k in range(1, each):  # the trapezoidal rule
        behind, ahead = np.eye(3) + half[:, k - 1], np.linalg.inv(np.eye(3) - half[:, k])
        push = 0.5 * BIN_S * (columns[:, k - 1] + columns[:, k])
        for i, part in enumerate(parts):
            for j, at in enumerate(part.at):
                if at >= 0:
                    push[:, i, ends[i] + at] += BIN_S * speed[rows[:, k]] * part.slopes[j] * e[:, j]
        moved = behind @ e[..., None] + 0.5 * BIN_S * (forced[:, k - 1] + forced[:, k])[..., None]
        e, S, F = (ahead @ moved)[..., 0], ahead @ (behind @ S + push), ahead @ behind @ F
        made.append((e, S, F))
    error, by_change, by_start = (np.stack(each, axis=1) for each in zip(*made, strict=True))
    return error, by_change, by_start


def _free(by_change: np.ndarray, by_start: np.ndarray) -> np.ndarray:
    """[stretches, bins, 3, factors] what a change does that no other beginning does."""
    to_start = np.einsum("skia,skip->sap", by_start, by_change)
    inside = np.linalg.solve(np.einsum("skia,skib->sab", by_start, by_start), to_start)
    return np.asarray(by_change - np.einsum("skia,sap->skip", by_start, inside))
