"""What an actuator may have done during a stretch of a log, and what each of these would have added to the rates;
and over the blocks of the log the likeliest course of these, and effectiveness with its uncertainty.

The course is of a hidden Markov model. Costs of changes are logarithms of how likely one is within a block, before anything is read
from the log. What broke does not often work again, and hardly ever does another actuator fail in the same block in which it does.

Effectiveness is that of a Kalman filter and a smoother (Rauch, Tung, Striebel). Its states and their constants are those of the
law's `estimator`: a random walk of each effectiveness, which begins at 1.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE, UNKNOWN_VARIANCE

MEANINGS = {
    "works": "it does what it is commanded",
    "weak": "it does a part of it",
    "lost": "it has no force",
    "held": "its force does not follow its command",
    "offset": "it follows its command with an offset",
    "reversed": "its force goes against its command",
    "slow": "it follows more slowly than it is designed to",
    "late": "it follows with a delay",
    "swings": "it moves by itself",
}
STATES = tuple(MEANINGS)
"""What is said of an actuator."""


class Variant(NamedTuple):
    """The actuators' model changed: its lag and rate limit multiplied, and its commands delayed [s]."""

    lag: float = 1.0
    rate: float = 1.0
    delay_s: float = 0.0


NOMINAL = Variant()
_SLOW = (Variant(lag=0.33), Variant(lag=0.1), Variant(rate=0.02), Variant(rate=0.005))
_LATE = tuple(Variant(delay_s=delay_s) for delay_s in (0.1, 0.15, 0.2, 0.4))
VARIANTS = (NOMINAL, *_SLOW, *_LATE)
"""Every model that the log is replayed with."""

_WEAK = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
_REVERSED = (-0.5, -1.0)
_OFFSETS = (0.15, 0.3, 0.45, 0.6, 0.9, 1.2)
_SWINGS = (0.1, 0.3, 0.8)
_HELD = 27
LOST_BELOW = 0.15
"""Effectiveness below which an actuator counts as lost."""


class Hypothesis(NamedTuple):
    """An actuator's force is `gain` times that of `variant`, plus that of `position` [scaled].

    `swing` is the standard deviation of what it does besides [scaled]. The first hypothesis of a chain is that all actuators work:
    its actuator is -1.
    """

    actuator: int
    state: str
    gain: float = 1.0
    position: float = 0.0
    variant: Variant = NOMINAL
    swing: float = 0.0

    def near(self, other: Hypothesis) -> bool:
        """Whether a course of one may go on as the other: what is held may move, and what is weak may grow weaker."""
        return self[:2] == other[:2] and self.state in ("held", "weak")


def hypotheses(low: np.ndarray, high: np.ndarray, servo: np.ndarray) -> list[Hypothesis]:
    """All of them; the first is that every actuator works. Stops `low`, `high` [n, scaled], and which actuators are servos [n].

    Only a servo may be slow or late. Commands of a propeller answer to the noise of airspeed and acceleration, and look late where
    they are not.
    """
    found = [Hypothesis(-1, "works")]
    for i in range(len(low)):
        found += _of_actuator(i, float(low[i]), float(high[i]), bool(servo[i]))
    return found


def _of_actuator(i: int, low: float, high: float, servo: bool) -> Iterator[Hypothesis]:
    yield Hypothesis(i, "lost", 0.0)
    for gain in _WEAK:
        yield Hypothesis(i, "weak" if gain >= LOST_BELOW else "lost", gain)
    for gain in _REVERSED:
        yield Hypothesis(i, "reversed", gain)
    braked = 0.0 if servo else 0.5  # a propeller that stands has more drag than one at its lowest throttle
    for position in np.linspace(low - braked, high, _HELD):
        yield Hypothesis(i, "held", 0.0, float(position))
    for offset in _OFFSETS:
        yield Hypothesis(i, "offset", 1.0, offset)
        yield Hypothesis(i, "offset", 1.0, -offset)
    for swing in _SWINGS:
        yield Hypothesis(i, "swings", swing=swing)
    for state, variants in (("slow", _SLOW), ("late", _LATE)) if servo else ():
        for variant in variants:
            yield Hypothesis(i, state, variant=variant)


FAILS, RECOVERS, CHANGES, MOVES, ANOTHER, SWINGS = -16.0, -16.0, -10.0, -3.0, -60.0, -6.0
"""Cost that an actuator fails, works again, fails in another way, goes to a neighbouring value of the same failure, and works again
while another fails; and what a swing costs more than other failures, because it explains anything a little."""


def costs(found: Sequence[Hypothesis]) -> np.ndarray:
    """[S, S] cost of the change from hypothesis i to j, 0 where nothing changes. The values of a state share its probability."""
    counts = Counter(one[:2] for one in found)
    made = np.zeros((len(found), len(found)))
    for i, one in enumerate(found):
        for j, other in enumerate(found):
            if i != j:
                made[i, j] = _cost(one, other) + (SWINGS if other.state == "swings" else 0.0)
                made[i, j] -= math.log(counts[other[:2]])
                made[i, j] = MOVES if abs(i - j) == 1 and one.near(other) else made[i, j]
    return made


