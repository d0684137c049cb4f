"""The page of one flight of a sweep or a matrix, made from the log that it kept."""

from __future__ import annotations

import shlex
from pathlib import Path

from testbed.flight.flight import Flight
from testbed.reporting import html, run_report
from testbed.reporting.html import tag
from testbed.studies.folder import logs
from testbed.studies.folder.names import file_of

FOLDER = "flights"
"""Folder of these pages in a sweep folder."""


def page_of(log: Path) -> Path:
    """The page of a kept log: SWEEP/logs/run-000017-pid.parquet has SWEEP/flights/run-000017-pid.html."""
    return log.parent.parent / FOLDER / f"{log.stem}.html"


def write_kept_page(flight: Flight, log: Path) -> Path:
    """Write the page of the flight of a kept log; returns its file. Raises OSError when it cannot be written."""
    file = page_of(log)
    back = html.note(f"Run {logs.run_of(log)} of ", html.link(f"a {_study(log).stem}", "../report.html"), ".")
    return run_report.write_page(flight, file, again=_again(log), back=back, within=log.parent.parent)


def _again(log: Path) -> html.Html:
    said = (
        f"Run this in the folder of the {_study(log).stem}. It flies the same flight, and keeps its log in full precision; "
        "here it has single precision."
    )
    return html.joined(
        [tag("p", said), tag("pre", only(logs.run_of(log), logs.label_of(log), _study(log).name))]
    )


def _study(log: Path) -> Path:
    return file_of(log.parent.parent)


def only(run: int, variant: str, file: str) -> str:
    """The command that flies one flight of a sweep or a matrix again, alone; `file` is that in its folder."""
    chosen = ["--variant", variant] if variant else []
    return f"python -m testbed {shlex.join([Path(file).stem, file, '--only', str(run), *chosen])}"
