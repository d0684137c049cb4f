"""The command line. Exit status: 0 every requirement met, 1 not met or aircraft lost, 2 bad input."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from testbed.cli.catalogue import LISTS
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup
    from testbed.flight.flight import Flight
    from testbed.scenario.load import Scenario

Result = TypeVar("Result")
MET, NOT_MET, BAD_INPUT = 0, 1, 2


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status; every problem with the input is one line on stderr."""
    options = parser().parse_args(arguments)
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
    commands = top.add_subparsers(required=True, metavar="COMMAND")

    command = _command(commands, "run", _run, "fly one scenario")
    command.add_argument("scenario", help="YAML file; those shipped are found from any folder")
    command.add_argument("--out", type=Path, metavar="DIR", help="run folder to make (default: runs/<name>)")
    command.add_argument("--no-plots", action="store_true", help="draw no figures")
    command.add_argument(
        "--controller", metavar="FILE.py:CLASS", help="fly a class of your own in place of the scenario's"
    )
    _add_set(command)

    command = _command(commands, "sweep", _sweep, "Monte Carlo: fly many variations of a scenario")
    _add_sweep(command)
    _add_set(command)

    command = _command(commands, "report", _report, "rebuild figures and report of a run or sweep folder")
    command.add_argument("folder", type=Path)

    command = _command(commands, "validate", _validate, "check scenarios and sweeps, fly nothing")
    command.add_argument("files", nargs="+", metavar="FILE")

    command = _command(
        commands, "identify", _identify, "find an aircraft's design model and store it beside it"
    )
    command.add_argument("aircraft", help="name, or folder as ./name")
    command.add_argument(
        "--check", action="store_true", help="only compare with what is stored; 1 if it differs"
    )

    command = _command(commands, "list", _list, "what there is")
    command.add_argument("what", nargs="?", choices=LISTS, help="default: everything")
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


def _add_set(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change a setting by its dotted path"
    )


def _add_sweep(command: argparse.ArgumentParser) -> None:
    command.add_argument("sweep", help="YAML file; those shipped are found from any folder")
    command.add_argument(
        "--out", type=Path, metavar="DIR", help="sweep folder to make (default: runs/<name>)"
    )
    command.add_argument(
        "--runs", type=int, metavar="N", help="runs in all; more than a finished sweep has extend it"
    )
    command.add_argument("--seed", type=int, metavar="S")
    command.add_argument("--jobs", type=int, metavar="N", help="processes (default: one a core)")
    command.add_argument("--cluster", metavar="ADDRESS", help="fly on a Dask cluster, as tcp://host:8786")
    command.add_argument("--resume", action="store_true", help="fly only what the folder is missing")
    command.add_argument("--only", type=int, metavar="I", help="fly run I alone and keep its whole log")
    command.add_argument(
        "--save-logs", default="failed", metavar="WHICH", help="none, failed or all, as Parquet"
    )
    command.add_argument("--no-plots", action="store_true", help="draw no figures, write no report")


def _run(options: argparse.Namespace) -> int:
    from testbed.flight.folder import refuse_existing

    problems: list[Problem] = []
    if options.out is not None:  # refused before flying for a minute, not after
        _collect(problems, lambda: refuse_existing(options.out))
    scenario = _collect(problems, lambda: _checked(options.scenario, options.set))
    controller = _collect(problems, lambda: _own_controller(options.controller))
    if scenario is None or problems:
        raise BadInput(problems)
    from testbed.simulation import fly

    flight = fly(scenario, controller)
    folder = _write(flight, options.out, _presentation(flight, figures=not options.no_plots))
    _print_verdict(flight)
    print(f"wrote {folder}")
    return MET if flight.passed else NOT_MET


def _own_controller(reference: str | None) -> Callable[[Setup], object] | None:
    """The user's class, from the file that it is in."""
    if reference is None:
        return None
    from testbed.controllers.user.loader import load_controller

    return load_controller(reference)


def _collect(problems: list[Problem], function: Callable[[], Result]) -> Result | None:
    """Result of a function; of one that refuses the input None, and its problems are added."""
    try:
        return function()
    except BadInput as error:
        problems += error.problems
        return None


