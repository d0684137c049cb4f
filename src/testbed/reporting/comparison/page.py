"""The page of a comparison: what differs in sentences, panels with all flights, differences, metrics side by side.

Its panels are those of `reporting.panels` with all flights in each, and the differences from the first flight.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from testbed.common.angles import unwrapped_deg, wrap_deg
from testbed.common.units import unit
from testbed.flight.breakage import failure_times_s
from testbed.flight.flight import Flight
from testbed.reporting import html
from testbed.reporting.comparison.differences import SAME_TIME, Compared
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.page import can_be_replayed, drawn, group_of, packed
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
from testbed.reporting.run_report import definition
from testbed.reporting.story import story
from testbed.reporting.words import VERDICTS, rounded, setting

_STYLES = 6  # in the palette
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
                away = own[name] - log[f"0:{name}"]
                own[f"{name}-0"] = wrap_deg(away) if name == heading.flown else away
        for name in turning & own.keys():
            own[name] = unwrapped_deg(own[name])
        log |= {f"{i}:{name}": values for name, values in own.items()}
    return log


def on_grid(time: np.ndarray, log: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """A column of a log at the times of a grid [rows]: its latest row, and NaN after its end."""
    own = log["time_s"]
    rows = np.searchsorted(own, time + SAME_TIME, side="right") - 1
    values = log[name][np.clip(rows, 0, len(own) - 1)]
    return np.where((rows >= 0) & (time <= own[-1] + SAME_TIME), values, np.nan)


def groups(comparison: Compared, log: Mapping[str, np.ndarray]) -> list[dict[str, Any]]:
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
    found = [group_of(name, title, folded, of_all(of, comparison, log)) for name, title, folded, of in made]
    for panel in (panel for group in found for panel in group["panels"]):
        panel["failures"] = failures
    return found


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
    for quantity, of in TRACKED.items():
        series = Series(f"{of.flown}-0", quantity, "truth")
        yield Panel(quantity, unit(of.flown), (series,), of.least_error)


def of_all(panels: Sequence[Panel], comparison: Compared, log: Mapping[str, np.ndarray]) -> Iterator[Panel]:
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


def _truths(true: Series, comparison: Compared, log: Mapping[str, np.ndarray]) -> list[Series]:
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


_MOST_COLUMNS = 4  # named where logs differ first


def write(comparison: Compared, file: Path, still: bytes) -> Path:
    """Write the page, with a PNG for where its script does not run; returns its file. Raises OSError when it cannot be written."""
    log = columns_of(comparison.flights)
    shown = groups(comparison, log)
    told, columns = packed(log)
    data = {"data": told, "panels": shown, "flights": list(_flights(comparison))}
    keys = comparison.keys
    title = " and ".join((", ".join(keys[:-1]), keys[-1]))
    if keys != comparison.names:
        title = f"{len(keys)} flights: {title}"
    parts = _parts(comparison, title, shown, still)
    return html.write_page(file, title, parts, "compare.js", {"comparison": data, "columns": columns})


def _parts(comparison: Compared, title: str, shown: list[dict[str, Any]], still: bytes) -> Iterator[Part]:
    yield html.opening(title, sentences(comparison))
    replayed = all(can_be_replayed(flight.signals) for flight in comparison.flights)
    panels = [
        tag("h2", "The flights"),
        tag("div", id="timelines"),
        tag("div", id="replay") if replayed else None,
        html.legend(comparison.names),
        *map(html.panels, shown),
    ]
    yield tag("div", panels, class_="moving")
    yield tag("div", html.picture(still, "Errors and bank of the flights"), class_="still")
    yield _stories(comparison)
    yield _requirements(comparison)
    yield metrics(comparison)
    yield _settings(comparison)


def _flights(comparison: Compared) -> Iterator[dict[str, Any]]:
    for key, name, flight in zip(comparison.keys, comparison.names, comparison.flights, strict=True):
        yield {"key": key, "name": name, **drawn(flight, flight.signals)}


def sentences(comparison: Compared) -> list[str]:
    """How each flight ended, what is set otherwise, and from when on they differ."""
    lines = [_ended(i, comparison) for i in range(len(comparison.flights))]
    differing = _paths(comparison)
    few = ", ".join(differing[:6]) + (f" and {len(differing) - 6} more" if len(differing) > 6 else "")
    lines.append(f"Set differently: {few}." if differing else "The scenarios are the same.")
    first = comparison.keys[0]
    for name, found in zip(comparison.keys[1:], comparison.first_differences, strict=True):
        if found.time_s is None:
            lines.append(f"The logs of {first} and {name} are the same in every step and column.")
            continue
        shown = ", ".join(found.columns[:_MOST_COLUMNS])
        more = f" and {len(found.columns) - _MOST_COLUMNS} more" if len(found.columns) > _MOST_COLUMNS else ""
        moved = (
            "they never move differently"
            if found.moved_s is None
            else f"they move differently from {found.moved_s:.3f} s on"
        )
        lines.append(f"{first} and {name} first differ at {found.time_s:.3f} s ({shown}{more}); {moved}.")
    return lines


def _paths(comparison: Compared) -> list[str]:
    """The settings that differ; those of controllers of another type, and requirements, are not named one by one."""
    paths = [each.path for each in comparison.settings]
    whole = {"requirements.": "requirements"}
    if "controller.type" in paths:
        whole = {"controller.": "the controller and what belongs to it", **whole}
    said = [words for start, words in whole.items() if any(path.startswith(start) for path in paths)]
    return [*said, *(setting(path) for path in paths if not path.startswith(tuple(whole)))]


def _ended(i: int, comparison: Compared) -> str:
    flight = comparison.flights[i]
    worst = ", ".join(
        f"{flight.metrics[name]:.3g} {unit}"
        for name, unit in (
            ("altitude_error_max_m", "m of altitude"),
            ("heading_error_max_deg", "deg of heading"),
        )
        if name in flight.metrics and math.isfinite(flight.metrics[name])
    )
    errors = f"; at worst {worst}" if worst else ""
    requirements = f"; {flight.counted}" if flight.requirements else ""
    return f"{comparison.names[i]}: {flight.verdict}. It {flight.outcome.sentence} ({flight.end_time_s:g} s){errors}{requirements}."


def _stories(comparison: Compared) -> Iterator[Html]:
    yield tag("h2", "Each flight told")
    for i, (name, flight) in enumerate(zip(comparison.names, comparison.flights, strict=True)):
        yield tag("h3", html.mark(i), " ", name)
        yield html.listed(story(flight))


def _requirements(comparison: Compared) -> Iterator[Html]:
    verdicts = [{r["name"]: r for r in flight.requirements} for flight in comparison.flights]
    rows = []
    for name in dict.fromkeys(name for one in verdicts for name in one):
        found = [one.get(name) for one in verdicts]
        cells = [
            ""
            if r is None
            else VERDICTS[r["passed"]] + ("" if r["passed"] is None else f" ({rounded(r['value'])})")
            for r in found
        ]
        missed = any(r is not None and r["passed"] is False for r in found)
        rows.append((not missed, html.row([name, *cells], "missed" if missed else "")))
    if rows:
        yield tag("h2", "Requirements")
        caption = "Verdict and worst value; those that any flight missed come first."
        ordered = [row for _, row in sorted(rows, key=lambda row: row[0])]
        yield html.table(["requirement", *comparison.keys], ordered, caption)


def metrics(comparison: Compared) -> Iterator[Html]:
    """The metrics that differ, and the others folded away."""
    rows: dict[bool, list[Html]] = {True: [], False: []}
    for name, values in comparison.metrics.iterrows():
        numbers = [rounded(value) for value in values]
        cells = [
            str(name),
            tag("span", definition(str(name)), class_="definition"),
            *(tag("span", number) for number in numbers),
        ]
        rows[len(set(numbers)) > 1].append(html.row(cells))
    heads = ["metric", "definition and [unit]", *comparison.keys]
    yield tag("h2", "Metrics side by side")
    yield html.table(heads, rows[True]) if rows[True] else tag("p", "All are the same.")
    if rows[False]:
        yield html.folded("Metrics that are the same", html.table(heads, rows[False]))


def _settings(comparison: Compared) -> Iterator[Html]:
    rows = [
        html.row([setting(each.path), *("-" if value is None else str(value) for value in each.values)])
        for each in comparison.settings
    ]
    if rows:
        yield html.folded("Settings that differ", html.table(["setting", *comparison.keys], rows))
