"""Functions of a model that can end the process in flight, also in a branch that the few steps of a first load do not reach."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping

from testbed.aircraft.model_files.numbers import finite
from testbed.aircraft.model_files.safe_xml import Element
from testbed.aircraft.model_files.used import ModelFiles
from testbed.inputs.problems import Problem

_NAMED = ("function", "table")
"""Elements whose `name` is a property that is worked out anew whenever it is read."""
_READ = ("property", "p", "independentVar")
_MOST_ENGINES = 8
"""Engines for which a name with `#`, their number, is written out."""
Named = Mapping[str, Element]


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


def _named(files: ModelFiles) -> Named:
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


def _circular(named: Named) -> Iterator[Problem]:
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
                return _trace(here, name, came_from)
            if each not in came_from:
                came_from[each] = here
                waiting.append(each)
    return []


def _trace(last: str, name: str, came_from: Mapping[str, str]) -> list[str]:
    way = [last]
    while way[-1] != name:
        way.append(came_from[way[-1]])
    return way[:-1] or [name]