def _checked(file: str, settings: Sequence[str] = ()) -> Scenario:
    """The scenario in a file, checked also against the log's columns, the metrics and the JSBSim model."""
    from testbed.aircraft.description import load_aircraft
    from testbed.flight.columns import all_columns
    from testbed.metrics import TABLE as METRICS
    from testbed.scenario.checks import unknown_names
    from testbed.scenario.load import load_scenario

    scenario = load_scenario(file, settings)
    aircraft = load_aircraft(scenario.aircraft)
    properties: Mapping[str, bool] = {}
    if scenario.failures:  # loading the model takes longer than all else here, and only failures need it
        from testbed.plant.jsbsim import property_catalog

        properties = property_catalog(aircraft)
    problems = unknown_names(scenario, aircraft, all_columns(aircraft, scenario), METRICS, properties)
    if problems:
        raise BadInput(problems)
    return scenario


def _presentation(flight: Flight, figures: bool = True) -> Callable[[Path], None]:
    """What writes figures (unless not wanted) and report into a folder that has log and summary."""

    def write_into(folder: Path) -> None:
        from testbed.reporting.run_report import write_report

        if figures:
            from testbed.reporting.figures import draw

            draw(flight, folder)
        write_report(folder)

    return write_into


def _write(flight: Flight, out: Path | None, add: Callable[[Path], None]) -> Path:
    """Write the run folder: the one asked for, else the first free of runs/<name>, -2, -3 ..."""
    from testbed.flight.folder import FolderExists, write_run_folder

    if out is not None:
        return write_run_folder(flight, out, add)
    first = Path("runs") / flight.scenario.slug
    for number in count(1):
        try:
            return write_run_folder(flight, first if number == 1 else f"{first}-{number}", add)
        except FolderExists:
            continue
    raise AssertionError("unreachable: count() does not end")


def _print_verdict(flight: Flight) -> None:
    print(f"{flight.scenario.name}: {flight.outcome.sentence}, {flight.end_time_s:g} s")
    if flight.flown_by:
        print(f"flown by {flight.flown_by}")
    for requirement in flight.requirements:
        verdict = "met    " if requirement["passed"] else "NOT MET"
        value = requirement["value"]
        shown = f"{value:.4g}" if isinstance(value, int | float) else value
        reason = f" ({requirement['reason']})" if requirement.get("reason") else ""
        print(f"  {verdict}  {requirement['name']}: {shown}{reason}")
    for event in flight.events:
        if event["kind"] == "diagnosis":
            print(f"  controller at {event['time_s']:.1f} s: {event['text']}")
    print("passed" if flight.passed else "not passed")
    for warning in flight.warnings:
        print(f"WARNING: {warning}", file=sys.stderr)


def _sweep(options: argparse.Namespace) -> int:
    from testbed.cli import sweep as command

    return command.run(options)


def _report(options: argparse.Namespace) -> int:
    if (options.folder / "sweep.yaml").is_file():
        from testbed.cli import sweep as command

        return command.report(options.folder)
    from testbed.flight.folder import load

    flight = load(options.folder)
    _presentation(flight)(options.folder)
    _print_verdict(flight)
    return MET if flight.passed else NOT_MET


def _validate(options: argparse.Namespace) -> int:
    problems: list[Problem] = []
    for file in options.files:
        if _collect(problems, partial(_validated, file)) is not None:
            print(f"{file}: ok")
    if problems:
        raise BadInput(problems)
    return MET


def _identify(options: argparse.Namespace) -> int:
    from testbed.aircraft.description import load_aircraft
    from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
    from testbed.plant.identification import identify

    aircraft = load_aircraft(options.aircraft)
    file = aircraft.folder / DESIGN_MODEL
    model = identify(aircraft)
    if options.check:
        same = file.is_file() and load_design_model(file).agrees_with(model)
        print(f"{file}: {'as identified' if same else 'differs from what is identified now'}")
        return MET if same else NOT_MET
    try:
        model.save(file)
    except OSError as error:
        raise BadInput([Problem(f"cannot be written: {error.strerror}", str(file))]) from None
    print(f"wrote {file}")
    return MET


def _validated(file: str) -> object:
    """The scenario or the sweep in a file, checked."""
    from testbed.aircraft.shipped import find_scenario
    from testbed.inputs import yaml_source as yamlfile
    from testbed.sweeps import is_sweep

    if not is_sweep(yamlfile.read(find_scenario(file)).tree):
        return _checked(file)
    from testbed.cli import sweep as command

    return command.validate(file)


def _list(options: argparse.Namespace) -> int:
    for what in [options.what] if options.what else LISTS:
        print(what)
        entries = LISTS[what]()
        width = max((len(name) for name, _ in entries), default=0) + 2
        for name, meaning in entries:
            print(f"  {name:<{width}}{meaning}")
    return MET
