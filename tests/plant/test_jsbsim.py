"""JSBSim behind one door: units, properties, wind, steps, and what is said of a model that cannot be loaded."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.common.signals import STATE
from testbed.inputs.problems import BadInput
from testbed.plant.first_load import property_catalog
from testbed.plant.jsbsim import NoProperty, Plant, opened
from testbed.plant.trim import Trim, begin_at

HZ = 200
STATE_PLACED = {
    "airspeed": 17.0, "altitude": 321.0, "alpha": 0.06, "beta": -0.04,
    "roll": 0.3, "pitch": 0.1, "heading": 2.0, "p": 0.2, "q": -0.1, "r": 0.05,
}  # fmt: skip


def signals(plant: Plant) -> dict[str, float]:
    return dict(zip(STATE, plant.read(), strict=False))


# Loading ----------------------------------------------------------------------------------------------------------


def test_no_warning_when_loaded(vtail: Aircraft) -> None:
    assert opened(vtail.folder, vtail.model, HZ)[1] == []


def test_a_warning_would_be_seen(vtail_copy: Path) -> None:
    """The negative control: a property declared twice."""
    line = '<property value="1">fcs/left-ruddervator/effectiveness</property>'
    text = (vtail_copy / "vtail.xml").read_text()
    assert line in text
    (vtail_copy / "vtail.xml").write_text(text.replace(line, line + line))
    (warning,) = opened(vtail_copy, "vtail", HZ)[1]
    assert "already defined" in warning


@pytest.mark.parametrize("text", ["", "no XML", "<fdm_config name='x' version='2.0' release='BETA'/>"])
def test_a_broken_model_is_bad_input_at_its_file(vtail_copy: Path, text: str) -> None:
    (vtail_copy / "vtail.xml").write_text(text)
    with pytest.raises(BadInput, match=r"vtail\.xml:1: "):
        Plant(load_aircraft(str(vtail_copy)), HZ)


# Reading and writing ----------------------------------------------------------------------------------------------


def test_what_is_placed_is_read(vtail: Aircraft) -> None:
    """In SI and radians, by the names of `signals.STATE`; the rest follows from it."""
    plant = Plant(vtail, HZ)
    plant.place(STATE_PLACED)
    now = signals(plant)
    for name, value in STATE_PLACED.items():
        assert now[name] == pytest.approx(value, abs=1e-6), name
    assert (now["north"], now["east"]) == pytest.approx((0.0, 0.0), abs=1e-6)
    a, b, roll, pitch = (STATE_PLACED[n] for n in ("alpha", "beta", "roll", "pitch"))
    climb = (
        math.cos(a) * math.cos(b) * math.sin(pitch)
        - math.sin(b) * math.sin(roll) * math.cos(pitch)
        - math.sin(a) * math.cos(b) * math.cos(roll) * math.cos(pitch)
    )
    assert now["climb_rate"] == pytest.approx(17.0 * climb, abs=1e-3)


def test_position_is_in_metres(vtail: Aircraft, level: Trim) -> None:
    """Ten seconds of level flight to the east at 18 m/s; the Earth is round, hence the centimetres."""
    plant = Plant(vtail, HZ)
    begin_at(plant, level)
    for _ in range(10 * HZ):
        plant.step()
    now = signals(plant)
    assert now["east"] == pytest.approx(180.0, abs=0.1)
    assert now["north"] == pytest.approx(0.0, abs=0.1)


def test_a_row_has_positions_and_effectiveness(vtail: Aircraft, level: Trim) -> None:
    plant = Plant(vtail, HZ)
    begin_at(plant, level)
    plant["fcs/right-propeller/effectiveness"] = 0.25
    row = plant.read()
    n = len(STATE)
    assert len(row) == n + 8
    assert row[n : n + 4] == pytest.approx(level.positions, rel=1e-6)
    assert list(row[n + 4 :]) == [1.0, 1.0, 1.0, 0.25]
    assert plant.position(0) == pytest.approx(math.radians(level.positions[0]), rel=1e-6)
    assert plant.position(2) == pytest.approx(level.positions[2], rel=1e-6)


def test_an_unknown_property_is_not_created(vtail: Aircraft) -> None:
    plant = Plant(vtail, HZ)
    for use in (plant.getter, plant.setter, plant.__getitem__):
        with pytest.raises(NoProperty, match=r"vtail\.xml: has no property fcs/no-such-property"):
            use("fcs/no-such-property")
    assert "fcs/no-such-property" not in plant.catalog()


def test_the_catalog_says_what_can_be_written(vtail: Aircraft) -> None:
    known = property_catalog(vtail)
    assert known["fcs/left-ruddervator/effectiveness"] is True
    assert known["velocities/vt-fps"] is False
    assert known == Plant(vtail, HZ).catalog()


# Steps ------------------------------------------------------------------------------------------------------------


def test_a_control_step_is_so_many_physics_steps(vtail: Aircraft, level: Trim) -> None:
    """Two control steps of five physics steps each are ten physics steps, to the last bit."""
    rows = []
    for substeps in (1, 5):
        plant = Plant(vtail, 1000, substeps)
        begin_at(plant, level)
        for _ in range(10 // substeps):
            plant.step()
        rows.append(plant.read())
    assert rows[0].tobytes() == rows[1].tobytes()


def test_settling_moves_servos_and_rotors_but_not_the_airframe(vtail: Aircraft, level: Trim) -> None:
    plant = Plant(vtail, HZ)
    plant.command([0.1, -0.1, 0.9, 0.5])
    plant.place(level.state)
    before = signals(plant)
    plant.settle(300)
    after = signals(plant)
    assert [plant.position(0), plant.position(1)] == pytest.approx([0.1, -0.1], abs=1e-6)
    for name in ("altitude", "airspeed", "roll", "pitch", "p", "q", "r"):
        assert after[name] == pytest.approx(before[name], abs=1e-9), name
    plant.step()
    assert signals(plant)["p"] != before["p"], "and afterwards it moves again"


# Air --------------------------------------------------------------------------------------------------------------


def test_a_placed_aircraft_moves_with_the_wind(vtail: Aircraft) -> None:
    """Airspeed, alpha and beta stay those asked for; the velocity over the ground has the wind added."""
    plant = Plant(vtail, HZ)
    plant.set_wind(np.array([4.0, -3.0, 1.0]))
    plant.place(STATE_PLACED)
    now = signals(plant)
    for name in ("airspeed", "alpha", "beta"):
        assert now[name] == pytest.approx(STATE_PLACED[name], abs=1e-9), name
    assert plant.total_wind() == pytest.approx((4.0, -3.0, 1.0), abs=1e-9)
    calm = Plant(vtail, HZ)
    calm.place(STATE_PLACED)
    assert now["climb_rate"] == pytest.approx(signals(calm)["climb_rate"] - 1.0, abs=1e-3)
    expected = [STATE_PLACED[n] for n in ("airspeed", "alpha", "beta", "roll", "pitch", "heading")]
    assert plant.air_data() == pytest.approx(expected, abs=1e-9)


def test_specific_force_of_steady_flight_is_gravity(vtail: Aircraft, level: Trim) -> None:
    """At rest in the air an accelerometer along x reads g sin(pitch), along z -g cos(pitch)."""
    plant = Plant(vtail, HZ)
    begin_at(plant, level)
    plant.settle(1)  # forces of the placed state
    pitch = level.state["pitch"]
    assert plant.specific_force_reader("x")() == pytest.approx(9.80665 * math.sin(pitch), rel=1e-2)
    assert plant.specific_force_reader("z")() == pytest.approx(-9.80665 * math.cos(pitch), rel=1e-2)
