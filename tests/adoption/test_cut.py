"""The cut model has the aerodynamics of the model: the same forces and moments at the same deflections."""

import numpy as np
import pytest

from testbed.adoption.bench import Bench, write
from testbed.adoption.blocks import cut, prefix_of
from testbed.adoption.controls import find_propulsors, find_surfaces
from testbed.adoption.source import find_source, package_root, read_whole, write_engines
from testbed.adoption.wiring import STICKS

AIRSPEED_M_S, ALTITUDE_M, ALPHA = 60.0, 1000.0, 0.05
FORCES = [f"forces/fb{axis}-aero-lbs" for axis in "xyz"] + [f"moments/{axis}-aero-lbsft" for axis in "lmn"]


def bench_of(folder, model, tree, source):
    write_engines(tree, source, folder)
    write(folder, model, tree)
    bench = Bench(folder, model)
    bench.place(AIRSPEED_M_S, ALTITUDE_M, ALPHA)
    return bench


def whole_and_cut(model, folder):
    """A bench with the model, one with its cut, and the surfaces. The cut one's servos are all but ideal."""
    source = find_source(model, package_root())
    tree = read_whole(source)
    whole = bench_of(folder / "whole", model, tree, source)
    surfaces = find_surfaces(tree, whole)
    adopted = cut(tree, [(each, 190.0, 30.0) for each in surfaces], find_propulsors(tree, source))
    return whole, bench_of(folder / "cut", model, adopted, source), surfaces


@pytest.mark.parametrize("model", ["c172p", "737", "T38", "f16", "SGS", "DHC6"])
def test_equal_deflections_give_equal_forces(model, tmp_path):
    whole, adopted, surfaces = whole_and_cut(model, tmp_path)
    for stick in STICKS.values():
        for position in (0.5, -0.3, 0.0):
            whole[stick] = adopted[stick] = (
                position  # what is no control but listens to the stick, as the f16's flaps
            )
            whole.settle(4.0)
            for each in surfaces:
                reading = next(r for r in each.readings if not r.table and not r.magnitude)
                adopted[f"{prefix_of(each.name)}/command-rad"] = whole[reading.name] / reading.gain
            adopted.settle(4.0)
            expected, got = np.array(whole.reader(FORCES)()), np.array(adopted.reader(FORCES)())
            assert got == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max())


def test_the_models_stick_moves_nothing_after_the_cut(tmp_path):
    _, adopted, _ = whole_and_cut("c172p", tmp_path)
    adopted.settle(2.0)
    before = adopted.reader(FORCES)()
    for stick in STICKS.values():
        adopted[stick] = 0.7
    adopted.settle(1.0)
    assert adopted["fcs/elevator-pos-rad"] > 0.2, "its flight control still runs"
    assert adopted.reader(FORCES)() == pytest.approx(before, rel=1e-9, abs=1e-9)


def test_effectiveness_scales_a_surface(tmp_path):
    _, adopted, _ = whole_and_cut("c172p", tmp_path)
    rolls = {}
    for deflection, effectiveness in ((0.0, 1.0), (0.1, 1.0), (0.1, 0.4), (0.1, 0.0)):
        adopted[f"{prefix_of('aileron')}/command-rad"] = deflection
        adopted[f"{prefix_of('aileron')}/effectiveness"] = effectiveness
        adopted.settle(2.0)
        rolls[deflection, effectiveness] = adopted["moments/l-aero-lbsft"]
    full = rolls[0.1, 1.0] - rolls[0.0, 1.0]
    assert full > 100.0
    assert rolls[0.1, 0.4] - rolls[0.0, 1.0] == pytest.approx(0.4 * full, rel=1e-6)
    assert rolls[0.1, 0.0] == pytest.approx(rolls[0.0, 1.0], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    ("model", "names"),
    [
        ("c172p", ["elevator", "aileron", "rudder"]),
        ("T38", ["elevator", "left_aileron", "right_aileron", "rudder"]),
        ("f16", ["elevator", "aileron", "rudder"]),
        ("f22", ["elevator", "aileron", "rudder", "tvc"]),
    ],
)
def test_the_surfaces_of_a_model(model, names, tmp_path):
    _, _, surfaces = whole_and_cut(model, tmp_path)
    assert sorted(each.name for each in surfaces) == sorted(names)


def test_travel_is_what_the_model_says(tmp_path):
    _, _, surfaces = whole_and_cut("c172p", tmp_path)
    travel = {each.name: np.degrees(each.travel) for each in surfaces}
    assert travel["elevator"] == pytest.approx([-28, 23], abs=0.01)  # its <range>, with a gain of 0.01745
    assert travel["aileron"] == pytest.approx([-20, 15], abs=0.01)
    assert travel["rudder"] == pytest.approx([-16, 16], abs=0.01)
