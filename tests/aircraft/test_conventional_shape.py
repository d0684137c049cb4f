"""What is drawn of an aircraft without a shape file: each surface where one with its effect would be, moving as it acts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from testbed.aircraft.conventional_shape import conventional, drawn_by_effect, roles
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, DesignModel, load_design_model
from testbed.aircraft.shape import Panel


@pytest.fixture(scope="module")
def model() -> DesignModel:
    """The Aerosonde's: an elevator, an aileron, a rudder and a propeller."""
    return load_design_model(load_aircraft("aerosonde").folder / DESIGN_MODEL)


def moved_by(model: DesignModel, name: str) -> list[Panel]:
    return [panel for panel in drawn_by_effect(model).panels if panel.actuator == name]


def lift_arm(panel: Panel) -> float:
    """Place of a panel along the span; its force is up where a positive position turns the trailing edge down."""
    return float(np.mean([y for _, y, _ in panel.points]))


def test_an_aileron_rolls_the_way_it_is_drawn(model: DesignModel) -> None:
    """Lift on the left rolls to the right."""
    rolling = model.input_matrix[0][model.actuators.index("aileron")]
    panels = moved_by(model, "aileron")
    assert len(panels) == 2
    assert all(np.sign(-panel.sense * lift_arm(panel)) == np.sign(rolling) for panel in panels)


def test_an_elevator_and_a_rudder_turn_the_way_they_are_drawn(model: DesignModel) -> None:
    """Both are behind the centre of gravity: lift there pitches down, and a force to the right there yaws left."""
    pitching = model.input_matrix[1][model.actuators.index("elevator")]
    yawing = model.input_matrix[2][model.actuators.index("rudder")]
    assert {panel.sense for panel in moved_by(model, "elevator")} == {-np.sign(pitching)}
    assert {panel.sense for panel in moved_by(model, "rudder")} == {-np.sign(yawing)}


def test_a_surface_of_one_side_is_drawn_there(model: DesignModel) -> None:
    """Also with a third that is on no side, and does little: it is not drawn."""
    aileron = np.array(model.input_matrix)[:, [model.actuators.index("aileron")]]
    matrix = np.hstack([0.5 * aileron, -0.5 * aileron, 0.01 * aileron])
    names = ("left_aileron", "right_aileron", "flap")
    two = replace(model, actuators=names, kinds=("servo",) * 3, input_matrix=tuple(map(tuple, matrix)))
    assert set(roles(two)) == set(names[:2])
    (left,), (right,) = moved_by(two, "left_aileron"), moved_by(two, "right_aileron")
    assert lift_arm(left) < 0.0 < lift_arm(right)
    assert left.sense == right.sense, "they roll to opposite sides by the same turn"


def test_ruddervators_are_elevators_on_their_sides() -> None:
    """Each rolls, pitches and yaws as much as the other: what both do alike must not be told by rounding."""
    vtail = load_design_model(load_aircraft("vtail").folder / DESIGN_MODEL)
    assert {role for role, _ in roles(vtail).values()} == {"elevator"}
    (left,), (right,) = moved_by(vtail, "left_ruddervator"), moved_by(vtail, "right_ruddervator")
    assert lift_arm(left) < 0.0 < lift_arm(right)


def test_the_span_is_that_of_the_aircraft(model: DesignModel) -> None:
    shape = drawn_by_effect(model, 10.0)
    assert max(y for panel in shape.panels for _, y, _ in panel.points) == pytest.approx(5.0)
    assert [propulsor.actuator for propulsor in shape.propulsors] == ["propeller"]


def test_of_an_unknown_aircraft_nothing_moves() -> None:
    assert not any(part.actuator for part in (*conventional().panels, *conventional().propulsors))
