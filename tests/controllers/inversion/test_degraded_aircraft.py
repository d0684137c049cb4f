"""The curvature of the forward force that lift, which leans forward, has and the linear design model has not."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import PAPER, WEATHER, trim_state, vtail, vtail_setup

from testbed.aircraft.design_model import ROWS, DesignModel
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import model_record
from testbed.controllers.inversion.degraded_aircraft import forward_curvature
from testbed.controllers.inversion.law import state_function
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import accelerations, trim

X, Z = ROWS.index("u_dot"), ROWS.index("w_dot")
LIFT, LIFT_SLOPE, LEAST_DRAG, INDUCED = 9.8, 90.0, 0.7, 0.004
"""Of a wing at the trim, for each kg: [N/kg], [N/kg/rad], [N/kg] and [kg/N] of lift squared."""


def body_forces(alpha: float, at: float) -> tuple[float, float]:
    """X and Z of that wing [m/s2] at an angle of attack [rad], with its trim at another."""
    lift = LIFT + LIFT_SLOPE * (alpha - at)
    drag = LEAST_DRAG + INDUCED * lift * lift
    return (
        lift * math.sin(alpha) - drag * math.cos(alpha),
        -lift * math.cos(alpha) - drag * math.sin(alpha),
    )


def second_difference(at: float, h: float = 1e-4) -> float:
    low, middle, high = (body_forces(at + step, at)[0] for step in (-h, 0.0, h))
    return (high - 2.0 * middle + low) / (h * h)


def wing(at: float, lift_factor: float = 1.0) -> DesignModel:
    """The v-tail's design model with the forces of that wing, and their slopes, at its trim."""
    model, h = vtail_setup().model, 1e-5
    bias, slopes, inputs = (np.array(each) for each in (model.bias, model.derivatives, model.input_matrix))
    inputs[[X, Z]] = 0.0
    for row, before, now, after in zip(
        (X, Z), body_forces(at - h, at), body_forces(at, at), body_forces(at + h, at), strict=True
    ):
        bias[row], slopes[row, 0] = lift_factor * now, (after - before) / (2.0 * h)
    return replace(
        model,
        alpha_rad=at,
        bias=tuple(bias),
        derivatives=tuple(map(tuple, slopes)),
        input_matrix=tuple(map(tuple, inputs)),
    )


@pytest.mark.parametrize("at", [0.0, 0.05, 0.2])
def test_it_is_that_of_a_wing_with_a_parabolic_polar(at: float) -> None:
    assert forward_curvature(wing(at)) == pytest.approx(0.5 * second_difference(at), rel=1e-4)


def test_a_trim_without_lift_has_none() -> None:
    assert forward_curvature(wing(0.05, lift_factor=-1.0)) == 0.0


def forward_error(settings: AdaptiveInversionSettings, more_alpha: float) -> float:
    """u_dot of the law's model less that of the truth [m/s2], this much angle of attack beyond the trim [rad]."""
    aircraft, model = vtail()
    plant = Plant(aircraft, 200)
    level = trim(plant, model.airspeed_m_s, model.altitude_m)
    state = {**level.state, "alpha": level.state["alpha"] + more_alpha}
    truth = accelerations(plant, state, level.commands)[0]
    setup, f = vtail_setup(settings), np.zeros(4)
    m = model_record(setup)[0]
    state_function(trim_state(model, alpha=state["alpha"]), m, f)
    return float(f[3] + m.B[3] @ m.trim_position - truth)


@pytest.mark.parametrize("more_alpha", [-0.06, 0.06, 0.09])
def test_the_law_knows_the_forward_force_of_the_truth_and_the_paper_its_tangent(more_alpha: float) -> None:
    """0.1 m/s2 of drag that is not there is a tenth of the thrust."""
    assert abs(forward_error(WEATHER, more_alpha)) < 0.02
    assert forward_error(PAPER, more_alpha) < -0.25
