"""Effectiveness of a flying wing's two elevons from its rates and commands: a model by least squares, white errors, and a hidden
Markov model over classes of effectiveness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from enac_logs import STEP_S, Flight

from testbed.logs.chain import likeliest
from testbed.logs.noise import Noise, noise_of
from testbed.logs.smoothing import smoothed

LAGS = 4
"""Commands that the rates of the next sample depend on."""
BLOCK = 10
"""Samples of a step of the hidden Markov model: 1 s."""
CLASSES = np.array([(1.0, 1.0), (0.3, 1.0)] + [(1.0, level) for level in (0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3)])
"""Effectiveness of the right and the left elevon in the nine classes of the authors, which all are of 21 July."""
FLAG = 0.75
"""An elevon is flagged while it is said to be weaker."""
UNKNOWN = np.array([0.15, 0.03, 0.03])
"""Standard deviations, from flight to flight, of the gain of both elevons, and of constant errors of p and q [rad/s]."""
AGAIN_S = 30.0
"""How often a reading in flight takes these from all that it has seen."""
WINDOW_S, LATE_S, WRONG_S = 10.0, 3.0, 10.0


class Settings(NamedTuple):
    """What was chosen on 21 July.

    Standard deviation of the model's error [rad/s], a factor on log-likelihoods, and minus the logarithm of the probability that
    the class changes in a step.
    """

    model_std: float
    temper: float
    change: float

    @property
    def cost(self) -> np.ndarray:
        """Of going from class to class."""
        return np.where(np.eye(len(CLASSES), dtype=bool), 0.0, -self.change)


@dataclass(frozen=True)
class Regression:
    """What the model leaves: z = sum of the elevons' columns + error, at each sample.

    Attributes:
        time_s: [rows] of the autopilot's clock.
        z: [rows, 2, rad/s] next p and q without what the rates and a constant foretell.
        phi: [rows, 2, 2] what the right and the left elevon add if they work.
        truth: [rows, 2] the factors that were flown.
    """

    time_s: np.ndarray
    z: np.ndarray
    phi: np.ndarray
    truth: np.ndarray


class Reading(NamedTuple):
    """What is said of a flight: class, effectiveness, truth of each block, and what was found common to the flight."""

    time_s: np.ndarray
    told: np.ndarray
    effectiveness: np.ndarray
    truth: np.ndarray
    common: np.ndarray
    causal: np.ndarray


def elevons(flight: Flight) -> np.ndarray:
    """[rows, 2] deflections of right and left elevon: the commands are those of roll and pitch, and both act on each."""
    roll, pitch = flight.commands.T
    return np.stack([roll + pitch, pitch - roll], axis=1)


def fitted(flight: Flight, truth: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """[4 + 2 LAGS, 2] coefficients of the next p and q, by least squares: rates, 1, and both elevons at each lag."""
    rows = np.flatnonzero(inside[LAGS:-1]) + LAGS
    columns = [_known(flight, rows), *_lagged(elevons(flight) * truth, rows)]
    return np.linalg.lstsq(np.hstack(columns), flight.rates[rows + 1, :2], rcond=None)[0]


def _known(flight: Flight, rows: np.ndarray) -> np.ndarray:
    return np.column_stack([flight.rates[rows], np.ones(len(rows))])


def _lagged(moved: np.ndarray, rows: np.ndarray) -> list[np.ndarray]:
    return [moved[rows - lag] for lag in range(LAGS)]


def regression(
    flight: Flight, clock_s: float, truth: np.ndarray, model: np.ndarray, judged: tuple[float, float]
) -> Regression:
    """Both sides for the time that is judged, with the model's coefficients."""
    time_s = flight.time_s + clock_s
    rows = np.flatnonzero((time_s[LAGS:-1] > judged[0]) & (time_s[LAGS:-1] < judged[1])) + LAGS
    rows = rows[: len(rows) // BLOCK * BLOCK]
    z = flight.rates[rows + 1, :2] - _known(flight, rows) @ model[:4]
    each = model[4:].reshape(LAGS, 2, 2)  # lag, elevon, rate
    phi = sum(
        part[:, None, :] * one.T[None] for part, one in zip(_lagged(elevons(flight), rows), each, strict=True)
    )
    return Regression(time_s[rows], z, np.asarray(phi), truth[rows])


def noise(data: Regression, model_std: float) -> Noise:
    """The colour of what is left on 21 July, with what was broken known."""
    errors = data.z - np.einsum("kri,ki->kr", data.phi, data.truth)
    return noise_of(errors, np.ones(len(errors), dtype=bool), np.full(2, model_std), 10.0, STEP_S)


class White:
    """A flight's regression with white errors, of which the first samples do not count."""

    def __init__(self, data: Regression, colour: Noise, settings: Settings) -> None:
        constant = np.broadcast_to(np.eye(2), (len(data.z), 2, 2))
        self.z, self.phi, self.one = colour.white(data.z), colour.white(data.phi), colour.white(constant)
        self.weight = np.where(np.arange(len(data.z)) < 25, 0.0, settings.temper)
        self.cost = settings.cost

    def evidence(self, common: np.ndarray, until: int) -> np.ndarray:
        """[blocks, classes] log-likelihoods of the first `until` samples, relative to that both work."""
        left = self.z[:until] - self.one[:until] @ common[1:]
        made = []
        for level in CLASSES:
            error = left - common[0] * self.phi[:until] @ level
            made.append((-0.5 * self.weight[:until] * (error**2).sum(axis=1)).reshape(-1, BLOCK).sum(axis=1))
        return np.stack(made, axis=1) - made[0][:, None]

    def common(self, course: np.ndarray) -> np.ndarray:
        """[3] gain of both elevons and constant errors of p and q, given a course of classes, by least squares with UNKNOWN."""
        until, level = len(course) * BLOCK, np.repeat(CLASSES[course], BLOCK, axis=0)
        X = np.concatenate(
            [np.einsum("kri,ki->kr", self.phi[:until], level)[:, :, None], self.one[:until]], axis=2
        )
        prior = np.diag(UNKNOWN**-2)
        A = np.einsum("k,kri,krj->ij", self.weight[:until], X, X) + prior
        b = np.einsum("k,kri,kr->i", self.weight[:until], X, self.z[:until]) + prior[0]
        return np.linalg.solve(A, b)

    def told(self, until: int, common: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(likeliest course of classes, what is common), each found with the other, of the first `until` samples."""
        for _ in range(3):
            course = likeliest(self.evidence(common, until), self.cost)
            common = self.common(course)
        return likeliest(self.evidence(common, until), self.cost), common


def told(data: Regression, colour: Noise, settings: Settings, causal: bool = False) -> Reading:
    """What is said of a flight, from all of it, and with `causal` also at each time from what was before it."""
    white = White(data, colour, settings)
    course, common = white.told(len(data.z), np.array([1.0, 0.0, 0.0]))
    phi, left = common[0] * white.phi, white.z - white.one @ common[1:]
    information = np.einsum("k,kri,krj->kij", white.weight, phi, phi).reshape(-1, BLOCK, 2, 2).sum(axis=1)
    towards = np.einsum("k,kri,kr->ki", white.weight, phi, left).reshape(-1, BLOCK, 2).sum(axis=1)
    level = CLASSES[course]
    changes = np.diff(level, axis=0, prepend=level[:1]) != 0
    effectiveness, _ = smoothed(information, towards, 0.002, changes)
    so_far = _causal(white, len(course)) if causal else course
    return Reading(
        data.time_s[::BLOCK], course, effectiveness, data.truth[BLOCK // 2 :: BLOCK], common, so_far
    )


def _causal(white: White, blocks: int) -> np.ndarray:
    """[blocks] likeliest class given all before: a forward filter; what is common is found again every AGAIN_S, from the past."""
    change = np.exp(white.cost) / np.exp(white.cost).sum(axis=1, keepdims=True)
    common, made, each = (
        np.array([1.0, 0.0, 0.0]),
        np.zeros(blocks, dtype=int),
        round(AGAIN_S / (BLOCK * STEP_S)),
    )
    for first in range(0, blocks, each):
        if first:
            _, common = white.told(first * BLOCK, common)
        end = min(first + each, blocks)
        evidence, now = white.evidence(common, end * BLOCK), np.eye(1, len(CLASSES))[0]
        for block, row in enumerate(evidence):
            now = (now @ change) * np.exp(row - row.max())
            now /= now.sum()
            made[block] = int(now.argmax()) if block >= first else made[block]
    return made


def true_class(reading: Reading) -> np.ndarray:
    """[blocks] the class nearest to the truth."""
    return np.abs(reading.truth[:, None] - CLASSES[None]).sum(axis=2).argmin(axis=1)


def matthews(truth: np.ndarray, said: np.ndarray) -> float:
    """Matthews's coefficient of several classes (Gorodkin 2004, equation 8)."""
    table = np.zeros((len(CLASSES), len(CLASSES)))
    np.add.at(table, (truth, said), 1)
    count, right, t, s = table.sum(), np.trace(table), table.sum(axis=1), table.sum(axis=0)
    spread = (count**2 - s @ s) * (count**2 - t @ t)
    return float((right * count - t @ s) / np.sqrt(spread)) if spread else float("nan")


def window_errors(reading: Reading) -> np.ndarray:
    """[windows, 2] mean error of the effectiveness in windows of 10 s in which nothing changed."""
    width = round(WINDOW_S / (BLOCK * STEP_S))
    parts = range(0, len(reading.truth) - width, width)
    steady = [slice(i, i + width) for i in parts if np.ptp(reading.truth[i : i + width], axis=0).max() < 0.01]
    return np.array([(reading.effectiveness[part] - reading.truth[part]).mean(axis=0) for part in steady])


class Flags(NamedTuple):
    """Sudden drops, how many were flagged in time, with the wrong elevon too; false flags, and hours of healthy flight."""

    drops: int
    in_time: int
    wrong: int
    false: int
    healthy_h: float
    delays_s: tuple[float, ...]


def flags(reading: Reading, said: np.ndarray) -> Flags:
    """What comes of flagging each elevon below FLAG. A flag in healthy flight is false 5 s after the last fault or later."""
    time_s, low = reading.time_s, CLASSES[said] < FLAG
    fell = np.flatnonzero((reading.truth[2:] - reading.truth[:-2]).min(axis=1) < -0.4) + 1
    fell = fell[np.diff(time_s[fell], prepend=-np.inf) > 5.0]
    fell = [at + int(np.argmax(reading.truth[at : at + 3].min(axis=1) < 0.95)) for at in fell]
    in_time, wrong = 0, 0
    delays: list[float] = []
    for at in fell:
        elevon = int(reading.truth[min(at + 2, len(said) - 1)].argmin())
        after = (time_s >= time_s[at]) & (time_s <= time_s[at] + WRONG_S)
        flagged = np.flatnonzero(after & low[:, elevon])
        delays.append(float(time_s[flagged[0]] - time_s[at] + BLOCK * STEP_S) if len(flagged) else np.inf)
        in_time += delays[-1] < LATE_S + 0.5 * BLOCK * STEP_S
        wrong += bool(np.any(after & low[:, 1 - elevon]))
    settling = round(5.0 / (BLOCK * STEP_S))
    healthy = (
        np.convolve((reading.truth.min(axis=1) < 0.95).astype(int), np.ones(settling + 1))[: len(said)] == 0
    )
    rises = np.diff(low.any(axis=1).astype(int), prepend=0) > 0
    hours = float(healthy.sum()) * BLOCK * STEP_S / 3600.0
    return Flags(len(fell), in_time, wrong, int(np.sum(rises & healthy)), hours, tuple(delays))


def fit_clock_s(
    flight: Flight,
    broken: tuple[np.ndarray, np.ndarray],
    model: np.ndarray,
    colour: Noise,
    judged: tuple[float, float],
) -> float:
    """The clock with which the faults that were flown explain the log best; for a flight whose commands are drawn nowhere."""

    def misfit(late_s: float) -> float:
        truth = between(flight.time_s + late_s, *broken)
        data = regression(flight, late_s, truth, model, judged)
        return float(np.sum(colour.white(data.z - np.einsum("kri,ki->kr", data.phi, data.truth))[25:] ** 2))

    coarse = min(np.arange(60.0, 300.0, 4.0), key=misfit)
    return float(min(np.arange(coarse - 4.0, coarse + 4.0, 0.5), key=misfit))


def between(time_s: np.ndarray, times: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """[rows, 2] levels that are given at some times, at others."""
    return np.stack([np.interp(time_s, times, each) for each in levels.T], axis=1)
