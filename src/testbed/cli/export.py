"""`testbed export`: write a flight for another program."""

from __future__ import annotations

from pathlib import Path

from testbed.api.load import load_flight
from testbed.reporting.export import export as write
from testbed.reporting.export import format_of
from testbed.reporting.export.place import DEFAULT_ORIGIN, parse_origin


def export(run: Path, to: str, out: Path | None, origin: str | None) -> None:
    """Write a run in a format of `reporting.export.TABLE`, by default into its folder; raises BadInput."""
    start = DEFAULT_ORIGIN if origin is None else parse_origin(origin)
    flight = load_flight(run)
    folder = run if run.is_dir() else run.parent
    file = write(flight, to, out or folder / f"{flight.scenario.slug}{format_of(to).ending}", start)
    print(f"wrote {file}")
