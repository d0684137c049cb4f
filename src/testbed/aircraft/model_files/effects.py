"""What a model may not ask JSBSim to do: write or read elsewhere, open ports, steer the simulation."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.inputs.problems import Problem

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
