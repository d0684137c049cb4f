"""Judge a flight by its requirements: the worst value, the limit, the margin and the robustness of each, and whether it was met.

Robustness is how far the rows of a signal are inside the limits of a requirement, as one signed number; a formula has one too. It
is that of signal temporal logic (Fainekos and Pappas, Robustness of temporal logic specifications, 2009; Donze and Maler,
Robust satisfaction of temporal logic over real-valued signals, 2010): an `and` is a minimum, an `or` a maximum, "always" a
minimum over time and "eventually" a maximum. It is negative where the limits are broken, and continuous in the signal.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.columns import Log, row_at, row_spacing_s, stays_from, stretches
from testbed.scenario.requirement import Node, Requirement

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

    `robustness` is how far the whole signal is from breaking its limits, in units of `scale` (see the module). It is
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
        metric = float(metrics[requirement.metric])
        if not math.isfinite(metric):
            return _Found(-1.0, reason=_NO_NUMBER)
        sides = sides_of(requirement, np.array([metric]))
        return _Found(always(scaled(sides)), *extreme(sides))
    if requirement.formula is not None:
        return _of_formula(requirement, log, duration_s)
    return _of_signal(requirement, log, duration_s)


def _of_formula(requirement: Requirement, log: Log, duration_s: float) -> _Found:
    """Of the first row: the formula's robustness is the value and, divided by `scale`, the requirement's."""
    node, time = requirement.parsed, log["time_s"]
    found = formula_robustness(node, log, 1.0 / (row_spacing_s(time) or math.inf)) if len(time) else time
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
    found = _of_sides(requirement, sides, time)
    if requirement.never_for_longer_than_s is not None:
        return _Found(found, *_longest_outside(requirement, sides, time))
    if requirement.settles_by_s is not None:
        return _Found(found, *_settling(requirement, log))
    return _Found(found, *extreme(sides, best=bool(requirement.eventually)))


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


def _of_sides(requirement: Requirement, sides: Sequence[Side], time: np.ndarray) -> float:
    if requirement.eventually:
        return eventually(scaled(sides))
    if requirement.never_for_longer_than_s is not None:
        return never_outside_for(scaled(sides), _rows_allowed(requirement, time) + 1)
    return always(scaled(sides))


def _of_part(requirement: Requirement, values: np.ndarray, time: np.ndarray) -> float:
    """Robustness of the rows that there are, or 0 if that is positive or there are none."""
    if not len(values):
        return 0.0
    return min(0.0, _of_sides(requirement, sides_of(requirement, values), time))


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


def always(distances: np.ndarray) -> float:
    """Robustness of "inside in every row", of the distances [rows] to the limit, positive inside."""
    return float(np.min(distances))


def eventually(distances: np.ndarray) -> float:
    """Robustness of "inside in some row"."""
    return float(np.max(distances))


def never_outside_for(distances: np.ndarray, rows: int) -> float:
    """Robustness of "never outside for this many rows in succession": the least, over time, of the largest in so many rows.

    No less than 0 if there are fewer rows than that.
    """
    if len(distances) < rows:
        return max(0.0, eventually(distances))
    return always(largest_of(distances, rows))


def largest_of(values: np.ndarray, rows: int) -> np.ndarray:
    """The largest of each so many values in succession, from windows that double."""
    width = 1
    while width < rows:
        shift = min(width, rows - width)
        values = np.maximum(values[:-shift], values[shift:])
        width += shift
    return values


class Side(NamedTuple):
    """One limit of a requirement: the values [rows] that it limits, how far inside they are [rows], and robustness 1."""

    values: np.ndarray
    inside: np.ndarray
    scale: float


def sides_of(requirement: Requirement, values: np.ndarray) -> list[Side]:
    """Each limit of a requirement, on the values [rows] of its metric or signal, or of the signal's difference from `of`."""
    away, found = np.abs(values), []
    if requirement.within is not None:
        found.append(Side(away, requirement.within - away, requirement.scale_of("within")))
    if requirement.at_most is not None:
        found.append(Side(values, requirement.at_most - values, requirement.scale_of("at_most")))
    if requirement.at_least is not None:
        found.append(Side(values, values - requirement.at_least, requirement.scale_of("at_least")))
    return found


