"""The report of a search folder: one page with the answer in sentences, the design point, the way to it, and the flight found.

Everything is read from the folder.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.flight import folder as run_folder
from testbed.inputs.received import read_json
from testbed.reporting import html
from testbed.reporting.comparison.compare import Comparison
from testbed.reporting.comparison.figure import picture
from testbed.reporting.html import Html, Part
from testbed.study_reports.search import sections
from testbed.study_reports.search.figures import CAPTIONS, draw_search

Summary = Mapping[str, Any]


def write_search_page(folder: str | Path) -> Path:
    """Draw the figures and write report.html of a search folder from its summary.json; returns the file.

    Beside it, comparison*.html has each flight found and the one at the origin. Raises OSError when it cannot be written.
    """
    folder = Path(folder).resolve()
    summary: Summary = read_json(folder / "summary.json", "the summary that testbed wrote")
    draw_search(summary, folder)
    return html.write_page(folder / "report.html", summary["search"], _parts(summary, folder))


def _parts(summary: Summary, folder: Path) -> Iterator[Part]:
    yield sections.head(summary)
    yield sections.probabilities(summary)
    yield sections.design_points(summary)
    yield (_flight(part, folder) for part in summary["parts"] if part["found"])
    yield html.figures(folder / "figures", CAPTIONS)
    yield sections.levels(summary)
    yield sections.searches(summary)


def _flight(part: Summary, folder: Path) -> Iterator[Html]:
    """The flight found beside the one at the origin: a picture, and a link to the page that compares them."""
    name = Path(part["folder"]).name  # a summary from somebody else names no other place
    found, origin = folder / name, folder / name.replace("found", "origin", 1)
    if not name.startswith("found") or not all((each / "log.csv").is_file() for each in (found, origin)):
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
    links = [
        html.link("Both flights side by side", page.name),
        html.link("the flight found", f"{name}/report.html"),
    ]
    yield html.note(html.joined(links, ", "), ".")
