"""Figures and report of a finished flight, added to its run folder."""

from __future__ import annotations

from pathlib import Path

from testbed.flight.flight import Flight
from testbed.reporting.attempt import attempt


def present(flight: Flight, folder: Path, figures: bool = True) -> bool:
    """Add the report, and the figures if wanted, to a folder with log and summary; returns whether all could be made."""

    def draw() -> None:
        from testbed.reporting.figures import draw

        draw(flight, folder)

    def write() -> None:
        from testbed.reporting.run_report import write_report

        write_report(folder)

    drawn = not figures or attempt("the figures", draw)
    return attempt("the report", write) and drawn
