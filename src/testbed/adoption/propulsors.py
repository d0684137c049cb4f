"""The engines of a model: their files, kinds, places and names."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from testbed.adoption.source import Source, found_in, parsed
from testbed.aircraft.changes import place_of
from testbed.common.writing import write_new
from testbed.inputs.problems import BadInput, Problem

PISTON, TURBINE = "piston_engine", "turbine_engine"
ELECTRIC = ("electric_engine", "brushless_dc_motor")
ADOPTED = {
    PISTON: "piston engine", "turboprop_engine": "turboprop", TURBINE: "turbine", **dict.fromkeys(ELECTRIC, "electric engine"),
}  # fmt: skip
"""Kinds of engine, by the first tag of their files, that become actuators, in words. A rocket stays off."""


@dataclass(frozen=True)
class Propulsor:
    """One engine with its propeller or jet.

    Attributes:
        name: of the actuator.
        number: of the engine in JSBSim.
        kind: first tag of its file.
        propeller: whether its thruster is a propeller.
        location_m: [3] of its thruster, in JSBSim's structural frame.
        direction: [3] of its thrust, in body axes.
        throttle: lowest and highest throttle, without the afterburner, with which thrust would jump.
    """

    name: str
    number: int
    kind: str
    propeller: bool
    location_m: tuple[float, float, float]
    direction: tuple[float, float, float]
    throttle: tuple[float, float] = (0.0, 1.0)


def find_propulsors(tree: ET.Element, source: Source) -> list[Propulsor]:
    """The engines that can be actuators, in JSBSim's order; raises BadInput when a file of one is missing."""
    found = []
    for number, engine in enumerate(tree.findall("propulsion/engine")):
        thruster = engine.find("thruster")
        if thruster is None:
            raise BadInput([Problem(f"its engine {number} has no <thruster>", str(source.file))])
        contents = parsed(file_of(engine, source))
        if contents.tag not in ADOPTED:
            continue
        propeller = parsed(file_of(thruster, source)).tag == "propeller"
        own = thruster.find("location")
        x, y, z = map(float, place_of(engine.find("location") if own is None else own))
        found.append(
            Propulsor(
                "engine",
                number,
                contents.tag,
                propeller,
                (x, y, z),
                _direction(thruster),
                _throttle(contents),
            )
        )
    return _named(found)


def engine_files(tree: ET.Element, source: Source) -> list[Path]:
    """Files of all engines and thrusters, each once."""
    named = [each for each in tree.iter() if each.tag in ("engine", "thruster") and each.get("file")]
    return list(dict.fromkeys(file_of(each, source) for each in named))


def write_engines(tree: ET.Element, source: Source, folder: Path) -> None:
    """Copy those files into `Engines` in a model's new folder."""
    (folder / "Engines").mkdir(parents=True)
    for file in engine_files(tree, source):
        write_new(folder / "Engines" / file.name, file.read_bytes())


def file_of(element: ET.Element, source: Source) -> Path:
    """The file of an engine or thruster, where JSBSim looks for it; raises BadInput when there is none."""
    folder = source.folder
    places = (folder / "Engines", folder / "engine", folder, source.root / "engine")
    return found_in(places, element.get("file", ""), source)


def _direction(thruster: ET.Element) -> tuple[float, float, float]:
    """Direction of thrust from the thruster's pitch and yaw: nose up is a thrust upwards, -z."""
    orient = thruster.find("orient")
    if orient is None:
        return 1.0, 0.0, 0.0
    scale = math.radians(1.0) if orient.get("unit", "RAD").upper() == "DEG" else 1.0
    pitch, yaw = (scale * float(orient.findtext(axis) or 0.0) for axis in ("pitch", "yaw"))
    direction = np.array([math.cos(pitch) * math.cos(yaw), math.cos(pitch) * math.sin(yaw), -math.sin(pitch)])
    x, y, z = map(float, np.where(np.abs(direction) < 1e-12, 0.0, direction))
    return x, y, z


def _throttle(engine: ET.Element) -> tuple[float, float]:
    """JSBSim lights an afterburner of method 1 above a throttle of 0.99; one of method 2 is above 1."""
    lights_itself = int(float(engine.findtext("augmethod") or 0)) == 1
    return 0.0, 0.98 if lights_itself else 1.0


def _named(found: list[Propulsor]) -> list[Propulsor]:
    """One is `engine`, two are left and right, more are numbered from the left, as pilots number them."""
    from_left = sorted(range(len(found)), key=lambda i: (found[i].location_m[1], found[i].number))
    names = ["engine"] if len(found) == 1 else [f"engine_{i + 1}" for i in range(len(found))]
    if len(found) == 2 and found[from_left[0]].location_m[1] < found[from_left[1]].location_m[1]:
        names = ["left_engine", "right_engine"]
    by_index = dict(zip(from_left, names, strict=True))
    return [replace(each, name=by_index[i]) for i, each in enumerate(found)]
