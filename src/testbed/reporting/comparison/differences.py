"""What differs between flights: their scenarios, and their logs step by step."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from testbed.common.angles import wrap_deg
from testbed.flight.breakage import failures_of
from testbed.flight.flight import Flight
from testbed.reporting.words import broke, joined, setting
from testbed.scenario.load import Scenario

FLOWN = (
    "north_m", "east_m", "altitude_m", "airspeed_m_s", "roll_deg", "pitch_deg", "heading_deg", "alpha_deg", "beta_deg",
    "p_deg_s", "q_deg_s", "r_deg_s",
)  # fmt: skip
"""Columns of how the aircraft truly moves."""
_MOST_NAMED = 2  # failures in the name of a flight
_SAME_TIME = 1e-6  # rows of two logs belong together if their times differ by no more [s]


class Setting(NamedTuple):
    """A setting by its dotted path, with its value in each flight; None where a flight does not have it."""

    path: str
    values: tuple[Any, ...]


class FirstDifference(NamedTuple):
    """Where two logs first differ: in any column, and in the motion. Times are None where they do not.

    `columns` are those that differ first, in the log's order.
    """

    time_s: float | None
    columns: tuple[str, ...]
    moved_s: float | None
    moved: tuple[str, ...]


def names_of(flights: Sequence[Flight], folders: Sequence[str] = ()) -> list[str]:
    """A name for each flight that no other has, by what differs: controller, scenario, failures; else its folder, or a number."""
    controllers, broken, when = (
        [of(flight) for flight in flights]
        for of in (lambda flight: flight.controller, _broken, lambda flight: _broken(flight, True))
    )
    for named in (
        controllers,
        [flight.scenario.name for flight in flights],
        broken,
        when,
        [f"{by}: {what}" for by, what in zip(controllers, broken, strict=True)],
        _by_settings(flights),
        list(folders),
    ):
        if len(set(named)) == len(flights):
            return named
    return [f"flight {i + 1}" for i in range(len(flights))]


def _broken(flight: Flight, timed: bool = False) -> str:
    """What broke in a flight, in words, and when if asked for."""
    said = [
        broke(flight, each.number).removeprefix("the ") + (f" at {each.from_s:g} s" if timed else "")
        for each in failures_of(flight.events)
    ]
    more = f", and {len(said) - _MOST_NAMED} more" if len(said) > _MOST_NAMED else ""
    return (joined(said[:_MOST_NAMED]) + more) if said else "nothing broken"


def _by_settings(flights: Sequence[Flight]) -> list[str]:
    differing = [s for s in settings(flights) if s.path != "name"]
    if not 1 <= len(differing) <= 2:
        return [""] * len(flights)
    return [", ".join(f"{setting(s.path)} {s.values[i]}" for s in differing) for i in range(len(flights))]


def settings(flights: Sequence[Flight]) -> list[Setting]:
    """The settings that are not the same in all scenarios, in their order."""
    flat = [settings_by_path(flight.scenario) for flight in flights]
    paths = dict.fromkeys(path for one in flat for path in one)
    found = (Setting(path, tuple(one.get(path) for one in flat)) for path in paths)
    return [setting for setting in found if any(value != setting.values[0] for value in setting.values)]


def settings_by_path(scenario: Scenario) -> dict[str, Any]:
    """{dotted path: value} of everything that a scenario has."""
    return dict(_flat(scenario.model_dump(mode="json", exclude_none=True)))


def _flat(tree: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(tree, Mapping) and tree:
        for key, value in tree.items():
            yield from _flat(value, f"{path}.{key}" if path else str(key))
    elif isinstance(tree, list) and tree:
        for i, value in enumerate(tree):
            yield from _flat(value, f"{path}.{i}")
    else:
        yield path, tree


def common_rows(one: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows of two logs at the same times, from the times [rows] of each [s]."""
    near = np.clip(np.searchsorted(other, one - _SAME_TIME), 0, max(len(other) - 1, 0))
    same = np.abs(other[near] - one) <= _SAME_TIME if len(other) else np.zeros(len(one), dtype=bool)
    return np.flatnonzero(same), near[same]


def first_difference(one: Flight, other: Flight) -> FirstDifference:
    """The first step in which two logs differ, by so little as a bit, in columns that both have."""
    shared = [name for name in one.columns if name in other.columns and name != "time_s"]
    a, b = one.column("time_s"), other.column("time_s")
    rows, others = common_rows(a, b)
    differs = {name: _unequal(one.column(name)[rows], other.column(name)[others]) for name in shared}
    time_s, columns = _first(a[rows], differs)
    moved_s, moved = _first(a[rows], {name: differs[name] for name in shared if name in FLOWN})
    return FirstDifference(time_s, columns, moved_s, moved)


def _unequal(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return (a != b) & ~(np.isnan(a) & np.isnan(b))


def _first(time: np.ndarray, differs: Mapping[str, np.ndarray]) -> tuple[float | None, tuple[str, ...]]:
    starts = {name: int(flag.argmax()) for name, flag in differs.items() if flag.any()}
    if not starts:
        return None, ()
    row = min(starts.values())
    return float(time[row]), tuple(name for name, start in starts.items() if start == row)


def on_grid(time: np.ndarray, log: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """A column of a log at the times of a grid [rows]: its latest row, and NaN after its end."""
    own = log["time_s"]
    rows = np.searchsorted(own, time + _SAME_TIME, side="right") - 1
    values = log[name][np.clip(rows, 0, len(own) - 1)]
    return np.where((rows >= 0) & (time <= own[-1] + _SAME_TIME), values, np.nan)


def minus(one: np.ndarray, other: np.ndarray, name: str) -> np.ndarray:
    """The difference of two columns; of headings, the short way round."""
    return wrap_deg(one - other) if name.startswith("heading") else one - other
