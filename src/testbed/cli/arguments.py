"""The arguments of each command: `of_run` gives those of `run` to its parser."""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path
from typing import Any

from testbed.cli import completion
from testbed.cli.catalogue import TABLE as CATALOGUE
from testbed.cli.option_parser import number, whole_number

SCHEMAS = ("aircraft", "scenario", "search", "sweep")
"""The kinds of file of which `cli.schema` has a schema."""


def of_run(command: ArgumentParser) -> None:
    _file(command, "scenario")
    _out(command, "DIR", "run folder to make (default: runs/<name>)")
    command.add_argument("--no-plots", action="store_true", help="draw no figures")
    own = "fly a controller class of your own in place of the scenario's"
    command.add_argument("--controller", metavar="FILE.py:CLASS", help=own)
    watched = "show the flight in FlightGear while it is flown, in real time"
    command.add_argument("--flightgear", metavar="HOST:PORT", help=watched)
    _origin(command, "with --flightgear")
    _set(command)


def of_sweep(command: ArgumentParser) -> None:
    _file(command, "sweep")
    _out(command, "DIR", "sweep folder to make (default: runs/<name>)")
    runs = "number of runs; with --resume, a larger number adds runs"
    command.add_argument("--runs", type=whole_number, metavar="N", help=runs)
    _many_flights(command)
    command.add_argument(
        "--only", type=whole_number, metavar="I", help="fly run I alone and keep its whole log"
    )
    variant = "with --only: fly only this one of the compared variants, into a run folder"
    command.add_argument("--variant", metavar="LABEL", help=variant)
    logs = "logs to keep: none, failed (default) or all"
    command.add_argument("--save-logs", default="failed", metavar="WHICH", help=logs)
    _set(command)


def of_search(command: ArgumentParser) -> None:
    _file(command, "search")
    _out(command, "DIR", "search folder to make (default: runs/<name>)")
    goal = "smallest or probability; with it the file may be a sweep's"
    command.add_argument("--goal", metavar="GOAL", help=goal)
    budget = "most flights for each variant and option of a choice"
    command.add_argument("--budget", type=whole_number, metavar="N", help=budget)
    _many_flights(command)
    _set(command)


def of_report(command: ArgumentParser) -> None:
    what = "run, sweep or search folder, or one run of a sweep whose log was kept: SWEEP/17"
    command.add_argument("folder", type=Path, help=what)


def of_compare(command: ArgumentParser) -> None:
    runs = "run folder, or a flight of a sweep: SWEEP/17"
    command.add_argument("runs", type=Path, nargs="+", metavar="RUN", help=runs)
    page = "page to write, or folder to write comparison.html into (default: %(default)s)"
    _out(command, "FILE", page, default=Path("runs/comparison.html"))


def of_export(command: ArgumentParser) -> None:
    command.add_argument("run", type=Path, help="run folder")
    command.add_argument("--to", required=True, metavar="FORMAT", help="acmi, kml, parquet, mcap or mat")
    _out(command, "FILE", "file to make (default: the scenario's name, in the run folder)")
    _origin(command, "for formats that show a place")


def of_validate(command: ArgumentParser) -> None:
    _file(command, "files", nargs="+", metavar="FILE")


def of_identify(command: ArgumentParser) -> None:
    command.add_argument("aircraft", help="name, or path of a folder such as ./name")
    check = "only compare with the stored model; exit status 1 if it differs"
    command.add_argument("--check", action="store_true", help=check)


def of_design(command: ArgumentParser) -> None:
    _file(command, "scenario")
    _number(command, "--deviation", 0.1, "SIGMA", "tolerated standard deviation of an estimate")
    _number(command, "--false-alarms", 0.1, "RATE", "tolerated false alarms per hour")
    _number(command, "--keep", 0.2, "EFFECTIVENESS", "effectiveness that must not be flagged")
    within = "time in which an estimate has to converge"
    command.add_argument("--within", type=number, metavar="SECONDS", help=within)
    _out(command, "FILE", "write the YAML into this file too")
    _set(command)


def of_adopt(command: ArgumentParser) -> None:
    command.add_argument(
        "model", help="name of a model in the jsbsim package, such as c172p, or a model's folder"
    )
    _out(command, "DIR", "folder to make (default: the model's name, here)")


def of_certify(command: ArgumentParser) -> None:
    _file(command, "scenario")
    error = "relative error of all entries for which the bias of the estimates is bounded"
    _number(command, "--error", 0.1, "FRACTION", error)
    _out(command, "FILE", "also write all numbers into this .csv or .json file")
    _set(command)


def of_list(command: ArgumentParser) -> None:
    command.add_argument("what", nargs="?", choices=CATALOGUE, help="default: everything")


def of_schema(command: ArgumentParser) -> None:
    command.add_argument("kind", choices=SCHEMAS)
    _out(command, "FILE", "write it into this file")


def of_init(command: ArgumentParser) -> None:
    command.add_argument("folder", type=Path, help="new or empty folder")
    command.add_argument("--aircraft", metavar="AIRCRAFT", help="name or folder of the one that is flown")


def of_completion(command: ArgumentParser) -> None:
    command.add_argument("shell", choices=completion.SHELLS)


def _many_flights(command: ArgumentParser) -> None:
    """What a sweep and a search share: seed, controllers, where and how the flights are flown, figures."""
    command.add_argument("--seed", type=whole_number, metavar="S", help="seed of everything random")
    command.add_argument(
        "--controller",
        action="append",
        default=[],
        metavar="NAME=FILE.py:CLASS",
        help="compare a controller class of your own too; may be given several times",
    )
    jobs = "number of processes (default: one for each core)"
    command.add_argument("--jobs", type=whole_number, metavar="N", help=jobs)
    command.add_argument(
        "--cluster", metavar="ADDRESS", help="fly on a Dask cluster, such as tcp://host:8786"
    )
    resume = "go on with an existing folder: fly only the missing flights"
    command.add_argument("--resume", action="store_true", help=resume)
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def _file(command: ArgumentParser, name: str, **more: Any) -> None:
    """A scenario, sweep or search file; a shell also completes the names of shipped ones."""
    action = command.add_argument(name, help="YAML file; a shipped one is found from any folder", **more)
    action.completer = completion.files  # type: ignore[attr-defined]


def _out(command: ArgumentParser, kind: str, meaning: str, default: Path | None = None) -> None:
    command.add_argument("--out", type=Path, default=default, metavar=kind, help=meaning)


def _number(command: ArgumentParser, name: str, default: float, unit: str, meaning: str) -> None:
    shown = f"{meaning} (default: %(default)s)"
    command.add_argument(name, type=number, default=default, metavar=unit, help=shown)


def _origin(command: ArgumentParser, when: str) -> None:
    meaning = f"where the flight starts, {when} (default: San Francisco airport)"
    command.add_argument("--origin", metavar="LAT,LON[,ALT]", help=meaning)


def _set(command: ArgumentParser) -> None:
    meaning = "change a setting by its dotted path"
    command.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help=meaning)
