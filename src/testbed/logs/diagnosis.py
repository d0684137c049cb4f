"""What a log says of each actuator over time: the likeliest course of hypotheses, effectiveness, and where nothing can be known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record
from testbed.controllers.setup import Setup
from testbed.flight.columns import stretches
from testbed.logs.chain import costs, likeliest, probabilities
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import NOMINAL, STATES, Hypothesis, hypotheses
from testbed.logs.noise import Noise, noise_of, quiet, settled
from testbed.logs.regression import BIN_S, Regression, regression
from testbed.logs.smoothing import alone, smoothed

BLOCK = 2
"""Bins of a block, in which nothing changes: 0.2 s."""
MODEL_SHARE = 0.15
"""Relative error of the terms of the regression [1] that no finding may rest on. It adds to the variance, as in the law."""
_SHARE_S = 1.0  # over which the terms' squares are averaged
TEMPER = 0.5
"""Factor on log-likelihoods: what the model leaves out is not as white as the noise that was fitted."""
ROUNDS = 2
"""Of fitting the noise to what the likeliest course leaves, and looking for that course."""
WINDOW_S = 10.0
"""Length of the windows in which it is said what can be known."""
UNKNOWN_STD = 0.3
"""Standard deviation of an effectiveness from a window alone [1] beyond which it says nothing."""
_SHORTEST_S = 1.0  # of a finding; what is shorter is on the way to the next
_BEGIN_S = 2.0  # at the beginning of a log, in which nothing is found


@dataclass(frozen=True)
class Finding:
    """What one actuator did during a stretch: `state` of `hypotheses.STATES`, from and until [s].

    `probability` is that of this state of this actuator, averaged over the stretch. `effectiveness` and `std` are the smoothed
    ones; `position` is where it was held, or by how much it was offset, in its unit. NaN is what a state has not.
    """

    actuator: str
    state: str
    from_s: float
    until_s: float
    probability: float
    effectiveness: float
    std: float
    position: float


@dataclass(frozen=True)
class Diagnosis:
    """What a log says.

    Attributes:
        actuators: their names.
        time_s: [T] beginning of each block of 0.2 s.
        states: [T, n] number of `hypotheses.STATES`.
        probability: [T, n] of that state.
        effectiveness, std: [T, n] smoothed; NaN where an actuator is held, as nothing follows its command.
        alone_std: [T, n] what a window of 10 s says by itself.
        inflation: [T, n] of that variance by the other actuators' moving alike.
        findings: each stretch in which an actuator did not work.
    """

    log: FlightLog
    actuators: tuple[str, ...]
    units: tuple[str, ...]
    time_s: np.ndarray
    states: np.ndarray
    probability: np.ndarray
    effectiveness: np.ndarray
    std: np.ndarray
    alone_std: np.ndarray
    inflation: np.ndarray
    findings: tuple[Finding, ...]

    def unknown_share(self, actuator: int) -> float:
        """Share of the log in which nothing can be known of an actuator."""
        return float(np.mean(self.alone_std[:, actuator] > UNKNOWN_STD))


def diagnosed(log: FlightLog, setup: Setup, units: Sequence[str]) -> Diagnosis:
    """Diagnose a log with the design model of `setup`; `units` [n] of the actuators' positions, `deg` or `N`."""
    data, m = regression(log, setup, BIN_S, block=BLOCK), model_record(setup)[0]
    c = settings_record(setup, AdaptiveInversionSettings())[0]
    found = hypotheses(m.low, m.high, m.servo > 0)
    cost, course = costs(found), np.zeros(len(data.z) // BLOCK, dtype=np.int64)
    known = data.known & (data.time_s > data.time_s[0] + _BEGIN_S)
    for step in range(ROUNDS):
        errors, calm = _errors(data, found, course)
        at = quiet(errors, known & calm, BIN_S) if step == 0 else known & calm
        noise = noise_of(errors, at, c.model_error_std, 1.0 / c.model_error_rate, BIN_S)
        white = _White(data, noise, known)
        evidence = white.evidence(found)
        course = likeliest(evidence, cost)
    probability = probabilities(evidence, cost)
    course = _renamed(_without_short(course), found, evidence, probability)
    return _told(log, setup, units, data, white, found, course, probability, float(c.process_noise))


def _errors(
    data: Regression, found: Sequence[Hypothesis], course: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """([bins, 4] what a course leaves of z, [bins] where nothing swings by itself)."""
    explained, each, calm = (
        data.phi[NOMINAL].sum(axis=2),
        np.repeat(course, BLOCK),
        np.ones(len(data.z), bool),
    )
    for number in np.unique(course):
        one, rows = found[number], each == number
        if one.actuator >= 0:
            explained[rows] += _change(data.phi, data.unit, one)[rows]
            calm[rows] = one.swing == 0.0
    return data.z - explained, calm


def _change(phi: dict, unit: np.ndarray, one: Hypothesis) -> np.ndarray:  # type: ignore[type-arg]
    """[bins, 4] what a hypothesis adds to the rates of a healthy aircraft."""
    i = one.actuator
    return np.asarray(
        one.gain * phi[one.variant][:, :, i] + one.position * unit[:, :, i] - phi[NOMINAL][:, :, i]
    )


class _White:
    """The regression with white errors of unit variance, and the variance that the model's own error adds."""

    def __init__(self, data: Regression, noise: Noise, known: np.ndarray) -> None:
        self.phi = {variant: noise.white(columns) for variant, columns in data.phi.items()}
        self.unit, self.z = noise.white(data.unit), noise.white(data.z)
        self.at_once = np.einsum("ij,tjn->tin", noise.mixing, data.unit)
        squares = np.sum(self.phi[NOMINAL] ** 2, axis=2) + self.z**2
        kernel = np.ones(round(_SHARE_S / BIN_S)) * BIN_S / _SHARE_S
        mean = np.stack([np.convolve(column, kernel, "same") for column in squares.T], axis=1)
        self.weight = np.where(settled(known)[:, None], TEMPER / (1.0 + MODEL_SHARE**2 * mean), 0.0)

    def evidence(self, found: Sequence[Hypothesis]) -> np.ndarray:
        """[blocks, hypotheses] log-likelihoods, relative to that all actuators work."""
        left = self.z - self.phi[NOMINAL].sum(axis=2)
        made = np.zeros((len(self.z) // BLOCK, len(found)))
        for number, one in enumerate(found):
            if one.actuator >= 0:
                ratio = self._swing(left, one) if one.swing else self._ratio(left, one)
                made[:, number] = ratio.reshape(-1, BLOCK).sum(axis=1)
        return made

    def _ratio(self, left: np.ndarray, one: Hypothesis) -> np.ndarray:
        change = _change(self.phi, self.unit, one)
        return np.asarray(((left - 0.5 * change) * change * self.weight).sum(axis=1))

    def _swing(self, left: np.ndarray, one: Hypothesis) -> np.ndarray:
        """Of motion that nothing foretells: variance `swing`^2 along the actuator's column."""
        column = self.at_once[:, :, one.actuator]
        power = one.swing**2 * (column * column * self.weight).sum(axis=1)
        along = one.swing * (left * column * self.weight).sum(axis=1)
        return np.asarray(0.5 * along**2 / (1.0 + power) - 0.5 * np.log1p(power))


def _without_short(course: np.ndarray) -> np.ndarray:
    """The course without stretches that are too short for a finding: each becomes what follows it."""
    edges = np.flatnonzero(np.diff(course)) + 1
    starts, ends = np.concatenate([[0], edges]), np.concatenate([edges, [len(course)]])
    made, least = course.copy(), round(_SHORTEST_S / (BLOCK * BIN_S))
    for start, end in reversed(list(zip(starts, ends, strict=True))):
        if end - start < least and end < len(course):
            made[start:end] = made[end]
    return made


def _renamed(
    course: np.ndarray, found: Sequence[Hypothesis], evidence: np.ndarray, probability: np.ndarray
) -> np.ndarray:
    """The course with the likeliest state of the actuator in each stretch: a state of many values may share its probability out
    among them, and lose to one value of another."""
    made = course.copy()
    actuators = np.array([one.actuator for one in found])
    kinds = np.array([STATES.index(one.state) for one in found])
    broken = kinds * len(found) + actuators
    for key in np.unique(broken[course[course > 0]]):
        for first, end in stretches(broken[course] == key):
            own = np.flatnonzero(actuators == actuators[course[first]])
            mass = {
                kind: probability[first:end, own[kinds[own] == kind]].sum() for kind in np.unique(kinds[own])
            }
            best = max(mass, key=lambda kind: mass[kind])
            if best != kinds[course[first]]:
                same = own[kinds[own] == best]
                made[first:end] = same[np.argmax(evidence[first:end, same].sum(axis=0))]
    return made


def _told(
    log: FlightLog, setup: Setup, units: Sequence[str], data: Regression, white: _White,
    found: Sequence[Hypothesis], course: np.ndarray, probability: np.ndarray, walk: float,
) -> Diagnosis:  # fmt: skip
    blocks, n = len(course), len(setup.actuators)
    states, sure = np.zeros((blocks, n), dtype=int), np.zeros((blocks, n))
    for i in range(n):
        for number in np.unique(course):
            if found[number].actuator == i:
                states[course == number, i] = STATES.index(found[number].state)
        for state in np.unique(states[:, i]):
            here = [one.state if one.actuator == i else "works" for one in found]
            same = [j for j, name in enumerate(here) if name == STATES[state]]
            rows = states[:, i] == state
            sure[rows, i] = probability[rows][:, same].sum(axis=1)
    information, towards = _moments(data, white, found, course)
    changes = np.diff(states, axis=0, prepend=states[:1]) != 0
    effectiveness, std = smoothed(information, towards, walk * float(np.sqrt(BLOCK * BIN_S)), changes)
    held = states == STATES.index("held")
    effectiveness, std = np.where(held, np.nan, effectiveness), np.where(held, np.nan, std)
    nominal, _ = _moments(data, white, found, np.zeros_like(course))
    own, inflation = alone(nominal, round(WINDOW_S / (BLOCK * BIN_S)))
    time_s, names = data.time_s[::BLOCK], tuple(setup.model.actuators)
    numbers = (states, sure, effectiveness, std)
    places = np.array([1.0 if unit == "N" else 180.0 / np.pi for unit in units]) * setup.scale
    findings = tuple(_findings(names, places, time_s, found, course, numbers))
    return Diagnosis(
        log, names, tuple(units), time_s, states, sure, effectiveness, std, own, inflation, findings
    )


def _moments(
    data: Regression, white: _White, found: Sequence[Hypothesis], course: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Phi' Phi and Phi' z of each block, with what the course says of lags and positions."""
    phi, z = white.phi[NOMINAL].copy(), white.z.copy()
    each = np.repeat(course, BLOCK)
    for number in np.unique(course):
        one, rows = found[number], each == number
        if one.actuator >= 0:
            i = one.actuator
            phi[rows, :, i] = 0.0 if one.state == "held" else white.phi[one.variant][rows, :, i]
            z[rows] -= one.position * white.unit[rows, :, i]
    weighted = phi * white.weight[:, :, None]
    information = np.einsum("tri,trj->tij", weighted, phi)
    towards = np.einsum("tri,tr->ti", weighted, z)
    blocks = len(course)
    shape = (blocks, BLOCK, *information.shape[1:])
    return information.reshape(shape).sum(axis=1), towards.reshape(shape[:3]).sum(axis=1)


def _findings(
    names: Sequence[str], scale: np.ndarray, time_s: np.ndarray, found: Sequence[Hypothesis], course: np.ndarray,
    numbers: tuple[np.ndarray, ...],
) -> Iterator[Finding]:  # fmt: skip
    """Each stretch in which an actuator did something else than work."""
    states, sure, effectiveness, std = numbers
    places = np.array([one.position for one in found])
    made = []
    for i, name in enumerate(names):
        for state in range(1, len(STATES)):
            for first, end in stretches(states[:, i] == state):
                has_place = STATES[state] in ("held", "offset")
                position = (
                    float(np.median(places[course[first:end]])) * float(scale[i]) if has_place else np.nan
                )
                until_s = float(time_s[end - 1]) + BLOCK * BIN_S
                known = effectiveness[first:end, i], std[first:end, i]
                level, spread = (float(np.median(each)) for each in known)
                mean = float(np.mean(sure[first:end, i]))
                made.append(
                    Finding(name, STATES[state], float(time_s[first]), until_s, mean, level, spread, position)
                )
    return iter(sorted(made, key=lambda each: each.from_s))
