"""The largest gain that the errors of a scenario allow: gamma and epsilon of (13), or the process noise of the default law."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from testbed.scenario.load import Scenario
from testbed.theory.error_sources import ErrorSource, known_offset, sources
from testbed.theory.false_alarms import false_alarm_rate
from testbed.theory.trimmed_law import TrimmedLaw

LEAST_SHAPE = 4.0
"""Least nu of a design: with more noise the tails are too heavy for a variance to say much."""
THRESHOLD_SHARE = 0.5
"""Threshold over the effectiveness that must not be flagged, where errors that last leave room for it."""
OFFSETS = 3.0
"""Errors that last are allowed for by this many standard deviations."""
_STEP_SHARE, _LAG_SHARE = 0.1, 0.25
"""Largest gamma (dt + delay), and largest gamma over an actuator's corner: without overshoot even if its lag were not modelled."""
_SLOWEST, _GAMMAS = 0.1, 40
_PROCESS_NOISE, _NOISES = (0.5, 0.005), 10
_PERSISTENCES_S = (0.05, 0.1, 0.2, 0.5)
_ANSWER_S = 30.0  # how long an estimate is followed after an error
_FINEST, _COARSEST = 0.1, 0.5
"""Least and largest epsilon over the position at the trim: a transient that takes a below epsilon slows the estimate."""
_ROOM = 0.7  # largest lower bound of the estimates, over the threshold
_ROUND = 3  # digits of a setting

Respond = Callable[[np.ndarray], np.ndarray]
"""Change of the estimates [steps, n] for a change [steps, 4] of the measured error."""


@dataclass(frozen=True)
class Tolerance:
    """What is asked of a design.

    Attributes:
        deviation: largest standard deviation of an estimate of a healthy actuator [1].
        false_alarms_per_hour: of the whole aircraft.
        keep: effectiveness that must not be flagged [1].
        within_s: time in which an estimate has to converge, or None.
    """

    deviation: float = 0.1
    false_alarms_per_hour: float = 0.1
    keep: float = 0.2
    within_s: float | None = None


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

    @property
    def middle(self) -> np.ndarray:
        """[n] lowest estimate over the truth that errors which last are expected to cause."""
        return 1.0 + np.minimum(self.bias, 0.0) - OFFSETS * self.offset


@dataclass(frozen=True)
class Chosen:
    """The settings chosen, and the predictions for each of the n actuators; attributes as in `Candidate`.

    Attributes:
        settings: keys of the scenario's `controller`.
        met: [n] whether noise and false alarms are tolerable for each actuator.
        middle: [n] as `Candidate.middle`.
    """

    settings: Mapping[str, Any]
    parts: np.ndarray
    noise: np.ndarray
    offset: np.ndarray
    bias: np.ndarray
    rates: np.ndarray
    middle: np.ndarray
    met: np.ndarray
    false_alarms_per_s: float


def choose(law: TrimmedLaw, errors: Errors, tolerance: Tolerance) -> Chosen:
    """The largest gain of each kind of actuator with which its noise and its false alarms are tolerable.

    Where no gain is tolerable it is the smallest that is tried.
    """
    newton = law.newton
    kinds = ["servo" if kind == "servo" else "motor" for kind in law.setup.model.kinds]
    groups = [kind for kind in ("servo", "motor") if kind in kinds] if newton else ["every"]
    candidates = _newton_candidates if newton else _weighted_candidates
    picked: dict[str, tuple[Candidate, float, bool]] = {}
    for group in groups:
        of = np.array([group in (kind, "every") for kind in kinds])
        picked[group] = _first_tolerable(candidates(law, errors), of, law, tolerance)
    every = [picked[kind if newton else "every"] for kind in kinds]
    persistence = max(found for _, found, _ in every)
    whole = {
        name: np.stack([getattr(each, name)[..., i] for i, (each, _, _) in enumerate(every)], axis=-1)
        for name in ("parts", "noise", "offset", "bias", "rates")
    }
    share = _share(np.array([each.middle[i] for i, (each, _, _) in enumerate(every)]))
    joint = Candidate(math.nan, **whole)
    threshold = _rounded(share * tolerance.keep)
    gains = {group: each.gain for group, (each, _, _) in picked.items()}
    settings = {"threshold": threshold, "persistence_s": persistence}
    if newton:
        settings = {**_newton_settings(gains, kinds, law, joint, tolerance), **settings}
        if law.settings.lambda_min > _ROOM * threshold:
            settings["lambda_min"] = _rounded(_ROOM * threshold)
    else:
        settings = {
            "process_noise_per_root_s": _rounded(gains["every"]),
            **settings,
            "propeller_threshold": threshold,
        }
    head: dict[str, Any] = {"type": "adaptive_inversion"}
    if newton:
        head["preset"] = "paper"
    return Chosen(
        settings={**head, **settings},
        middle=joint.middle,
        met=np.array([met for _, _, met in every]),
        false_alarms_per_s=float(joint.alarms(law.setup.dt_s, persistence, share).sum()),
        **whole,
    )


