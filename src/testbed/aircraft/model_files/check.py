"""Everything that can be said of an aircraft's JSBSim files without JSBSim."""

from __future__ import annotations

import contextlib

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.agreement import disagreements
from testbed.aircraft.model_files.effects import forbidden
from testbed.aircraft.model_files.functions import dangerous
from testbed.aircraft.model_files.mass import unphysical
from testbed.aircraft.model_files.numbers import not_numbers
from testbed.aircraft.model_files.sections import incomplete
from testbed.aircraft.model_files.used import ModelFiles, read_model
from testbed.inputs import yaml_source
from testbed.inputs.problems import BadInput, Issue, Problem


def model_problems(aircraft: Aircraft) -> list[Problem]:
    """Everything wrong with the JSBSim files of an aircraft, and with what its YAML says of them; none if they may be loaded."""
    files = read_model(aircraft.folder, aircraft.model)
    problems = list(files.problems)
    for rule in (forbidden, incomplete, not_numbers, unphysical, dangerous):
        problems += rule(files)
    if files.root is not None and not problems:
        problems += in_yaml(aircraft, list(disagreements(aircraft, files)))
    return problems


def model_files(aircraft: Aircraft) -> ModelFiles:
    """The files of an aircraft's model."""
    return read_model(aircraft.folder, aircraft.model)


def in_yaml(aircraft: Aircraft, issues: list[Issue]) -> list[Problem]:
    """Issues of the aircraft's YAML as problems, with the line where its file can be read."""
    file = aircraft.folder / f"{aircraft.folder.name}.yaml"
    source = yaml_source.Source(str(file))
    if issues and file.is_file():
        with contextlib.suppress(BadInput):  # the aircraft was made in Python, beside a file of another kind
            source = yaml_source.read(file)
    return [source.problem(*issue) for issue in issues]
