"""Control modes: what is released, what is refused, and the inverses; equation (29) itself is in tests/theory."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from vtail_setup import vtail_setup

from testbed.aircraft.control_design import ControlDesign
from testbed.controllers.inversion.modes import Mode, enumerate_modes
from testbed.controllers.records import Q_DOT, R_DOT, U_DOT

SETUP = vtail_setup()
B = np.array(SETUP.model.input_matrix)[:4] * SETUP.scale


def modes(
    control: ControlDesign = SETUP.control, released: tuple[str, ...] = ()
) -> Mapping[tuple[int, ...], Mode]:
    return enumerate_modes(SETUP.model, SETUP.scale, control, released)


def test_every_combination_but_that_of_all() -> None:
    assert len(modes()) == 15
    assert modes()[(0, 2)].failed == ("left_ruddervator", "left_propeller")


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


def test_the_spare_actuator_can_be_left_at_its_stop() -> None:
    """Roll released: without any one of the four, the other three still give the three axes."""
    mode = modes(released=("p_dot",))[()]
    assert mode.inverse_at_stop is not None
    kept = [Q_DOT, R_DOT, U_DOT]
    for i in range(4):
        effect = B @ mode.inverse_at_stop[i]
        assert effect[np.ix_(kept, kept)] == pytest.approx(np.eye(3), abs=1e-8)
        assert not mode.inverse_at_stop[i, i].any()
    assert modes()[()].inverse_at_stop is None, "four axes need all four"


def test_an_ill_conditioned_mode_is_refused_with_its_condition_number() -> None:
    mode = modes(ControlDesign(condition_max=2.0))[()]
    assert mode.refused == (
        f"nothing failed, nothing released: condition number {mode.condition:.3g} of the remaining input matrix "
        "is above 2"
    )
    assert not mode.inverse.any() and mode.inverse_at_stop is None


def test_releasing_everything_is_refused() -> None:
    mode = modes(released=("p_dot", "q_dot", "r_dot", "u_dot"))[()]
    assert mode.refused.endswith("0 axes to keep with 4 actuators")


def test_modes_are_kept() -> None:
    assert modes() is modes()
    assert modes(released=("p_dot",)) is not modes()
