"""What a log says of each actuator over time: the likeliest course of hypotheses, effectiveness, and where nothing can be known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record
from testbed.controllers.setup import Setup
from testbed.flight.columns import stretches
from testbed.logs.chain import alone, costs, likeliest, probabilities, smoothed
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import NOMINAL, STATES, Hypothesis, hypotheses
from testbed.logs.regression import BIN_S, Noise, Regression, noise_of, quiet, regression, settled
from testbed.logs.words import WINDOW_S, Diagnosis, Finding

BLOCK = 2
"""Bins of a block, in which nothing changes: 0.2 s."""
MODEL_SHARE = 0.15
"""Relative error of the terms of the regression [1] that no finding may rest on. It adds to the variance, as in the law."""
_SHARE_S = 1.0  # over which the terms' squares are averaged
TEMPER = 0.5
"""Factor on log-likelihoods: what the model leaves out is not as white as the noise that was fitted."""
ROUNDS = 2
"""Of fitting the noise to what the likeliest course leaves, and looking for that course."""
_SHORTEST_S = 1.0  # of a finding; what is shorter is on the way to the next
_BEGIN_S = 2.0  # at the beginning of a log, in which nothing is found


def diagnosed(log: FlightLog, setup: Setup) -> Diagnosis:
    """Diagnose a log with the design model of `setup`."""
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
    return _told(log, setup, white, found, course, probability, float(c.process_noise))


def _errors(
    data: Regression, found: Sequence[Hypothesis], course: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """([bins, 4] what a course leaves of z, [bins] where nothing swings by itself)."""
    explained, calm = data.phi[NOMINAL].sum(axis=2), np.ones(len(data.z), bool)
    each = np.repeat(course, BLOCK)
    for number in np.unique(course):
        one, rows = found[number], each == number
        if one.actuator >= 0:
            explained[rows] += _change(data, one)[rows]
            calm[rows] = one.swing == 0.0
    return data.z - explained, calm


def _change(data: Regression, one: Hypothesis) -> np.ndarray:
    """[bins, 4] what a hypothesis adds to the rates of a healthy aircraft."""
    i = one.actuator
    nominal, own = data.phi[NOMINAL][:, :, i], data.phi[one.variant][:, :, i]
    return np.asarray(one.gain * own + one.position * data.unit[:, :, i] - nominal)


class _White:
    """The regression with white errors of unit variance, and the variance that the model's own error adds."""

    def __init__(self, data: Regression, noise: Noise, known: np.ndarray) -> None:
        phi = {variant: noise.white(columns) for variant, columns in data.phi.items()}
        self.data = replace(data, z=noise.white(data.z), unit=noise.white(data.unit), phi=phi)
        self.at_once = np.einsum("ij,tjn->tin", noise.mixing, data.unit)
        squares = np.sum(phi[NOMINAL] ** 2, axis=2) + self.data.z**2
        kernel = np.ones(round(_SHARE_S / BIN_S)) * BIN_S / _SHARE_S
        mean = np.stack([np.convolve(column, kernel, "same") for column in squares.T], axis=1)
        self.weight = np.where(settled(known)[:, None], TEMPER / (1.0 + MODEL_SHARE**2 * mean), 0.0)

    def evidence(self, found: Sequence[Hypothesis]) -> np.ndarray:
        """[blocks, hypotheses] log-likelihoods, relative to that all actuators work."""
        left = self.data.z - self.data.phi[NOMINAL].sum(axis=2)
        made = np.zeros((len(left) // BLOCK, len(found)))
        for number, one in enumerate(found):
            if one.actuator >= 0:
                ratio = self._swing(left, one) if one.swing else self._ratio(left, one)
                made[:, number] = ratio.reshape(-1, BLOCK).sum(axis=1)
        return made

    def _ratio(self, left: np.ndarray, one: Hypothesis) -> np.ndarray:
        change = _change(self.data, one)
        return np.asarray(((left - 0.5 * change) * change * self.weight).sum(axis=1))

    def _swing(self, left: np.ndarray, one: Hypothesis) -> np.ndarray:
        """Of motion that nothing foretells: variance `swing`^2 along the actuator's column."""
        column = self.at_once[:, :, one.actuator]
        power = one.swing**2 * (column * column * self.weight).sum(axis=1)
        along = one.swing * (left * column * self.weight).sum(axis=1)
        return np.asarray(0.5 * along**2 / (1.0 + power) - 0.5 * np.log1p(power))

    def moments(self, found: Sequence[Hypothesis], course: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Phi' Phi and Phi' z of each block, with what the course says of lags and positions."""
        phi, z = self.data.phi[NOMINAL].copy(), self.data.z.copy()
        each = np.repeat(course, BLOCK)
        for number in np.unique(course):
            one, rows, i = found[number], each == number, found[number].actuator
            if i >= 0:
                phi[rows, :, i] = 0.0 if one.state == "held" else self.data.phi[one.variant][rows, :, i]
                z[rows] -= one.position * self.data.unit[rows, :, i]
        weighted = phi * self.weight[:, :, None]
        information = np.einsum("tri,trj->tij", weighted, phi)
        towards = np.einsum("tri,tr->ti", weighted, z)
        shape = (len(course), BLOCK, *information.shape[1:])
        return information.reshape(shape).sum(axis=1), towards.reshape(shape[:3]).sum(axis=1)


def _without_short(course: np.ndarray) -> np.ndarray:
    """The course without stretches that are too short for a finding: each becomes what follows it."""
    edges = np.flatnonzero(np.diff(course)) + 1
    starts, ends = np.concatenate([[0], edges]), np.concatenate([edges, [len(course)]])
    made, least = course.copy(), round(_SHORTEST_S / (BLOCK * BIN_S))
    for start, end in reversed(list(zip(starts, ends, strict=True))):
        if end - start < least and end < len(course):
            made[start:end] = made[end]
    return made


def _numbers(found: Sequence[Hypothesis]) -> tuple[np.ndarray, np.ndarray]:
    """Number of the actuator, -1 for none, and of the state of each hypothesis."""
    return np.array([one.actuator for one in found]), np.array([STATES.index(one.state) for one in found])


def _renamed(
    course: np.ndarray, found: Sequence[Hypothesis], evidence: np.ndarray, probability: np.ndarray
) -> np.ndarray:
    """The course with the likeliest state of the actuator in each stretch: a state of many values may share its probability out
    among them, and lose to one value of another."""
    made, (actuators, kinds) = course.copy(), _numbers(found)
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
    log: FlightLog, setup: Setup, white: _White,
    found: Sequence[Hypothesis], course: np.ndarray, probability: np.ndarray, walk: float,
) -> Diagnosis:  # fmt: skip
    (actuators, kinds), n = _numbers(found), len(setup.actuators)
    states = np.where(actuators[course][:, None] == np.arange(n), kinds[course][:, None], 0)
    sure = np.zeros(states.shape)
    for i in range(n):
        here = np.where(actuators == i, kinds, 0)
        for state in np.unique(states[:, i]):
            rows = states[:, i] == state
            sure[rows, i] = probability[rows][:, here == state].sum(axis=1)
    information, towards = white.moments(found, course)
    changes = np.diff(states, axis=0, prepend=states[:1]) != 0
    effectiveness, std = smoothed(information, towards, walk * float(np.sqrt(BLOCK * BIN_S)), changes)
    held = states == STATES.index("held")
    effectiveness, std = np.where(held, np.nan, effectiveness), np.where(held, np.nan, std)
    nominal, _ = white.moments(found, np.zeros_like(course))
    own, inflation = alone(nominal, round(WINDOW_S / (BLOCK * BIN_S)))
    time_s, names = white.data.time_s[::BLOCK], tuple(setup.model.actuators)
    units = tuple("deg" if kind == "servo" else "N" for kind in setup.model.kinds)
    told = Diagnosis(log, names, units, time_s, states, sure, effectiveness, std, own, inflation, ())
    places = np.array([one.position for one in found])[course]
    return replace(told, findings=tuple(_findings(told, places, setup.scale)))


def _findings(told: Diagnosis, places: np.ndarray, scale: np.ndarray) -> list[Finding]:
    """Each stretch in which an actuator did something else than work; `places` [T, scaled] are those of the course."""
    made = []
    for i, name in enumerate(told.actuators):
        unit = (180.0 / np.pi if told.units[i] == "deg" else 1.0) * float(scale[i])
        for state in range(1, len(STATES)):
            for first, end in stretches(told.states[:, i] == state):
                at, has_place = slice(first, end), STATES[state] in ("held", "offset")
                finding = Finding(
                    actuator=name,
                    state=STATES[state],
                    from_s=float(told.time_s[first]),
                    until_s=float(told.time_s[end - 1]) + BLOCK * BIN_S,
                    probability=float(np.mean(told.probability[at, i])),
                    effectiveness=float(np.median(told.effectiveness[at, i])),
                    std=float(np.median(told.std[at, i])),
                    position=float(np.median(places[at])) * unit if has_place else np.nan,
                )
                made.append(finding)
    return sorted(made, key=lambda each: each.from_s)
