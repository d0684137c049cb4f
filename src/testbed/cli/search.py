"""`testbed search`, and `testbed report` of a search folder: the smallest failure, or how likely one is.

When a search ends early, or by Ctrl-C, its finished flights are kept.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from testbed import monte_carlo, searching
from testbed.cli.interrupts import tidily
from testbed.cli.status import ENDED_EARLY, INTERRUPTED, MET, NOT_MET
from testbed.cli.working import working
from testbed.reporting.search_page.words import answer
from testbed.searches.run import run_search
from testbed.sweeps.run import Stopped


def search(options: argparse.Namespace) -> int:
    """Search, print the answer, and return the exit status; raises BadInput when nothing can be searched."""
    how = monte_carlo.options(options.jobs, options.cluster, "none")
    plan, folder = searching.prepare(
        options.search,
        options.out,
        options.set,
        goal=options.goal,
        budget=options.budget,
        seed=options.seed,
        controllers=options.controller,
    )
    with tidily():
        try:
            found = run_search(plan, folder, how, resume=options.resume)
        except Stopped as stopped:
            print(stopped, file=sys.stderr)
            return INTERRUPTED if isinstance(stopped.__context__, KeyboardInterrupt) else ENDED_EARLY
        again = "every flight is kept; --resume writes the rest"
        try:
            with working("drawing and writing"):
                job = how.job(plan.plan)
                summary = searching.finish(plan, folder, found, job, figures=not options.no_plots)
        except KeyboardInterrupt:
            print(f"{folder}: interrupted; {again}", file=sys.stderr)
            return INTERRUPTED
        except OSError as error:
            print(f"{folder}: cannot write: {error.strerror or error}; {again}", file=sys.stderr)
            return ENDED_EARLY
    _print(summary)
    print(f"wrote {folder}")
    return _status(summary)


def report(folder: Path) -> int:
    """Write figures and report of a search folder again; returns the exit status."""
    with working("drawing and writing"), tidily():
        summary = searching.rebuild(folder)
    _print(summary)
    return _status(summary)


def _print(summary: dict[str, Any]) -> None:
    for line in answer(summary):
        print(line)
    print(f"{summary['flights']} flights")


def _status(summary: dict[str, Any]) -> int:
    """1 when a smallest failure was found, else 0: no requirement was broken, or a probability was asked for."""
    found = any(part["found"] for part in summary["parts"])
    return NOT_MET if found and summary["goal"] == "smallest" else MET
