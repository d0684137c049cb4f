"""Changes to the truth of an aircraft: made in JSBSim as asked, refused where there is no such part, unknown to the controller."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from testbed.aircraft.changes import ChangedAircraft, load_with_changes, put_rotation
from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.inputs.problems import BadInput
from testbed.plant.identification import stored
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import accelerations, trim, trimmed_start
from testbed.scenario.load import dump, load_scenario
from testbed.simulation.assembly import _setup, assemble
from testbed.simulation.check import start_of

SLUG_KG, INCH_M = 14.59390294, 0.0254
LEVEL = {"airspeed": 18.0, "altitude": 300.0, "alpha": 0.03, "pitch": 0.03}
TAIL = "scenarios/left_tail_fail.yaml"


def changed(**changes: Any) -> Aircraft:
    return load_with_changes(ChangedAircraft(name="vtail", **changes))


def test_mass_is_that_asked_for(vtail: Aircraft) -> None:
    """With the ruddervators, which are masses of their own; the radii of gyration of the rest do not change."""
    heavy, nominal = Plant(changed(mass_kg=6.0), 200), Plant(vtail, 200)
    for plant in (heavy, nominal):
        trim(plant, 18.0, 300.0)
    assert heavy["inertia/mass-slugs"] * SLUG_KG == pytest.approx(6.0, rel=1e-6)
    ratio = heavy["inertia/iyy-slugs_ft2"] / nominal["inertia/iyy-slugs_ft2"]
    assert ratio == pytest.approx(1.0 + (0.327 - 0.046) / 0.327 * 1.0 / 4.95, abs=2e-3), (
        "0.046 kg m2 of ruddervators stay"
    )
    assert heavy["inertia/cg-x-in"] == pytest.approx(nominal["inertia/cg-x-in"], abs=1e-9)


def test_the_centre_of_gravity_moves_as_asked(vtail: Aircraft) -> None:
    shifted, nominal = (
        Plant(changed(cg_shift_x_m=0.02, cg_shift_y_m=-0.01, cg_shift_z_m=0.005), 200),
        Plant(vtail, 200),
    )
    for plant in (shifted, nominal):
        plant.place({"airspeed": 18.0, "alpha": 0.05, "altitude": 300.0, "pitch": 0.05})
    moved = [(shifted[f"inertia/cg-{a}-in"] - nominal[f"inertia/cg-{a}-in"]) * INCH_M for a in "xyz"]
    np.testing.assert_allclose(moved, [0.02, -0.01, 0.005], atol=1e-9)
    assert shifted["inertia/mass-slugs"] == pytest.approx(nominal["inertia/mass-slugs"], rel=1e-12)


def test_a_coefficient_is_multiplied_and_no_other(vtail: Aircraft) -> None:
    state = {"airspeed": 18.0, "alpha": 0.05, "altitude": 300.0, "pitch": 0.05, "q": 0.5}
    values = []
    for aircraft in (changed(coefficients={"Cm_q": 0.5}), vtail):
        plant = Plant(aircraft, 200)
        accelerations(plant, state, [0.0, 0.0, 0.5, 0.5])
        names = [name for name in plant.catalog() if name.startswith("aero/coefficient/")]
        values.append({name: plant[name] for name in names})
    ours, theirs = values
    assert ours.pop("aero/coefficient/Cm_q") == pytest.approx(
        0.5 * theirs.pop("aero/coefficient/Cm_q"), rel=1e-12
    )
    assert ours == pytest.approx(theirs, rel=1e-12)


def test_the_files_stay_as_they_are(vtail: Aircraft) -> None:
    before = {file: file.read_bytes() for file in vtail.folder.rglob("*") if file.is_file()}
    Plant(changed(mass_kg=6.0), 200)
    assert {file: file.read_bytes() for file in vtail.folder.rglob("*") if file.is_file()} == before


def test_each_change_is_another_aircraft_to_every_cache(vtail: Aircraft) -> None:
    prints = [
        a.fingerprint()
        for a in (vtail, changed(mass_kg=5.1), changed(mass_kg=5.2), changed(coefficients={"Cm_q": 1.1}))
    ]
    assert len(set(prints)) == 4
    assert changed(mass_kg=5.1).nominal.fingerprint() == prints[0]
    assert load_with_changes(ChangedAircraft(name="vtail")).fingerprint() == prints[0], "nothing is changed"


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"coefficients": {"Cm_qq": 1.1}}, "vtail has no aerodynamic function of this name, did you mean Cm_q?"),
        ({"mass_kg": 0.04}, "mass_kg: is 0.04, expected more than 0.05 kg"),
        ({"mass_kg": 5000.0}, "mass_kg: is 5000, expected no more than 100 times the 5 kg"),
    ],
)  # fmt: skip
def test_what_cannot_be_changed_is_refused(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(BadInput) as error:
        changed(**changes)
    assert words in str(error.value)


def test_a_model_with_its_mass_in_another_file_is_refused(vtail: Aircraft, tmp_path: Path) -> None:
    folder = tmp_path / "vtail"
    shutil.copytree(vtail.folder, folder)
    model = folder / "vtail.xml"
    text = model.read_text()
    start, end = text.index("  <mass_balance>"), text.index("</mass_balance>") + len("</mass_balance>")
    (folder / "mass.xml").write_text(text[start:end].strip())
    model.write_text(text[:start] + '<mass_balance file="mass"/>' + text[end:])
    with pytest.raises(BadInput, match=r"vtail\.xml has no mass_balance with emptywt of its own to change"):
        load_with_changes(ChangedAircraft(name=str(folder), mass_kg=5.5))


def test_a_problem_has_its_place_in_the_scenario() -> None:
    with pytest.raises(BadInput) as error:
        load_scenario(TAIL, ["aircraft.coefficients.Cm_qq=1"])
    assert str(error.value).startswith(
        "--set aircraft.coefficients.Cm_qq=1: aircraft.coefficients.Cm_qq: vtail has no"
    )


def test_a_flight_begins_in_the_true_trim_and_the_controller_knows_the_nominal_one(vtail: Aircraft) -> None:
    parts = assemble(load_scenario(TAIL, ["aircraft.mass_kg=6"]))
    nominal = assemble(load_scenario(TAIL))
    parts.plant.step()
    assert abs(parts.plant["accelerations/wdot-ft_sec2"]) < 1e-2, "steady although heavier"
    here, there = (p.plant["aero/alpha-rad"] for p in (parts, nominal))
    assert here > there + 0.01, "more lift"
    assert stored(parts.aircraft.nominal) == stored(vtail)
    told = [
        _setup(p.scenario, p.aircraft, trimmed_start(p.aircraft, *start_of(p.scenario)))
        for p in (parts, nominal)
    ]
    assert told[0].trim_pitch == told[1].trim_pitch
    assert told[0].trim_commands == told[1].trim_commands


def test_a_changed_aircraft_is_written_out_and_read_again() -> None:
    scenario = load_scenario(TAIL, ["aircraft.mass_kg=5.5", "aircraft.coefficients.Cm_q=0.9"])
    assert "mass_kg: 5.5" in dump(scenario)
    assert str(scenario.aircraft) == "vtail with mass_kg 5.5, coefficients {'Cm_q': 0.9}"
    assert load_scenario(TAIL).aircraft == "vtail"


# Air that rotates: the same bits without rotation, and as if the aircraft rotated the other way with it ------------


def in_air(rotating_air: bool, name: str = "vtail") -> Plant:
    made = Plant(load_aircraft(name), 200, 1, rotating_air)
    made.place(LEVEL)
    return made


@pytest.mark.parametrize("name", ["vtail", "aerosonde"])
def test_without_rotation_nothing_changes(name: str) -> None:
    one, other = in_air(False, name), in_air(True, name)
    for _ in range(200):
        one.step()
        other.step()
    assert one.read().tobytes() == other.read().tobytes()


def moments_in(gust: dict[str, float], **own: float) -> np.ndarray:
    """[3] aerodynamic moments in air that rotates, for an aircraft that rotates [lbf ft]."""
    made = in_air(True)
    made.place({**LEVEL, **own})
    made.blow([0.0, 0.0, 0.0, *(gust.get(rate, 0.0) for rate in "pqr")])
    made.settle(1)
    return np.array([made[f"moments/{m}-aero-lbsft"] for m in "lmn"])


@pytest.mark.parametrize("rate", ["p", "r"])
def test_rotating_air_acts_as_rotation_the_other_way(rate: str) -> None:
    still, gust, turning = moments_in({}), moments_in({rate: -0.2}), moments_in({}, **{rate: 0.2})
    np.testing.assert_allclose(gust - still, turning - still, rtol=1e-3, atol=1e-6)
    assert np.max(np.abs(gust - still)) > 0.01
    np.testing.assert_allclose(moments_in({rate: 0.2}, **{rate: 0.2}), still, atol=1e-4)


def test_air_that_rotates_nose_up_lifts_the_nose() -> None:
    """It is as if the aircraft rotated nose down, but for the moment of the rate of alpha, which is its own."""
    still, up, down = (moments_in({"q": rate}) for rate in (0.0, 0.2, -0.2))
    assert up[1] - still[1] > 0.1
    assert up[1] - still[1] == pytest.approx(still[1] - down[1], rel=1e-6)


def test_a_model_with_no_aerodynamics_of_its_own_stays_as_it_is() -> None:
    for text in ("<fdm_config/>", '<fdm_config><aerodynamics file="a"/></fdm_config>'):
        root = ElementTree.fromstring(text)
        before = ElementTree.tostring(root)
        put_rotation(root)
        assert ElementTree.tostring(root) == before
