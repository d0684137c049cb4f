"""The forward force's second derivative by the angle of attack, which the linear design model leaves out.

Along the body's x axis, X = L sin(alpha) - D cos(alpha). Both lift L and the sine grow with the angle, so X is about a parabola of
it. Its tangent at the reference trim gives an aircraft that glides slower than that far too much drag.
"""

from __future__ import annotations

import math

import numpy as np

from testbed.aircraft.design_model import COLUMNS, ROWS, DesignModel

_X, _Z, _ALPHA = ROWS.index("u_dot"), ROWS.index("w_dot"), COLUMNS.index("alpha")


def forward_curvature(model: DesignModel) -> float:
    """Half the second derivative of u_dot by alpha at the reference trim [m/s2 per rad^2], without thrust.

    Lift is taken as linear in alpha, and drag as a parabola of lift, D = D_0 + k L^2 (Etkin and Reid, Dynamics of Flight,
    sec. 2.1). Then D'' = D' L' / L, where ' is the derivative by alpha, and

        X'' = 2 L' cos(alpha) - L sin(alpha) - D'' cos(alpha) + 2 D' sin(alpha) + D cos(alpha).

    L, D, L' and D' at the trim, all per mass, follow from the model's X and Z. A model whose lift does not grow has no such polar:
    0.
    """
    servos = np.array([kind == "servo" for kind in model.kinds])
    surfaces = np.array(model.input_matrix)[:, servos] @ np.array(model.trim)[servos]
    force, slope = np.array(model.bias) + surfaces, np.array(model.derivatives)[:, _ALPHA]
    x, z, x_alpha, z_alpha = force[_X], force[_Z], slope[_X], slope[_Z]
    sin, cos = math.sin(model.alpha_rad), math.cos(model.alpha_rad)
    lift, drag = x * sin - z * cos, -x * cos - z * sin
    lift_slope = (x_alpha + z) * sin + (x - z_alpha) * cos
    drag_slope = (x - z_alpha) * sin - (x_alpha + z) * cos
    if min(lift, lift_slope) <= 0.0:
        return 0.0
    drag_curvature = max(drag_slope, 0.0) * lift_slope / lift
    leaning = 2.0 * lift_slope * cos - lift * sin
    return float(0.5 * (leaning - drag_curvature * cos + 2.0 * drag_slope * sin + drag * cos))
