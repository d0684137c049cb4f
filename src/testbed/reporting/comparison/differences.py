"""What differs between flights: their names, settings and metrics, and where their logs first differ."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from string import ascii_uppercase
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from testbed.flight.breakage import failures_of
from testbed.flight.flight import Flight
from testbed.reporting.words import broke, joined, setting
from testbed.scenario.load import Scenario

if TYPE_CHECKING:
    import pandas as pd

SAME_TIME = 1e-6
"""Rows of two logs belong together if their times differ by no more [s]."""
FLOWN = (
    "north_m", "east_m", "altitude_m", "airspeed_m_s", "roll_deg", "pitch_deg", "heading_deg", "alpha_deg", "beta_deg",
    "p_deg_s", "q_deg_s", "r_deg_s",
)  # fmt: skip
"""Columns of how the aircraft truly moves."""
_MOST_NAMED = 2  # failures in the name of a flight
_MOST_LETTERS = 80  # of all names together, that one line or the heads of a table can take


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


class Compared:
    """Flights side by side, each with a name. The first is the one that the others are compared with.

    Attributes:
        names: what tells each flight from the others.
        keys: the same, short: letters, with which the names begin then, where the names are long together.
    """

    def __init__(
        self, flights: Sequence[Flight], names: Sequence[str] | None = None, folders: Sequence[str] = ()
    ) -> None:
        """Without `names` each flight is named by what is different about it, else by its folder if those are given."""
        self.flights = tuple(flights)
        own = names_of(self.flights, folders) if names is None else list(names)
        long = len(own) > 2 and sum(map(len, own)) > _MOST_LETTERS
        self.keys = list(ascii_uppercase[: len(own)]) if long else own
        self.names = [f"{key}: {name}" for key, name in zip(self.keys, own, strict=True)] if long else own

    @property
    def settings(self) -> list[Setting]:
        """What the scenarios have that differs: {path, values}, a value for each flight."""
        return settings(self.flights)

    @property
    def first_differences(self) -> list[FirstDifference]:
        """Where the log of each other flight first differs from that of the first."""
        return [first_difference(self.flights[0], flight) for flight in self.flights[1:]]

    @property
    def metrics(self) -> pd.DataFrame:
        """The metrics, a row for each, with a column for each flight."""
        import pandas as pd

        named = zip(self.keys, self.flights, strict=True)
        return pd.DataFrame({name: dict(flight.metrics) for name, flight in named})


def names_of(flights: Sequence[Flight], folders: Sequence[str] = ()) -> list[str]:
    """A name for each flight that no other has, by what differs: controller, scenario, failures; else its folder, or a number."""
    controllers, broken = [flight.controller for flight in flights], [_broken(flight) for flight in flights]
    for named in (
        controllers,
        [flight.scenario.name for flight in flights],
        broken,
        [_broken(flight, timed=True) for flight in flights],
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


def first_difference(one: Flight, other: Flight) -> FirstDifference:
    """The first step in which two logs differ, by so little as a bit, in columns that both have."""
    shared = [name for name in one.columns if name in other.columns and name != "time_s"]
    a, b = one.column("time_s"), other.column("time_s")
    rows, others = common_rows(a, b)
    both = ((name, one.column(name)[rows], other.column(name)[others]) for name in shared)
    differs = {name: (x != y) & ~(np.isnan(x) & np.isnan(y)) for name, x, y in both}
    time_s, columns = _first(a[rows], differs)
    moved_s, moved = _first(a[rows], {name: differs[name] for name in shared if name in FLOWN})
    return FirstDifference(time_s, columns, moved_s, moved)


def _first(time: np.ndarray, differs: Mapping[str, np.ndarray]) -> tuple[float | None, tuple[str, ...]]:
    starts = {name: int(flag.argmax()) for name, flag in differs.items() if flag.any()}
    if not starts:
        return None, ()
    row = min(starts.values())
    return float(time[row]), tuple(name for name, start in starts.items() if start == row)


def common_rows(one: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows of two logs at the same times, from the times [rows] of each [s]."""
    near = np.clip(np.searchsorted(other, one - SAME_TIME), 0, max(len(other) - 1, 0))
    same = np.abs(other[near] - one) <= SAME_TIME if len(other) else np.zeros(len(one), dtype=bool)
    return np.flatnonzero(same), near[same]
