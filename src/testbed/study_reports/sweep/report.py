"""The report of a sweep folder: one page with the answer, the map of its flights, what drives it, and every flight."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.inputs.received import read_json
from testbed.reporting import html
from testbed.reporting.html import Html, Part, tag
from testbed.studies.folder import reading
from testbed.study_reports.sweep import sections
from testbed.study_reports.sweep.flights import for_the_script

_CAPTIONS = {
    "probabilities": "Probability that each requirement is met, with 95 % intervals (Wilson).",
    "map": "Every flight, by the two varied numbers that matter most: passed, missed and lost.",
    "pass_share": "Share of flights that pass along each varied value; 95 % intervals.",
    "envelope": "Errors in time: median, 5 to 95 % of the flights still flying, and the flight with the largest.",
    "detection_delay": "Detection delays of the flights in which something was detected.",
    "drivers": "Which varied values decide whether a flight passes: PAWN index (Pianosi and Wagener 2018).",
}
_PLACES = Html("""<div class="moving">
<h2>Where it passes, and where it does not</h2><div id="map"></div>
<h2>The share that passes along each varied value</h2><div id="shares"></div>
<h2>Errors in time</h2><div id="errors"></div>
<h2>Every flight</h2><div id="flights"></div>
</div>""")
"""What the script fills."""


def write_sweep_report(folder: str | Path) -> Path:
    """Write report.html from summary.json, the table and figures/ of a sweep folder; returns the file.

    Without a table, as in a folder with nothing but summary.json, the page has no moving parts. Raises OSError when
    summary.json is missing or the report cannot be written.
    """
    folder = Path(folder).resolve()
    summary = read_json(folder / "summary.json", "the summary that testbed wrote")
    file, name = folder / "report.html", summary["sweep"]
    if not (folder / "sweep.yaml").is_file() or not len(frame := reading.load(folder)):
        return html.write_page(file, name, parts(summary, folder))
    data = {"sweep": for_the_script(reading.load_plan(folder), frame, folder)}
    return html.write_page(file, name, parts(summary, folder, moving=True), "sweep.js", data)


def parts(summary: Mapping[str, Any], folder: Path, *, moving: bool = False) -> Iterator[Part]:
    """The sections of the report in their order; with `moving`, the places that the script fills."""
    yield sections.head(summary)
    yield sections.probabilities(summary)
    yield sections.pairs(summary)
    if moving:
        yield _PLACES
    yield sections.drivers(summary)
    still = [html.figures(folder / "figures", _CAPTIONS), sections.worst(summary, folder)]
    yield tag("div", still, class_="still")
    yield sections.excursions(summary)
    yield sections.runs_needed(summary)
