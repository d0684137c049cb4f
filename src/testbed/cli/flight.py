"""`testbed run`, and `testbed report` of a run folder: fly one scenario, write its folder, print its verdict."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.cli.checked import checked, collect
from testbed.flight.folder import FolderExists, load, refuse_existing, write_run_folder
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.numbers import number

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup
    from testbed.flight.flight import Flight


def fly(options: argparse.Namespace) -> bool:
    """Fly one scenario into a run folder; returns whether it passed. Raises BadInput with every problem at once."""
    problems: list[Problem] = []
    if options.out is not None:  # before the flight, not after it
        collect(problems, lambda: refuse_existing(options.out))
    scenario = collect(problems, lambda: checked(options.scenario, options.set))
    controller = collect(problems, lambda: _own_controller(options.controller))
    if scenario is None or problems:
        raise BadInput(problems)
    from testbed.common.jit import has_compiled
    from testbed.simulation import fly

    if not has_compiled():
        print("compiling the control law for the first flight: some seconds, once", file=sys.stderr)
    flight = fly(scenario, controller)
    folder = write(flight, options.out, _presentation(flight, figures=not options.no_plots))
    _print_verdict(flight)
    print(f"wrote {folder}")
    return flight.passed


def report(folder: Path) -> bool:
    """Draw the figures and write the report of a run folder again; returns whether the flight passed."""
    flight = load(folder)
    _presentation(flight)(folder)
    _print_verdict(flight)
    return flight.passed


def _own_controller(reference: str | None) -> Callable[[Setup], object] | None:
    """The user's controller class, from `FILE.py:CLASS`; None for None."""
    if reference is None:
        return None
    from testbed.controllers.user.loader import load_controller

    return load_controller(reference)


def _presentation(flight: Flight, figures: bool = True) -> Callable[[Path], None]:
    """A function that adds the report, and the figures if wanted, to a folder with log and summary."""

    def write_into(folder: Path) -> None:
        from testbed.reporting.run_report import write_report

        if figures:
            from testbed.reporting.figures import draw

            draw(flight, folder)
        write_report(folder)

    return write_into


def write(flight: Flight, out: Path | None, add: Callable[[Path], None]) -> Path:
    """Write the run folder: `out`, or else the first of runs/<name>, runs/<name>-2, ... that does not exist; returns it."""
    if out is not None:
        return write_run_folder(flight, out, add)
    first = Path("runs") / flight.scenario.slug
    for i in count(1):
        try:
            return write_run_folder(flight, first if i == 1 else f"{first}-{i}", add)
        except FolderExists:
            continue
    raise AssertionError("unreachable: count() does not end")


def _print_verdict(flight: Flight) -> None:
    """The story of the flight, then the requirements that were missed."""
    from testbed.reporting.story import story

    by = f", flown by {flight.flown_by}" if flight.flown_by else ""
    print(f"{flight.scenario.name}: {flight.outcome.sentence}, {flight.end_time_s:g} s{by}")
    for line in story(flight):
        print(f"  {line}")
    for event in flight.events:
        if event["kind"] == "diagnosis":
            print(f"  controller at {event['time_s']:.1f} s: {event['text']}")
    missed = [requirement for requirement in flight.requirements if not requirement["passed"]]
    for requirement in missed:
        reason = f" ({requirement['reason']})" if requirement.get("reason") else ""
        print(f"  NOT MET  {requirement['name']}: {number(requirement['value'])}{reason}")
    total = len(flight.requirements)
    met = f": {total - len(missed)} of {total} requirements met" if total else ""
    print(f"{'passed' if flight.passed else 'not passed'}{met}")
    for warning in flight.warnings:
        print(f"WARNING: {warning}", file=sys.stderr)
