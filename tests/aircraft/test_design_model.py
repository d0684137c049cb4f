"""The design model: its equations, its errors as a scenario sets them, and the file that it is stored in."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest

from testbed import fly
from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import (
    COLUMNS,
    DESIGN_MODEL,
    NOT_GYROSCOPIC,
    ROWS,
    DesignModel,
    Propulsor,
    coefficient_names,
    kinematics,
    load_design_model,
)
from testbed.common.units import GRAVITY_M_S2
from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario, load_scenario


@pytest.fixture(scope="module")
def model(vtail: Aircraft) -> DesignModel:
    return load_design_model(vtail.folder / DESIGN_MODEL)


def reference(model: DesignModel) -> dict[str, float]:
    """The state of the level trim about which the model is built."""
    rates = dict.fromkeys(("beta", "p", "q", "r", "roll"), 0.0)
    return {"airspeed": model.airspeed_m_s, "alpha": model.alpha_rad, "pitch": model.alpha_rad, **rates}


HEALTHY = np.ones(4)

# f_m and B_m ------------------------------------------------------------------------------------------------------


def test_nothing_accelerates_at_the_reference(model: DesignModel) -> None:
    """But for the Earth's rotation and gravity's change with height, which the plant has and the model has not."""
    assert np.abs(model.rates(reference(model), model.trim, HEALTHY)).max() < 0.04


def test_an_actuator_adds_its_column(model: DesignModel) -> None:
    at, column = reference(model), np.array(model.input_matrix)
    level = model.rates(at, model.trim, HEALTHY)
    for i in range(4):
        moved = np.array(model.trim)
        moved[i] += 0.01
        np.testing.assert_allclose(model.rates(at, moved, HEALTHY) - level, 0.01 * column[:, i], atol=1e-12)


def test_surfaces_work_with_dynamic_pressure_and_propellers_do_not(model: DesignModel) -> None:
    """At 1.2 times the airspeed a surface has 1.44 times its effect, a newton of thrust is a newton."""
    at = reference(model) | {"airspeed": 1.2 * model.airspeed_m_s}
    level = model.rates(at, model.trim, HEALTHY)
    for i, factor in enumerate((1.44, 1.44, 1.0, 1.0)):
        moved = np.array(model.trim)
        moved[i] += 0.01
        expected = factor * 0.01 * np.array(model.input_matrix)[:, i]
        np.testing.assert_allclose(model.rates(at, moved, HEALTHY) - level, expected, atol=1e-12)


def test_a_lost_actuator_does_nothing(model: DesignModel) -> None:
    at, lost = reference(model), np.array([0.0, 1.0, 0.0, 1.0])
    moved = np.add(model.trim, [0.3, 0.0, 2.0, 0.0])
    assert np.array_equal(model.rates(at, moved, lost), model.rates(at, model.trim, lost))


@pytest.mark.parametrize(("name", "power"), [("alpha", 2), ("beta", 2), ("p", 1), ("q", 1), ("r", 1)])
def test_derivatives_are_scaled_with_airspeed(model: DesignModel, name: str, power: int) -> None:
    """Angles with dynamic pressure, rates with airspeed; gravity, axis rotation and gyroscopic moments apart."""
    model = replace(model, gyroscopic=NOT_GYROSCOPIC)
    slope = np.array(model.derivatives)[:, COLUMNS.index(name)]
    at = reference(model) | {"airspeed": 1.3 * model.airspeed_m_s}
    moved = at | {name: at[name] + 0.01}
    change = model.rates(moved, model.trim, HEALTHY) - model.rates(at, model.trim, HEALTHY)
    aerodynamic = change - (kinematics(moved) - kinematics(at))
    np.testing.assert_allclose(aerodynamic, 0.01 * 1.3**power * slope, atol=1e-9)


def test_gravity_and_rotation_of_the_axes() -> None:
    """Stevens, Lewis and Johnson (3rd ed.), eq. 1.7-18: u_dot = -g sin(pitch) + r v - q w, and so on."""
    still = {
        "airspeed": 20.0,
        "alpha": 0.0,
        "beta": 0.0,
        "p": 0.0,
        "q": 0.0,
        "r": 0.0,
        "roll": 0.0,
        "pitch": 0.0,
    }
    assert kinematics(still) == pytest.approx([0, 0, 0, 0, 0, GRAVITY_M_S2])
    assert kinematics(still | {"pitch": math.pi / 2}) == pytest.approx(
        [0, 0, 0, -GRAVITY_M_S2, 0, 0], abs=1e-12
    )
    assert kinematics(still | {"roll": math.pi / 2}) == pytest.approx(
        [0, 0, 0, 0, GRAVITY_M_S2, 0], abs=1e-12
    )
    assert kinematics(still | {"r": 0.1})[4] == pytest.approx(-2.0)
    assert kinematics(still | {"q": 0.1})[5] == pytest.approx(GRAVITY_M_S2 + 2.0)


# Propellers -------------------------------------------------------------------------------------------------------


def test_a_thrust_that_the_propeller_cannot_give(model: DesignModel) -> None:
    propulsor = model.propulsors[2]
    assert isinstance(propulsor, Propulsor)
    with pytest.raises(BadInput, match=r"cannot give 1e\+03 N at 18 m/s, expected .* N by its tables"):
        propulsor.speed_at(1000.0, 18.0, 1.2)
    nothing = replace(propulsor, thrust=(0.0,) * len(propulsor.thrust))
    with pytest.raises(BadInput, match="does not change with its speed"):
        nothing.torque_at(0.0, 18.0, 1.2)


def test_speed_and_torque_are_of_the_tables(model: DesignModel) -> None:
    """T = rho n^2 D^4 C_T(J) and Q = rho n^2 D^5 C_Q(J), looked up again at the speed that was found."""
    propulsor = model.propulsors[2]
    assert isinstance(propulsor, Propulsor)
    axial, rho = 18.0, 1.2
    n = propulsor.speed_at(3.0, axial, rho)
    grid = np.linspace(*propulsor.advance, len(propulsor.thrust))
    j, pressure = axial / (n * propulsor.diameter_m), rho * n * n * propulsor.diameter_m**4
    assert pressure * np.interp(j, grid, propulsor.thrust) == pytest.approx(3.0)
    torque, slope = propulsor.torque_at(3.0, axial, rho)
    assert torque == pytest.approx(pressure * propulsor.diameter_m * np.interp(j, grid, propulsor.torque))
    more, less = (propulsor.torque_at(3.0 + step, axial, rho)[0] for step in (0.1, -0.1))
    assert slope == pytest.approx((more - less) / 0.2, rel=0.05)


# Its error --------------------------------------------------------------------------------------------------------


def test_errors_scale_what_they_name_and_keep_the_trim(model: DesignModel) -> None:
    wrong = model.with_error({"Cm_alpha": 1.2, "CX_left_propeller": 0.5})
    row, column = ROWS.index("q_dot"), COLUMNS.index("alpha")
    assert wrong.derivatives[row][column] == 1.2 * model.derivatives[row][column]
    row, column = ROWS.index("u_dot"), model.actuators.index("left_propeller")
    assert wrong.input_matrix[row][column] == 0.5 * model.input_matrix[row][column]
    at = reference(model)
    np.testing.assert_allclose(
        wrong.rates(at, model.trim, HEALTHY), model.rates(at, model.trim, HEALTHY), atol=1e-12
    )
    assert model.with_error({}).agrees_with(model)


def test_every_coefficient_has_a_name_and_an_effect(model: DesignModel) -> None:
    names = model.coefficient_names()
    assert names == coefficient_names(model.actuators)
    assert len(names) == len(set(names)) == len(ROWS) * (len(COLUMNS) + 4)
    zero = [name for name in names if model.with_error({name: 2.0}) == model]
    assert "Cm_alpha" not in zero
    assert len(zero) < len(names) / 2, "the model is not made of zeros"


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=2", "failures=[]", "requirements=[]", *settings]
    )


@pytest.mark.parametrize(
    "errors",
    [
        "{Cm_alpha: 1.2, Cl_beta: 0.8, Cm_right_ruddervator: 1.2, CX_left_propeller: 1.2}",
        "{Cl_left_propeller: 1.2}",
    ],
)
def test_a_model_error_changes_the_flight_but_not_the_trim(errors: str) -> None:
    """In trimmed flight a wrong slope has nothing to act on; in a manoeuvre it has."""
    turn = "commands=[{at_s: 1, heading_deg: 120, altitude_m: 305}]"
    sure, wrong = fly(scenario(turn)), fly(scenario(turn, f"controller.model_error={errors}"))
    before = sure.log["time_s"] <= 1.0
    for name in ("altitude_m", "heading_deg", "airspeed_m_s", "pitch_deg"):
        difference = (wrong.log[name] - sure.log[name]).abs()
        assert difference[before].max() < 1e-4, name
        assert difference[~before].max() > 10 * difference[before].max(), name


# Its file ---------------------------------------------------------------------------------------------------------


def test_what_is_saved_is_loaded(model: DesignModel, tmp_path: Path) -> None:
    model.save(tmp_path / "m.json")
    assert load_design_model(tmp_path / "m.json") == model


@pytest.mark.parametrize("text", ["", "[]", "3", "{}", '{"bias": 3}', "\udcff", "[" * 100_000])
def test_anything_else_is_refused(text: str, tmp_path: Path) -> None:
    file = tmp_path / "m.json"
    file.write_bytes(text.encode(errors="surrogateescape"))
    with pytest.raises(BadInput, match=r"m\.json: .*expected what `testbed identify` writes"):
        load_design_model(file)


@pytest.mark.parametrize("key", ["stall_alpha_rad", "span_m", "identified_from"])
def test_a_list_in_the_place_of_one_value_is_refused(model: DesignModel, tmp_path: Path, key: str) -> None:
    (tmp_path / "m.json").write_text(json.dumps({**asdict(model), key: []}))
    with pytest.raises(BadInput, match=rf"m\.json: is no design model: {key} "):
        load_design_model(tmp_path / "m.json")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"bias": [', '"bias": [0.0, ', r"bias has the shape \[7\]"),
        ('"airspeed_m_s": 18.0', '"airspeed_m_s": 1e999', "airspeed_m_s is not finite"),
        ('"diameter_m": 0.4826', '"diameter_m": NaN', "NaN is no finite number"),
        ('"kinds": [', '"kinds": ["servo", ', "4 entries"),
        ('"kinds": [', '"kinds": [1e300, ', r"kinds has 1e\+300, expected servo, motor, engine"),
        ('"airspeed_m_s": 18.0', '"airspeed_m_s": -18.0', "airspeed_m_s is not positive"),
        ('"airspeed_m_s": 18.0', '"airspeed_m_s": 1e300', "airspeed_m_s is beyond"),
        ('"airspeed_m_s": 18.0', f'"airspeed_m_s": {10**400}', "has a number beyond"),
        ('"span_m": 2', '"span_m": -2', "span_m is not positive"),
    ],
)
def test_numbers_that_no_identification_gives_are_refused(
    model: DesignModel, tmp_path: Path, old: str, new: str, words: str
) -> None:
    file = tmp_path / "m.json"
    model.save(file)
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))
    with pytest.raises(BadInput, match=rf"m\.json: .*{words}"):
        load_design_model(file)


def test_a_changed_design_model_is_noticed(model: DesignModel) -> None:
    """The negative control: a millionth of one coefficient, a millionth of one propeller."""
    assert not model.with_error({"Cm_alpha": 1.000001}).agrees_with(model)
    *others, right = model.propulsors
    assert right is not None
    weaker = replace(right, thrust=tuple(1.000001 * c for c in right.thrust))
    assert not replace(model, propulsors=(*others, weaker)).agrees_with(model)
