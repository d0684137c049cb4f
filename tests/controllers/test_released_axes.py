"""Which axes are given up from the start: authority within the stops against what gusts do."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import vtail, vtail_setup

from testbed.aircraft.control_design import Axis
from testbed.aircraft.design_model import DesignModel
from testbed.common.signals import RATES
from testbed.controllers.config import AdaptiveInversionSettings, FixedInversionSettings, IndiSettings
from testbed.controllers.released_axes import (
    GUST_STD_M_S,
    MARGIN,
    authorities,
    axes_to_release,
    gust_disturbance,
    released_from_start,
)
from testbed.controllers.setup import stops

PRIORITIES: tuple[Axis, ...] = ("q_dot", "u_dot", "r_dot", "p_dot")
AIRCRAFT, VTAIL = vtail()
VTAIL_STOPS = stops(AIRCRAFT)


def conventional() -> tuple[DesignModel, np.ndarray]:
    """A Cessna 172 at 67 m/s: derivatives of Roskam, Airplane Flight Dynamics I, appendix C, as rates [rad/s2 per rad]."""
    inputs = np.zeros((6, 4))
    inputs[:4] = [
        # aileron, elevator, rudder, thrust [N]
        [57.4, 0.0, 4.7, 0.0],
        [0.0, -39.2, 0.0, 0.0],
        [-9.5, 0.0, -10.2, 0.0],
        [0.0, 0.0, 0.0, 1.0 / 1043.0],
    ]
    derivatives = np.zeros((6, 5))
    derivatives[:4, :2] = [[0.0, -30.0], [-19.5, 0.0], [0.0, 9.6], [6.0, 0.0]]
    model = replace(
        VTAIL,
        airspeed_m_s=67.0,
        actuators=("aileron", "elevator", "rudder", "engine"),
        kinds=("servo", "servo", "servo", "motor"),
        trim=(0.0, 0.0, 0.0, 930.0),
        bias=(0.0,) * 6,
        derivatives=tuple(map(tuple, derivatives)),
        input_matrix=tuple(map(tuple, inputs)),
    )
    travel = np.radians(20.0)
    return model, np.array([(-travel, travel)] * 3 + [(0.0, 2500.0)])


def test_the_vtail_gives_up_roll() -> None:
    """Roll is only the propellers' torque: 4.7 rad/s2, and one standard deviation of the gusts' effect is 2.2."""
    assert released_from_start(VTAIL, VTAIL_STOPS, PRIORITIES) == ("p_dot",)
    found = {one.axis: one for one in authorities(VTAIL, VTAIL_STOPS, RATES, range(4))}
    assert [axis for axis in RATES if not found[axis].suffices] == ["p_dot"]
    beta = math.radians(2.4255)  # 0.762 m/s at 18 m/s
    l_beta = abs(VTAIL.derivatives[0][1])
    assert found["p_dot"].disturbance == pytest.approx(l_beta * beta, rel=1e-3)


def test_authority_is_what_the_inverse_says_where_it_is_unique() -> None:
    """Four actuators, four axes: the positions for a rate are the column of the inverse, up to the first stop."""
    column = np.linalg.inv(np.array(VTAIL.input_matrix)[:4])[:, 0]
    travel = VTAIL_STOPS - np.array(VTAIL.trim)[:, None]
    ends = travel / column[:, None]
    most = min(np.max(ends, axis=1).min(), -np.min(ends, axis=1).max())
    assert authorities(VTAIL, VTAIL_STOPS, RATES, range(4))[0].authority == pytest.approx(most)


def test_an_aircraft_with_ailerons_gives_up_nothing() -> None:
    model, limits = conventional()
    assert released_from_start(model, limits, PRIORITIES) == ()


def test_weak_ailerons_are_given_up_and_only_they() -> None:
    model, limits = conventional()
    limits[0] /= 50.0
    assert released_from_start(model, limits, PRIORITIES) == ("p_dot",)


@pytest.mark.parametrize(
    ("missing", "released"), [(0, "p_dot"), (1, "q_dot"), (2, "r_dot"), (3, "u_dot")], ids=str
)
def test_with_an_actuator_too_few_the_axis_without_one_is_given_up(missing: int, released: str) -> None:
    model, limits = conventional()
    inputs = np.array(model.input_matrix)
    inputs[2, 0] = inputs[0, 2] = 0.0  # no adverse yaw, which is an authority too
    model = replace(model, input_matrix=tuple(map(tuple, inputs)))
    left = [i for i in range(4) if i != missing]
    assert axes_to_release(model, limits, left, PRIORITIES) == (released,)


def test_a_flying_wing_does_not_give_up_roll_for_a_little_pitch() -> None:
    """Its two elevons give 0.98 of the pitch that gusts ask for, and all of it with roll given up: that would be a bad bargain."""
    model, _ = conventional()
    inputs, derivatives = np.zeros((6, 3)), np.array(model.derivatives)
    inputs[:4] = [[28.7, -28.7, 0.0], [-19.6, -19.6, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0 / 1043.0]]
    derivatives[0, 1] = -10.0
    model = replace(
        model,
        actuators=("left_elevon", "right_elevon", "engine"),
        kinds=("servo", "servo", "motor"),
        trim=(0.0005, -0.0005, 930.0),
        derivatives=tuple(map(tuple, derivatives)),
        input_matrix=tuple(map(tuple, inputs)),
    )
    limits = np.array([(-0.0172, 0.0172)] * 2 + [(0.0, 2500.0)])
    pitch = authorities(model, limits, ("q_dot", "u_dot", "p_dot"), range(3))[0]
    assert 0.95 < pitch.ratio < 1.0 < authorities(model, limits, ("q_dot", "u_dot"), range(3))[0].ratio
    assert axes_to_release(model, limits, range(3), PRIORITIES) == ("r_dot",)


def test_never_more_axes_are_kept_than_actuators_are_left() -> None:
    for left in ([0], [1, 2], [0, 1, 3], [2, 3]):
        kept = 4 - len(axes_to_release(VTAIL, VTAIL_STOPS, left, PRIORITIES))
        assert 1 <= kept <= len(left)


def test_gusts_disturb_in_proportion_and_a_slow_aircraft_more() -> None:
    slow = replace(VTAIL, airspeed_m_s=VTAIL.airspeed_m_s / 2.0)
    assert gust_disturbance(slow) == pytest.approx(2.0 * gust_disturbance(VTAIL))
    assert pytest.approx(0.762) == GUST_STD_M_S
    assert set(MARGIN) == set(RATES)


@pytest.mark.parametrize("kind", [AdaptiveInversionSettings, FixedInversionSettings, IndiSettings])
def test_every_inversion_starts_with_the_same_axes(kind: type[AdaptiveInversionSettings]) -> None:
    assert vtail_setup(kind()).released == ("p_dot",)
    assert vtail_setup(kind(released=())).released == ()
    wrong_model = kind(model_error={"Cl_beta": 0.1})
    assert vtail_setup(wrong_model).released == ("p_dot",), "a study of model error keeps the axes"
