"""Put the blocks into a model: the aerodynamics and engines then follow the blocks, no longer the model's flight control."""

from __future__ import annotations

import copy
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping

from testbed.adoption.blocks import engine_block, engine_losses, read_as, servo_block
from testbed.adoption.controls import Surface, places_read
from testbed.adoption.propulsors import Propulsor
from testbed.adoption.source import FOREIGN
from testbed.adoption.wiring import bare


def cut(
    tree: ET.Element,
    surfaces: Iterable[tuple[Surface, float, float]],
    propulsors: Iterable[Propulsor],
) -> ET.Element:
    """A new model with the blocks.

    Args:
        surfaces: each with its servo's lag and rate limit [rad/s].
    """
    tree = copy.deepcopy(tree)
    control = _section(tree, "flight_control")
    for surface, lag, rate in surfaces:
        _add(control, *servo_block(surface, lag, rate))
        _rename(tree, {each.name: read_as(surface, each) for each in surface.readings})
    for propulsor in propulsors:
        _add(control, *engine_block(propulsor, _heard_as(tree, propulsor)))
        _section(tree, "external_reactions").extend(engine_losses(propulsor))
    return tree


def _section(tree: ET.Element, tag: str) -> ET.Element:
    """The model's section of this tag, made where there is none; of several the last, which runs last."""
    found = tree.findall(tag)
    if found:
        return found[-1]
    section = ET.Element(tag, {"name": "adopted"} if tag == "flight_control" else {})
    aerodynamics = next((i for i, each in enumerate(tree) if each.tag == "aerodynamics"), len(tree))
    tree.insert(aerodynamics, section)
    return section


def _add(control: ET.Element, values: Mapping[str, float], channel: ET.Element) -> None:
    """Append a block: its channel runs after all of the model's own."""
    for name, value in values.items():
        ET.SubElement(control, "property", {"value": f"{value:.9g}"}).text = name
    control.append(channel)


def _rename(tree: ET.Element, new_names: Mapping[str, str]) -> None:
    for name, element in list(places_read(tree)):
        if name in new_names:
            sign = "-" if (element.text or "").strip().startswith("-") else ""
            element.text = sign + new_names[bare(element.text)]


def _heard_as(tree: ET.Element, propulsor: Propulsor) -> list[str]:
    """FlightGear's names of this engine's throttle that the model reads."""
    index = f"[{propulsor.number}]" if propulsor.number else ""
    names = {f"{FOREIGN}controls/engines/engine{i}/throttle" for i in (index, f"[{propulsor.number}]")}
    declared = {(each.text or "").strip() for each in tree.iter("property")}
    return sorted(names & declared)


def set_property(tree: ET.Element, name: str, value: float) -> None:
    """Change the value of a property that the model declares."""
    for element in tree.iter("property"):
        if element.text == name:
            element.set("value", f"{value:.9g}")
