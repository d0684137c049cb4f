"""The curvature of the forward force that lift, which leans forward, has and the linear design model has not."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import vtail_setup

from testbed.aircraft.design_model import ROWS, DesignModel
from testbed.controllers.inversion.degraded_aircraft import forward_curvature

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
