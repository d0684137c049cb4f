"""`testbed merge`: shards of a study joined into one folder."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from testbed.cli import study
from testbed.cli.command import Command, add_mixed
from testbed.cli.interrupts import tidily
from testbed.cli.status import ENDED_EARLY, Ended
from testbed.cli.working import working

_SHOWN = 10


def _arguments(command: ArgumentParser) -> None:
    command.add_argument("folders", type=Path, nargs="+", metavar="FOLDER", help="folders of the shards")
    command.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to make")
    add_mixed(command)
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def _run(options: Namespace) -> int:
    """Join the folders; raises BadInput when they do not belong together, and Ended, with what is missing, when runs are."""
    from testbed.api.load import kind_of
    from testbed.api.merge import merge

    with working("merging"), tidily():
        summary, missing = merge(
            options.folders, options.out, figures=not options.no_plots, mixed=options.mixed
        )
    kind = kind_of(options.out)
    if summary is None:
        raise Ended(f"{options.out}: {_unfinished(kind, options.out, missing)}", ENDED_EARLY)
    status = study.told(import_module(f"testbed.api.{kind}"), summary)
    print(f"wrote {options.out}")
    return status


def _unfinished(kind: str, out: Path, missing: Sequence[int | str]) -> str:
    """What is missing, and the command that goes on."""
    file = "..." if kind == "benchmark" else out / f"{kind}.yaml"
    how = f"`testbed {kind} {file} --out {out} --resume`"
    if not missing:
        return f"every flight is there; {how} with your own controllers writes what was found"
    what = "searches" if kind == "search" else "runs"
    named = ", ".join(map(str, missing[:_SHOWN])) + (", ..." if len(missing) > _SHOWN else "")
    return f"{len(missing)} {what} are missing: {named}; {how} flies them"


COMMAND = Command(
    "join the shards of a study into one folder",
    _arguments,
    _run,
    ("testbed merge runs/shard-1 runs/shard-2 --out runs/whole",),
)
