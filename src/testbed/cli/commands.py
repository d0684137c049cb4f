"""The commands, their options, and their exit status.

`status` has the exit status. An error that no command expects is one line, too, never a traceback.
The module of a command is imported only when the command runs, so that `--help` and `validate` are quick.
"""

from __future__ import annotations

import argparse
import os
import sys
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path

from testbed import __version__
from testbed.cli import completion, interrupts
from testbed.cli.catalogue import TABLE as CATALOGUE
from testbed.cli.status import BAD_INPUT, ENDED_EARLY, INTERRUPTED, MET, NOT_MET
from testbed.cli.terminal import give_up_stdout, plain_output
from testbed.cli.working import working
from testbed.inputs.problems import BadInput

_TRACEBACK = "TESTBED_TRACEBACK"
"""Environment variable with which a defect of the program shows its traceback."""
SCHEMAS = ("aircraft", "scenario", "search", "sweep")
"""The kinds of file of which `cli.schema` has a schema."""
_SCENARIO = "YAML file; a shipped one is found from any folder"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status; every problem with the input is one line on stderr."""
    with plain_output():
        try:
            try:
                return _run(arguments)
            finally:
                sys.stdout.flush()  # here, so that a closed pipe or a full disk is noticed inside this `try`
        except BrokenPipeError:  # as with `testbed list | head -1`
            give_up_stdout()
            return NOT_MET
        except KeyboardInterrupt:
            return _said(interrupts.WORDS, INTERRUPTED)
        except Exception as error:
            if os.environ.get(_TRACEBACK):
                raise
            give_up_stdout()
            return _said(_in_words(error), ENDED_EARLY)


def _run(arguments: Sequence[str] | None) -> int:
    top = parser()
    completion.answer(top)  # ends the process if a shell asks for completions
    options = top.parse_args(arguments)
    try:
        status: int = options.command(options)
    except BadInput as error:
        return _said("\n".join(map(str, error.problems)), BAD_INPUT)
    return status


def _said(words: str, status: int) -> int:
    print(words, file=sys.stderr)
    return status


def _in_words(error: Exception) -> str:
    """One line for an error that no command expects: of the operating system, or a defect of the program."""
    if isinstance(error, OSError):
        where = f"{error.filename}: " if error.filename else ""
        return f"{where}cannot be read or written: {error.strerror or error}"
    if isinstance(error, MemoryError):
        return "there is not enough memory for this"
    last = traceback.extract_tb(error.__traceback__)[-1]
    place = f"{Path(last.filename).name}:{last.lineno}"
    words = " ".join(str(error).split())
    return f"a defect of testbed: {type(error).__name__} at {place}: {words}; {_TRACEBACK}=1 shows where it comes from"


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = argparse.ArgumentParser(prog="testbed", description="A flight-control failure testbed.")
    top.add_argument("--version", action="version", version=f"testbed {__version__}")
    commands = top.add_subparsers(required=True, metavar="COMMAND")

    command = _command(commands, "run", _fly, "fly one scenario")
    _add_run(command)
    _add_set(command)

    command = _command(commands, "sweep", _sweep, "Monte Carlo: fly many variations of a scenario")
    _add_sweep(command)
    _add_set(command)

    command = _command(
        commands, "search", _search, "the smallest failure that breaks a requirement, or how likely one is"
    )
    _add_search(command)
    _add_set(command)

    command = _command(
        commands, "report", _report, "rebuild figures and report of a run, sweep or search folder"
    )
    command.add_argument(
        "folder",
        type=Path,
        help="run, sweep or search folder, or one run of a sweep whose log was kept: SWEEP/17",
    )

    _add_compare(_command(commands, "compare", _compare, "flights side by side, in one page"))

    _add_export(_command(commands, "export", _export, "write a flight for another program"))

    command = _command(commands, "validate", _validate, "check scenarios, sweeps and searches without flying")
    _file(command, "files", _SCENARIO, nargs="+", metavar="FILE")

    command = _command(
        commands,
        "identify",
        _identify,
        "find an aircraft's design model and store it in the aircraft's folder",
    )
    command.add_argument("aircraft", help="name, or path of a folder such as ./name")
    command.add_argument(
        "--check", action="store_true", help="only compare with the stored model; exit status 1 if it differs"
    )

    command = _command(commands, "design", _design, "gains of the estimator from a scenario's noise, as YAML")
    _add_design(command)
    _add_set(command)

    command = _command(
        commands,
        "adopt",
        _adopt,
        "make an aircraft of a JSBSim model, in a folder of its own, and print its card",
    )
    command.add_argument(
        "model", help="name of a model in the jsbsim package, such as c172p, or a model's folder"
    )
    command.add_argument(
        "--out", type=Path, metavar="DIR", help="folder to make (default: the model's name, here)"
    )

    command = _command(
        commands,
        "certify",
        _certify,
        "say how wrong the input matrix of a scenario's design model may be",
    )
    _add_certify(command)
    _add_set(command)

    command = _command(
        commands, "list", _list, "list the names that scenarios and commands can use, with their meanings"
    )
    command.add_argument("what", nargs="?", choices=CATALOGUE, help="default: everything")

    command = _command(
        commands, "schema", _schema, "print the JSON schema of a kind of file, for editors that check YAML"
    )
    command.add_argument("kind", choices=SCHEMAS)
    command.add_argument("--out", type=Path, metavar="FILE", help="write it into this file")

    command = _command(
        commands,
        "init",
        _init,
        "make a small project: a scenario, a sweep, a controller, and schemas for editors",
    )
    command.add_argument("folder", type=Path, help="new or empty folder")
    command.add_argument("--aircraft", metavar="AIRCRAFT", help="name or folder of the one that is flown")

    command = _command(commands, "completion", _completion, "print the completion script of a shell")
    command.add_argument("shell", choices=completion.SHELLS)
    return top


def _command(
    commands: argparse._SubParsersAction[argparse.ArgumentParser],
    name: str,
    function: Callable[[argparse.Namespace], int],
    description: str,
) -> argparse.ArgumentParser:
    command = commands.add_parser(name, help=description, description=description)
    command.set_defaults(command=function)
    return command


def _file(command: argparse.ArgumentParser, name: str, description: str, **more: str) -> None:
    """Add an argument for scenario or sweep files; a shell also completes the names of shipped ones."""
    action = command.add_argument(name, help=description, **more)  # type: ignore[arg-type]
    action.completer = completion.files  # type: ignore[attr-defined]


def _add_set(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change a setting by its dotted path"
    )


def _add_run(command: argparse.ArgumentParser) -> None:
    _file(command, "scenario", _SCENARIO)
    command.add_argument("--out", type=Path, metavar="DIR", help="run folder to make (default: runs/<name>)")
    command.add_argument("--no-plots", action="store_true", help="draw no figures")
    command.add_argument(
        "--controller",
        metavar="FILE.py:CLASS",
        help="fly a controller class of your own in place of the scenario's",
    )
    command.add_argument(
        "--flightgear",
        metavar="HOST:PORT",
        help="show the flight in FlightGear while it is flown, in real time",
    )
    _add_origin(command, "with --flightgear")


def _add_sweep(command: argparse.ArgumentParser) -> None:
    _file(command, "sweep", _SCENARIO)
    command.add_argument(
        "--out", type=Path, metavar="DIR", help="sweep folder to make (default: runs/<name>)"
    )
    command.add_argument(
        "--runs", type=int, metavar="N", help="number of runs; with --resume, a larger number adds runs"
    )
    _add_flying(command)
    command.add_argument("--only", type=int, metavar="I", help="fly run I alone and keep its whole log")
    command.add_argument(
        "--variant",
        metavar="LABEL",
        help="with --only: fly only this one of the compared variants, into a run folder",
    )
    command.add_argument(
        "--save-logs", default="failed", metavar="WHICH", help="logs to keep: none, failed (default) or all"
    )
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def _add_search(command: argparse.ArgumentParser) -> None:
    _file(command, "search", _SCENARIO)
    command.add_argument(
        "--out", type=Path, metavar="DIR", help="search folder to make (default: runs/<name>)"
    )
    command.add_argument(
        "--goal", metavar="GOAL", help="smallest or probability; with it the file may be a sweep's"
    )
    command.add_argument(
        "--budget", type=int, metavar="N", help="most flights for each variant and option of a choice"
    )
    _add_flying(command)
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def _add_flying(command: argparse.ArgumentParser) -> None:
    """What a sweep and a search share: seed, controllers, and where and how the flights are flown."""
    command.add_argument("--seed", type=int, metavar="S", help="seed of everything random")
    command.add_argument(
        "--controller",
        action="append",
        default=[],
        metavar="NAME=FILE.py:CLASS",
        help="compare a controller class of your own too; may be given several times",
    )
    command.add_argument(
        "--jobs", type=int, metavar="N", help="number of processes (default: one for each core)"
    )
    command.add_argument(
        "--cluster", metavar="ADDRESS", help="fly on a Dask cluster, such as tcp://host:8786"
    )
    command.add_argument(
        "--resume", action="store_true", help="go on with an existing folder: fly only the missing flights"
    )


def _add_design(command: argparse.ArgumentParser) -> None:
    _file(command, "scenario", _SCENARIO)
    command.add_argument(
        "--deviation",
        type=float,
        default=0.1,
        metavar="SIGMA",
        help="tolerated standard deviation of an estimate (default: %(default)s)",
    )
    command.add_argument(
        "--false-alarms",
        type=float,
        default=0.1,
        metavar="RATE",
        help="tolerated false alarms per hour (default: %(default)s)",
    )
    command.add_argument(
        "--keep",
        type=float,
        default=0.2,
        metavar="EFFECTIVENESS",
        help="effectiveness that must not be flagged (default: %(default)s)",
    )
    command.add_argument(
        "--within", type=float, metavar="SECONDS", help="time in which an estimate has to converge"
    )
    command.add_argument("--out", type=Path, metavar="FILE", help="write the YAML into this file too")


def _add_compare(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "runs", type=Path, nargs="+", metavar="RUN", help="run folder, or a flight of a sweep: SWEEP/17"
    )
    command.add_argument(
        "--out",
        type=Path,
        default=Path("runs/comparison.html"),
        metavar="FILE",
        help="page to write, or folder to write comparison.html into (default: %(default)s)",
    )


def _add_certify(command: argparse.ArgumentParser) -> None:
    _file(command, "scenario", _SCENARIO)
    command.add_argument(
        "--error",
        type=float,
        default=0.1,
        metavar="FRACTION",
        help="relative error of all entries for which the bias of the estimates is bounded (default: %(default)s)",
    )
    command.add_argument(
        "--out", type=Path, metavar="FILE", help="also write all numbers into this .csv or .json file"
    )


def _add_export(command: argparse.ArgumentParser) -> None:
    command.add_argument("run", type=Path, help="run folder")
    command.add_argument("--to", required=True, metavar="FORMAT", help="acmi, kml, parquet, mcap or mat")
    command.add_argument(
        "--out",
        type=Path,
        metavar="FILE",
        help="file to make (default: the scenario's name, in the run folder)",
    )
    _add_origin(command, "for formats that show a place")


def _add_origin(command: argparse.ArgumentParser, when: str) -> None:
    command.add_argument(
        "--origin",
        metavar="LAT,LON[,ALT]",
        help=f"where the flight starts, {when} (default: San Francisco airport)",
    )


def _fly(options: argparse.Namespace) -> int:
    from testbed.cli import flight

    return MET if flight.fly(options) else NOT_MET


def _sweep(options: argparse.Namespace) -> int:
    from testbed.cli import sweep

    return sweep.fly(options)


def _search(options: argparse.Namespace) -> int:
    from testbed.cli import search

    return search.search(options)


def _report(options: argparse.Namespace) -> int:
    from testbed.loading import is_search_folder, is_sweep_folder, names_kept_log

    if names_kept_log(options.folder):
        from testbed.cli import sweep

        return sweep.report_run(options.folder)
    if is_search_folder(options.folder):
        from testbed.cli import search

        return search.report(options.folder)
    if is_sweep_folder(options.folder):
        from testbed.cli import sweep

        return sweep.report(options.folder)
    from testbed.cli import flight

    return flight.report(options.folder)


def _compare(options: argparse.Namespace) -> int:
    from testbed.cli import comparing

    return comparing.compare(options.runs, options.out)


def _export(options: argparse.Namespace) -> int:
    from testbed.cli import export

    export.export(options.run, options.to, options.out, options.origin)
    return MET


def _validate(options: argparse.Namespace) -> int:
    from testbed.cli import checked

    with working("checking"):
        checked.validate(options.files)
    return MET


def _identify(options: argparse.Namespace) -> int:
    from testbed.cli import aircraft

    with working("identifying"):
        same = aircraft.identify(options.aircraft, check=options.check)
    return MET if same else NOT_MET


def _design(options: argparse.Namespace) -> int:
    from testbed.cli import design

    return MET if design.design(options) else NOT_MET


def _adopt(options: argparse.Namespace) -> int:
    from testbed.cli import adopt

    with working("adopting"):
        adopt.adopt(options.model, options.out)
    return MET


def _certify(options: argparse.Namespace) -> int:
    from testbed.cli import certify

    certify.certify(options)
    return MET


def _schema(options: argparse.Namespace) -> int:
    from testbed.cli import schema

    schema.write(options.kind, options.out)
    return MET


def _init(options: argparse.Namespace) -> int:
    from testbed.cli import project

    project.make(options.folder, options.aircraft or project.USUAL)
    return MET


def _list(options: argparse.Namespace) -> int:
    for what in [options.what] if options.what else CATALOGUE:
        print(what)
        entries = CATALOGUE[what]()
        width = max((len(name) for name, _ in entries), default=0) + 2
        for name, meaning in entries:
            print(f"  {name:<{width}}{meaning}")
    return MET


def _completion(options: argparse.Namespace) -> int:
    print(completion.script(options.shell), end="")
    return MET
