"""What an actuator may have done during a stretch of a log, and what each of these would have added to the rates."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

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
