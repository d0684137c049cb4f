"""`testbed search`: the smallest failure, or how likely one is."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from testbed.cli import study, sweep
from testbed.cli.command import Command, add_file, add_many_flights, add_out, add_set, add_shard, whole_number


def _arguments(command: ArgumentParser) -> None:
    add_file(command, "search")
    add_out(command, "DIR", "search folder to make (default: runs/<name>)")
    goal = "smallest or probability; with it the file may be a sweep's"
    command.add_argument("--goal", metavar="GOAL", help=goal)
    budget = "most flights for each variant and option of a choice"
    command.add_argument("--budget", type=whole_number, metavar="N", help=budget)
    add_shard(command, "run every N-th of the searches, one for each variant and option, from the K-th on")
    add_many_flights(command)
    add_set(command)


def _run(options: Namespace) -> int:
    from testbed.api import search

    own = {"goal": options.goal, "budget": options.budget}
    if options.shard is not None:
        return sweep.fly_shard(search, options, options.search, "none", **own)
    return study.run(search, options, options.search, **own)


COMMAND = Command(
    "the smallest failure that breaks a requirement, or how likely one is",
    _arguments,
    _run,
    (
        "testbed search smallest_gust.yaml",
        "testbed search my_sweep.yaml --goal probability --budget 2000",
    ),
)
