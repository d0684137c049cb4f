"""What a model's XML says of a property: which commands it follows, whether any moment depends on it, and of a surface's
position also its range, its lag and its rate limit.

Models name their surfaces as they like. What makes a property a surface's position is that it follows the pilot's controls, and
that the aircraft turns with it. JSBSim's own names of the pilot's controls are the only ones that are known here.
"""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from dataclasses import dataclass

from testbed.aircraft.model_files.numbers import finite

_SCALES = ("aerosurface_scale", "pure_gain", "summer", "fcs_function", "switch", "scheduled_gain")
_DEPTH = 2  # components between the surface and its servo
_RATE_MIN, _RATE_MAX = 0.05, 30.0  # rad/s: outside them a number is no servo's rate
_LAG_MIN, _LAG_MAX = 1.0, 200.0  # rad/s, likewise


@dataclass(frozen=True)
class Dynamics:
    """Of a servo: corner frequency of its lag [rad/s] and its rate limit [rad/s], where the model has them."""

    lag_rad_s: float | None = None
    rate_rad_s: float | None = None


def writers(tree: ET.Element, name: str) -> list[ET.Element]:
    """Components that write a property: by an output, or by their own name."""
    return [each for each in all_components(tree) if name in written(each)]


def all_components(tree: ET.Element) -> list[ET.Element]:
    """The components of all channels."""
    return [component for channel in tree.iter("channel") for component in channel if component.get("name")]


def written(component: ET.Element) -> set[str]:
    """Properties that a component writes."""
    own = component.get("name", "")
    own = own if "/" in own else "fcs/" + re.sub(r"\s+", "-", own.strip().lower())
    return {own, *((each.text or "").strip() for each in component.findall("output"))}


def range_of(tree: ET.Element, name: str) -> tuple[float, float] | None:
    """Lowest and highest value that the components which write a property can give it, if they say so in numbers."""
    ends = [end for component in writers(tree, name) for end in _range(component)]
    return (min(ends), max(ends)) if ends and max(ends) > min(ends) else None


def _range(component: ET.Element) -> list[float]:
    """Ends of a component's output, of its range, stops or settings; empty when it has none in numbers."""
    ends = []
    if component.tag == "aerosurface_scale":
        gain = finite(component.findtext("gain", ""))
        ends = [_number(component.findtext(f"range/{end}")) for end in ("min", "max")]
        ends = [end * (1.0 if gain is None else gain) for end in ends]
    elif component.tag == "kinematic":
        ends = [_number(each.findtext("position")) for each in component.findall("traverse/setting")]
    clips = [_number(component.findtext(f"clipto/{end}")) for end in ("min", "max")]
    return [end for end in (ends or clips) if math.isfinite(end)]


def _number(text: str | None) -> float:
    number = finite(text or "")
    return math.nan if number is None else number


def dynamics_of(tree: ET.Element, name: str, travel: tuple[float, float]) -> Dynamics:
    """Lag and rate limit of the servo that moves a surface: the component that writes it, or one of the scales behind it.

    Args:
        travel: of the surface [rad]: a servo that moves another quantity is taken to cross it in the same time.
    """
    span, found = travel[1] - travel[0], Dynamics()
    frontier = writers(tree, name)
    for _ in range(_DEPTH + 1):
        for component in frontier:
            lag = _number(component.findtext("lag")) if component.tag == "actuator" else None
            crossing_s = _crossing_s(component, span)
            rate = span / crossing_s if crossing_s else None
            found = Dynamics(
                found.lag_rad_s or _within(lag, _LAG_MIN, _LAG_MAX),
                found.rate_rad_s or _within(rate, _RATE_MIN, _RATE_MAX),
            )
        frontier = [
            writer
            for component in frontier
            if component.tag in _SCALES
            for each in component.findall("input")
            for writer in writers(tree, (each.text or "").strip().lstrip("-"))
            if writer is not component
        ]
    return found


def _within(value: float | None, low: float, high: float) -> float | None:
    return value if value is not None and low <= value <= high else None


def _crossing_s(component: ET.Element, span_rad: float) -> float | None:
    """Time in which a component with a rate limit crosses its whole range."""
    if component.tag == "kinematic":
        seconds = sum(
            max(_number(each.findtext("time")), 0.0) for each in component.findall("traverse/setting")
        )
        return seconds if seconds > 0.0 else None
    rate = _number(component.findtext("rate_limit")) if component.tag == "actuator" else math.nan
    if not rate > 0.0:
        return None
    ends = _range(component)
    return (max(ends) - min(ends) if len(ends) == 2 else span_rad) / rate


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
    """The connections of a model that is one tree."""

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
