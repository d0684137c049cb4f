"""`testbed benchmark`: controllers on flights that are drawn from a suite."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from testbed.cli import study
from testbed.cli.command import add_flying, add_junit, add_out, add_shard, whole_number
from testbed.cli.ending import MET, NOT_MET, tidily
from testbed.cli.terminal import working

PURPOSE = "compare controllers on flights that are drawn from a suite"
EXAMPLES = (
    "testbed benchmark --draws 100",
    "testbed benchmark open --controller mine=my_controller.py:MyController --draws 200",
    "testbed benchmark --controller default --controller 'blind={type: adaptive_inversion, ablate: [monitor]}'",
    "testbed benchmark open --seed 7 --only 12 --controller default",
    "testbed benchmark --verify entry.yaml --controller mine=my_controller.py:MyController",
)


def arguments(command: ArgumentParser) -> None:
    suite = "a shipped suite, or a suite's YAML file (default: open)"
    command.add_argument("suite", nargs="?", help=suite)
    add_out(command, "DIR", "folder to make (default: runs/benchmark-<suite>-<seed>)")
    own = "fly one of your own too, or a shipped one with settings (NAME={type: ...}); NAME alone: of the suite's only those"
    command.add_argument(
        "--controller", action="append", default=[], metavar="NAME[=FILE.py:CLASS]", help=own
    )
    draws = "flights of each controller (default: 1000); with --verify, those flown again (20)"
    command.add_argument("--draws", type=whole_number, metavar="N", help=draws)
    seed = "from which the flights are drawn (default: 1)"
    command.add_argument("--seed", type=whole_number, metavar="S", help=seed)
    word = "make the seed from a public word and the digest of the law"
    command.add_argument("--word", metavar="WORD", help=word)
    command.add_argument("--only", type=whole_number, metavar="I", help="fly draw I alone, into run folders")
    entry = "write the result as a file that others can check"
    command.add_argument("--entry", type=Path, metavar="FILE", help=entry)
    verify = "fly a part of an entry again, and compare; needs --controller for those of its author"
    command.add_argument("--verify", type=Path, metavar="FILE", help=verify)
    add_shard(command)
    add_flying(command)
    add_junit(command)
    command.set_defaults(set=[], variant=None, save_logs="none")


def run(options: Namespace) -> int:
    """Fly a benchmark, one draw of it, or a part of an entry; as `study.run`."""
    from testbed.api import benchmark

    if options.verify is not None:
        return _verify(options)
    draws = options.draws if options.only is None else options.only + 1
    own = {"draws": draws, "word": options.word, "entry": options.entry}
    return study.run(benchmark, options, options.suite or "open", one="draw", **own)


def _verify(options: Namespace) -> int:
    """Fly a part of an entry again, say what came of it, and return the exit status."""
    from testbed.api import benchmark

    with tidily(), working("flying"):
        same, lines = benchmark.verify(
            options.verify,
            options.suite,
            controllers=options.controller,
            draws=options.draws,
            jobs=options.jobs,
            cluster=options.cluster,
        )
    print("\n".join(lines))
    return MET if same else NOT_MET
