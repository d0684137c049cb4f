"""Everything that can be said of an aircraft's JSBSim files without JSBSim; here, what a model may not ask it to do: write or read
elsewhere, open ports, steer the simulation."""

from __future__ import annotations

import contextlib
import posixpath
import re
from collections.abc import Iterator

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.agreement import disagreements
from testbed.aircraft.model_files.functions import dangerous
from testbed.aircraft.model_files.mass import unphysical
from testbed.aircraft.model_files.numbers import not_numbers
from testbed.aircraft.model_files.safe_xml import Element
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


_REFUSED_SECTIONS = {
    "output": "makes JSBSim write a file or send to a port; `testbed adopt` removes it",
    "input": "makes JSBSim listen on a port; `testbed adopt` removes it",
    "child": "makes JSBSim load another aircraft",
}
_SOCKET = ("port", "protocol")
_STEERING = re.compile(
    r"propulsion/set-running\b|simulation/(do_simple_trim|do_linearization|reset|terminate|pause|write-state-file|force-output|output"
    r"|jsbsim-debug|disperse|randomseed|frame|trim-completed|notify-time-trigger|frozen)\b"
)
"""Properties that make JSBSim act when they are written. Models of ships and gliders do write `simulation/integrator`."""
_COMPONENTS_OF = "channel"


def steers(name: str) -> bool:
    """Whether writing a property of this name makes JSBSim trim, stop, reset, write or seed."""
    plain = posixpath.normpath("/" + re.sub(r"\[0+\]", "", name.strip())).lstrip("/")
    return _STEERING.match(plain) is not None


def forbidden(files: ModelFiles) -> Iterator[Problem]:
    """Everything in the files that is not a description of an aircraft."""
    root = files.root
    if root is None:
        return
    if root.tag != "fdm_config":
        yield root.problem(f"is <{root.tag}>", "<fdm_config>: a JSBSim model")
    for child in root.children:
        if child.tag in _REFUSED_SECTIONS:
            yield child.problem(_REFUSED_SECTIONS[child.tag], "a model without it")
    for element in files.elements():
        if element.parent is not root and element.tag in _REFUSED_SECTIONS:
            for name in _SOCKET:
                if name in element.attributes:
                    yield element.problem(f"has {name}=", "no ports in a model")
        if element.tag == "runscript":
            yield element.problem("is a script", "no scripts in a model")
        for name in _written(element):
            if steers(name):
                what = f"writes {name}, which steers the simulation and not the aircraft"
                yield element.problem(what, "a property of the aircraft")


def _written(element: Element) -> Iterator[str]:
    """Names of properties that an element makes JSBSim write."""
    parent = element.parent.tag if element.parent is not None else ""
    if element.tag == "output" and element.text:
        yield element.text
    if "copyto" in element.attributes:  # of a function: its value, each time that it is worked out
        yield element.attributes["copyto"]
    if element.tag == "property" and "value" in element.attributes:
        yield element.text
    if "name" in element.attributes and (parent == _COMPONENTS_OF or element.tag in ("function", "table")):
        yield element.attributes["name"]
