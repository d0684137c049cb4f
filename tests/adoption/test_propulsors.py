"""Engines of models of the jsbsim package."""

import pytest

from testbed.adoption.controls import find_propulsors
from testbed.adoption.source import engine_files, find_source, package_root, read_whole


def found(model):
    source = find_source(model, package_root())
    return find_propulsors(read_whole(source), source)


@pytest.mark.parametrize(
    ("model", "names"),
    [
        ("c172p", ["engine"]),
        ("c310", ["left_engine", "right_engine"]),
        ("MD11", ["engine_1", "engine_2", "engine_3"]),
        ("SGS", []),
        ("X15", []),
    ],
)
def test_names_follow_from_the_number_and_place_of_the_engines(model, names):
    assert [each.name for each in found(model)] == names


def test_the_left_engine_is_the_one_on_the_left():
    left, right = found("c310")
    assert left.location_m[1] == pytest.approx(-70 * 0.0254) and right.location_m[1] == pytest.approx(
        70 * 0.0254
    )
    assert left.kind == "piston_engine" and left.propeller and left.direction == (1.0, 0.0, 0.0)


def test_an_inclined_thruster_pushes_upwards():
    # its pitch is 1.13 deg
    for each in found("Short_S23"):
        assert each.direction == pytest.approx((0.99980553, 0.0, -0.01972), abs=1e-5)


def test_the_afterburner_that_lights_itself_is_left_out():
    assert [each.throttle for each in found("F4N")] == [(0.0, 0.98)] * 2
    assert [each.throttle for each in found("f16")] == [(0.0, 1.0)], (
        "its throttle for the afterburner is above 1"
    )


def test_a_models_own_engine_comes_before_the_shared_one():
    source = find_source("DHC6", package_root())
    assert {file.parent for file in engine_files(read_whole(source), source)} == {source.folder / "Engines"}
