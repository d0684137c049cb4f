"""Control modes: what is released, what is refused, and the inverses; equation (29) itself is in tests/theory."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import vtail_setup

from testbed.aircraft.control_design import AllocationWeights, ControlDesign
from testbed.controllers.inversion.modes import Mode, allocation_of, enumerate_modes
from testbed.controllers.records import Q_DOT, R_DOT, U_DOT

SETUP = vtail_setup()
B = np.array(SETUP.model.input_matrix)[:4] * SETUP.scale


def modes(
    control: ControlDesign = SETUP.control, released: tuple[str, ...] = ()
) -> Mapping[tuple[int, ...], Mode]:
    return enumerate_modes(SETUP.model, SETUP.scale, control, released)


def test_every_combination_but_that_of_all() -> None:
    assert len(modes()) == len(list(modes())) == 15
    assert modes()[(0, 2)].failed == ("left_ruddervator", "left_propeller")
    assert modes().get((0, 1, 2, 3)) is None
    for nonsense in ((2, 0), (0, 0), (4,), (-1,)):
        assert nonsense not in modes(), nonsense


def test_modes_are_made_when_they_are_asked_for() -> None:
    """Twelve actuators have 4095 combinations; a flight needs a few."""
    names = tuple(f"flap_{i}" for i in range(12))
    inputs = tuple(tuple(row) for row in np.random.default_rng(1).normal(size=(6, 12)))
    wide = replace(SETUP.model, actuators=names, kinds=("servo",) * 12, input_matrix=inputs)
    found = enumerate_modes(wide, np.ones(12), ControlDesign(condition_max=1e9), ())
    assert len(found) == 4095
    assert found[(0, 11)].failed == ("flap_0", "flap_11")
    assert len(found._made) == 1


JET = np.array([
    [4.3, 0.0, 0.42, -1e-5, 1e-5],
    [0.0, -49.6, 0.0, 0.0, 0.0],
    [-0.36, 0.0, -2.5, 1e-4, -1e-4],
    [0.0, -2.0, 0.0, 5e-4, 5e-4],
])  # fmt: skip
JET_SCALE = np.array([0.1, 0.1, 0.2, 1000.0, 1000.0])


def jet_inputs() -> np.ndarray:
    return JET * JET_SCALE


def jet(condition_max: float = 50.0, axes=("q_dot", "u_dot", "r_dot", "p_dot"), release=None):
    """Modes of aileron, elevator, rudder and two engines on the wings; nothing is listed in `release` by default."""
    model = replace(
        SETUP.model,
        actuators=("aileron", "elevator", "rudder", "left", "right"),
        kinds=("servo", "servo", "servo", "engine", "engine"),
        input_matrix=tuple(map(tuple, np.vstack([JET, np.zeros((2, 5))]))),
    )
    control = ControlDesign(condition_max=condition_max, priorities=axes, release=release or {})
    return enumerate_modes(model, JET_SCALE, control, ())


def test_what_the_rest_cannot_control_well_is_given_up() -> None:
    """Roll without the aileron, yaw without the rudder though the engines turn the aircraft slowly; nothing without an engine."""
    assert [jet()[(i,)].released for i in range(5)] == [
        ("p_dot",),
        ("q_dot",),
        ("r_dot",),
        (),
        (),
    ]
    assert not any(jet()[(i,)].refused for i in range(5))


def test_surfaces_meet_demands_for_rotation_and_engines_those_for_thrust() -> None:
    """Each actuator moves by what it does for a rate."""
    inverse = jet()[()].inverse
    assert jet_inputs() @ inverse == pytest.approx(np.eye(4), abs=1e-9)
    assert np.abs(inverse[3:, 2]).max() < 0.25 * abs(inverse[2, 2])
    assert inverse[3, 3] == pytest.approx(inverse[4, 3])


def test_engines_turn_the_aircraft_where_nothing_else_does() -> None:
    """With yaw kept and no rudder; the aircraft's settings say so."""
    mode = jet(condition_max=1e9, release={"rudder": ()})[(2,)]
    assert mode.released == ()
    assert mode.inverse[3, 2] == pytest.approx(-mode.inverse[4, 2])


def test_axes_that_the_aircraft_does_not_have_stay_given_up() -> None:
    found = jet(axes=("q_dot", "r_dot", "p_dot"))
    assert found[(0,)].released == ("p_dot", "u_dot")
    assert found[(3,)].released == ("u_dot",)


def test_released_axes_have_no_weight_in_the_allocation() -> None:
    weights = AllocationWeights(p_dot=1.0, q_dot=1.0, r_dot=2.0, u_dot=0.5)
    row_weight, hessian = allocation_of(B, ("p_dot",), weights)
    assert row_weight.tolist() == [0.0, 1.0, 4.0, 0.25]
    d = np.array([0.3, -0.2, 0.5, 0.1])
    assert d @ hessian @ d == pytest.approx(row_weight @ (B @ d) ** 2 + weights.deviation**2 * d @ d)


def test_the_vtail_gives_up_what_its_designer_chose() -> None:
    """A lost tail yaw, as in the paper; a lost propeller roll, whose only control it was."""
    chosen = {
        (0,): ("r_dot",),
        (1,): ("r_dot",),
        (2,): ("p_dot",),
        (3,): ("p_dot",),
        (0, 1): ("p_dot", "q_dot"),
    }
    for failed, released in chosen.items():
        assert modes()[failed].released == released
        assert not modes()[failed].refused
    assert modes()[()].released == ()


def test_axes_asked_for_are_released_until_something_fails() -> None:
    found = modes(released=("p_dot",))
    assert found[()].released == ("p_dot",)
    assert found[(0,)].released == ("r_dot",)


def test_combinations_that_are_not_listed_go_by_priority() -> None:
    """One tail and one propeller: both lists, and three actuators' worth of axes would be one too many for two."""
    control = ControlDesign(
        release={"left_ruddervator": ("r_dot",)}, priorities=("q_dot", "u_dot", "r_dot", "p_dot")
    )
    assert modes(control)[(0, 2)].released == ("p_dot", "r_dot")
    assert modes(control)[(0, 1, 2)].released == ("p_dot", "r_dot", "u_dot")
    assert modes(control)[(2,)].released == ("p_dot",), "the last in the list goes first"


def test_kept_axes_get_what_they_ask_for_from_what_is_left() -> None:
    mode = modes()[(0,)]
    effect = B @ mode.inverse
    kept = [0, Q_DOT, U_DOT]
    assert effect[np.ix_(kept, kept)] == pytest.approx(np.eye(3), abs=1e-9)
    assert not mode.inverse[0].any() and not mode.inverse[:, R_DOT].any()
    remaining = B[np.ix_(kept, [1, 2, 3])]
    assert mode.condition == pytest.approx(np.linalg.cond(remaining))


def test_an_ill_conditioned_mode_is_refused_with_its_condition_number() -> None:
    mode = modes(ControlDesign(condition_max=2.0))[()]
    assert mode.refused == (
        f"nothing failed, nothing released: condition number {mode.condition:.3g} of the remaining input matrix "
        "is above 2"
    )
    assert not mode.inverse.any()


def test_releasing_everything_is_refused() -> None:
    mode = modes(released=("p_dot", "q_dot", "r_dot", "u_dot"))[()]
    assert mode.refused.endswith("0 axes to keep with 4 actuators")


def test_modes_are_kept() -> None:
    assert modes() is modes()
    assert modes(released=("p_dot",)) is not modes()
