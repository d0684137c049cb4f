"""`testbed search`: the smallest failure, or how likely one is."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from testbed.cli import study
from testbed.cli.command import add_file, add_many_flights, add_out, add_set, add_shard, whole_number

PURPOSE = "the smallest failure that breaks a requirement, or how likely one is"
EXAMPLES = (
    "testbed search smallest_gust.yaml",
    "testbed search my_sweep.yaml --goal probability --budget 2000",
)


def arguments(command: ArgumentParser) -> None:
    add_file(command, "search")
    add_out(command, "DIR", "search folder to make (default: runs/<name>)")
    goal = "smallest or probability; with it the file may be a sweep's"
    command.add_argument("--goal", metavar="GOAL", help=goal)
    budget = "most flights for each variant and option of a choice"
    command.add_argument("--budget", type=whole_number, metavar="N", help=budget)
    add_shard(command, "run every N-th of the searches, one for each variant and option, from the K-th on")
    add_many_flights(command)
    add_set(command)
    command.set_defaults(only=None, variant=None, save_logs="none", junit=None)


def run(options: Namespace) -> int:
    from testbed.api import search

    own = {"goal": options.goal, "budget": options.budget}
    return study.run(search, options, options.search, **own)
