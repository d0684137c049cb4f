"""The largest gain that the errors of a scenario allow: gamma and epsilon of (13), or the process noise of the default law."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from testbed.gains.candidates import Candidate, Errors, newton_candidates, weighted_candidates
from testbed.gains.moving_law import MovingLaw
from testbed.gains.trimmed_law import TrimmedLaw

LEAST_SHAPE = 12.0
"""Least nu of a design, for each actuator: a deviation of 0.29. The estimates of one flight then stay where its trim is held. With
a nu of 9 a third of the v-tail's flights lost it: while both propellers' estimates are above 1.3 its lateral motion is unstable."""
THRESHOLD_SHARE = 0.5
"""Threshold over the effectiveness that must not be flagged, where errors that last leave room for it."""
_PERSISTENCES_S = (0.05, 0.1, 0.2, 0.5)
_FINEST, _COARSEST = 0.1, 0.5
"""Least and largest epsilon over the position at the trim: a transient that takes a below epsilon slows the estimate."""
_ROOM = 0.7  # largest lower bound of the estimates, over the threshold
_ROUND = 3  # digits of a setting


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
class Chosen:
    """The settings chosen, and what is predicted of the n actuators.

    Attributes:
        settings: keys of the scenario's `controller`.
        predicted: what errors do to the estimates, of each actuator with the gain of its kind.
        met: [n] whether noise and false alarms are tolerable for each actuator.
    """

    settings: Mapping[str, Any]
    predicted: Candidate
    met: np.ndarray
    false_alarms_per_s: float


def choose(law: TrimmedLaw, errors: Errors, tolerance: Tolerance, moving: MovingLaw | None = None) -> Chosen:
    """The largest gain of each kind of actuator with which its noise and its false alarms are tolerable.

    Where no gain is tolerable it is the smallest that is tried. `moving` is the weighted estimator in weather.
    """
    newton = law.newton
    kinds = ["servo" if kind == "servo" else "motor" for kind in law.setup.model.kinds]
    groups = [kind for kind in ("servo", "motor") if kind in kinds] if newton else ["every"]
    candidates = newton_candidates if newton else partial(weighted_candidates, moving=moving)
    picked: dict[str, tuple[Candidate, float, bool]] = {}
    for group in groups:
        of = np.array([group in (kind, "every") for kind in kinds])
        picked[group] = _first_tolerable(candidates(law, errors), of, law, tolerance)
    every = [picked[kind if newton else "every"] for kind in kinds]
    persistence = max(found for _, found, _ in every)
    joint = _joint([each for each, _, _ in every])
    share = _share(joint.middle[joint.judged(np.ones(errors.n, dtype=bool))])
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
        predicted=joint,
        met=np.array([met for _, _, met in every]),
        false_alarms_per_s=float(joint.alarms(law.setup.dt_s, persistence, share).sum()),
    )


def _joint(candidates: Sequence[Candidate]) -> Candidate:
    """Of actuator i, what candidate i predicts."""
    return Candidate(
        math.nan,
        *(
            np.stack([getattr(each, name)[..., i] for i, each in enumerate(candidates)], axis=-1)
            for name in ("parts", "noise", "offset", "bias", "rates")
        ),
    )


def _first_tolerable(
    candidates: Iterator[Candidate], of: np.ndarray, law: TrimmedLaw, tolerance: Tolerance
) -> tuple[Candidate, float, bool]:
    """The first candidate that is tolerable for the actuators `of` [n], its persistence [s], and whether there is one."""
    tolerated = tolerance.false_alarms_per_hour / 3600.0 / len(of)
    for candidate in candidates:
        judged = candidate.judged(of)
        if np.any(candidate.noise[judged] > _allowed(candidate.offset[judged], tolerance)):
            continue
        share = _share(candidate.middle[judged])
        for persistence in _PERSISTENCES_S:
            if np.all(candidate.alarms(law.setup.dt_s, persistence, share)[judged] <= tolerated):
                return candidate, persistence, True
    return candidate, _PERSISTENCES_S[-1], False


def _allowed(offset: np.ndarray, tolerance: Tolerance) -> np.ndarray:
    """[n] largest standard deviation by noise, so that noise and offset together have the tolerated one.

    At least half of the tolerated deviation is left to noise, also beside an offset that takes all of it.
    """
    whole = min(tolerance.deviation, 1.0 / math.sqrt(LEAST_SHAPE))
    return np.sqrt(np.maximum(whole**2 - offset**2, (0.5 * whole) ** 2))


def _share(middle: np.ndarray) -> float:
    """Threshold over `keep`: less where errors that last bring estimates down."""
    return THRESHOLD_SHARE * float(np.clip(middle.min(), 0.1, 1.0))


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
        of = joint.judged(np.array([one == kind for one in kinds]))
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
