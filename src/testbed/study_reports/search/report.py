"""The report of a search folder: one page with the answer in sentences, the design point, the way to it, and the flight found.

Everything is read from the folder.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from testbed.flight import folder as run_folder
from testbed.reporting import html
from testbed.reporting.comparison.compare import Comparison
from testbed.reporting.comparison.figure import picture
from testbed.study_reports.search import sections
from testbed.study_reports.search.figures import CAPTIONS, draw_search

Summary = dict[str, Any]


def write_search_page(folder: str | Path) -> Path:
    """Draw the figures and write report.html of a search folder from its summary.json; returns the file.

    Beside it, comparison*.html has each flight found and the one at the origin. Raises OSError when it cannot be written.
    """
    folder = Path(folder).resolve()
    summary: Summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    draw_search(summary, folder)
    return html.write_page(folder / "report.html", summary["search"], _parts(summary, folder), ["sweep.css"])


def _parts(summary: Summary, folder: Path) -> Iterator[str]:
    yield from sections.head(summary)
    yield from sections.probabilities(summary)
    yield from sections.design_points(summary)
    for part in summary["parts"]:
        if part["found"]:
            yield from _flight(part, folder)
    yield from html.figures(folder / "figures", CAPTIONS)
    yield from sections.levels(summary)
    yield from sections.searches(summary)


def _flight(part: Summary, folder: Path) -> Iterator[str]:
    """The flight found beside the one at the origin: a picture, and a link to the page that compares them."""
    name = Path(
        part["folder"]
    ).name  # summary.json may be somebody else's, and say a path that leads out of the folder
    found, origin = folder / name, folder / name.replace("found", "origin", 1)
    if not (found / "log.csv").is_file() or not (origin / "log.csv").is_file():
        return
    flights = [run_folder.load(origin), run_folder.load(found)]
    if not all(flight.actuators for flight in flights):  # made up by a function of the user's
        return
    comparison = Comparison(flights, ["at the origin", "found"])
    page = comparison.write(folder / f"{name.replace('found', 'comparison', 1)}.html")
    label = f" ({part['label']})" if part["label"] else ""
    yield html.picture(
        picture(comparison), f"The flight found, and the one at the origin of the search{label}"
    )
    yield html.note(
        html.Html(
            f'<a href="{page.name}">Both flights side by side</a>, <a href="{found.name}/report.html">the flight found</a>.'
        )
    )
