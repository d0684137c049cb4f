"""Everything that can be said of an aircraft's JSBSim files without JSBSim; here, what a model may not ask it to do: write or read
elsewhere, open ports, steer the simulation, or end the process in flight; and what it must have."""

from __future__ import annotations

import contextlib
import posixpath
import re
from collections.abc import Iterator, Mapping

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.agreement import disagreements
from testbed.aircraft.model_files.numbers import finite, not_numbers, unphysical
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ENGINES, ModelFiles
from testbed.inputs import yaml_source
from testbed.inputs.problems import BadInput, Issue, Problem


def model_problems(aircraft: Aircraft) -> list[Problem]:
    """Everything wrong with the JSBSim files of an aircraft, and with what its YAML says of them; none if they may be loaded."""
    files = ModelFiles(aircraft.folder, aircraft.model)
    problems = list(files.problems)
    for rule in (forbidden, incomplete, not_numbers, unphysical, dangerous):
        problems += rule(files)
    if files.root is not None and not problems:
        problems += in_yaml(aircraft, list(disagreements(aircraft, files)))
    return problems


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


def steers(name: str) -> bool:
    """Whether writing a property of this name makes JSBSim trim, stop, reset, write or seed."""
    return _STEERING.match(_plain(name)) is not None


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
    if "name" in element.attributes and (parent == "channel" or element.tag in ("function", "table")):
        yield element.attributes["name"]


# Functions that can end the process in flight, also in a branch that the few steps of a first load do not reach ---

_NAMED = ("function", "table")
"""Elements whose `name` is a property that is worked out anew whenever it is read."""
_READ = ("property", "p", "independentVar")
_MOST_ENGINES = 8
"""Engines for which a name with `#`, their number, is written out."""


def dangerous(files: ModelFiles) -> Iterator[Problem]:
    """Operators that can divide by zero or leave their range, seeds that change, and functions that read themselves."""
    for element in files.elements():
        if element.tag == "mod":
            yield from _remainder(element)
        elif element.tag == "switch" and element.parent is not None and element.parent.tag != "channel":
            what = "ends the process when its first operand is not the number of one of the others"
            yield element.problem(what, "<ifthen>, or a <table>")
        elif (
            element.attributes.get("seed", "0").strip()
            and finite(element.attributes.get("seed", "0")) is None
        ):
            what = f"has seed={element.attributes['seed']!r}, which makes each flight another one"
            yield element.problem(what[:100], "a number, or none: the scenario's seed")
    yield from _circular(_named(files))


def _remainder(element: Element) -> Iterator[Problem]:
    """JSBSim takes `mod` of whole numbers: a divisor below 1 becomes zero, which ends the process."""
    operands = [child for child in element.children if child.tag != "description"]
    divisor = finite(operands[1].text) if len(operands) == 2 and operands[1].tag in ("value", "v") else None
    if divisor is None or divisor < 1.0:
        yield element.problem(
            "can divide by zero, which ends the process", "a divisor <value> of 1 or more, or <fmod>"
        )


def _named(files: ModelFiles) -> dict[str, Element]:
    """The elements that a property of some name stands for."""
    found = {}
    for element in files.elements():
        if element.tag in _NAMED and element.attributes.get("name"):
            for name in _written_out(element.attributes["name"]):
                found[name] = element
    return found


def _written_out(name: str) -> Iterator[str]:
    """The plain names of a property, one for each engine where its number is left open by `#`."""
    for i in range(_MOST_ENGINES if "#" in name else 1):
        yield _plain(name.replace("#", str(i)))


def _plain(name: str) -> str:
    """A name without what makes no difference: a sign, index zero, `//` and `./`."""
    bare = re.sub(r"\[0+\]", "", name.strip().lstrip("-").replace(" ", "-"))
    return posixpath.normpath("/" + bare).lstrip("/")


def _circular(named: Mapping[str, Element]) -> Iterator[Problem]:
    """Each named element that is needed for its own value: JSBSim would work it out without end."""
    needs = {name: [each for each in _needed(element) if each in named] for name, element in named.items()}
    for name, element in named.items():
        way = _way_back(name, needs)
        if way:
            through = f" through {', '.join(way)}" if len(way) < 4 and way[0] != name else ""
            yield element.problem(
                f"reads its own value, {name}{through}"[:200], "a value that does not depend on itself"
            )


