"""What `Flight` does with itself: draw, report, save, export. Its methods import this when called, and reading does not."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.flight import display
from testbed.flight.flight import Flight
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.reporting.present import present
from testbed.reporting.story import story

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_AGAIN = """<p>Save the scenario below as scenario.yaml, and run this beside it.</p>
<pre>python -m testbed run scenario.yaml</pre>"""
"""How to fly a flight again whose page stands alone."""
_TOLD = ("altitude_m", "heading_deg", "airspeed_m_s", "beta_deg")
"""Columns without which there is no story."""


def html(flight: Flight) -> str:
    """HTML for a notebook, the story first."""
    told = story(flight) if all(name in flight.columns for name in _TOLD) else []
    return display.html(flight, told)


def plot(flight: Flight, name: str) -> Figure:
    """A figure of `figures.TABLE`; raises BadInput when there is none of this name."""
    from testbed.reporting.figures import TABLE
    from testbed.reporting.figures.page import plain_text

    if name not in TABLE:
        expected, suggestion = guess(name, TABLE)
        raise BadInput([Problem(f"is no figure: {name}", "plot", expected=expected, suggestion=suggestion)])
    with plain_text():
        return TABLE[name][1](flight)


def save(flight: Flight, folder: str | Path, figures: bool = True) -> Path:
    """Write a run folder with the report, and the figures if wanted; returns it."""
    return write_run_folder(flight, folder, lambda partial: present(flight, partial, figures))


def report(flight: Flight, file: str | Path) -> Path:
    """Write the flight's page with its figures in it, replacing the file; returns it."""
    from testbed.reporting.figures import draw
    from testbed.reporting.run_report import write_page

    with tempfile.TemporaryDirectory() as scratch:
        draw(flight, scratch)
        return write_page(flight, Path(file), Path(scratch) / "figures", _AGAIN)


def export(flight: Flight, to: str, file: str | Path, origin: str | None) -> Path:
    """Write a flight for another program (see `reporting.export`); returns the file."""
    from testbed.reporting.export import export as write
    from testbed.reporting.export.place import DEFAULT_ORIGIN, parse_origin

    return write(flight, to, file, DEFAULT_ORIGIN if origin is None else parse_origin(origin))
