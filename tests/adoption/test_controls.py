"""Surfaces of models that are not among those of the jsbsim package, made from one that is."""

import math
import re
import xml.etree.ElementTree as ET

import pytest

from testbed.adoption.bench import Bench, write
from testbed.adoption.controls import find_surfaces
from testbed.adoption.source import find_source, package_root, read_whole

SECOND_ELEVATOR = """<channel name="second"><aerosurface_scale name="second"><input>fcs/elevator-cmd-norm</input>
<range><min>-0.3</min><max>0.2</max></range><output>fcs/right-elevator-pos-rad</output></aerosurface_scale></channel>"""


def renamed(tree):
    text = ET.tostring(tree, encoding="unicode")
    for old, new in (
        ("elevator-pos", "flipper-pos"),
        ("left-aileron-pos", "warp-pos"),
        ("rudder-pos", "vane-pos"),
    ):
        text = text.replace(old, new)
    return ET.fromstring(text)


def with_two_elevators(tree):
    for axis in tree.findall("aerodynamics/axis"):
        for function in axis.findall("function"):
            text = ET.tostring(function, encoding="unicode")
            if "fcs/elevator-pos" in text:
                second = ET.fromstring(text.replace("fcs/elevator-pos", "fcs/right-elevator-pos"))
                second.set("name", f"{function.get('name')}-right")
                axis.append(second)
    tree.find("flight_control").append(ET.fromstring(SECOND_ELEVATOR))
    return tree


def without_flight_control(tree):
    for section in [each for each in tree if each.tag in ("flight_control", "autopilot", "system")]:
        tree.remove(section)
    return tree


def with_other_sticks(tree):
    text = re.sub(
        "fcs/(elevator|aileron|rudder)-cmd-norm", r"fcs/my-\1-cmd", ET.tostring(tree, encoding="unicode")
    )
    return ET.fromstring(text)


def found(change, folder):
    """The surfaces of a changed SGS glider, by name."""
    tree = change(read_whole(find_source("SGS", package_root())))
    write(folder, "changed", tree)
    bench = Bench(folder, "changed")
    bench.place(30.0, 1000.0)
    return {each.name: each for each in find_surfaces(tree, bench)}


@pytest.mark.parametrize(
    ("change", "names"),
    [
        (lambda tree: tree, ["elevator", "aileron", "rudder"]),
        (renamed, ["flipper", "warp", "vane"]),
        (with_two_elevators, ["elevator", "right_elevator", "aileron", "rudder"]),
    ],
)
def test_surfaces_have_the_models_names_in_the_order_of_the_sticks(change, names, tmp_path):
    surfaces = found(change, tmp_path)
    assert list(surfaces) == names
    assert not any(each.unlimited for each in surfaces.values())


def test_without_flight_control_the_travel_is_a_default(tmp_path):
    surfaces = found(without_flight_control, tmp_path)
    assert sorted(surfaces) == ["aileron", "elevator", "rudder"]
    for each in surfaces.values():
        assert each.unlimited and each.travel == pytest.approx((-math.radians(20), math.radians(20)))


def test_with_sticks_of_its_own_the_travel_is_that_of_the_components(tmp_path):
    plain, other = found(lambda tree: tree, tmp_path / "plain"), found(with_other_sticks, tmp_path / "other")
    assert sorted(other) == sorted(plain)
    assert other["elevator"].travel == pytest.approx(plain["elevator"].travel, abs=1e-6)
