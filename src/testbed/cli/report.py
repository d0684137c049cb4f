"""`testbed report`: figures and report of the folder of a run or a study again, without flying."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from importlib import import_module
from pathlib import Path

from testbed.cli.command import Command
from testbed.inputs.problems import BadInput, Problem


def _arguments(command: ArgumentParser) -> None:
    what = "folder of a run or a study, or one run of a sweep whose log was kept: SWEEP/17"
    command.add_argument("folder", type=Path, help=what)


def _run(options: Namespace) -> int:
    """Rebuild what the kind of folder has; raises BadInput for a folder of no kind, and for one that is read-only."""
    from testbed.api.load import STUDIES, kind_of
    from testbed.cli import run, study, sweep

    if options.folder.is_dir() and not os.access(options.folder, os.W_OK):
        raise BadInput([Problem("cannot be written: Permission denied", str(options.folder))])
    kind = kind_of(options.folder)
    if kind in STUDIES:
        return study.report(import_module(f"testbed.api.{kind}"), options.folder)
    return (sweep.report_run if kind == "log" else run.report)(options.folder)


COMMAND = Command(
    "rebuild figures and report of the folder of a run or a study",
    _arguments,
    _run,
    ("testbed report runs/left-tail-failure", "testbed report runs/my-sweep/17"),
)
