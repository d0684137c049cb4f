"""What JSBSim's own models say of their looks, against what those aircraft are."""

from __future__ import annotations

import shutil
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

import jsbsim
import pytest

from testbed.aircraft.conventional_shape import conventional
from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.looks import Looks, looks_of
from testbed.aircraft.shape import Shape

ROOT = Path(jsbsim.get_default_root_dir())


@lru_cache(maxsize=16)
def looks(model: str, engines: int) -> Looks:
    """Of a model of the package, with its engines' files beside it, whose engines are given names."""
    like = load_aircraft("aerosonde").model_dump(exclude_unset=True)
    motor = like["actuators"]["propeller"]
    actuators = {f"engine_{i}": {**motor, "engine": i} for i in range(engines)}
    if not engines:
        actuators = {name: each for name, each in like["actuators"].items() if each["kind"] == "servo"}
    aircraft = Aircraft.model_validate({**like, "model": model, "actuators": actuators})
    with TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "engine", Path(folder, "engine"))
        shutil.copy(ROOT / "aircraft" / model / f"{model}.xml", folder)
        aircraft._folder = Path(folder)
        return looks_of(aircraft)


def drawn(model: str, engines: int = 1) -> Shape:
    seen = looks(model, engines)
    return conventional(seen.span_m, looks=seen)


def wing_height(shape: Shape) -> float:
    return -min(z for panel in shape.panels for _, y, z in panel.points if abs(y) > 0.49 * shape.span_m)


def test_sizes_are_those_of_the_file() -> None:
    """A Cessna 172: 35.8 ft, 174 square feet, its wing 22.9 in above the centre of gravity, wheels that stay out."""
    cessna = looks("c172p", 1)
    assert cessna.span_m == pytest.approx(10.91, abs=0.01) and cessna.wing_m2 == pytest.approx(
        16.17, abs=0.01
    )
    assert cessna.tips[0][2] == pytest.approx(-0.582, abs=0.001) and len(cessna.wheels) == 3
    assert cessna.engines[0].at[0] == pytest.approx(2.0, abs=0.01)
    assert cessna.engines[0].diameter_m == pytest.approx(75 * 0.0254)


def test_a_high_wing_is_above_its_fuselage_and_a_low_one_is_not() -> None:
    high, low = drawn("c172p"), drawn("p51d")
    assert wing_height(high) > 0.9 * high.bodies[0].radius_m > wing_height(low)


def test_a_jet_has_no_blades_and_a_swept_wing() -> None:
    fighter, cessna = drawn("f16"), drawn("c172p")
    assert [propulsor.jet for propulsor in fighter.propulsors] == [True]
    assert [propulsor.jet for propulsor in cessna.propulsors] == [None]

    def swept(shape: Shape) -> float:
        (root, *_), (tip, *_) = shape.panels[0].points[:2]
        return (root - tip) / shape.span_m

    assert swept(fighter) > 0.2 and swept(cessna) == 0.0


def test_engines_are_where_they_are() -> None:
    """A Boeing 737 has its two 193 in from the middle, each in a nacelle."""
    sides = [propulsor.at[1] for propulsor in drawn("737", 2).propulsors]
    assert sides == pytest.approx([-4.902, 4.902], abs=0.001)


def test_a_flying_boat_has_a_hull_and_floats_and_a_glider_is_slender() -> None:
    boat, glider = looks("Short_S23", 4), looks("SGS", 0)
    assert boat.hull and not boat.wheels and not glider.hull and not glider.engines
    assert len(drawn("Short_S23", 4).bodies) == 1 + 3 + 4  # fuselage; hull and two floats; four nacelles
    assert glider.span_m**2 / glider.wing_m2 == pytest.approx(15.1, abs=0.1)


def test_two_wings_are_drawn_for_two_rows_of_tips() -> None:
    heights = {point[2] for panel in drawn("dr1").panels for point in panel.points if abs(point[1]) > 3.0}
    assert len(heights) == 2


def test_of_what_has_no_sizes_a_common_aircraft_is_drawn() -> None:
    assert drawn("mk82", 0).span_m > 0.0 and conventional().panels