def _first_tolerable(
    candidates: Iterator[Candidate], of: np.ndarray, law: TrimmedLaw, tolerance: Tolerance
) -> tuple[Candidate, float, bool]:
    """The first candidate that is tolerable for the actuators `of` [n], its persistence [s], and whether there is one."""
    tolerated = tolerance.false_alarms_per_hour / 3600.0 / len(of)
    for candidate in candidates:
        allowed = _allowed(candidate.offset[of], tolerance)
        if np.any(candidate.noise[of] > allowed):
            continue
        share = _share(candidate.middle[of])
        for persistence in _PERSISTENCES_S:
            if np.all(candidate.alarms(law.setup.dt_s, persistence, share)[of] <= tolerated):
                return candidate, persistence, True
    return candidate, _PERSISTENCES_S[-1], False


def _allowed(offset: np.ndarray, tolerance: Tolerance) -> np.ndarray:
    """Noise that is allowed beside these offsets; where offsets take all that is tolerated, half of it."""
    whole = min(tolerance.deviation, 1.0 / math.sqrt(LEAST_SHAPE))
    return np.sqrt(np.maximum(whole**2 - offset**2, (0.5 * whole) ** 2))


def _share(middle: np.ndarray) -> float:
    """Threshold over `keep`: less where errors that last bring estimates down."""
    return THRESHOLD_SHARE * float(np.clip(middle.min(), 0.1, 1.0))


def _newton_candidates(law: TrimmedLaw, errors: Errors) -> Iterator[Candidate]:
    for gamma in np.geomspace(max(_fastest(law), _SLOWEST), _SLOWEST, _GAMMAS):
        rates = np.full(errors.n, gamma)
        yield _candidate(float(gamma), errors, partial(law.newton_response, gamma=float(gamma)), rates)


def _fastest(law: TrimmedLaw) -> float:
    """Largest gamma that sampling and the actuators' lags allow [1/s]."""
    return min(_STEP_SHARE * law.rate_hz, _LAG_SHARE * float(np.min(law.setup.lags)))


def _weighted_candidates(law: TrimmedLaw, errors: Errors) -> Iterator[Candidate]:
    for noise in np.geomspace(*_PROCESS_NOISE, _NOISES):
        respond = partial(law.weighted_response, process_noise_per_root_s=float(noise))
        yield _candidate(float(noise), errors, respond, law.rates(process_noise_per_root_s=float(noise)))


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


def _newton_settings(
    gains: Mapping[str, float], kinds: list[str], law: TrimmedLaw, joint: Candidate, tolerance: Tolerance
) -> dict[str, Any]:
    """gamma and epsilon of each kind of actuator; a kind that the aircraft lacks has those of the other."""
    gamma = {kind: _rounded(gain) for kind, gain in gains.items()}
    finest = np.clip(joint.noise / _allowed(joint.offset, tolerance), _FINEST, _COARSEST) * np.abs(
        law.positions
    )
    epsilon = {}
    for kind in gamma:
        of = [i for i, one in enumerate(kinds) if one == kind]
        epsilon[kind] = _rounded(
            max(min(finest[of].max(), _COARSEST * np.abs(law.positions[of]).min()), 1e-3)
        )
    for settings in (gamma, epsilon):
        for kind in ("servo", "motor"):
            settings.setdefault(kind, next(iter(settings.values())))
    return {"gamma": gamma, "epsilon": epsilon}


def _rounded(value: float) -> float:
    """To three digits, downwards."""
    size = 10.0 ** (math.floor(math.log10(value)) - _ROUND + 1)
    return float(f"{math.floor(value / size + 1e-9) * size:.{_ROUND}g}")
