"""A flight that shows itself: it draws, reports, saves and exports. This is what `testbed.fly` and `testbed.load` return."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.flight.flight import Flight
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.reporting import html, run_report
from testbed.reporting.attempt import add_report
from testbed.reporting.html import Html, tag
from testbed.reporting.story import story
from testbed.reporting.words import VERDICTS, number

if TYPE_CHECKING:
    from matplotlib.figure import Figure

KEY_NUMBERS = {
    "altitude_error_max_m": "largest altitude error [m]",
    "heading_error_max_deg": "largest heading error [deg]",
    "airspeed_error_max_m_s": "largest airspeed error [m/s]",
    "detection_delay_s": "longest detection delay [s]",
    "missed_detections": "missed detections",
    "false_alarms": "false alarms",
}
"""Metrics that a notebook shows of every flight, and their titles."""
_MOST_ROWS = 12  # requirements shown in a notebook; the report has all of them
_AGAIN = Html("""<p>Save the scenario below as scenario.yaml, and run this beside it.</p>
<pre>python -m testbed run scenario.yaml</pre>""")
"""How to fly a flight again whose page stands alone."""
_TOLD = ("altitude_m", "heading_deg", "airspeed_m_s", "beta_deg")
"""Columns without which there is no story."""


class ReportedFlight(Flight):
    """A finished flight with its figures and its report."""

    @classmethod
    def of(cls, flight: Flight) -> ReportedFlight:
        """The same flight, with these methods."""
        return cls(**{field.name: getattr(flight, field.name) for field in fields(flight)})

    def plot(self, figure: str = "states") -> Figure:
        """A figure of the flight: `states`, `actuators`, `effectiveness` or `rates`; raises BadInput for another name."""
        from testbed.reporting.figures import TABLE, plot

        if figure not in TABLE:
            raise BadInput([Problem(f"is no figure: {figure}", "plot", None, "", *guess(figure, TABLE))])
        return plot(self, figure)

    def report(self, file: str | Path) -> Path:
        """Write the flight's page, one HTML file that needs no other, replacing the file; returns it. Raises OSError."""
        from testbed.reporting.figures import draw

        with tempfile.TemporaryDirectory() as scratch:
            draw(self, scratch)
            return run_report.write_page(self, Path(file), Path(scratch) / "figures", _AGAIN)

    def save(self, folder: str | Path, *, figures: bool = True) -> Path:
        """Write a run folder as `testbed run` does; returns it. `testbed.load` reads it.

        Raises BadInput when the folder exists or cannot be made, OSError when the disk is full.
        """
        return write_run_folder(self, folder, lambda partial: add_report(self, partial, figures))

    def export(self, to: str, file: str | Path, *, origin: str | None = None) -> Path:
        """Write the flight for another program; returns the file.

        Args:
            to: a format of `reporting.export.TABLE`, such as `acmi`.
            file: the file to write; an existing one is never overwritten.
            origin: where the flight starts, `LAT,LON` or `LAT,LON,ALT` in degrees and metres.

        Raises BadInput when that cannot be done.
        """
        from testbed.reporting.export import export
        from testbed.reporting.export.place import DEFAULT_ORIGIN, parse_origin

        return export(self, to, file, DEFAULT_ORIGIN if origin is None else parse_origin(origin))

    def _repr_html_(self) -> str:
        """What a notebook shows: the verdict, the story, the requirements (those not met first), and KEY_NUMBERS."""
        who = [tag("strong", self.scenario.name), f", {self.controller}: ", run_report.verdict(self)]
        warnings = (f"Warning: {warning}" for warning in self.warnings)
        told = story(self) if all(name in self.columns for name in _TOLD) else []
        lines = [tag("p", line) for line in (who, *warnings, *told)]
        return tag("div", lines, _requirements(self), _numbers(self))


def _requirements(flight: Flight) -> Iterator[Html]:
    columns: dict[str, Callable[[Mapping[str, Any]], html.Cell]] = {
        "requirement": lambda r: r["name"],
        "": lambda r: VERDICTS[r["passed"]],
        "worst value": lambda r: number(r.get("value")),
        "remark": lambda r: r.get("reason", ""),
    }
    if order := run_report.in_order(flight):
        yield html.listing(order[:_MOST_ROWS], columns)
    if len(order) > _MOST_ROWS:
        yield tag("p", f"and {len(order) - _MOST_ROWS} more")


def _numbers(flight: Flight) -> Iterator[Html]:
    known = {what: flight.metrics[name] for name, what in KEY_NUMBERS.items() if name in flight.metrics}
    if known:
        yield html.listing(known, {"of the whole flight": str, "": lambda what: number(known[what])})
