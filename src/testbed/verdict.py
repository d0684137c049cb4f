"""Requirements against a flight: each with the worst value, the limit, the margin and whether it was met."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from testbed.requirement import Requirement


def judge(
    requirements: Sequence[Requirement], log: Mapping[str, np.ndarray], metrics: Mapping[str, float]
) -> list[dict[str, Any]]:
    """[{name, passed, value, limit, margin}] for each requirement; value is the worst seen, margin negative if missed.

    A requirement on a window that the flight did not reach is not met; a metric that does not exist in this flight
    (NaN, such as the delay of a detection that never came) is not met either.
    """
    return [_judge(requirement, log, metrics) for requirement in requirements]


def _judge(
    requirement: Requirement, log: Mapping[str, np.ndarray], metrics: Mapping[str, float]
) -> dict[str, Any]:
    values = _values(requirement, log, metrics)
    margin, value = -math.inf, math.nan
    if len(values) and np.all(np.isfinite(values)):
        margin, value = _worst(requirement, values)
    passed = margin >= 0.0
    return {
        "name": requirement.title,
        "passed": bool(passed),
        "value": value,
        "limit": requirement.limit,
        "margin": margin,
    }


def _values(
    requirement: Requirement, log: Mapping[str, np.ndarray], metrics: Mapping[str, float]
) -> np.ndarray:
    """The metric, or the signal (its distance from `of`) in its window."""
    if requirement.metric is not None:
        return np.array([metrics[requirement.metric]], dtype=float)
    time, signal = log["time_s"], log[str(requirement.signal)]
    start = requirement.from_s or 0.0
    end = math.inf if requirement.until_s is None else requirement.until_s
    window = (time >= start - 1e-9) & (time < end - 1e-9)
    if not math.isinf(end) and len(time) and time[-1] < end - 1.5 * _step(time):
        return np.array([])  # the flight ended before the window did
    values = signal[window]
    if requirement.within is not None:
        of = log[requirement.of][window] if isinstance(requirement.of, str) else float(requirement.of or 0.0)
        values = values - of
        if str(requirement.signal).startswith("heading"):
            values = np.mod(values + 180.0, 360.0) - 180.0
    return values


def _step(time: np.ndarray) -> float:
    return float(time[1] - time[0]) if len(time) > 1 else 0.0


def _worst(requirement: Requirement, values: np.ndarray) -> tuple[float, float]:
    """(margin, value) where the margin is least."""
    candidates = []
    if requirement.within is not None:
        worst = float(np.max(np.abs(values)))
        candidates.append((requirement.within - worst, worst))
    if requirement.at_most is not None:
        candidates.append((requirement.at_most - float(np.max(values)), float(np.max(values))))
    if requirement.at_least is not None:
        candidates.append((float(np.min(values)) - requirement.at_least, float(np.min(values))))
    return min(candidates)
