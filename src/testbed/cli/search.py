"""`testbed search`, and `testbed report` of a search folder: the smallest failure, or how likely one is."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from testbed.cli.command import (
    Command,
    add_file,
    add_many_flights,
    add_out,
    add_set,
    whole_number,
)
from testbed.cli.interrupts import tidily
from testbed.cli.status import MET, NOT_MET
from testbed.cli.study import flying, writing
from testbed.cli.working import working


def _arguments(command: ArgumentParser) -> None:
    add_file(command, "search")
    add_out(command, "DIR", "search folder to make (default: runs/<name>)")
    goal = "smallest or probability; with it the file may be a sweep's"
    command.add_argument("--goal", metavar="GOAL", help=goal)
    budget = "most flights for each variant and option of a choice"
    command.add_argument("--budget", type=whole_number, metavar="N", help=budget)
    add_many_flights(command)
    add_set(command)


def _run(options: Namespace) -> int:
    """Search, print the answer, and return the exit status.

    Raises BadInput when nothing can be searched, and Ended when it ends early.
    """
    from testbed.api import search as study
    from testbed.api.options import checked_options
    from testbed.studies.search.run import run_search

    how = checked_options(options.jobs, options.cluster)
    plan, folder = study.prepare(
        options.search,
        options.out,
        options.set,
        goal=options.goal,
        budget=options.budget,
        seed=options.seed,
        controllers=options.controller,
    )
    with tidily():
        with flying():
            found = run_search(plan, folder, how, resume=options.resume)
        with writing(folder, "--resume writes the rest"):
            job = how.job(plan.plan)
            summary = study.finish(plan, folder, found, job, figures=not options.no_plots)
    _print(summary)
    print(f"wrote {folder}")
    return _status(summary)


def report(folder: Path) -> int:
    """Write figures and report of a search folder again; returns the exit status."""
    from testbed.api import search as study

    with working("drawing and writing"), tidily():
        summary = study.rebuild(folder)
    _print(summary)
    return _status(summary)


def _print(summary: dict[str, Any]) -> None:
    from testbed.study_reports.search.words import answer

    for line in answer(summary):
        print(line)
    print(f"{summary['flights']} flights")


def _status(summary: dict[str, Any]) -> int:
    """1 when a smallest failure was found, else 0: no requirement was broken, or a probability was asked for."""
    found = any(part["found"] for part in summary["parts"])
    return NOT_MET if found and summary["goal"] == "smallest" else MET


COMMAND = Command(
    "the smallest failure that breaks a requirement, or how likely one is",
    _arguments,
    _run,
    (
        "testbed search smallest_gust.yaml",
        "testbed search my_sweep.yaml --goal probability --budget 2000",
    ),
)
