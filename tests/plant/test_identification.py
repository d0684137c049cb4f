"""The identified model is that of the aircraft's files; one of other files is not used."""

from __future__ import annotations

import json
import math
import shutil
from pathlib import Path

import numpy as np
import pytest
from command_line import ROOT
from hostile_models import MODEL, replaced, vtail_at

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, PRODUCTS, ROWS, DesignModel, load_design_model
from testbed.inputs.problems import BadInput
from testbed.plant.identification import identify, stored
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import accelerations, trim


@pytest.fixture
def minimal_copy(tmp_path: Path) -> Path:
    return Path(shutil.copytree(ROOT / "examples" / "minimal", tmp_path / "minimal"))


@pytest.fixture(scope="module")
def model(vtail: Aircraft) -> DesignModel:
    return identify(vtail)


def test_the_stored_design_model_is_of_this_aircraft(vtail: Aircraft, model: DesignModel) -> None:
    """Identified anew it is the same to 1e-9; not to the bit, as a solver's last digits may depend on the machine."""
    kept = load_design_model(vtail.folder / DESIGN_MODEL)
    assert kept.identified_from == vtail.fingerprint(), "run `testbed identify vtail`"
    assert model.agrees_with(kept)
    assert stored(vtail) == kept


def test_an_actuator_that_does_not_move_is_named(tmp_path: Path) -> None:
    """The tail's block reads the command of the other one, which the identification holds still."""
    folder = vtail_at(tmp_path)
    command = "<product><property>fcs/left-ruddervator/command-rad"
    replaced(MODEL, command, command.replace("left", "right"))(folder)
    with pytest.raises(
        BadInput, match=r"vtail\.yaml:\d+: actuators\.left_ruddervator: .* does not follow its command"
    ):
        identify(load_aircraft(str(folder)))


def test_it_predicts_what_the_aircraft_does(vtail: Aircraft, model: DesignModel) -> None:
    """Beside the trim: half a degree of alpha, of sideslip and of each tail, 10 deg/s of roll, 0.3 N of one propeller.

    Rates within 1 % of the change, or 0.02 where there is none: what is not linear.
    """
    plant = Plant(vtail, 200)
    level = trim(plant, 18.0, 300.0)
    state = {**level.state, "alpha": level.state["alpha"] + 0.008, "beta": 0.008, "p": 0.17}
    commands = [
        level.commands[0] + 0.01,
        level.commands[1] - 0.005,
        level.commands[2] + 0.03,
        level.commands[3],
    ]
    flown = accelerations(plant, state, commands)[[3, 4, 5, 0, 1, 2]]
    positions = [plant.position(i) for i in range(4)]
    predicted = model.rates({"q": 0.0, "r": 0.0, **state}, positions, np.ones(4))
    for row, truth, found in zip(ROWS, flown, predicted, strict=True):
        assert found == pytest.approx(truth, rel=0.02, abs=0.03), row
    assert np.abs(flown[:3]).min() > 0.1, "each axis is moved"


def test_the_gyroscopic_moments_are_those_of_the_truth() -> None:
    """Second differences of the truth by each pair of rates. The Aerosonde's products of inertia are not zero."""
    aerosonde = load_aircraft("aerosonde")
    plant = Plant(aerosonde, 200)
    level = trim(plant, aerosonde.reference.airspeed_m_s, aerosonde.reference.altitude_m)

    def moments(one: str, other: str, sign: float) -> np.ndarray:
        rates = {"p": 0.0, "q": 0.0, "r": 0.0}
        rates[one] += 0.1
        rates[other] += 0.1 * sign
        both = [{axis: way * rate for axis, rate in rates.items()} for way in (1.0, -1.0)]
        flown = [accelerations(plant, {**level.state, **each}, level.commands)[3:] for each in both]
        return np.asarray(flown[0] + flown[1])

    model = load_design_model(aerosonde.folder / DESIGN_MODEL)
    for (one, other), predicted in zip(PRODUCTS, np.transpose(model.gyroscopic), strict=True):
        size = 0.08 if one == other else 0.04
        differences = (moments(one, other, 1.0) - moments(one, other, -1.0)) / size
        assert differences == pytest.approx(predicted, abs=1e-3), (one, other)


