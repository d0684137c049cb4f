"""`testbed sweep`, and `testbed report` of a sweep folder: fly many variations, print how often they passed."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.cli.command import (
    Command,
    add_file,
    add_many_flights,
    add_out,
    add_set,
    whole_number,
)
from testbed.cli.interrupts import later, tidily
from testbed.cli.run import print_verdict
from testbed.cli.status import MET, NOT_MET
from testbed.cli.study import flying, writing
from testbed.cli.working import working
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.numbers import interval, number

if TYPE_CHECKING:
    from testbed.studies.run import Options


def _arguments(command: ArgumentParser) -> None:
    add_file(command, "sweep")
    add_out(command, "DIR", "sweep folder to make (default: runs/<name>)")
    runs = "number of runs; with --resume, a larger number adds runs"
    command.add_argument("--runs", type=whole_number, metavar="N", help=runs)
    add_many_flights(command)
    command.add_argument(
        "--only", type=whole_number, metavar="I", help="fly run I alone and keep its whole log"
    )
    variant = "with --only: fly only this one of the compared variants, into a run folder"
    command.add_argument("--variant", metavar="LABEL", help=variant)
    logs = "logs to keep: none, failed (default) or all"
    command.add_argument("--save-logs", default="failed", metavar="WHICH", help=logs)
    add_set(command)


def _run(options: Namespace) -> int:
    """Fly a sweep, or one run of it, print the answer, and return the exit status.

    Raises BadInput when nothing can be flown, and Ended when it ends early.
    """
    from testbed.api import sweep as study
    from testbed.api.options import checked_options
    from testbed.studies.sweep import fly_sweep

    how = checked_options(options.jobs, options.cluster, options.save_logs)
    if options.only is None and options.variant is not None:
        raise BadInput([Problem("is for one run", "--variant", expected="--only I beside it")])
    if options.only is not None:
        return _fly_only(options, how)
    plan, folder = study.prepare(
        options.sweep,
        options.out,
        options.set,
        runs=options.runs,
        seed=options.seed,
        resume=options.resume,
        controllers=options.controller,
    )
    with tidily():
        with flying():
            flights = fly_sweep(plan, folder, how, resume=options.resume)
        with writing(folder, f"`testbed report {folder}` writes the rest"):
            summary = study.finish(plan, folder, figures=not options.no_plots)
    print_answer(summary)
    print(flights if flights.count else "no flight was missing")
    print(f"wrote {folder}")
    return _status(summary)


def report(folder: Path) -> int:
    """Write table, summary, figures and report of a sweep folder again; returns the exit status."""
    from testbed.api import sweep as study

    with working("drawing and writing"), tidily():
        summary = study.rebuild(folder)
    print_answer(summary)
    return _status(summary)


def print_answer(summary: dict[str, Any]) -> None:
    """Print the answer in sentences, P(all requirements met) and P(each met) for every variant, and the differences."""
    from testbed.study_reports.sweep.answer import answer

    for line in answer(summary):
        print(line)
    for variant in summary["variants"]:
        total = variant["all_requirements"]
        if total["estimate"] is None:
            continue
        print(f"{variant['label'] or summary['sweep']}: {total['n']} runs")
        for known, name in [(total, "all requirements"), *((r, r["name"]) for r in variant["requirements"])]:
            print(f"  {interval(known)}  {name}")
    for pair in summary["pairs"]:
        if pair["difference"] is not None:
            difference = interval(pair, "difference", "+.3f")
            print(
                f"{pair['first']} minus {pair['second']}: {difference}, p = {number(pair['p_value'], '.2g')}"
            )


def _status(summary: dict[str, Any]) -> int:
    """0 when every flight passed, else 1."""
    shares = [variant["all_requirements"] for variant in summary["variants"]]
    return MET if all(share["successes"] == share["n"] for share in shares) else NOT_MET


def _fly_only(options: Namespace, how: Options) -> int:
    """Fly one run alone, tell each of its flights, and return the exit status."""
    from testbed.api import sweep as study
    from testbed.flight.folder import refuse_existing, refuse_unwritable

    plan, usual = study.prepare(
        options.sweep, None, options.set, runs=options.runs, seed=options.seed, controllers=options.controller
    )
    folder = options.out or usual.with_name(_name(usual.name, options.only, options.variant))
    refuse_existing(folder)
    with later():
        refuse_unwritable(folder)
    with tidily():
        passed, flights = study.fly_run(
            plan, options.only, folder, how, variant=options.variant, figures=not options.no_plots
        )
    for flight in flights:
        print_verdict(flight)
    print(f"wrote {folder}")
    return MET if passed else NOT_MET


def _name(sweep: str, run: int, variant: str | None) -> str:
    """The folder's name: `left-tail-monte-carlo-run-17-pid`."""
    from testbed.common.files import slug

    return f"{sweep}-run-{run}" + (f"-{slug(variant, otherwise='variant')}" if variant else "")


def report_run(path: Path) -> int:
    """Write the page of each kept log of a run in a sweep; returns the exit status."""
    from testbed.api import sweep as study

    with tidily():
        made = study.report_run(path)
    for flight, file in made:
        print_verdict(flight)
        print(f"wrote {file}")
    return MET if all(flight.passed for flight, _ in made) else NOT_MET


COMMAND = Command(
    "Monte Carlo: fly many variations of a scenario",
    _arguments,
    _run,
    (
        "testbed sweep any_failure_in_turbulence.yaml --runs 100",
        "testbed sweep my_sweep.yaml --out runs/my-sweep --resume --runs 1000",
        "testbed sweep my_sweep.yaml --only 17",
    ),
)
