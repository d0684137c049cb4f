"""What is made of one flight of a sweep or a matrix: its page, from the log that it kept, and its test (see `reporting.junit`)."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.flight.flight import Flight
from testbed.reporting import html, run_report
from testbed.reporting.html import tag
from testbed.reporting.junit import Test
from testbed.reporting.story import story
from testbed.studies.folder import logs, table
from testbed.studies.plan import Plan
from testbed.studies.verdicts import said_of

FOLDER = "flights"
"""Folder of these pages in a sweep folder."""


def page_of(log: Path) -> Path:
    """The page of a kept log: SWEEP/logs/run-000017-pid.parquet has SWEEP/flights/run-000017-pid.html."""
    return log.parent.parent / FOLDER / f"{log.stem}.html"


def write_kept_page(flight: Flight, log: Path) -> Path:
    """Write the page of the flight of a kept log; returns its file. Raises OSError when it cannot be written."""
    study, (run, label) = logs.file_of(log.parent.parent), logs.run_and_label(log.stem)
    back = html.note(f"Run {run} of ", html.link(f"a {study.stem}", "../report.html"), ".")
    said = (
        f"Run this in the folder of the {study.stem}. It flies the same flight, and keeps its log in full precision; "
        "here it has single precision."
    )
    again = html.joined([tag("p", said), tag("pre", only(run, label, study.name))])
    return run_report.write_page(flight, page_of(log), again=again, back=back, within=log.parent.parent)


def write_page_if_kept(folder: Path, run: int, variant: str) -> None:
    """Write the page of a flight, by its run and its variant's label, if its log was kept. Raises OSError as `write_kept_page`."""
    if (flight := logs.kept(folder, run, variant)) is not None:
        write_kept_page(flight, logs.log_file(folder, run, variant))


def only(run: int, variant: str, file: str) -> str:
    """The command that flies one flight of a sweep or a matrix again, alone; `file` is that in its folder."""
    chosen = ["--variant", variant] if variant else []
    return f"python -m testbed {shlex.join([Path(file).stem, file, '--only', str(run), *chosen])}"


def tests_of_sweep(plan: Plan, folder: Path, summary: Mapping[str, Any]) -> Iterator[Test]:
    """A test of each flight, in the order of runs and variants."""
    for k, row in enumerate(table.load(folder).to_dict("records")):
        label = plan.variants[k % len(plan.variants)].label
        name = f"run {row['run']}" + (f", {label}" if label else "")
        if row["passed"] is None:
            yield Test(name, skipped=said_of(plan, row))
            continue
        failure = "" if row["passed"] else said_of(plan, row) or "not passed"
        yield Test(name, failure, told(plan, row["run"], label, folder) if failure else "")


def told(plan: Plan, run: int, label: str, folder: Path) -> str:
    """The story of a flight, if its log was kept, and the command that flies it again."""
    again = only(run, logs.in_file_names(label), str(folder / f"{plan.study.word}.yaml"))
    flight = logs.kept(folder, run, label)
    return "\n".join([*(story(flight) if flight is not None else []), again])
