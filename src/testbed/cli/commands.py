"""The commands, their options, and their exit status.

Exit status: 0 every requirement was met; 1 one was not met, or the aircraft was lost; 2 bad input, and nothing was flown.
The module of a command is imported only when the command runs, so that `--help` and `validate` are quick.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from testbed import __version__
from testbed.cli import completion
from testbed.cli.catalogue import TABLE as CATALOGUE
from testbed.inputs.problems import BadInput

MET, NOT_MET, BAD_INPUT = 0, 1, 2
_SCENARIO = "YAML file; a shipped one is found from any folder"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status; every problem with the input is one line on stderr."""
    try:
        try:
            return _run(arguments)
        finally:
            sys.stdout.flush()  # here, so that a closed pipe is noticed inside this `try`
    except BrokenPipeError:
        # As with `testbed list | head -1`. The remedy is that of the notes on SIGPIPE in Python's `signal` module.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # so that the flush at exit succeeds
        return NOT_MET


def _run(arguments: Sequence[str] | None) -> int:
    top = parser()
    completion.answer(top)  # ends the process if a shell asks for completions
    options = top.parse_args(arguments)
    try:
        status: int = options.command(options)
    except BadInput as error:
        for problem in error.problems:
            print(problem, file=sys.stderr)
        return BAD_INPUT
    return status


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

    command = _command(commands, "report", _report, "rebuild figures and report of a run or sweep folder")
    command.add_argument("folder", type=Path, help="run or sweep folder")

    command = _command(commands, "validate", _validate, "check scenarios and sweeps without flying")
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

    command = _command(
        commands, "list", _list, "list the names that scenarios and commands can use, with their meanings"
    )
    command.add_argument("what", nargs="?", choices=CATALOGUE, help="default: everything")

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


def _add_sweep(command: argparse.ArgumentParser) -> None:
    _file(command, "sweep", _SCENARIO)
    command.add_argument(
        "--out", type=Path, metavar="DIR", help="sweep folder to make (default: runs/<name>)"
    )
    command.add_argument(
        "--runs", type=int, metavar="N", help="number of runs; with --resume, a larger number adds runs"
    )
    command.add_argument("--seed", type=int, metavar="S", help="seed of everything random")
    command.add_argument(
        "--jobs", type=int, metavar="N", help="number of processes (default: one for each core)"
    )
    command.add_argument(
        "--cluster", metavar="ADDRESS", help="fly on a Dask cluster, such as tcp://host:8786"
    )
    command.add_argument(
        "--resume", action="store_true", help="go on with an existing folder: fly only the missing flights"
    )
    command.add_argument("--only", type=int, metavar="I", help="fly run I alone and keep its whole log")
    command.add_argument(
        "--save-logs", default="failed", metavar="WHICH", help="logs to keep: none, failed (default) or all"
    )
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def _fly(options: argparse.Namespace) -> int:
    from testbed.cli import flight

    return MET if flight.fly(options) else NOT_MET


def _sweep(options: argparse.Namespace) -> int:
    from testbed.cli import sweep

    return sweep.fly(options)


def _report(options: argparse.Namespace) -> int:
    from testbed.loading import is_sweep_folder

    if is_sweep_folder(options.folder):
        from testbed.cli import sweep

        return sweep.report(options.folder)
    from testbed.cli import flight

    return MET if flight.report(options.folder) else NOT_MET


def _validate(options: argparse.Namespace) -> int:
    from testbed.cli import checked

    checked.validate(options.files)
    return MET


def _identify(options: argparse.Namespace) -> int:
    from testbed.cli import aircraft

    return MET if aircraft.identify(options.aircraft, check=options.check) else NOT_MET


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