def test_without_a_stored_model_it_is_identified(vtail_copy: Path, model: DesignModel) -> None:
    (vtail_copy / DESIGN_MODEL).unlink()
    assert stored(load_aircraft(str(vtail_copy))).agrees_with(model)


def test_a_model_of_other_files_is_not_used(vtail_copy: Path, model: DesignModel) -> None:
    """The aircraft's XML was edited since: its own model is found, not the one that lies there."""
    file = vtail_copy / "vtail.xml"
    text = file.read_text()
    assert text.count("<emptywt") == 1
    file.write_text(text.replace('<emptywt unit="KG">4', '<emptywt unit="KG">5'))
    found = stored(load_aircraft(str(vtail_copy)))
    assert not found.agrees_with(model)
    assert found.trim[0] != pytest.approx(model.trim[0], rel=1e-3)


def test_a_model_of_a_version_without_gyroscopic_moments_is_not_used(
    vtail_copy: Path, model: DesignModel
) -> None:
    tree = json.loads((vtail_copy / DESIGN_MODEL).read_text())
    del tree["gyroscopic"]
    (vtail_copy / DESIGN_MODEL).write_text(json.dumps(tree))
    assert np.abs(model.gyroscopic).max() > 0.1
    assert stored(load_aircraft(str(vtail_copy))).agrees_with(model)


def test_an_edited_model_is_read_again(vtail_copy: Path) -> None:
    """Its fingerprint is that of the aircraft still: the edit is the designer's."""
    aircraft = load_aircraft(str(vtail_copy))
    before = stored(aircraft)
    tree = json.loads((vtail_copy / DESIGN_MODEL).read_text())
    tree["bias"][1] += 1.0
    (vtail_copy / DESIGN_MODEL).write_text(json.dumps(tree))
    assert stored(aircraft).bias[1] == before.bias[1] + 1.0


def test_what_is_no_model_is_said(vtail_copy: Path) -> None:
    (vtail_copy / DESIGN_MODEL).write_text("{}")
    with pytest.raises(BadInput, match=r"design_model\.json: is no design model"):
        stored(load_aircraft(str(vtail_copy)))


def test_the_stall_is_where_the_lift_curve_bends(vtail: Aircraft) -> None:
    """The lift table of vtail.xml is straight up to 0.209 rad and at its highest at 0.236 rad."""
    kept = load_design_model(vtail.folder / DESIGN_MODEL)
    assert 0.209 < kept.stall_alpha_rad < 0.236


def test_drag_by_the_size_of_sideslip_is_found(minimal_copy: Path) -> None:
    """CD = 2 |beta| slows by 2 q S cos(alpha) / m; mass and wing are those of minimal.xml. Nothing else has such a term."""
    xml = minimal_copy / "minimal.xml"
    drag = '<axis name="DRAG"><function name="aero/sideslip"><product><property>aero/qbar-area</property><value>2</value>'
    drag += "<abs><property>aero/beta-rad</property></abs></product></function>"
    xml.write_text(xml.read_text().replace('<axis name="DRAG">', drag))
    found = identify(load_aircraft(str(minimal_copy)))
    slower = found.density_kg_m3 * found.airspeed_m_s**2 * 0.5 * math.cos(found.alpha_rad) / 4.0
    assert found.sideslip[ROWS.index("u_dot")] == pytest.approx(-slower, rel=1e-3)
    assert np.count_nonzero(found.sideslip) == 1


def test_the_vtail_has_none(model: DesignModel) -> None:
    assert not np.any(model.sideslip)
