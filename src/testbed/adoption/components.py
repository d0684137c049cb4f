"""What a model's flight-control components say of a surface: its range, its lag and its rate limit."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from dataclasses import dataclass

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
    gain = _number(component.findtext("gain")) if component.tag == "aerosurface_scale" else 1.0
    ends = []
    if component.tag == "aerosurface_scale":
        ends = [_number(component.findtext(f"range/{end}")) for end in ("min", "max")]
        ends = [end * (1.0 if math.isnan(gain) else gain) for end in ends]
    elif component.tag == "kinematic":
        ends = [_number(each.findtext("position")) for each in component.findall("traverse/setting")]
    clips = [_number(component.findtext(f"clipto/{end}")) for end in ("min", "max")]
    return [end for end in (ends or clips) if math.isfinite(end)]


def _number(text: str | None) -> float:
    try:
        return float(text or "nan")
    except ValueError:
        return math.nan


def dynamics_of(tree: ET.Element, name: str, travel: tuple[float, float]) -> Dynamics:
    """Lag and rate limit of the servo that moves a surface: the component that writes it, or one of the scales behind it.

    Args:
        travel: of the surface [rad]: a servo that moves another quantity is taken to cross it in the same time.
    """
    span, found = travel[1] - travel[0], Dynamics()
    frontier = writers(tree, name)
    for _ in range(_DEPTH + 1):
        for component in frontier:
            lag, crossing_s = _lag(component), _crossing_s(component, span)
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


def _lag(component: ET.Element) -> float | None:
    text = component.findtext("lag") if component.tag == "actuator" else None
    value = _number(text)
    return value if math.isfinite(value) else None


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
