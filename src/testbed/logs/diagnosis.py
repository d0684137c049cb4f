"""What a log says of each actuator over time: the likeliest course of hypotheses, effectiveness, and where nothing can be known; in
sentences and in numbers."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from testbed.common.files import plain
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record, settings_record
from testbed.controllers.setup import Setup
from testbed.flight.columns import stretches
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import (
    NOMINAL,
    STATES,
    Hypothesis,
    alone,
    costs,
    hypotheses,
    likeliest,
    probabilities,
    smoothed,
)
from testbed.logs.regression import BIN_S, Noise, Regression, noise_of, quiet, regression, settled
from testbed.reporting.words import number as text_of
from testbed.reporting.words import title

WINDOW_S = 10.0
"""Length of the windows in which it is said what can be known."""
UNKNOWN_STD = 0.3
"""Standard deviation of an effectiveness from a window alone [1] beyond which it says nothing."""
_MUCH = 0.2
"""Share of a log in which nothing can be known of an actuator, from which on the story says so."""
_INFLATED = 10.0


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
    """What a log says; `print` shows its story.

    Attributes:
        actuators: their names.
        units: of their positions, `deg` or `N`.
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

    def __str__(self) -> str:
        return "\n".join(story(self))

    def unknown_share(self, actuator: int) -> float:
        """Share of the log in which nothing can be known of an actuator."""
        return float(np.mean(self.alone_std[:, actuator] > UNKNOWN_STD))


def story(diagnosis: Diagnosis) -> list[str]:
    """What the log says, in sentences: what was found, what cannot be known, and what was mended in the log."""
    log = diagnosis.log
    length = log.time_s[-1] - log.time_s[0]
    found = [sentence(finding, diagnosis) for finding in diagnosis.findings]
    return [*(found or [f"Nothing was found wrong in {length:.0f} s."]), *_unknown(diagnosis), *log.remarks]


def sentence(finding: Finding, diagnosis: Diagnosis) -> str:
    """`The left tail kept 20 % of its effect (+-6) from 20.0 s on (probability 0.99).`"""
    unit = diagnosis.units[diagnosis.actuators.index(finding.actuator)]
    at = f"{finding.position:.1f} {unit}"
    did = {
        "weak": f"kept {100 * finding.effectiveness:.0f} % of its effect (+-{100 * finding.std:.0f})",
        "lost": "had no effect",
        "held": f"did not follow its commands, and acted as if held at {at}",
        "offset": f"followed with an offset of {at}",
        "reversed": "acted against its commands",
        "slow": "followed more slowly than designed",
        "late": "followed late",
        "swings": "moved by itself",
    }[finding.state]
    last = finding.until_s >= diagnosis.time_s[-1]
    until = "on" if last else f"until {finding.until_s:.1f} s"
    return f"The {title(finding.actuator)} {did} from {finding.from_s:.1f} s {until} (probability {finding.probability:.2f})."


def _unknown(diagnosis: Diagnosis) -> Iterator[str]:
    for i, name in enumerate(diagnosis.actuators):
        share = diagnosis.unknown_share(i)
        if share > _MUCH:
            alike = float(np.median(diagnosis.inflation[:, i])) > _INFLATED
            why = "it moved like others" if alike else "it hardly moved"
            known = f"{WINDOW_S:g} s give its effectiveness with a standard deviation above {UNKNOWN_STD:g}"
            yield f"What the {title(name)} did cannot be known in {100 * share:.0f} % of the log: {why}, and {known}."


def summary(diagnosis: Diagnosis, model: str) -> str:
    """summary.json."""
    return as_json(
        {
            "log": diagnosis.log.name,
            "model": model,
            "duration_s": float(diagnosis.log.time_s[-1] - diagnosis.log.time_s[0]),
            "findings": [{k: _rounded(v) for k, v in vars(each).items()} for each in diagnosis.findings],
            "actuators": {
                name: {
                    "unknown_share": diagnosis.unknown_share(i),
                    "alone_std_median": _rounded(np.median(diagnosis.alone_std[:, i])),
                    "variance_inflation_median": _rounded(np.median(diagnosis.inflation[:, i])),
                }
                for i, name in enumerate(diagnosis.actuators)
            },
            "remarks": diagnosis.log.remarks,
            "story": story(diagnosis),
        }
    )


def as_json(contents: dict[str, Any]) -> str:
    """A summary as text. JSON has no NaN, so what is not there is null."""
    return json.dumps(plain(contents), indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"


def _rounded(value: Any) -> Any:
    return value if isinstance(value, str) else round(float(value), 6)


def table(diagnosis: Diagnosis) -> str:
    """diagnosis.csv: a row for each 0.2 s; `A_state` is a word; what a state has not is empty."""
    columns = {"time_s": [f"{time:.3f}" for time in diagnosis.time_s]}
    numbers = {
        "probability": diagnosis.probability, "effectiveness": diagnosis.effectiveness, "effectiveness_std": diagnosis.std,
        "alone_std": diagnosis.alone_std, "variance_inflation": diagnosis.inflation,
    }  # fmt: skip
    for i, name in enumerate(diagnosis.actuators):
        columns[f"{name}_state"] = [STATES[state] for state in diagnosis.states[:, i]]
        for what, values in numbers.items():
            columns[f"{name}_{what}"] = [text_of(value, absent="") for value in values[:, i]]
    return "".join(",".join(row) + "\n" for row in [columns, *zip(*columns.values(), strict=True)])


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
