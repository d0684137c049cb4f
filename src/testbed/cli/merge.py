"""`testbed merge`: shards of a study joined into one folder."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from testbed.cli import study
from testbed.cli.command import add_junit, add_mixed
from testbed.cli.ending import ENDED_EARLY, Ended, tidily
from testbed.cli.terminal import working
from testbed.inputs.bucket import fetch, is_address

PURPOSE = "join the shards of a study into one folder"
EXAMPLES = ("testbed merge runs/shard-1 runs/shard-2 --out runs/whole",)

_SHOWN = 10


def arguments(command: ArgumentParser) -> None:
    folders = "folders of the shards, or where --copy-to put them: s3://bucket/folder"
    command.add_argument("folders", nargs="+", metavar="FOLDER", help=folders)
    command.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to make")
    add_junit(command)
    add_mixed(command)
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def run(options: Namespace) -> int:
    """Join the folders; raises BadInput when they do not belong together, and Ended, with what is missing, when runs are."""
    from testbed.api.load import kind_of
    from testbed.api.merge import merge
    from testbed.reporting import junit

    if options.junit is not None:
        junit.refuse(options.junit, options.out)
    with working("merging"), tidily(), _here(options.folders) as folders:
        summary, missing = merge(folders, options.out, figures=not options.no_plots, mixed=options.mixed)
    word = kind_of(options.out)
    if summary is None:
        raise Ended(f"{options.out}: {_unfinished(word, options.out, missing)}", ENDED_EARLY)
    kind: Any = import_module(f"testbed.api.{word}")
    if options.junit is not None and hasattr(kind, "tests"):  # a search has no verdict
        study.write_junit(kind, kind.plan_of(options.out), options.out, summary, options.junit)
    status = study.told(kind, summary)
    print(f"wrote {options.out}")
    return status


@contextmanager
def _here(folders: Sequence[str]) -> Iterator[list[Path]]:
    """The folders, for the block; those of a bucket are fetched."""
    with TemporaryDirectory() as work:
        yield [
            fetch(folder, Path(work) / str(number)) if is_address(folder) else Path(folder)
            for number, folder in enumerate(folders)
        ]


def _unfinished(kind: str, out: Path, missing: Sequence[int | str]) -> str:
    """What is missing, and the command that goes on."""
    file = "..." if kind == "benchmark" else out / f"{kind}.yaml"
    how = f"`testbed {kind} {file} --out {out} --resume`"
    if not missing:
        return f"every flight is there; {how} with your own controllers writes what was found"
    what = "searches" if kind == "search" else "runs"
    named = ", ".join(map(str, missing[:_SHOWN])) + (", ..." if len(missing) > _SHOWN else "")
    return f"{len(missing)} {what} are missing: {named}; {how} flies them"
