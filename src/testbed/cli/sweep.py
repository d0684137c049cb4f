"""`testbed sweep`: fly many variations, or one of them alone, and print how often they passed."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from testbed.cli import study
from testbed.cli.command import add_file, add_many_flights, add_out, add_set, add_single_runs, whole_number

PURPOSE = "Monte Carlo: fly many variations of a scenario"
EXAMPLES = (
    "testbed sweep any_failure_in_turbulence.yaml --runs 100",
    "testbed sweep my_sweep.yaml --out runs/my-sweep --resume --runs 1000",
    "testbed sweep my_sweep.yaml --only 17",
)


def arguments(command: ArgumentParser) -> None:
    add_file(command, "sweep")
    add_out(command, "DIR", "sweep folder to make (default: runs/<name>)")
    runs = "number of runs; with --resume, a larger number adds runs"
    command.add_argument("--runs", type=whole_number, metavar="N", help=runs)
    add_many_flights(command)
    add_single_runs(command, logs="failed")
    add_set(command)


def run(options: Namespace) -> int:
    from testbed.api import sweep

    return study.run(sweep, options, options.sweep, runs=options.runs)
