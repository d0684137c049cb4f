"""`testbed validate`: check scenarios, studies and suites as before a flight, and fly nothing."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from importlib import import_module

from testbed.aircraft.shipped import find_scenario
from testbed.cli.command import add_file, checked
from testbed.cli.ending import MET
from testbed.cli.terminal import working
from testbed.inputs.problems import BadInput, Problem, collect

PURPOSE = "check scenarios, studies and suites without flying"
EXAMPLES = ("testbed validate my_scenario.yaml my_sweep.yaml",)


def arguments(command: ArgumentParser) -> None:
    add_file(command, "files", nargs="+", metavar="FILE")


def run(options: Namespace) -> int:
    """Print the valid files; raises BadInput with all problems of the others."""
    problems: list[Problem] = []
    with working("checking"):
        for file in options.files:
            if collect(problems, partial(valid, file)) is not None:
                print(f"{file}: ok")
    if problems:
        raise BadInput(problems)
    return MET


def valid(file: str) -> object:
    """The scenario, the study or the suite in a file, checked."""
    from testbed.inputs import yaml_source
    from testbed.inputs.kinds import study_in

    tree = yaml_source.read(find_scenario(file)).tree
    kind = "benchmark" if "suite" in tree else study_in(tree)
    return import_module(f"testbed.api.{kind}").prepare(file) if kind else checked(file)
