"""The report of a sweep folder: one page with the answer, the map of its flights, what drives it, and every flight."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from testbed.common.files import plain
from testbed.reporting import html
from testbed.studies.folder import reading
from testbed.studies.folder.names import flight_label
from testbed.studies.plan import Plan
from testbed.study_reports.sweep import sections
from testbed.study_reports.sweep.flight_page import FOLDER
from testbed.study_reports.sweep.flights import PAGE, for_the_script, kept_of

Summary = dict[str, Any]

_CAPTIONS = {
    "probabilities": "Probability that each requirement is met, with 95 % intervals (Wilson).",
    "map": "Every flight, by the two varied numbers that matter most: passed, missed and lost.",
    "pass_share": "Share of flights that pass along each varied value; 95 % intervals.",
    "envelope": "Errors in time: median, 5 to 95 % of the flights still flying, and the flight with the largest.",
    "detection_delay": "Detection delays of the flights in which something was detected.",
    "drivers": "Which varied values decide whether a flight passes: PAWN index (Pianosi and Wagener 2018).",
}
_PLACES = """<div class="moving">
<h2>Where it passes, and where it does not</h2><div id="map"></div>
<h2>The share that passes along each varied value</h2><div id="shares"></div>
<h2>Errors in time</h2><div id="errors"></div>
<h2>Every flight</h2><div id="flights"></div>
</div>"""
"""What the script fills."""


def write_sweep_report(folder: str | Path) -> Path:
    """Write report.html from summary.json, the table and figures/ of a sweep folder; returns the file.

    Without a table, as in a folder with nothing but summary.json, the page has no moving parts. Raises OSError when
    summary.json is missing or the report cannot be written.
    """
    folder = Path(folder).resolve()
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    data = None
    if (folder / "sweep.yaml").is_file():
        plan, frame = reading.load_plan(folder), reading.load(folder)
        data = for_the_script(plan, frame, folder) if len(frame) else None
        _add_pages(summary, plan, folder)
    inside = parts(summary, folder, moving=data is not None)
    return html.write_page(folder / "report.html", summary["sweep"], [*inside, *_script(data)], ["sweep.css"])


def parts(summary: Summary, folder: Path, *, moving: bool = False) -> Iterator[str]:
    """The sections of the report, as HTML, in their order; with `moving`, the places that the script fills."""
    yield from sections.head(summary)
    yield from sections.probabilities(summary)
    yield from sections.pairs(summary)
    if moving:
        yield _PLACES
    yield from sections.drivers(summary)
    yield '<div class="still">'
    yield from html.figures(folder / "figures", _CAPTIONS)
    yield from sections.worst(summary, folder.name)
    yield "</div>"
    yield from sections.excursions(summary)
    yield from sections.runs_needed(summary)


def _add_pages(summary: Summary, plan: Plan, folder: Path) -> None:
    """Tell of each of the worst flights where its page is, if it has one."""
    for i, variant in enumerate(summary["variants"]):
        for flight in variant["worst"]:
            if kept_of(plan, folder, flight["run"], i) == PAGE:
                label = flight_label(plan, flight["run"] * len(plan.variants) + i)
                flight["page"] = f"{FOLDER}/{label}.html"


def _script(data: dict[str, Any] | None) -> Iterator[str]:
    if data is not None:
        text = json.dumps(plain(data), separators=(",", ":"), ensure_ascii=False)
        yield html.script(text, "application/json", "sweep")
        yield html.script(html.asset("sweep.js"))
