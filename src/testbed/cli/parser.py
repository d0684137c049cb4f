"""The commands of the command line: what each is for, what runs it, and its options."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import NamedTuple

from testbed import __version__
from testbed.cli import actions, arguments
from testbed.cli.option_parser import Parser


class Command(NamedTuple):
    """A command: its description, the action, and what gives its parser the arguments."""

    description: str
    run: Callable[[argparse.Namespace], int]
    add_arguments: Callable[[argparse.ArgumentParser], None]


TABLE = {
    "run": Command("fly one scenario", actions.fly, arguments.of_run),
    "sweep": Command("Monte Carlo: fly many variations of a scenario", actions.sweep, arguments.of_sweep),
    "search": Command(
        "the smallest failure that breaks a requirement, or how likely one is",
        actions.search,
        arguments.of_search,
    ),
    "report": Command(
        "rebuild figures and report of a run, sweep or search folder", actions.report, arguments.of_report
    ),
    "compare": Command("flights side by side, in one page", actions.compare, arguments.of_compare),
    "export": Command("write a flight for another program", actions.export, arguments.of_export),
    "validate": Command(
        "check scenarios, sweeps and searches without flying", actions.validate, arguments.of_validate
    ),
    "identify": Command(
        "find an aircraft's design model and store it in the aircraft's folder",
        actions.identify,
        arguments.of_identify,
    ),
    "design": Command(
        "gains of the estimator from a scenario's noise, as YAML", actions.design, arguments.of_design
    ),
    "adopt": Command(
        "make an aircraft of a JSBSim model, in a folder of its own, and print its card",
        actions.adopt,
        arguments.of_adopt,
    ),
    "certify": Command(
        "say how wrong the input matrix of a scenario's design model may be",
        actions.certify,
        arguments.of_certify,
    ),
    "list": Command(
        "list the names that scenarios and commands can use, with their meanings",
        actions.list_names,
        arguments.of_list,
    ),
    "schema": Command(
        "print the JSON schema of a kind of file, for editors that check YAML",
        actions.schema,
        arguments.of_schema,
    ),
    "init": Command(
        "make a small project: a scenario, a sweep, a controller, and schemas for editors",
        actions.init,
        arguments.of_init,
    ),
    "completion": Command(
        "print the completion script of a shell", actions.print_completion, arguments.of_completion
    ),
}
"""The commands by their names, in the order of `--help`."""


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = Parser(prog="testbed", description="A flight-control failure testbed.")
    top.add_argument("--version", action="version", version=f"testbed {__version__}")
    commands = top.add_subparsers(required=True, metavar="COMMAND")
    for name, command in TABLE.items():
        one = commands.add_parser(name, help=command.description, description=command.description)
        one.set_defaults(command=command.run)
        command.add_arguments(one)
    return top
