"""The panels of a comparison: those of `reporting.panels` with all flights in each, and the differences from the first flight."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.common.angles import unwrapped_deg, wrap_deg
from testbed.common.units import unit
from testbed.flight.breakage import failure_times_s
from testbed.flight.flight import Flight
from testbed.reporting.page import group_of
from testbed.reporting.panels import (
    TRACKED,
    Panel,
    Series,
    actuators,
    effectiveness,
    errors,
    shown_log,
    states,
)

if TYPE_CHECKING:
    from testbed.reporting.comparison.compare import Comparison

_STYLES = 6  # in the palette
_SAME_TIME = 1e-6  # rows of two logs belong together if their times differ by no more [s]
_FEW = 3  # flights whose actuators are not folded away


def columns_of(flights: Sequence[Flight]) -> dict[str, np.ndarray]:
    """The columns of all flights on one time grid, that of the longest: `1:roll_deg` is of the second flight."""
    time = max(flights, key=lambda flight: flight.end_time_s).column("time_s")
    log: dict[str, np.ndarray] = {"time_s": time}
    heading = TRACKED["heading"]
    turning = {heading.error, f"{heading.flown}-0"}  # differences, which go on beyond a half turn
    for i, shown in enumerate(map(shown_log, flights)):
        own = {name: on_grid(time, shown, name) for name in shown if name != "time_s"}
        for name in (of.flown for of in TRACKED.values()):
            if i and f"0:{name}" in log and name in own:
                own[f"{name}-0"] = _minus(own[name], log[f"0:{name}"], name)
        for name in turning & own.keys():
            own[name] = unwrapped_deg(own[name])
        log |= {f"{i}:{name}": values for name, values in own.items()}
    return log


def common_rows(one: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows of two logs at the same times, from the times [rows] of each [s]."""
    near = np.clip(np.searchsorted(other, one - _SAME_TIME), 0, max(len(other) - 1, 0))
    same = np.abs(other[near] - one) <= _SAME_TIME if len(other) else np.zeros(len(one), dtype=bool)
    return np.flatnonzero(same), near[same]


def on_grid(time: np.ndarray, log: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """A column of a log at the times of a grid [rows]: its latest row, and NaN after its end."""
    own = log["time_s"]
    rows = np.searchsorted(own, time + _SAME_TIME, side="right") - 1
    values = log[name][np.clip(rows, 0, len(own) - 1)]
    return np.where((rows >= 0) & (time <= own[-1] + _SAME_TIME), values, np.nan)


def _minus(one: np.ndarray, other: np.ndarray, name: str) -> np.ndarray:
    """The difference of two columns; of headings, the short way round."""
    return wrap_deg(one - other) if name.startswith("heading") else one - other


def groups(comparison: Comparison, log: Mapping[str, np.ndarray]) -> list[dict[str, Any]]:
    """{name, title, folded, panels} of each group, as `web/src/panels.js` draws them."""
    flights, names = comparison.flights, comparison.keys
    failures = [  # of all flights, or in the colour of each one that they belong to
        {"time_s": time, "style": style}
        for time, having in began(flights).items()
        for style in (["failure"] if len(having) == len(flights) else [f"v{i % _STYLES}" for i in having])
    ]
    made = [
        ("errors", "Errors against the references", False, _all_panels(flights, errors)),
        ("differences", f"Differences from {names[0]}", False, list(_differences())),
        ("attitude", "Attitude", False, _all_panels(flights, states)),
        ("effectiveness", "Effectiveness, true and believed", False, _all_panels(flights, effectiveness)),
        ("positions", "Positions of the actuators", len(flights) > _FEW, _all_panels(flights, actuators)),
    ]
    drawn = [group_of(name, title, folded, of_all(of, comparison, log)) for name, title, folded, of in made]
    for panel in (panel for group in drawn for panel in group["panels"]):
        panel["failures"] = failures
    return drawn


def began(flights: Sequence[Flight]) -> dict[float, list[int]]:
    """{time [s]: the numbers of the flights in which failures began then}, in order of time."""
    found: dict[float, list[int]] = {}
    for i, flight in enumerate(flights):
        for time in failure_times_s(flight.events):
            found.setdefault(time, []).append(i)
    return dict(sorted(found.items()))


def _all_panels(flights: Sequence[Flight], make: Callable[[Flight], Iterator[Panel]]) -> list[Panel]:
    """The panels that any of the flights has, each with all the series that it has in one of them.

    Levels, such as the limits of an actuator, are drawn where they are those of all the flights.
    """
    known: dict[str, Panel] = {}
    for panel in (panel for flight in flights for panel in make(flight)):
        before = known.setdefault(panel.title, panel)
        levels = panel.levels if panel.levels == before.levels else None
        known[panel.title] = replace(max(before, panel, key=lambda each: len(each.series)), levels=levels)
    return list(known.values())


def _differences() -> Iterator[Panel]:
    for quantity, drawn in TRACKED.items():
        series = Series(f"{drawn.flown}-0", quantity, "truth")
        yield Panel(quantity, unit(drawn.flown), (series,), drawn.least_error)


def of_all(panels: Sequence[Panel], comparison: Comparison, log: Mapping[str, np.ndarray]) -> Iterator[Panel]:
    """Each panel with one series of each flight: what its controller believes, if that is drawn, else the first.

    Beside what is believed stands what is true: once where that is the same in all flights, else of each.
    """
    for panel in panels:
        first = panel.series[0]
        main = next((series for series in panel.series if series.style == "belief"), first)
        series = [
            Series(f"{i}:{main.column}", name, f"v{i % _STYLES}") for i, name in enumerate(comparison.keys)
        ]
        truth = [] if main is first else _truths(first, comparison, log)
        if known := [each for each in (*truth, *series) if each.column in log]:
            yield replace(panel, series=tuple(known), flag="", notes=())


def _truths(true: Series, comparison: Comparison, log: Mapping[str, np.ndarray]) -> list[Series]:
    """What is true in each flight, and once what is true in all for as long as they fly."""
    found = {
        i: true._replace(column=f"{i}:{true.column}", label=f"true, {name}")
        for i, name in enumerate(comparison.keys)
        if f"{i}:{true.column}" in log
    }
    together = log["time_s"] < min(comparison.flights[i].end_time_s for i in found)
    longest = max(found, key=lambda i: comparison.flights[i].end_time_s)
    values = [log[series.column][together] for series in found.values()]
    if all(np.array_equal(each, values[0], equal_nan=True) for each in values):
        return [found[longest]._replace(label="true")]
    return list(found.values())
