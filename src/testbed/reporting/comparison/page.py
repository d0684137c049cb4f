"""The page of a comparison: what differs in sentences, panels with all flights, differences, metrics side by side."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.reporting import html
from testbed.reporting.comparison.panels import columns_of, groups
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.page import can_be_replayed, drawn, packed
from testbed.reporting.run_report import definition
from testbed.reporting.story import story
from testbed.reporting.words import VERDICTS, rounded, setting

if TYPE_CHECKING:
    from testbed.reporting.comparison.compare import Comparison

_MOST_COLUMNS = 4  # named where logs differ first


def write(comparison: Comparison, file: Path) -> Path:
    """Write the page; returns its file. Raises OSError when it cannot be written."""
    log = columns_of(comparison.flights)
    shown = groups(comparison, log)
    told, columns = packed(log)
    data = {"data": told, "panels": shown, "flights": list(_flights(comparison))}
    keys = comparison.keys
    title = " and ".join((", ".join(keys[:-1]), keys[-1]))
    if keys != comparison.names:
        title = f"{len(keys)} flights: {title}"
    parts = _parts(comparison, title, shown)
    return html.write_page(file, title, parts, "compare.js", {"comparison": data, "columns": columns})


def _parts(comparison: Comparison, title: str, shown: list[dict[str, Any]]) -> Iterator[Part]:
    from testbed.reporting.comparison.figure import picture

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
    yield tag("div", html.picture(picture(comparison), "Errors and bank of the flights"), class_="still")
    yield _stories(comparison)
    yield _requirements(comparison)
    yield metrics(comparison)
    yield _settings(comparison)


def _flights(comparison: Comparison) -> Iterator[dict[str, Any]]:
    for key, name, flight in zip(comparison.keys, comparison.names, comparison.flights, strict=True):
        yield {"key": key, "name": name, **drawn(flight, flight.signals)}


def sentences(comparison: Comparison) -> list[str]:
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


def _paths(comparison: Comparison) -> list[str]:
    """The settings that differ; those of controllers of another type, and requirements, are not named one by one."""
    paths = [each.path for each in comparison.settings]
    whole = {"requirements.": "requirements"}
    if "controller.type" in paths:
        whole = {"controller.": "the controller and what belongs to it", **whole}
    said = [words for start, words in whole.items() if any(path.startswith(start) for path in paths)]
    return [*said, *(setting(path) for path in paths if not path.startswith(tuple(whole)))]


def _ended(i: int, comparison: Comparison) -> str:
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


def _stories(comparison: Comparison) -> Iterator[Html]:
    yield tag("h2", "Each flight told")
    for i, (name, flight) in enumerate(zip(comparison.names, comparison.flights, strict=True)):
        yield tag("h3", html.mark(i), " ", name)
        yield html.listed(story(flight))


def _requirements(comparison: Comparison) -> Iterator[Html]:
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


def metrics(comparison: Comparison) -> Iterator[Html]:
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


def _settings(comparison: Comparison) -> Iterator[Html]:
    rows = [
        html.row([setting(each.path), *("-" if value is None else str(value) for value in each.values)])
        for each in comparison.settings
    ]
    if rows:
        yield html.folded("Settings that differ", html.table(["setting", *comparison.keys], rows))
