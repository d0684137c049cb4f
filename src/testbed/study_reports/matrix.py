"""The page of a failure matrix: a table of actuators by failures, in which each cell opens its flight and names its command.

Each cell is a test, too (see `reporting.junit`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from operator import itemgetter
from pathlib import Path
from typing import Any

from testbed.reporting import html
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.junit import Test
from testbed.studies.folder.logs import flight_label, in_file_names
from testbed.studies.matrix import MatrixPlan
from testbed.study_reports.sweep.flight_page import FOLDER, only, told

Cell = Mapping[str, Any]


def write_matrix_page(plan: MatrixPlan, summary: Mapping[str, Any], folder: Path) -> Path:
    """Write report.html of a matrix folder; returns the file. Raises OSError when it cannot be written."""
    return html.write_page(folder / "report.html", summary["matrix"], _parts(plan, summary, folder))


def _parts(plan: MatrixPlan, summary: Mapping[str, Any], folder: Path) -> Iterator[Part]:
    cells: Sequence[Cell] = summary["cells"]
    facts = {result: str(number) for result, number in summary["counts"].items()}
    facts |= {"flights": str(summary["flights"]), "seeds": str(summary["seeds"])}
    yield html.opening(summary["matrix"], [], facts, _verdict(summary))
    for against in ("worse", "better"):
        found = [cell for cell in cells if cell["against"] == against]
        if found:
            yield tag("h2", f"{against.capitalize()} than expected")
            shown = ("actuator", "failure", "severity", "weather", "controller", "result", "expected", "why")
            yield html.listing(found, {key: itemgetter(key) for key in shown})
    for weather, label in dict.fromkeys((cell["weather"], cell["controller"]) for cell in cells):
        yield tag("h2", ", ".join(filter(None, [label, weather])))
        here = [cell for cell in cells if (cell["weather"], cell["controller"]) == (weather, label)]
        yield _table(plan, here, folder)
    yield html.note(
        "Each cell: each severity, and what came of the worst of its flights. Held: every requirement met. Survived: flown to the "
        "end. Not possible (-): the failure does not fit the actuator. The commands are run in the folder of this page; "
        "matrix.csv has every cell."
    )


def _verdict(summary: Mapping[str, Any]) -> Html:
    worse, better = summary["worse"], summary["better"]
    said = f"{worse} worse and {better} better than expected." if worse or better else "As expected."
    return tag("p", tag("strong", said), class_=f"verdict {'missed' if worse or better else 'met'}")


def _table(plan: MatrixPlan, cells: Sequence[Cell], folder: Path) -> Html:
    """The matrix of one controller in one kind of weather: a row for each failure, a column for each actuator."""
    actuators = list(dict.fromkeys(cell["actuator"] for cell in cells))
    failures = dict.fromkeys(cell["failure"] for cell in cells)
    places: dict[tuple[str, str], list[Html]] = {}
    for cell in cells:
        places.setdefault((cell["failure"], cell["actuator"]), []).append(_cell(plan, cell, folder))
    rows = (
        html.row([failure, *(html.joined(places.get((failure, name), [])) for name in actuators)])
        for failure in failures
    )
    return html.table(["failure", *actuators], rows)


def _cell(plan: MatrixPlan, cell: Cell, folder: Path) -> Html:
    """What came of a cell in a word, which opens: why, its flight, and the command that flies it again."""
    if cell["run"] is None:
        return tag("span", "-", title=cell["why"])
    variant = plan.variant_of(cell["controller"])
    page = f"{FOLDER}/{flight_label(cell['run'], variant)}.html"
    against = "" if cell["against"] == "as expected" else f" ({cell['against']})"
    kind = f"cell {cell['result'].replace(' ', '-')}"
    return tag(
        "details",
        tag("summary", f"{cell['severity']:g}: {cell['result']}{against}", class_=kind),
        tag("p", cell["why"] or f"{cell['held']} of {cell['flights']} held"),
        tag("p", html.link("the flight", page)) if (folder / page).is_file() else None,
        tag("pre", only(cell["run"], in_file_names(variant), "matrix.yaml")),
    )


def tests_of_matrix(plan: MatrixPlan, folder: Path, summary: Mapping[str, Any]) -> Iterator[Test]:
    """A test of each cell, which fails where it is worse or better than expected."""
    for cell in summary["cells"]:
        shown = {**cell, "severity": f"{cell['severity']:g}"}
        keys = ("actuator", "failure", "severity", "weather", "controller")
        name = ", ".join(shown[key] for key in keys if shown[key])
        if cell["against"] != "as expected":
            said = f"{cell['result']}, expected {cell['expected']}: {cell['why'] or 'better'}"
            label = plan.variant_of(cell["controller"])
            yield Test(name, said, "" if cell["run"] is None else told(plan, cell["run"], label, folder))
        else:
            yield Test(name, skipped=cell["why"] if cell["run"] is None else "")
