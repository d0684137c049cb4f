"""What several commands share: their arguments, the check of a scenario, and the file of `--out`."""

from __future__ import annotations

import argparse
import sys
from argparse import ArgumentParser
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.aircraft.shipped import data_root, shipped_files
from testbed.cli.ending import tidily
from testbed.inputs.output_file import written

if TYPE_CHECKING:
    from testbed.scenario.load import Scenario


def _read(kind: Callable[[str], Any], expected: str, text: str) -> Any:
    try:
        return kind(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"is {text!r}, expected {expected}") from None


whole_number, number = partial(_read, int, "a whole number"), partial(_read, float, "a number")
"""The values of options that are numbers."""


def add_file(command: ArgumentParser, name: str, **more: Any) -> None:
    """A scenario, sweep or search file; a shell also completes the names of shipped ones."""
    action = command.add_argument(name, help="YAML file; a shipped one is found from any folder", **more)
    action.completer = matching_files  # type: ignore[attr-defined]


def matching_files(prefix: str, **_: object) -> list[str]:
    """YAML files and folders, and shipped scenarios, sweeps and searches, whose paths begin with `prefix`."""
    shipped = [str(file.relative_to(data_root())) for file in shipped_files()]
    folder = Path(prefix).parent if Path(prefix).name or not prefix else Path(prefix)
    here = (
        [f"{path}/" if path.is_dir() else str(path) for path in folder.glob("*")] if folder.is_dir() else []
    )
    known = {name for name in (*shipped, *here) if name.endswith((".yaml", "/"))}
    return sorted(name for name in known if name.startswith(prefix))


def add_out(command: ArgumentParser, kind: str, meaning: str, default: Path | None = None) -> None:
    """`--out`: where a command writes."""
    command.add_argument("--out", type=Path, default=default, metavar=kind, help=meaning)


def add_number(command: ArgumentParser, name: str, default: float, unit: str, meaning: str) -> None:
    """An option that is a number, with its default in `--help`."""
    shown = f"{meaning} (default: %(default)s)"
    command.add_argument(name, type=number, default=default, metavar=unit, help=shown)


def add_origin(command: ArgumentParser, when: str) -> None:
    """`--origin`: the place on earth at which a flight starts."""
    meaning = f"where the flight starts, {when} (default: San Francisco airport)"
    command.add_argument("--origin", metavar="LAT,LON[,ALT]", help=meaning)


def add_junit(command: ArgumentParser) -> None:
    """`--junit`: the verdict for continuous integration."""
    meaning = "write the verdict as JUnit XML, with the stories of flights that failed"
    command.add_argument("--junit", type=Path, metavar="FILE", help=meaning)


def add_set(command: ArgumentParser) -> None:
    """`--set`: changes of a scenario's settings."""
    meaning = "change a setting by its dotted path"
    command.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help=meaning)


def add_many_flights(command: ArgumentParser) -> None:
    """What a sweep and a search share: seed, controllers, where and how the flights are flown, figures."""
    command.add_argument("--seed", type=whole_number, metavar="S", help="seed of everything random")
    command.add_argument(
        "--controller",
        action="append",
        default=[],
        metavar="NAME=OWN",
        help="compare a controller of your own too: FILE.py:CLASS, a command, a C library, ardupilot:PATH; repeatable",
    )
    add_flying(command)


def add_shard(command: ArgumentParser, which: str = "fly every N-th run, from the K-th on") -> None:
    """`--shard`: a part of the runs."""
    command.add_argument("--shard", metavar="K/N", help=f"{which}; `testbed merge` joins the folders")


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


def add_flying(command: ArgumentParser) -> None:
    """How and where many flights are flown."""
    jobs = "number of processes (default: one for each core)"
    command.add_argument("--jobs", type=whole_number, metavar="N", help=jobs)
    command.add_argument(
        "--cluster", metavar="ADDRESS", help="fly on a Dask cluster, such as tcp://host:8786"
    )
    wait = "how long to wait for a cluster that is starting (default: 8)"
    command.add_argument("--cluster-wait", type=number, metavar="S", help=wait)
    copy = "copy the folder there when the command ends, also early: s3://bucket/folder and what else fsspec reaches"
    command.add_argument("--copy-to", metavar="URL", help=copy)
    resume = "go on with an existing folder, or one that --copy-to has: fly only the missing flights"
    command.add_argument("--resume", action="store_true", help=resume)
    add_mixed(command)
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def add_mixed(command: ArgumentParser) -> None:
    """`--mixed`: flights of several environments."""
    mixed = "allow other versions or processors than the study was begun with, and mark those flights in the table"
    command.add_argument("--mixed", action="store_true", help=mixed)


def checked(file: str, settings: Sequence[str] = ()) -> Scenario:
    """The scenario in a file, completely checked; conditions that its controller is not made for are printed on stderr."""
    from testbed.scenario import conditions
    from testbed.scenario.load import load_scenario
    from testbed.simulation.check import check

    scenario = load_scenario(file, settings)
    check(scenario)
    for warning in conditions.warnings(scenario):
        print(f"WARNING: {warning}", file=sys.stderr)
    return scenario


def write_out(file: Path, text: str) -> None:
    """Write what `--out` asks for, whole or not at all, and say so; raises BadInput when it cannot be written."""
    with tidily(), written(file) as stream:
        stream.write(text.encode())
    print(f"wrote {file}")
