"""`testbed benchmark`: controllers on flights that are drawn from a suite."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.cli.command import Command, add_flying, add_out, whole_number
from testbed.cli.interrupts import tidily
from testbed.cli.run import print_verdict
from testbed.cli.status import MET
from testbed.cli.study import flying, writing
from testbed.common.files import slug

if TYPE_CHECKING:
    from testbed.studies.benchmark.plan import Benchmark
    from testbed.studies.run import Options


def _arguments(command: ArgumentParser) -> None:
    command.add_argument(
        "suite", nargs="?", default="open", help="a shipped suite, or a suite's YAML file (default: open)"
    )
    add_out(command, "DIR", "folder to make (default: runs/benchmark-<suite>-<seed>)")
    own = "fly a controller class of your own too; with a NAME alone, of the suite's controllers only those"
    command.add_argument(
        "--controller", action="append", default=[], metavar="NAME[=FILE.py:CLASS]", help=own
    )
    command.add_argument(
        "--draws",
        type=whole_number,
        default=1000,
        metavar="N",
        help="flights of each controller (default: 1000)",
    )
    command.add_argument(
        "--seed", type=whole_number, metavar="S", help="from which flights are drawn (default: 1)"
    )
    word = "make the seed from a public word and the digest of the law"
    command.add_argument("--word", metavar="WORD", help=word)
    command.add_argument("--only", type=whole_number, metavar="I", help="fly draw I alone, into run folders")
    add_flying(command)


def _run(options: Namespace) -> int:
    """Fly a benchmark, or one draw of it, print the tables, and return the exit status.

    Raises BadInput when nothing can be flown, and Ended when it ends early.
    """
    from testbed.api import benchmark as study
    from testbed.api.options import checked_options
    from testbed.studies.benchmark.run import fly_benchmark

    how = checked_options(options.jobs, options.cluster)
    draws = options.draws if options.only is None else max(options.draws, options.only + 1)
    plan, folder = study.prepare(
        options.suite,
        options.out,
        controllers=options.controller,
        draws=draws,
        seed=options.seed,
        word=options.word,
    )
    if options.only is not None:
        return _fly_only(plan, options, how)
    with tidily():
        with flying():
            flown = fly_benchmark(plan, folder, how, resume=options.resume)
        with writing(folder, "--resume writes the rest"):
            summary, _ = study.finish(plan, folder, options.suite, options.word)
    from testbed.study_reports.benchmark import page

    print("\n".join(page(summary)))
    print(f"\n{flown} flights; wrote {folder}")
    return MET


def _fly_only(plan: Benchmark, options: Namespace, how: Options) -> int:
    """Fly one draw alone by every controller, tell each of its flights, and return the exit status."""
    from testbed.api import sweep as study
    from testbed.flight.folder import refuse_existing

    folder = options.out or Path("runs") / slug(
        f"{plan.name} {plan.sweep.seed} draw {options.only}", otherwise="draw"
    )
    refuse_existing(folder)
    with tidily():
        _, flights = study.fly_run(plan, options.only, folder, how, figures=not options.no_plots)
    for flight in flights:
        print(f"{flight.scenario.controller.type}:")
        print_verdict(flight)
    print(f"wrote {folder}")
    return MET


COMMAND = Command(
    "compare controllers on flights that are drawn from a suite",
    _arguments,
    _run,
    (
        "testbed benchmark --draws 100",
        "testbed benchmark open --controller mine=my_controller.py:MyController --draws 200",
        "testbed benchmark open --seed 7 --only 12 --controller default",
    ),
)
