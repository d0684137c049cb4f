"""Gains that can be chosen, the largest first, each with what the errors of a scenario do to the estimates."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from testbed.gains.error_sources import ErrorSource, known_offset, sources
from testbed.gains.false_alarms import false_alarm_rate
from testbed.gains.moving_law import MovingLaw
from testbed.gains.trimmed_law import TrimmedLaw
from testbed.scenario.load import Scenario

OFFSETS = 3.0
"""Errors that last are allowed for by this many standard deviations."""
_STEP_SHARE, _LAG_SHARE = 0.1, 0.25
"""Largest gamma times the control step, and largest gamma over an actuator's corner: without overshoot even if its lag were not
modelled."""
_SLOWEST, _GAMMAS = 0.1, 40
_PROCESS_NOISE, _NOISES = (0.5, 0.005), 10
_ANSWER_S = 30.0  # how long an estimate is followed after an error
_HOPELESS = 0.05

Respond = Callable[[np.ndarray], np.ndarray]
"""Change of the estimates [steps, n] for a change [steps, 4] of the measured error."""


@dataclass(frozen=True)
class Errors:
    """All errors of a scenario: the random ones, and the constant part of e that is no chance [4]; how long estimates answer."""

    sources: list[ErrorSource]
    known: np.ndarray
    n: int
    steps: int
    dt_s: float

    @classmethod
    def of(cls, law: TrimmedLaw, scenario: Scenario) -> Errors:
        """Those of this scenario in this trimmed flight."""
        steps = round(_ANSWER_S * law.rate_hz)
        n = len(law.positions)
        return cls(sources(law, scenario), known_offset(law, scenario), n, steps, law.setup.dt_s)

    def parts(self, respond: Respond) -> np.ndarray:
        """[sources, n] standard deviation of each estimate by each error."""
        found = [
            source.deviation(respond(self._padded(source.response)), self.dt_s) for source in self.sources
        ]
        return np.array(found).reshape(len(found), self.n)

    def bias(self, respond: Respond) -> np.ndarray:
        """[n] what the constant part adds to the estimates in the end."""
        return respond(self._padded(self.known[None])).sum(axis=0)

    @property
    def lasting(self) -> np.ndarray:
        """[sources] which of them last longer than an estimate takes to converge."""
        return np.array([source.lasts for source in self.sources], dtype=bool)

    def _padded(self, response: np.ndarray) -> np.ndarray:
        whole = np.zeros((self.steps, 4))
        whole[: len(response)] = response
        return whole


@dataclass(frozen=True)
class Candidate:
    """One gain, and what errors do to the n estimates with it.

    Attributes:
        gain: gamma [1/s], or process noise [1/sqrt(s)].
        parts: [sources, n] standard deviation by each error.
        noise, offset: [n] standard deviation by the errors that do not last, and by those that do.
        bias: [n] by the constant part.
        rates: [n] at which an error decays [1/s].
    """

    gain: float
    parts: np.ndarray
    noise: np.ndarray
    offset: np.ndarray
    bias: np.ndarray
    rates: np.ndarray

    def alarms(self, dt_s: float, persistence_s: float, share: float) -> np.ndarray:
        """[n] false alarms per second of actuators whose effectiveness is the threshold over `share`.

        Relative to the truth, noise and offsets are the same for any effectiveness while the force is held. Offsets count by
        `OFFSETS` standard deviations.
        """
        middle = self.middle
        found = np.full(len(middle), math.inf)
        for i in np.flatnonzero(middle > share):
            nu = (middle[i] / self.noise[i]) ** 2 if self.noise[i] > 0.0 else math.inf
            found[i] = false_alarm_rate(
                nu, float(self.rates[i]), dt_s, persistence_s, share / float(middle[i])
            )
        return found

    def judged(self, of: np.ndarray) -> np.ndarray:
        """[n] those of the actuators `of` [n] for which a gain can be chosen: no errors that last can bring them to zero."""
        hopeful = of & (self.middle > _HOPELESS)
        return hopeful if hopeful.any() else of

    @property
    def middle(self) -> np.ndarray:
        """[n] lowest estimate over the truth that errors which last are expected to cause."""
        return 1.0 + np.minimum(self.bias, 0.0) - OFFSETS * self.offset


def newton_candidates(law: TrimmedLaw, errors: Errors) -> Iterator[Candidate]:
    """Values of gamma of (13), down from what sampling and the actuators' lags allow."""
    for gamma in np.geomspace(max(_fastest(law), _SLOWEST), _SLOWEST, _GAMMAS):
        rates = np.full(errors.n, gamma)
        yield _candidate(float(gamma), errors, partial(law.newton_response, gamma=float(gamma)), rates)


def _fastest(law: TrimmedLaw) -> float:
    """Largest gamma that sampling and the actuators' lags allow [1/s]."""
    return min(_STEP_SHARE * law.rate_hz, _LAG_SHARE * float(np.min(law.setup.lags)))


def weighted_candidates(
    law: TrimmedLaw, errors: Errors, moving: MovingLaw | None = None
) -> Iterator[Candidate]:
    """Values of the default law's process noise; `moving` is the law in weather."""
    for noise in np.geomspace(*_PROCESS_NOISE, _NOISES):
        change = {"process_noise_per_root_s": float(noise)}
        respond = partial(law.weighted_response, process_noise_per_root_s=float(noise))
        found = _candidate(float(noise), errors, respond, law.rates(**change))
        yield found if moving is None else _moved(found, errors, moving, change)


def _moved(found: Candidate, errors: Errors, moving: MovingLaw, change: Mapping[str, float]) -> Candidate:
    """A candidate with the noise of actuators that move, and its parts in proportion."""
    passing = [source for source in errors.sources if not source.lasts]
    if not passing:
        return found
    noise = moving.deviation(passing, **change)
    share = noise / np.where(found.noise > 0.0, found.noise, 1.0)
    parts = np.where(errors.lasting[:, None], found.parts, share * found.parts)
    return replace(found, noise=noise, parts=parts)


def _candidate(gain: float, errors: Errors, respond: Respond, rates: np.ndarray) -> Candidate:
    parts, bias = errors.parts(respond), errors.bias(respond)
    lasting = errors.lasting
    squares = np.square(parts)
    return Candidate(
        gain,
        parts,
        np.sqrt(squares[~lasting].sum(axis=0)),
        np.sqrt(squares[lasting].sum(axis=0)),
        bias,
        rates,
    )
