"""Judge a flight by its requirements: the worst value, the limit, the margin and the robustness of each, and whether it was met."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.columns import Log, row_at, row_spacing_s, stays_from, stretches
from testbed.flight.robustness import (
    Side,
    always,
    eventually,
    extreme,
    never_outside_for,
    outside,
    robustness,
    scaled,
    sides_of,
)
from testbed.scenario.requirement import Requirement

_ENDED = "the flight ended before this window did"
_NO_NUMBER = "not a number in this flight"
_UNSAID = "not judged: the controller does not say it"
_NOT_SETTLED = "it was outside at the end of the window"


def judge(
    requirements: Sequence[Requirement],
    log: Log,
    metrics: Mapping[str, float],
    duration_s: float = math.inf,
    unjudged: Collection[str] = (),
) -> list[dict[str, Any]]:
    """{name, passed, value, limit, margin, robustness, reason} of each requirement, in their order.

    `value` is the worst value and `margin` its distance from the limit: the requirement is met if the margin is not
    negative. With `eventually` it is the best value, with `settles_by_s` the time from which on the limits are kept [s],
    with `never_for_longer_than_s` the longest time outside of them [s]. The window of a signal has the rows with
    from_s <= time < until_s. Without `until_s` it ends with the flight, even if that ended early.

    `robustness` is how far the whole signal is from breaking its limits, in units of `scale` (see `flight.robustness`). It is
    finite, and negative where the requirement is not met, also if it has no value.

    A requirement that has no value has a `reason`, a margin of -inf and the value NaN. It is not met: the flight ended before
    `until_s` or before the window began, the metric or signal is not a number (such as the delay of a detection that did not
    happen), or the signal has not settled. Its robustness is that of the rows there are, at most 0, minus the share
    of the time to the window's end that was not flown, or of the rows without a number.

    A requirement on what the controller does not say is neither met nor missed: `passed` is None, and the numbers are NaN.

    Args:
        duration_s: how long the flight was to be [s].
        unjudged: metrics and signals of which the controller said nothing.
    """
    verdicts: list[dict[str, Any]] = []
    for requirement in requirements:
        if judged := about(requirement).isdisjoint(unjudged):
            found = _found(requirement, log, metrics, duration_s)
        else:
            found = _Found(math.nan, math.nan, reason=_UNSAID)
        verdicts.append(
            {
                "name": requirement.title,
                "passed": bool(found.margin >= 0.0) if judged else None,
                "value": found.value,
                "limit": requirement.limit,
                "margin": found.margin,
                "robustness": found.robustness,
                "reason": found.reason,
            }
        )
    return verdicts


def about(requirement: Requirement) -> set[str]:
    """The metric or the signals that it limits."""
    return {
        name for name in (requirement.metric, requirement.signal, requirement.of) if isinstance(name, str)
    }


def worst_s(requirement: Requirement, log: Log) -> float | None:
    """When a signal was furthest outside of its limits, or nearest to them [s]; None for a formula, and if no row has a number."""
    if requirement.formula is not None:
        return None
    rows = _window(requirement, log["time_s"])
    values = _values(requirement, log, rows)
    known = np.flatnonzero(np.isfinite(values))
    if not len(known):
        return None
    nearest = scaled(sides_of(requirement, values[known]))
    return float(log["time_s"][rows][known[np.argmin(nearest)]])


class _Found(NamedTuple):
    robustness: float
    margin: float = -math.inf
    value: float = math.nan
    reason: str = ""


def _found(requirement: Requirement, log: Log, metrics: Mapping[str, float], duration_s: float) -> _Found:
    if requirement.metric is not None:
        return _of_metric(requirement, float(metrics[requirement.metric]))
    if requirement.formula is not None:
        return _of_formula(requirement, log, duration_s)
    return _of_signal(requirement, log, duration_s)


def _of_metric(requirement: Requirement, metric: float) -> _Found:
    if not math.isfinite(metric):
        return _Found(-1.0, reason=_NO_NUMBER)
    sides = sides_of(requirement, np.array([metric]))
    return _Found(always(scaled(sides)), *extreme(sides))


def _of_formula(requirement: Requirement, log: Log, duration_s: float) -> _Found:
    """Of the first row: the formula's robustness is the value and, divided by `scale`, the requirement's."""
    node, time = requirement.parsed, log["time_s"]
    found = robustness(node, log, 1.0 / (row_spacing_s(time) or math.inf)) if len(time) else time
    if not len(found):
        return _Found(-_not_flown(requirement, time, duration_s), reason=_ENDED)
    value = float(found[0])
    if not math.isfinite(value):
        return _Found(-1.0, reason=_NO_NUMBER)
    return _Found(value / (requirement.scale or 1.0), value, value)


def _of_signal(requirement: Requirement, log: Log, duration_s: float) -> _Found:
    time = log["time_s"]
    rows = _window(requirement, time)
    values = _values(requirement, log, rows)
    known = np.isfinite(values)
    if _cut_short(requirement, time) or rows.start >= rows.stop:
        not_flown = _not_flown(requirement, time, duration_s)
        return _Found(_of_part(requirement, values[known], time) - not_flown, reason=_ENDED)
    if not known.all():
        no_number = float(np.mean(~known))
        return _Found(_of_part(requirement, values[known], time) - no_number, reason=_NO_NUMBER)
    sides = sides_of(requirement, values)
    robustness = _robustness(requirement, sides, time)
    if requirement.never_for_longer_than_s is not None:
        return _Found(robustness, *_longest_outside(requirement, sides, time))
    if requirement.settles_by_s is not None:
        return _Found(robustness, *_settling(requirement, log))
    return _Found(robustness, *extreme(sides, best=bool(requirement.eventually)))


def _window(requirement: Requirement, time: np.ndarray) -> slice:
    """Rows with begins_s <= time < until_s that were flown."""
    end = len(time) if requirement.until_s is None else row_at(time, requirement.until_s)
    return slice(row_at(time, requirement.begins_s), end)


def _cut_short(requirement: Requirement, time: np.ndarray) -> bool:
    """Whether the flight ended more than a step before `until_s`."""
    until = requirement.until_s
    return until is not None and (not len(time) or time[-1] < until - 1.5 * row_spacing_s(time))


def _not_flown(requirement: Requirement, time: np.ndarray, duration_s: float) -> float:
    """Share of the time to the end of the window that was not flown; 1 if there is nothing of the window in the log."""
    end = duration_s if requirement.until_s is None else requirement.until_s
    flown = time[-1] / end if len(time) else 0.0
    return 1.0 - float(flown) if flown < 1.0 else 1.0


def _values(requirement: Requirement, log: Log, rows: slice) -> np.ndarray:
    """[rows] the signal, or its difference from `of`."""
    values = log[str(requirement.signal)][rows]
    if requirement.within is not None:
        of = log[requirement.of][rows] if isinstance(requirement.of, str) else float(requirement.of or 0.0)
        values = values - of
        if str(requirement.signal).startswith("heading"):
            values = wrap_deg(values)
    return values


def _robustness(requirement: Requirement, sides: Sequence[Side], time: np.ndarray) -> float:
    if requirement.eventually:
        return eventually(scaled(sides))
    if requirement.never_for_longer_than_s is not None:
        return never_outside_for(scaled(sides), _rows_allowed(requirement, time) + 1)
    return always(scaled(sides))


def _of_part(requirement: Requirement, values: np.ndarray, time: np.ndarray) -> float:
    """Robustness of the rows that there are, or 0 if that is positive or there are none."""
    if not len(values):
        return 0.0
    return min(0.0, _robustness(requirement, sides_of(requirement, values), time))


def _rows_allowed(requirement: Requirement, time: np.ndarray) -> int:
    """Rows in succession that may be outside the limits."""
    return int(float(requirement.never_for_longer_than_s or 0.0) / (row_spacing_s(time) or math.inf) + 1e-6)


def _longest_outside(
    requirement: Requirement, sides: Sequence[Side], time: np.ndarray
) -> tuple[float, float]:
    """(margin, value): the longest time outside the limits [s]. A row counts for the time to the next."""
    rows = max((end - first for first, end in stretches(outside(sides))), default=0)
    longest = rows * row_spacing_s(time)
    margin = float(requirement.never_for_longer_than_s or 0.0) - longest
    return (margin if rows > _rows_allowed(requirement, time) else max(0.0, margin)), longest


def _settling(requirement: Requirement, log: Log) -> tuple[float, float, str]:
    """(margin, value, reason): the time of the first row after which the limits are kept to the end of the window [s]."""
    time = log["time_s"]
    rows = slice(0, _window(requirement, time).stop)
    kept = ~outside(sides_of(requirement, _values(requirement, log, rows)))
    settled = stays_from(kept, 0, rows.stop)
    if settled is None:
        return -math.inf, math.nan, _NOT_SETTLED
    allowed = time[row_at(time, requirement.begins_s)]
    return float(allowed - time[settled]), float(time[settled]), ""