def _needed(element: Element) -> Iterator[str]:
    for inside in element.walk():
        if inside.tag in _READ and not inside.children:
            yield from _written_out(inside.text)
        yield from _written_out(inside.attributes.get("apply", "")) if "apply" in inside.attributes else ()


def _way_back(name: str, needs: Mapping[str, list[str]]) -> list[str]:
    """Names by which `name` leads to itself, the last one before it first; none if it does not."""
    came_from: dict[str, str] = {}
    waiting = [name]
    while waiting:
        here = waiting.pop()
        for each in needs[here]:
            if each == name:
                way = [here]
                while way[-1] != name:
                    way.append(came_from[way[-1]])
                return way[:-1] or [name]
            if each not in came_from:
                came_from[each] = here
                waiting.append(each)
    return []


# Sections that JSBSim needs, and the parts of engines, propellers and motors -------------------------------------

_SECTIONS = ("metrics", "mass_balance", "ground_reactions", "aerodynamics")
_THRUSTERS = ("propeller", "nozzle", "rotor", "direct")
_MOTOR_PARTS = ("maxvolts", "velocityconstant", "coilresistance", "noloadcurrent")
_UNITS = {
    "ixx": ("SLUG*FT2", "KG*M2"), "diameter": ("FT", "IN", "M", "CM"), "maxvolts": ("VOLTS",),
    "coilresistance": ("OHMS",), "noloadcurrent": ("AMPERES",),
}  # fmt: skip
"""Units that JSBSim converts, of parts of propellers and motors."""
_PROPELLER_PARTS, _PROPELLER_TABLES = ("ixx", "diameter", "numblades"), ("C_THRUST", "C_POWER")


def incomplete(files: ModelFiles) -> Iterator[Problem]:
    """Sections that JSBSim needs and that are not there, and engines that it cannot make."""
    root = files.root
    if root is None:
        return
    for tag in _SECTIONS:
        if root.first(tag) is None:
            yield root.problem(
                f"has no <{tag}>",
                "a section that JSBSim needs; it may be empty" * (tag == "ground_reactions"),
            )
    for engine in files.inside("propulsion", "engine"):
        yield from _engine(files, engine)
    yield from _parts(files)


def _engine(files: ModelFiles, engine: Element) -> Iterator[Problem]:
    if not _has_one(files, engine, ENGINES):
        yield engine.problem("has no engine", f"its file, with one of {', '.join(ENGINES)}")
    thrusters = files.children(engine, "thruster")
    if not thrusters:
        yield engine.problem("has no <thruster>", "a propeller, nozzle, rotor or direct thruster")
    elif not _has_one(files, thrusters[0], _THRUSTERS):
        yield thrusters[0].problem("has no thruster", f"its file, with one of {', '.join(_THRUSTERS)}")


def _parts(files: ModelFiles) -> Iterator[Problem]:
    """Parts of propellers and motors that JSBSim takes for granted: without a table it ends the process."""
    for element in files.elements():
        if element.tag == "propeller" and element.children:
            yield from _lacking(element, _PROPELLER_PARTS)
            names = [table.attributes.get("name") for table in element.all("table")]
            for name in _PROPELLER_TABLES:
                if names.count(name) != 1:
                    yield element.problem(f"has {names.count(name)} tables {name}", "one")
        elif element.tag == "brushless_dc_motor":
            yield from _lacking(element, _MOTOR_PARTS)


def _lacking(element: Element, tags: tuple[str, ...]) -> Iterator[Problem]:
    for tag in tags:
        part = element.first(tag)
        if part is None:
            yield element.problem(f"has no <{tag}>", "a number that JSBSim needs")
            continue
        unit = part.attributes.get("unit", "")
        if unit and unit not in _UNITS.get(tag, (unit,)):
            yield part.problem(f"has unit={unit!r}", f"one of {', '.join(_UNITS[tag])}")


def _has_one(files: ModelFiles, element: Element, tags: tuple[str, ...]) -> bool:
    """Whether an element has a child with one of these tags, or names a file that is one. Files that are refused count."""
    if "file" in element.attributes and element not in files.content:
        return True  # what is wrong with the file has been said
    return files.described(element, tags) is not None
