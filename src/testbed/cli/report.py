"""`testbed report`: figures and report of the folder of a run or a study again, without flying."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from importlib import import_module
from pathlib import Path

from testbed.cli.ending import ENDED_EARLY, MET, NOT_MET, tidily
from testbed.cli.run import print_verdict
from testbed.cli.study import told
from testbed.cli.terminal import working
from testbed.inputs.problems import BadInput, Problem

PURPOSE = "rebuild figures and report of the folder of a run or a study"
EXAMPLES = ("testbed report runs/left-tail-failure", "testbed report runs/my-sweep/17")


def arguments(command: ArgumentParser) -> None:
    what = "folder of a run or a study, or one run of a sweep whose log was kept: SWEEP/17"
    command.add_argument("folder", type=Path, help=what)


def run(options: Namespace) -> int:
    """Rebuild what the kind of folder has; raises BadInput for a folder of no kind, and for one that is read-only."""
    from testbed.api.load import STUDIES, kind_of

    if options.folder.is_dir() and not os.access(options.folder, os.W_OK):
        raise BadInput([Problem("cannot be written: Permission denied", str(options.folder))])
    kind = kind_of(options.folder)
    if kind in STUDIES:
        study = import_module(f"testbed.api.{kind}")
        with working("drawing and writing"), tidily():
            summary = study.rebuild(options.folder)
        return told(study, summary)
    return (_logs if kind == "log" else _flight)(options.folder)


def _flight(folder: Path) -> int:
    """Draw the figures and write the report of a run folder again; returns the exit status."""
    from testbed.flight.folder import load
    from testbed.reporting.attempt import add_report

    flight = load(folder)
    with working("drawing and writing"), tidily():
        shown = add_report(flight, folder)
    print_verdict(flight)
    return (MET if flight.passed else NOT_MET) if shown else ENDED_EARLY


def _logs(run: Path) -> int:
    """Write the page of each kept log of a run in a sweep; returns the exit status."""
    from testbed.api.sweep import report_run

    with tidily():
        made = report_run(run)
    for flight, file in made:
        print_verdict(flight)
        print(f"wrote {file}")
    return MET if all(flight.passed for flight, _ in made) else NOT_MET
