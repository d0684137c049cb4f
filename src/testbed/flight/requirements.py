"""Judge a flight by its requirements: the worst value, the limit and the margin of each, and whether it was met."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.columns import row_at, row_spacing_s
from testbed.scenario.requirement import Requirement


def judge(
    requirements: Sequence[Requirement], log: Mapping[str, np.ndarray], metrics: Mapping[str, float]
) -> list[dict[str, Any]]:
    """{name, passed, value, limit, margin, reason} of each requirement, in their order.

    `value` is the worst value and `margin` its distance from the limit: the requirement is met if the margin is not
    negative. The window of a signal has the rows with from_s <= time < until_s. Without `until_s` it ends with the flight,
    even if that ended early.

    In two cases a requirement is not met, has a `reason`, a margin of -inf and the value NaN: if the flight ended before
    `until_s` or before the window began, and if the metric or signal is not a number (such as the delay of a detection that
    did not happen).
    """
    return [_judge(requirement, log, metrics) for requirement in requirements]


def _judge(
    requirement: Requirement, log: Mapping[str, np.ndarray], metrics: Mapping[str, float]
) -> dict[str, Any]:
    margin, value, reason = -math.inf, math.nan, ""
    values = _values(requirement, log, metrics)
    if not len(values):
        reason = "the flight ended before this window did"
    elif not np.all(np.isfinite(values)):
        reason = "not a number in this flight"
    else:
        margin, value = _worst(requirement, values)
    return {
        "name": requirement.title,
        "passed": bool(margin >= 0.0),
        "value": value,
        "limit": requirement.limit,
        "margin": margin,
        "reason": reason,
    }


def _values(
    requirement: Requirement, log: Mapping[str, np.ndarray], metrics: Mapping[str, float]
) -> np.ndarray:
    """[1] the metric, or [rows in the window] the signal or its difference from `of`; empty if the window was not flown."""
    if requirement.metric is not None:
        return np.array([metrics[requirement.metric]], dtype=float)
    window = _window(requirement, log["time_s"])
    values = log[str(requirement.signal)][window]
    if requirement.within is not None:
        of = log[requirement.of][window] if isinstance(requirement.of, str) else float(requirement.of or 0.0)
        values = values - of
        if str(requirement.signal).startswith("heading"):
            values = wrap_deg(values)
    return values


def _window(requirement: Requirement, time: np.ndarray) -> slice:
    """Rows with from_s <= time < until_s; none if the flight ended more than a step before `until_s`."""
    first = row_at(time, requirement.from_s or 0.0)
    if requirement.until_s is None:
        return slice(first, len(time))
    if not len(time) or time[-1] < requirement.until_s - 1.5 * row_spacing_s(time):
        return slice(0, 0)
    return slice(first, row_at(time, requirement.until_s))


def _worst(requirement: Requirement, values: np.ndarray) -> tuple[float, float]:
    """(margin, value) for the limit with the smallest margin."""
    candidates = []
    if requirement.within is not None:
        worst = float(np.max(np.abs(values)))
        candidates.append((requirement.within - worst, worst))
    if requirement.at_most is not None:
        candidates.append((requirement.at_most - float(np.max(values)), float(np.max(values))))
    if requirement.at_least is not None:
        candidates.append((float(np.min(values)) - requirement.at_least, float(np.min(values))))
    return min(candidates)
