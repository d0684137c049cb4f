"""Drawing figures and writing reports must never cost the results that they show."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path

from testbed.flight.flight import Flight


class NotShown(UserWarning):
    """A figure or a report could not be made; log, table and summary are there."""


def attempt(what: str, write: Callable[[], object]) -> bool:
    """Call a function that writes figures or a report; returns whether it succeeded. Else there is a `NotShown` warning."""
    try:
        write()
    except Exception as error:  # of matplotlib, of the disk, of memory: the results are there in any case
        words = getattr(error, "strerror", None) or f"{type(error).__name__}: {error}"
        warnings.warn(NotShown(f"{what} could not be made: {words}"), stacklevel=2)
        return False
    return True


def add_report(flight: Flight, folder: Path, figures: bool = True) -> bool:
    """Add the report, and the figures if wanted, to a folder with log and summary; returns whether all could be made."""
    from testbed.reporting.figures import draw
    from testbed.reporting.run_report import write_page

    drawn = not figures or attempt("the figures", lambda: draw(flight, folder))
    page = folder / "report.html"
    return attempt("the report", lambda: write_page(flight, page, folder / "figures")) and drawn
