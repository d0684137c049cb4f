"""Let a JSBSim model feel air that rotates: JSBSim gives it only the rotation of its own turbulence, which nobody can write.

Within <aerodynamics> the properties of the rates relative to the air are replaced by functions that subtract a rotation that can
be written. Without rotation the model computes the same bits.
"""

from __future__ import annotations

from xml.etree import ElementTree

RATES = {f"velocities/{axis}-aero-rad_sec": f"testbed/{axis}-aero-rad_sec" for axis in "pqr"}
"""JSBSim's rate relative to the air, and that which takes its place."""
ROTATION = tuple(f"testbed/{axis}-gust-rad_sec" for axis in "pqr")
"""Rotation of the air about the body axes [rad/s]."""


def put_rotation(root: ElementTree.Element) -> None:
    """Change the tree of a model's own file. Aerodynamics in another file do not feel the rotation."""
    section = root.find("aerodynamics")
    if section is None or section.get("file"):
        return
    for element in section.iter("property"):
        name = (element.text or "").strip()
        element.text = RATES.get(name, element.text)
    rates = [_difference(*rate, gust) for rate, gust in zip(RATES.items(), ROTATION, strict=True)]
    for element in reversed([*map(_declared, ROTATION), *rates]):
        section.insert(0, element)


def _declared(name: str) -> ElementTree.Element:
    element = ElementTree.Element("property", value="0")
    element.text = name
    return element


def _difference(theirs: str, ours: str, gust: str) -> ElementTree.Element:
    function = ElementTree.Element("function", name=ours)
    difference = ElementTree.SubElement(function, "difference")
    for name in (theirs, gust):
        ElementTree.SubElement(difference, "property").text = name
    return function
