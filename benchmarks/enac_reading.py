"""Effectiveness of a flying wing's two elevons from its rates and commands: a model by least squares, errors whose colour is
learnt, and a hidden Markov model over classes of effectiveness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from enac_filter import ORDER, Filtered, filtered, lagged, moments_of, predictor
from enac_logs import STEP_S, Flight
from scipy.stats import norm

from testbed.logs.hypotheses import likeliest, probabilities, smoothed

LAGS = 4
"""Commands that the rates of the next sample depend on."""
BLOCK = 10
"""Samples of a step of the hidden Markov model: 1 s."""
CLASSES = np.array([(1.0, 1.0), (0.3, 1.0)] + [(1.0, level) for level in (0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3)])
"""Effectiveness of the right and the left elevon in the nine classes of the authors, which all are of 21 July."""
FLAG = 0.75
"""An elevon is flagged while it is said to be weaker."""
_WEAK = (CLASSES < FLAG).astype(float)
UNKNOWN = np.array([0.2, 0.05])
"""Standard deviations, from flight to flight, of the gain of both elevons, and of their difference."""
WINDOW_S, LATE_S, WRONG_S = 10.0, 3.0, 10.0
LABEL_S = 1.6
"""A flag may come this much before the drawing's fault: 0.6 s that the drawing leaves open, and a step of the model."""
FALSE_PER_H = 2.0
STRETCH = 600
"""Samples on either side of a drop, of which its noise is taken for what can be reached at best."""
LIKELY = 0.9
"""Probability of being weaker than FLAG from which on an elevon is flagged from the whole log. With 1 - LIKELY the flag
goes, also in flight, where one is raised by far more: there each sample is another chance to be wrong."""


class Settings(NamedTuple):
    """What is chosen on 21 July.

    Minus the logarithms of the probabilities that the class changes, in a sample in flight and in a step of the whole log; and the
    probability of being weaker than FLAG from which on an elevon is flagged in flight.
    """

    change: float
    step_change: float
    sure: float


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
    """What is said of a flight.

    At each sample: time, truth [rows, 2], and from the whole log and in flight the likeliest class, the probability that each
    elevon is weaker than FLAG [rows, 2] and which are flagged [rows, 2]. In steps of 1 s: the effectiveness [steps, 2].
    Of the flight: the gain of both elevons, and for each drop the probability that the best of all tests flags it in time.
    """

    time_s: np.ndarray
    truth: np.ndarray
    told: np.ndarray
    weak: np.ndarray
    flagged: np.ndarray
    told_in_flight: np.ndarray
    weak_in_flight: np.ndarray
    flagged_in_flight: np.ndarray
    effectiveness: np.ndarray
    gain: float
    reachable: np.ndarray


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
    z = flight.rates[rows + 1, :2] - _known(flight, rows) @ model[:4]
    each = model[4:].reshape(LAGS, 2, 2)  # lag, elevon, rate
    phi = sum(
        part[:, None, :] * one.T[None] for part, one in zip(_lagged(elevons(flight), rows), each, strict=True)
    )
    return Regression(time_s[rows], z, np.asarray(phi), truth[rows])


def thinned(flight: Flight) -> Flight:
    """A flight with every second sample replaced by the mean of its neighbours: a drawing leaves points out."""
    kept = np.arange(0, len(flight.time_s), 2)

    def drawn(values: np.ndarray) -> np.ndarray:
        return np.stack(
            [np.interp(flight.time_s, flight.time_s[kept], each) for each in values[kept].T], axis=1
        )

    return Flight(flight.time_s, drawn(flight.rates), drawn(flight.commands))


def errors(data: Regression, gain: float = 1.0) -> np.ndarray:
    """[rows, 2] what the model leaves, with what was broken known."""
    return data.z - gain * np.einsum("kri,ki->kr", data.phi, data.truth)