def _cost(one: Hypothesis, other: Hypothesis) -> float:
    if one.actuator < 0:
        return FAILS
    if other.actuator < 0:
        return RECOVERS
    return CHANGES if one.actuator == other.actuator else ANOTHER


def likeliest(evidence: np.ndarray, cost: np.ndarray) -> np.ndarray:
    """[T] the likeliest course, by Viterbi's algorithm; it begins with hypothesis 0.

    Args:
        evidence: [T, S] log-likelihood of each block under each hypothesis, relative to the first.
        cost: [S, S] of `costs`.
    """
    count, size = evidence.shape
    value, course = np.where(np.arange(size) == 0, 0.0, -1e12), np.zeros(count, dtype=np.int64)
    _viterbi(evidence, cost, np.zeros((count, size), dtype=np.int64), value, np.zeros(size), course)
    return course


@compiled
def _viterbi(evidence, cost, best, value, after, course):
    """Fill `course` [T]; `best` [T, S], `value` [S] of each hypothesis at the beginning, and `after` [S] are working memory."""
    count, size = evidence.shape
    for t in range(count):
        for j in range(size):
            chosen, most = j, value[j]
            for i in range(size):
                if value[i] + cost[i, j] > most:
                    chosen, most = i, value[i] + cost[i, j]
            after[j], best[t, j] = most + evidence[t, j], chosen
        for j in range(size):
            value[j] = after[j]
    state = 0
    for j in range(size):
        if value[j] > value[state]:
            state = j
    for t in range(count - 1, -1, -1):
        course[t] = state
        state = best[t, state]


def probabilities(evidence: np.ndarray, cost: np.ndarray) -> np.ndarray:
    """[T, S] probability of each hypothesis in each block given the whole log, by the forward-backward algorithm."""
    change = np.exp(cost)
    change /= change.sum(axis=1, keepdims=True)
    likelihood = np.exp(evidence - evidence.max(axis=1, keepdims=True)) + 1e-300
    forward, backward = np.zeros_like(evidence), np.ones_like(evidence)
    now = np.eye(1, len(cost))[0]
    for t, each in enumerate(likelihood):
        now = (now @ change) * each
        now /= now.sum()
        forward[t] = now
    for t in range(len(evidence) - 2, -1, -1):
        behind = change @ (likelihood[t + 1] * backward[t + 1])
        backward[t] = behind / behind.sum()
    both = forward * backward + 1e-300
    return np.asarray(both / both.sum(axis=1, keepdims=True))


def smoothed(
    information: np.ndarray, towards: np.ndarray, walk: float, changes: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """([T, n] effectiveness, [T, n] its standard deviation).

    Args:
        information: [T, n, n] of each block, Phi' Phi of white columns.
        towards: [T, n] Phi' z.
        walk: standard deviation of a change within a block.
        changes: [T, n] whether the actuator begins to do something else: nothing is known of it then.
    """
    count, n = towards.shape
    before, after = np.zeros((count, n)), np.zeros((count, n))
    P_before, P_after = np.zeros((count, n, n)), np.zeros((count, n, n))
    x, P = np.ones(n), HEALTHY_VARIANCE * np.eye(n)
    for t in range(count):
        P = P + np.diag(np.where(changes[t], UNKNOWN_VARIANCE, walk * walk))
        before[t], P_before[t] = x, P
        gain = np.linalg.inv(np.eye(n) + P @ information[t])
        P = gain @ P
        P = 0.5 * (P + P.T)
        x = x + P @ (towards[t] - information[t] @ x)
        after[t], P_after[t] = x, P
    for t in range(count - 2, -1, -1):
        back = P_after[t] @ np.linalg.inv(P_before[t + 1])
        after[t] += back @ (after[t + 1] - before[t + 1])
        P_after[t] += back @ (P_after[t + 1] - P_before[t + 1]) @ back.T
    variance = np.diagonal(P_after, axis1=1, axis2=2)
    return after, np.sqrt(np.maximum(variance, 0.0))


def alone(information: np.ndarray, width: int) -> tuple[np.ndarray, np.ndarray]:
    """What the log itself says in a window about each block, without any belief before it.

    Returns:
        [T, n] the standard deviation of each effectiveness, and [T, n] the inflation of its variance by the other actuators: 1
        where no other moved like it, and large where several cannot be told apart.
    """
    kernel = np.ones(min(width, len(information)))
    sums = np.apply_along_axis(lambda x: np.convolve(x, kernel, "same"), 0, information)
    n = sums.shape[1]
    own = np.maximum(np.diagonal(sums, axis1=1, axis2=2), 1e-9)
    scale = 1.0 / np.sqrt(own)
    correlation = sums * scale[:, :, None] * scale[:, None, :] + 1e-9 * np.eye(n)
    inflation = np.maximum(np.diagonal(np.linalg.inv(correlation), axis1=1, axis2=2), 1.0)
    return np.sqrt(inflation / own), inflation