def scaled(sides: Sequence[Side]) -> np.ndarray:
    """[rows] distance to the nearest limit, in units of its scale."""
    nearest: np.ndarray = np.min([side.inside / side.scale for side in sides], axis=0)
    return nearest


def extreme(sides: Sequence[Side], best: bool = False) -> tuple[float, float]:
    """(margin, value) in the row with the smallest margin, or in that with the largest, for the limit that is nearest."""
    inside = np.array([side.inside for side in sides])
    nearest = inside.min(axis=0)
    row = int(np.argmax(nearest) if best else np.argmin(nearest))
    side = int(np.argmin(inside[:, row]))
    return float(inside[side, row]), float(sides[side].values[row])


def outside(sides: Sequence[Side]) -> np.ndarray:
    """[rows] whether any limit is broken."""
    kept: np.ndarray = np.all([side.inside >= 0.0 for side in sides], axis=0)
    return ~kept


def formula_robustness(node: Node, log: Log, rate_hz: float) -> np.ndarray:
    """[rows] robustness of a formula, in the unit of what it compares: 0 or more where it holds. The log has `rate_hz` rows/s.

    A row is judged from those that follow it, only where its windows end within the log; so a formula over a shorter log has fewer
    rows, and perhaps none.
    """
    if node.form == "above":
        upper, lower = (_numbers(part, log) for part in node.parts)
        return np.asarray(upper - lower)
    parts = [formula_robustness(part, log, rate_hz) for part in node.parts]
    if node.form in ("and", "or"):
        rows = min(map(len, parts))
        return np.asarray(
            (np.minimum if node.form == "and" else np.maximum).reduce([p[:rows] for p in parts])
        )
    if node.form == "not":
        return -parts[0]
    if node.form == "until":
        return _until(parts[0], parts[1], node.window, rate_hz)
    sign = 1.0 if node.form == "eventually" else -1.0
    return sign * _largest_ahead(sign * parts[0], node.window, rate_hz)


def _largest_ahead(values: np.ndarray, window: tuple[float, float], rate_hz: float) -> np.ndarray:
    """The largest value from the beginning to the end of a window after each row; shorter by the window."""
    first = round(window[0] * rate_hz)
    values = values[first:]
    if window[1] == math.inf:
        return np.maximum.accumulate(values[::-1])[::-1]
    rows = round(window[1] * rate_hz) - first + 1
    return largest_of(values, rows) if len(values) >= rows else values[:0]


def _until(before: np.ndarray, then: np.ndarray, window: tuple[float, float], rate_hz: float) -> np.ndarray:
    """The largest, over the window, of the lesser of `then` and the least of `before` until there (Donze and Maler 2010)."""
    rows = min(len(before), len(then))
    first = round(window[0] * rate_hz)
    last = rows - 1 if window[1] == math.inf else round(window[1] * rate_hz)
    judged = rows - (first if window[1] == math.inf else last)
    if judged <= 0:
        return before[:0]
    best, least = np.full(judged, -math.inf), np.full(judged, math.inf)
    for ahead in range(last + 1):
        held = min(judged, rows - ahead)  # without an end the window is shorter for later rows
        if ahead >= first:
            best[:held] = np.maximum(best[:held], np.minimum(then[ahead : ahead + held], least[:held]))
        least[:held] = np.minimum(least[:held], before[ahead : ahead + held])
    return best


_ARITHMETIC: dict[str, Callable[[np.ndarray, np.ndarray], np.ndarray]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": np.divide,
}  # fmt: skip


def _numbers(node: Node, log: Log) -> np.ndarray:
    """[rows] of a part that is a number at each time."""
    if node.form == "column":
        return log[node.name]
    if node.form == "number":
        return np.full(len(log["time_s"]), node.value)
    parts = [_numbers(part, log) for part in node.parts]
    if node.form == "abs":
        return np.abs(parts[0])
    with np.errstate(all="ignore"):  # what is no number is said of the requirement
        return _ARITHMETIC[node.form](parts[0], parts[1])
