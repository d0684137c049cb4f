"""The largest gain that the errors of a scenario allow: gamma and epsilon of (13), or the process noise of the default law."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from testbed.gains.candidates import COARSEST, Candidate, Candidates

LEAST_SHAPE = 12.0
"""Least nu of a design, for each actuator: a deviation of 0.29. The estimates of one flight then stay where its trim is held. With
a nu of 9 a third of the v-tail's flights lost it: while both propellers' estimates are above 1.3 its lateral motion is unstable."""
THRESHOLD_SHARE = 0.5
"""Threshold over the effectiveness that must not be flagged, where errors that last leave room for it."""
_PERSISTENCES_S = (0.05, 0.1, 0.2, 0.5)
_FINEST = 0.1  # least epsilon over the position at the trim
_ROOM = 0.7  # largest lower bound of the estimates, over the threshold
_ROUND = 3  # digits of a setting


@dataclass(frozen=True)
class Tolerance:
    """What is asked of a design: the arguments of `design.design`."""

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


def choose(candidates: Candidates, tolerance: Tolerance) -> Chosen:
    """The largest gain of each kind of actuator with which its noise and its false alarms are tolerable.

    Where no gain is tolerable it is the smallest that is tried.
    """
    newton, kinds = candidates.newton, candidates.kinds
    dt_s = candidates.setup.dt_s
    groups = {kind: kinds == kind for kind in dict.fromkeys(kinds)} if newton else {"every": kinds == kinds}
    picked = {group: _largest_tolerable(candidates, of, tolerance) for group, of in groups.items()}
    every = [picked[kind if newton else "every"] for kind in kinds]
    persistence = max(found or _PERSISTENCES_S[-1] for _, found in every)
    joint = _joint([each for each, _ in every])
    share = _share(joint.middle[joint.judged(np.ones(len(kinds), dtype=bool))])
    threshold = _rounded(share * tolerance.keep)
    settings: dict[str, Any] = {"threshold": threshold, "persistence_s": persistence}
    if newton:
        gains = np.array([each.gain for each, _ in every])
        settings = {"preset": "paper", **_newton_settings(gains, candidates, joint, tolerance), **settings}
        if candidates.settings.lambda_min > _ROOM * threshold:
            settings["lambda_min"] = _rounded(_ROOM * threshold)
    else:
        noise = {"process_noise_per_root_s": _rounded(every[0][0].gain)}
        settings = {**noise, **settings, "propeller_threshold": threshold}
    return Chosen(
        settings={"type": "adaptive_inversion", **settings},
        predicted=joint,
        met=np.array([found is not None for _, found in every]),
        false_alarms_per_s=float(joint.alarms(dt_s, persistence, share).sum()),
    )


def _joint(candidates: Sequence[Candidate]) -> Candidate:
    """Of actuator i, what candidate i predicts."""
    columns = ("parts", "noise", "offset", "bias", "rates")
    own = {
        name: np.stack([getattr(each, name)[..., i] for i, each in enumerate(candidates)], axis=-1)
        for name in columns
    }
    return replace(candidates[0], gain=math.nan, **own)


def _largest_tolerable(
    candidates: Candidates, of: np.ndarray, tolerance: Tolerance
) -> tuple[Candidate, float | None]:
    """The largest gain that is tolerable for the actuators `of` [n], and its persistence [s]; without one the smallest, and None.

    What is tolerable with one gain is taken to be so with each that is smaller.
    """
    gains = [float(gain) for gain in candidates.gains]
    dt_s = candidates.setup.dt_s

    def tolerable(gain: float) -> bool:
        return _persistence(candidates.at(gain), of, dt_s, tolerance) is not None

    first = 0 if tolerable(gains[0]) else bisect_left(gains, True, lo=1, key=tolerable)
    found = candidates.at(gains[min(first, len(gains) - 1)])
    return found, _persistence(found, of, dt_s, tolerance)


def _persistence(candidate: Candidate, of: np.ndarray, dt_s: float, tolerance: Tolerance) -> float | None:
    """The shortest persistence [s] with which the actuators `of` [n] have tolerable noise and false alarms; None without one."""
    judged = candidate.judged(of)
    if np.any(candidate.noise[judged] > _allowed(candidate.offset[judged], tolerance)):
        return None
    tolerated = tolerance.false_alarms_per_hour / 3600.0 / len(of)
    share = _share(candidate.middle[judged])
    few = (p for p in _PERSISTENCES_S if np.all(candidate.alarms(dt_s, p, share)[judged] <= tolerated))
    return next(few, None)


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
    gains: np.ndarray, candidates: Candidates, joint: Candidate, tolerance: Tolerance
) -> dict[str, Any]:
    """gamma and epsilon of each kind of actuator; gains [n]."""
    size = np.abs(candidates.positions)
    finest = np.clip(joint.noise / _allowed(joint.offset, tolerance), _FINEST, COARSEST) * size
    epsilon = np.empty(len(size))
    for kind in dict.fromkeys(candidates.kinds):
        of = joint.judged(candidates.kinds == kind)
        epsilon[candidates.kinds == kind] = max(min(finest[of].max(), COARSEST * size[of].min()), 1e-3)
    return {
        name: {kind: _rounded(one) for kind, one in candidates.per_kind(values).items()}
        for name, values in (("gamma", gains), ("epsilon", epsilon))
    }


def _rounded(value: float) -> float:
    """To three digits, downwards."""
    size = 10.0 ** (math.floor(math.log10(value)) - _ROUND + 1)
    return float(f"{math.floor(value / size + 1e-9) * size:.{_ROUND}g}")
