"""`testbed diagnose`: what each actuator did in a flight, from its log."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from testbed.cli.command import add_out
from testbed.cli.ending import MET, NOT_MET, tidily
from testbed.cli.terminal import working

PURPOSE = "which actuator failed, when and how much, from a flight's log"
EXAMPLES = (
    "testbed diagnose runs/left-tail-failure",
    "testbed diagnose flight.csv --model ./my_aircraft --columns columns.yaml --out diagnosis",
)


def arguments(command: ArgumentParser) -> None:
    command.add_argument(
        "log", type=Path, help="run folder; or, with --columns, a CSV, Parquet, .BIN or .ulg file"
    )
    model = "aircraft, by name or folder (default: that of the run folder)"
    command.add_argument("--model", metavar="MODEL", help=model)
    columns = "YAML file that says which column is what, in which unit"
    command.add_argument("--columns", type=Path, metavar="MAP", help=columns)
    add_out(command, "DIR", "folder to write diagnosis.csv, summary.json and report.html into")


def run(options: Namespace) -> int:
    """Print the story, and write the folder; NOT_MET where something was found. Raises BadInput."""
    from testbed.logs.entry import diagnose

    with working("diagnosing"), tidily():
        found = diagnose(options.log, options.model, options.columns, options.out)
    print(found)
    if options.out is not None:
        print(f"wrote {options.out}")
    return NOT_MET if found.findings else MET
