"""`testbed check`: parts of one's own against the contract of the shipped ones."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from testbed.cli.ending import MET, NOT_MET

PURPOSE = "test parts of your own against the contract of the shipped ones"
EXAMPLES = ("testbed check my_parts.py",)


def arguments(command: ArgumentParser) -> None:
    command.add_argument("files", type=Path, nargs="+", metavar="FILE.py", help="files as of --with")
    aircraft = "name or folder of the one that flies them (default: vtail)"
    command.add_argument("--aircraft", default="vtail", metavar="AIRCRAFT", help=aircraft)


def run(options: Namespace) -> int:
    """Fly each part for some seconds and print what was found; raises BadInput for a file that has none."""
    from testbed.api.conformance import conformance

    kept = True
    for file in options.files:
        for finding in conformance(file, options.aircraft):
            kept &= not finding.wrong
            print(finding, flush=True)
    return MET if kept else NOT_MET
