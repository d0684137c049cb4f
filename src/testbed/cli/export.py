"""`testbed export`: write a flight for another program."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from testbed.cli.command import add_origin, add_out
from testbed.cli.ending import MET

PURPOSE = "write a flight for another program"
EXAMPLES = (
    "testbed export runs/left-tail-failure --to kml",
    "testbed export runs/left-tail-failure --to mat --out flight.mat",
)


def arguments(command: ArgumentParser) -> None:
    command.add_argument(
        "run", type=Path, help="run folder, or one run of a sweep whose log was kept: SWEEP/17"
    )
    command.add_argument(
        "--to", required=True, metavar="FORMAT", help="acmi, kml, parquet, mcap, ulog or mat"
    )
    add_out(command, "FILE", "file to make (default: named as the scenario, beside the log)")
    add_origin(command, "for formats that show a place")


def run(options: Namespace) -> int:
    """Write a run in a format of `reporting.export.TABLE`, by default into its folder; raises BadInput."""
    from testbed.api.load import load_flight
    from testbed.reporting.export import export, format_of
    from testbed.reporting.export.place import DEFAULT_ORIGIN, parse_origin

    start = DEFAULT_ORIGIN if options.origin is None else parse_origin(options.origin)
    flight = load_flight(options.run)
    usual = _usual(options.run, flight.scenario.slug, format_of(options.to).ending)
    print(f"wrote {export(flight, options.to, options.out or usual, start)}")
    return MET


def _usual(run: Path, name: str, ending: str) -> Path:
    """The file in the run folder; beside a kept log, whose sweep has many flights of this name, with the log's name too."""
    if run.is_dir():
        return run / f"{name}{ending}"
    from testbed.studies.folder.logs import logs_of

    return run.parent / f"{name}-{logs_of(run)[0].stem}{ending}"
