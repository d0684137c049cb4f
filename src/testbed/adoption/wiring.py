"""What a model's XML says of a property: which commands it follows, and whether any moment depends on it.

Models name their surfaces as they like. What makes a property a surface's position is that it follows the pilot's controls, and
that the aircraft turns with it. JSBSim's own names of the pilot's controls are the only ones that are known here.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable

from testbed.adoption.components import all_components, written

STICKS = {"pitch": "fcs/elevator-cmd-norm", "roll": "fcs/aileron-cmd-norm", "yaw": "fcs/rudder-cmd-norm"}
"""JSBSim's own properties of the pilot's controls."""
POSITIONS = ("elevator", "left-aileron", "right-aileron", "rudder")
"""Beginnings, below `fcs/`, of the positions that JSBSim itself has for these controls."""
READERS = ("property", "p", "independentVar")
"""Tags of what a function reads."""

_MOMENTS = ("ROLL", "PITCH", "YAW")
_NAMES = re.compile(r"[A-Za-z_][\w.\-\[\]]*(?:/[\w.\-\[\]]+)+")


def bare(text: str | None) -> str:
    """A property's name without sign and without the index of the first of several."""
    return (text or "").strip().lstrip("-").removesuffix("[0]")


class Wiring:
    """The connections of one model.

    Args:
        tree: the model, in one tree.
    """

    def __init__(self, tree: ET.Element) -> None:
        self._sources: dict[str, set[str]] = {}
        for component in all_components(tree):
            for name in written(component):
                self._sources.setdefault(name, set()).update(_named_in(component))
        self._turning = _read_by_moments(tree)

    def turns(self, names: Iterable[str]) -> bool:
        """Whether a moment depends on one of these properties: those of flaps or brakes may change lift and drag alone."""
        return not self._turning.isdisjoint(names)

    def follows(self, names: Iterable[str], commands: Iterable[str]) -> bool:
        """Whether one of the properties depends on one of the commands, through any number of components."""
        wanted, seen, waiting = set(commands), set[str](), list(names)
        while waiting:
            name = waiting.pop()
            if name in wanted:
                return True
            if name not in seen:
                seen.add(name)
                waiting += self._sources.get(name, ())
        return False


def _named_in(component: ET.Element) -> set[str]:
    """Properties that a component names other than as its output, in its elements or in the conditions of a switch."""
    texts = [element.text or "" for element in component.iter() if element.tag != "output"]
    texts += [element.get("value", "") for element in component.iter()]
    return {bare(name) for text in texts for name in _NAMES.findall(text)}


def _read_by_moments(tree: ET.Element) -> set[str]:
    """Properties that moments read, themselves or through other functions; so does every external reaction."""
    functions = {each.get("name", ""): _read(each) for each in tree.findall("aerodynamics//function")}
    found = set[str]().union(*(_read(each) for each in tree.findall("external_reactions")))
    for axis in tree.findall("aerodynamics/axis"):
        if axis.get("name", "").upper() in _MOMENTS:
            found |= _read(axis)
    waiting = list(found)
    while waiting:
        more = functions.get(waiting.pop(), set()) - found
        found |= more
        waiting += more
    return found


def _read(element: ET.Element) -> set[str]:
    return {bare(each.text) for each in element.iter() if each.tag in READERS}
