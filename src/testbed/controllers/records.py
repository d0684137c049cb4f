"""The memory of the compiled law: four numpy records, made new for each flight.

A record is a fixed block of float64 with named fields, so the law reads `m.B[i, j]` as the paper writes it, whether it
is compiled or not. Actuator quantities are in scaled units: position divided by the actuator's `scale`, so that one
unit means the same authority for a tail as for a propeller and a single epsilon serves all (14).
"""

from __future__ import annotations

from functools import cache

import numpy as np

from testbed.aircraft.design_model import PROPELLER_POINTS

OUTER = ("airspeed", "alpha", "beta", "p", "q", "r", "roll", "pitch", "heading", "altitude")
"""State that the degraded modes' regulator feeds back, as deviations from the mode's trim and the references."""
INTEGRALS = ("airspeed", "altitude", "heading")


def _dtype(fields: list[tuple[str, tuple[int, ...]]]) -> np.dtype:
    return np.dtype((np.record, [(name, np.float64, shape) for name, shape in fields]))


@cache
def model_dtype(n: int) -> np.dtype:
    """Design model f_m, B_m and the actuators' own dynamics, for n actuators."""
    scalars = ("airspeed", "alpha", "density")
    per_actuator = (
        "servo", "scale", "low", "high", "lag", "rate", "hold", "torque_slope",
        "diameter", "advance_min", "advance_step", "rotor_inertia", "max_volts", "k_v", "k_t", "resistance",
        "no_load_current",
    )  # fmt: skip
    fields: list[tuple[str, tuple[int, ...]]] = [(name, ()) for name in scalars]
    fields += [(name, (n,)) for name in per_actuator]
    fields += [
        ("bias", (4,)),
        ("offset", (4,)),
        ("A", (4, 5)),
        ("B", (4, n)),
        ("B_inv", (n, 4)),
        ("B_torque", (4, n)),
    ]
    fields += [("c_thrust", (n, PROPELLER_POINTS)), ("c_torque", (n, PROPELLER_POINTS))]
    return _dtype(fields)


@cache
def settings_dtype(n: int) -> np.dtype:
    """What the control designer chooses."""
    scalars = (
        "dt", "lambda_min", "lambda_max", "threshold", "recovery", "persistence", "recovery_time", "adapts", "monitors",
        "divisor_min", "filter", "weighted", "walk", "jam_sigma", "jam_time", "jam_walk", "residual_time",
        "doubt_rate", "model_doubt", "certain",
        "airspeed_kp", "airspeed_ki", "u_dot_max", "altitude_kp", "altitude_ki", "climb_max", "pitch_kp", "q_kp",
        "heading_kp", "heading_ki", "roll_max", "roll_kp", "p_kp", "sideslip_kp", "sideslip_ki", "r_kp",
        "heading_error_max", "altitude_error_max", "airspeed_error_max",
    )  # fmt: skip
    fields: list[tuple[str, tuple[int, ...]]] = [(name, ()) for name in scalars]
    fields += [("gamma", (n,)), ("epsilon", (n,)), ("noise", (4,)), ("doubt", (4,))]
    return _dtype(fields)


@cache
def mode_dtype(n: int) -> np.dtype:
    """One control mode: which actuators are left, and the modified inverse of equation (29)."""
    return _dtype(
        [
            ("regulated", ()),
            ("B_hat_inv", (n, 4)),
            ("spare", ()),
            ("protect", ()),
            ("protect_from", ()),
            ("faster", ()),
            ("held_inv", (n, n, 4)),
            ("alive", (n,)),
            ("released", (4,)),
            ("r_trim", (n,)),
            ("x_trim", (len(OUTER),)),
            ("K", (4, len(OUTER))),
            ("K_actuator", (4, n)),
            ("K_integral", (4, len(INTEGRALS))),
        ]
    )


@cache
def memory_dtype(n: int) -> np.dtype:
    """What the law remembers from step to step, and what it says to the log."""
    return _dtype(
        [
            ("lambda_hat", (n,)),
            ("r", (n,)),
            ("u", (n,)),
            ("command", (n,)),
            ("position", (n,)),
            ("servo_input", (n,)),
            ("servo_lagged", (n,)),
            ("rotor", (n,)),
            ("torque", (n,)),
            ("failed", (n,)),
            ("timer", (n,)),
            ("integral", (4,)),
            ("x_dot_desired", (4,)),
            ("jammed", (n,)),
            ("designed_for", (n,)),
            ("suspicion", (n,)),
            ("reversed", (n,)),
            ("since", (n,)),
            ("residual", (4,)),
            ("P", (n + 4, n + 4)),
            ("Ph", (n + 4,)),
            ("b", (4,)),
            ("doubt", (4,)),
            ("filtered", (2, 4)),
            ("filtered_phi", (2, 4, n)),
        ]
    )
