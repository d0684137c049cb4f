"""`testbed sweep`: fly many variations, or one of them alone, and print how often they passed."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.cli import study
from testbed.cli.command import (
    Command,
    add_file,
    add_junit,
    add_many_flights,
    add_out,
    add_set,
    add_shard,
    whole_number,
)
from testbed.cli.interrupts import later, tidily
from testbed.cli.run import print_verdict
from testbed.cli.status import MET, NOT_MET
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.api.study import Kind


def _arguments(command: ArgumentParser) -> None:
    add_file(command, "sweep")
    add_out(command, "DIR", "sweep folder to make (default: runs/<name>)")
    runs = "number of runs; with --resume, a larger number adds runs"
    command.add_argument("--runs", type=whole_number, metavar="N", help=runs)
    add_many_flights(command)
    add_single_runs(command, logs="failed")
    add_set(command)


def add_single_runs(command: ArgumentParser, logs: str) -> None:
    """What a sweep and a matrix share: one run alone, the verdict as a file, and the logs that are kept, by default `logs`."""
    command.add_argument(
        "--only", type=whole_number, metavar="I", help="fly run I alone and keep its whole log"
    )
    variant = "with --only: fly only this one of the compared variants, into a run folder"
    command.add_argument("--variant", metavar="LABEL", help=variant)
    which = "logs to keep: none, failed or all (default: %(default)s)"
    add_shard(command)
    add_junit(command)
    command.add_argument("--save-logs", default=logs, metavar="WHICH", help=which)


def _run(options: Namespace) -> int:
    from testbed.api import sweep

    return run(sweep, options, options.sweep, runs=options.runs)


def run(kind: Kind, options: Namespace, file: str, **own: Any) -> int:
    """Fly a sweep or a matrix, or one run of it; as `study.run`."""
    if options.only is not None:
        return _fly_only(kind, options, file, **own)
    if options.variant is not None:
        raise BadInput([Problem("is for one run", "--variant", expected="--only I beside it")])
    if options.shard is not None:
        return fly_shard(kind, options, file, options.save_logs, **own)
    return study.run(kind, options, file, save_logs=options.save_logs, **own)


def fly_shard(kind: Kind, options: Namespace, file: str, save_logs: str, **own: Any) -> int:
    """Fly a part of the runs, which `testbed merge` joins with the others; returns the exit status."""
    from testbed.studies.run import Options

    how = Options(
        options.jobs, options.cluster, save_logs, shard=options.shard, cluster_wait_s=options.cluster_wait,
        mixed=options.mixed,
    )  # fmt: skip
    plan, folder = kind.prepare(
        file, options.out, options.set, seed=options.seed, resume=options.resume,
        controllers=options.controller, **own,
    )  # fmt: skip
    with tidily(), study.copied(folder, options), study.flying():
        flights = kind.fly(plan, folder, how, resume=options.resume)
    print(flights)
    print(f"wrote {folder}, shard {options.shard}")
    return MET


def _fly_only(kind: Kind, options: Namespace, file: str, **own: Any) -> int:
    """Fly one run alone, tell each of its flights, and return the exit status."""
    from testbed.api import sweep
    from testbed.flight.folder import refuse_existing, refuse_unwritable
    from testbed.reporting import junit
    from testbed.studies.run import Options

    how = Options(options.jobs, options.cluster, options.save_logs, mixed=options.mixed)
    plan, usual = kind.prepare(
        file, None, options.set, seed=options.seed, controllers=options.controller, **own
    )
    folder = options.out or usual.with_name(_name(usual.name, options.only, options.variant))
    refuse_existing(folder)
    if options.junit is not None:
        junit.refuse(options.junit, folder)
    with later():
        refuse_unwritable(folder)
    with tidily():
        passed, flights = sweep.fly_run(
            plan, options.only, folder, how, variant=options.variant, figures=not options.no_plots
        )
    for flight in flights:
        print_verdict(flight)
    if options.junit is not None:
        junit.write(options.junit, plan.name, chain.from_iterable(map(junit.tests_of, flights)))
    print(f"wrote {folder}")
    return MET if passed else NOT_MET


def _name(sweep: str, run: int, variant: str | None) -> str:
    """The folder's name: `left-tail-monte-carlo-run-17-pid`."""
    from testbed.common.files import slug

    return f"{sweep}-run-{run}" + (f"-{slug(variant, otherwise='variant')}" if variant else "")


def report_run(path: Path) -> int:
    """Write the page of each kept log of a run in a sweep; returns the exit status."""
    from testbed.api import sweep

    with tidily():
        made = sweep.report_run(path)
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