def told(data: Regression, moments: np.ndarray, settings: Settings) -> Reading:
    """What is said of a flight, in flight with the gain of 21 July, and from all of it with its own."""
    first = filtered(data.z, data.phi, CLASSES, settings.change, moments)
    course = _course(first, settings)
    gain, _ = _common(first, course)
    acting = gain * data.phi[: len(course) * BLOCK] * np.repeat(CLASSES[course], BLOCK, axis=0)[:, None]
    own = moments_of(data.z[: len(acting)] - acting.sum(axis=2))
    whole = filtered(data.z, data.phi * gain, CLASSES, settings.change, own)
    course = _course(whole, settings)
    _, difference = _common(whole, course)
    levels, blocks = CLASSES[course], len(course)
    z, phi = whole.z[: blocks * BLOCK], whole.phi[: blocks * BLOCK] * [1.0 + difference, 1.0 - difference]
    weight = 1.0 / whole.variance[: blocks * BLOCK]
    information = np.einsum("k,kri,krj->kij", weight, phi, phi).reshape(-1, BLOCK, 2, 2).sum(axis=1)
    towards = np.einsum("k,kri,kr->ki", weight, phi, z).reshape(-1, BLOCK, 2).sum(axis=1)
    changes = np.diff(levels, axis=0, prepend=levels[:1]) != 0
    effectiveness, _ = smoothed(information, towards, 0.002, changes)
    step = np.minimum(np.arange(len(data.z)) // BLOCK, blocks - 1)
    after, in_flight = probabilities(*_steps(whole, settings))[step], first.log_probability
    weak_after, weak_before = after @ _WEAK, weak(first)
    return Reading(
        data.time_s, data.truth, after.argmax(axis=1), weak_after, raised(weak_after, LIKELY),
        in_flight.argmax(axis=1), weak_before, raised(weak_before, settings.sure), effectiveness, gain, reachable(data, gain),
    )  # fmt: skip


def _course(made: Filtered, settings: Settings) -> np.ndarray:
    """[steps] likeliest course of classes, from the whole log."""
    return likeliest(*_steps(made, settings))


def _steps(made: Filtered, settings: Settings) -> tuple[np.ndarray, np.ndarray]:
    """([steps, classes] log-likelihoods of the steps, relative to the first class's, [classes, classes] cost of each change)."""
    rows = len(made.evidence) // BLOCK * BLOCK
    evidence = made.evidence[:rows].reshape(-1, BLOCK, len(CLASSES)).sum(axis=1)
    cost = np.where(np.eye(len(CLASSES), dtype=bool), 0.0, -settings.step_change)
    return evidence - evidence[:, :1], cost


def _common(made: Filtered, course: np.ndarray) -> tuple[float, float]:
    """Gain of both elevons, and half of their difference, given a course of classes, by least squares with UNKNOWN."""
    rows = len(course) * BLOCK
    acting = made.phi[:rows] * np.repeat(CLASSES[course], BLOCK, axis=0)[:, None]
    X = np.stack([acting.sum(axis=2), acting[:, :, 0] - acting[:, :, 1]], axis=2)
    weight, prior = 1.0 / made.variance[:rows], np.diag(UNKNOWN**-2)
    A = np.einsum("k,kri,krj->ij", weight, X, X) + prior
    gain, difference = np.linalg.solve(A, np.einsum("k,kri,kr->i", weight, X, made.z[:rows]) + prior[0])
    return float(gain), float(difference)


def weak(made: Filtered) -> np.ndarray:
    """[rows, 2] probability that each elevon is weaker than FLAG."""
    return np.exp(made.log_probability) @ _WEAK


def raised(probability: np.ndarray, sure: float) -> np.ndarray:
    """[rows, 2] where each elevon is flagged: from `sure` on, until the probability that it is weak is below 1 - LIKELY."""
    flagged = np.zeros(probability.shape, dtype=bool)
    for elevon in range(2):
        now = False
        for k, each in enumerate(probability[:, elevon]):
            now = each > (1.0 - LIKELY if now else sure)
            flagged[k, elevon] = now
    return flagged


def reachable(data: Regression, gain: float) -> np.ndarray:
    """[drops] probability that the best of all tests flags each within LATE_S (Neyman and Pearson).

    That test knows the fault, its time, the gain and the noise, which is fitted to the very stretch. In any LATE_S of healthy
    flight it flags no more often than FALSE_PER_H allows.
    """
    left, missing = errors(data, gain), gain * np.einsum("kri,ki->kr", data.phi, 1.0 - data.truth)
    late = round(LATE_S / STEP_S)
    found = []
    for at, _ in drops(data.truth):
        coefficients, whitening = predictor(moments_of(left[max(at - STRETCH, 0) : at + STRETCH]))
        rows = lagged(np.concatenate([np.zeros((ORDER, 2)), missing[at : at + late]]))
        white = (rows[:, :2] - rows[:, 2:-1] @ coefficients[:, :-1].T) @ whitening.T
        found.append(np.sqrt(np.sum(white**2)))
    return np.asarray(norm.cdf(np.array(found) - norm.isf(FALSE_PER_H * LATE_S / 3600.0)))


def drops(truth: np.ndarray) -> list[tuple[int, int]]:
    """(sample, elevon) of each sudden drop to 0.3."""
    found = []
    for elevon, level in enumerate(truth.T):
        starts = np.flatnonzero((level[1:] < 0.95) & (level[:-1] >= 0.95)) + 1
        found += [(int(at), elevon) for at in starts if level[min(at + 30, len(level) - 1)] < 0.45]
    return sorted(found)


def true_class(truth: np.ndarray) -> np.ndarray:
    """[rows] the class nearest to the truth."""
    return np.abs(truth[:, None] - CLASSES[None]).sum(axis=2).argmin(axis=1)


def matthews(truth: np.ndarray, said: np.ndarray) -> float:
    """Matthews's coefficient of several classes (Gorodkin 2004, equation 8)."""
    table = np.zeros((len(CLASSES), len(CLASSES)))
    np.add.at(table, (truth, said), 1)
    count, right, t, s = table.sum(), np.trace(table), table.sum(axis=1), table.sum(axis=0)
    spread = (count**2 - s @ s) * (count**2 - t @ t)
    return float((right * count - t @ s) / np.sqrt(spread)) if spread else float("nan")


def window_errors(reading: Reading) -> np.ndarray:
    """[windows, 2] mean error of the effectiveness in windows of 10 s in which nothing changed."""
    truth = reading.truth[BLOCK // 2 :: BLOCK][: len(reading.effectiveness)]
    width = round(WINDOW_S / (BLOCK * STEP_S))
    parts = [slice(i, i + width) for i in range(0, len(truth) - width, width)]
    steady = [part for part in parts if np.ptp(truth[part], axis=0).max() < 0.01]
    return np.array([(reading.effectiveness[part] - truth[part]).mean(axis=0) for part in steady])


class Flags(NamedTuple):
    """Delays of the flags of sudden drops; how many had the wrong elevon too; false flags, and hours of healthy flight."""

    delays_s: np.ndarray
    wrong: int
    false: int
    healthy_h: float


def flags(time_s: np.ndarray, truth: np.ndarray, flagged: np.ndarray) -> Flags:
    """What comes of the flags [rows, 2]. One in healthy flight is false 5 s after the last fault or later, and LABEL_S before the
    next fault of its elevon or earlier."""
    delays, wrong = [], 0
    for at, elevon in drops(truth):
        after = np.flatnonzero(flagged[at:, elevon])
        delays.append(float(after[0]) * STEP_S if len(after) else np.inf)
        wrong += bool(flagged[at : at + round(WRONG_S / STEP_S), 1 - elevon].any())
    broken = truth < 0.95
    healthy = np.convolve(broken.any(axis=1).astype(int), np.ones(51))[: len(truth)] == 0
    false = 0
    for elevon in range(2):
        starts = np.flatnonzero(np.diff(flagged[:, elevon].astype(int), prepend=0) > 0)
        soon = round(LABEL_S / STEP_S)
        false += sum(bool(healthy[k] and not broken[k : k + soon, elevon].any()) for k in starts)
    return Flags(np.array(delays), wrong, false, float(healthy.sum()) * STEP_S / 3600.0)


def fit_clock_s(
    flight: Flight,
    broken: tuple[np.ndarray, np.ndarray],
    model: np.ndarray,
    moments: np.ndarray,
    judged: tuple[float, float],
) -> float:
    """The clock with which the faults that were flown explain the log best; for a flight whose commands are drawn nowhere."""
    coefficients, whitening = predictor(moments)

    def misfit(late_s: float) -> float:
        truth = between(flight.time_s + late_s, *broken)
        rows = lagged(errors(regression(flight, late_s, truth, model, judged)))
        return float(np.sum(((rows[:, :2] - rows[:, 2:] @ coefficients.T) @ whitening.T) ** 2))

    coarse = min(np.arange(60.0, 300.0, 4.0), key=misfit)
    return float(min(np.arange(coarse - 4.0, coarse + 4.0, 0.5), key=misfit))


def between(time_s: np.ndarray, times: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """[rows, 2] levels that are given at some times, at others."""
    return np.stack([np.interp(time_s, times, each) for each in levels.T], axis=1)
