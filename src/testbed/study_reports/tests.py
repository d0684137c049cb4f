"""The flights of a sweep or a benchmark and the cells of a matrix as tests (see `reporting.junit`)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.reporting.junit import Test
from testbed.reporting.story import story
from testbed.studies.folder import logs, table
from testbed.studies.folder.logs import in_file_names
from testbed.studies.matrix import MatrixPlan
from testbed.studies.plan import Plan
from testbed.studies.verdicts import said_of
from testbed.study_reports.benchmark import again
from testbed.study_reports.sweep.flight_page import only

if TYPE_CHECKING:
    import pandas as pd


def tests_of_sweep(plan: Plan, folder: Path, summary: Mapping[str, Any]) -> Iterator[Test]:
    """A test of each flight, in the order of runs and variants."""
    for k, row in enumerate(table.load(folder).to_dict("records")):
        label = plan.variants[k % len(plan.variants)].label
        name = f"run {row['run']}" + (f", {label}" if label else "")
        if row["passed"] is None:
            yield Test(name, skipped=said_of(plan, row))
            continue
        failure = "" if row["passed"] else said_of(plan, row) or "not passed"
        yield Test(name, failure, _text(plan, row["run"], label, folder) if failure else "")


def tests_of_matrix(plan: MatrixPlan, folder: Path, summary: Mapping[str, Any]) -> Iterator[Test]:
    """A test of each cell, which fails where it is worse or better than expected."""
    for cell in summary["cells"]:
        shown = {**cell, "severity": f"{cell['severity']:g}"}
        keys = ("actuator", "failure", "severity", "weather", "controller")
        name = ", ".join(shown[key] for key in keys if shown[key])
        if cell["against"] != "as expected":
            said = f"{cell['result']}, expected {cell['expected']}: {cell['why'] or 'better'}"
            label = plan.variant_of(cell["controller"])
            yield Test(name, said, "" if cell["run"] is None else _text(plan, cell["run"], label, folder))
        else:
            yield Test(name, skipped=cell["why"] if cell["run"] is None else "")


def tests_of_benchmark(summary: Mapping[str, Any], frame: pd.DataFrame) -> Iterator[Test]:
    """A test of each flight, in the order of draws and controllers, which fails where it was not held."""
    for row in frame.to_dict("records"):
        said = row["reason"] or ("left its limits" if row["survived"] else f"lost: {row['outcome']}")
        command = again(summary, row["draw"], row["controller"])
        name = f"draw {row['draw']}, {row['controller']}"
        yield Test(name) if row["held"] else Test(name, said, f"{_drawn(row)}\n{command}")


def _drawn(row: Mapping[Any, Any]) -> str:
    """What was drawn, and how far the flight strayed: a benchmark keeps no log of which a story could be told."""
    about = ", ".join(f"{key} {row[key]}" for key in ("weather", "gust", "sensors", "failures", "course"))
    inside = f"within its limits in {100 * row['inside']:.0f} % of the flight, which ended at {row['end_time_s']:g} s"
    worst = (
        f"{row['altitude_error_max_m']:.1f} m of altitude, {row['heading_error_max_deg']:.0f} deg of heading"
    )
    return f"{row['aircraft']}, {row['truth']}: {about}.\nWorst: {worst}; {inside}."


def _text(plan: Plan, run: int, label: str, folder: Path) -> str:
    """The story of a flight, if its log was kept, and the command that flies it again."""
    again = only(run, in_file_names(label), str(folder / f"{plan.study.word}.yaml"))
    flight = logs.kept(folder, run, label)
    return "\n".join([*(story(flight) if flight is not None else []), again])
