"""A flight for other programs. To add a format, write a function of a flight in a file here, and add a line to TABLE.

A format is written from the log and the events, and has nothing of the clock: the same flight gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import BinaryIO

from testbed.flight.flight import Flight
from testbed.inputs.output_file import refuse_unwritable, written
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.reporting.export.place import DEFAULT_ORIGIN, POSE, Origin

Write = Callable[[Flight, BinaryIO, Origin], None]


@dataclass(frozen=True)
class Format:
    """A file format: the module here that writes it, the ending of its files, what reads it, and the log's columns without which
    there is nothing to show."""

    module: str
    ending: str
    meaning: str
    needs: tuple[str, ...] = ()


TABLE: dict[str, Format] = {
    "acmi": Format("tracks", ".acmi", "Tacview 2.2: attitude, air data, actuators, events as bookmarks", POSE),
    "kml": Format("tracks", ".kml", "Google Earth and others: a track in time with attitude, events as places", POSE),
    "parquet": Format("tables", ".parquet", "pandas, polars, DuckDB: the log with units in its metadata", ("time_s",)),
    "mcap": Format("mcap", ".mcap", "Foxglove: frames, location, a topic for each actuator, events", POSE),
    "ulog": Format(
        "ulog", ".ulg", "PlotJuggler and pyulog, as PX4's: sensors and truth, a topic for each actuator, events",
        (*POSE, "p_deg_s", "q_deg_s", "r_deg_s", "alpha_deg", "beta_deg", "airspeed_m_s", "climb_rate_m_s"),
    ),
    "mat": Format("tables", ".mat", "MATLAB and Octave: structs log, units and flight, and events", ("time_s",)),
}  # fmt: skip
"""By the name on the command line, which is also the name of the function that writes it."""


def export(flight: Flight, to: str, file: str | Path, origin: Origin = DEFAULT_ORIGIN) -> Path:
    """Write a flight in a format of TABLE, completely or not at all; returns the file. `origin` is for formats that show a place.

    Raises BadInput: there is no such format, the log lacks a column, a package is not installed, or the file exists or cannot be
    written.
    """
    file, form = Path(file), format_of(to)
    refuse_unwritable(file)
    if missing := [name for name in form.needs if name not in flight.columns]:
        raise BadInput([Problem(f"the log has no column {name}", "--to " + to) for name in missing])
    write: Write = getattr(import_module(f"{__name__}.{form.module}"), to)
    with written(file) as stream:
        write(flight, stream, origin)
    return file


def format_of(to: str) -> Format:
    """The format of this name; raises BadInput when there is none."""
    if to not in TABLE:
        raise BadInput([Problem(f"is no format: {to}", "--to", None, "", *guess(to, TABLE))])
    return TABLE[to]
