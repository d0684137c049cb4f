"""Gains of `pid` that suit an aircraft, by loop shaping on its design model: one rule for every aircraft.

Each rotation has a rate loop inside an angle loop. The rate loop crosses over at w, where the slowest servo takes 34 deg of its
phase, or lower: so that the largest demand for the angle asks for no more than two thirds of the authority. The angle loop is a
third of it, w / 3, so both together have the stiffness w^2 / 3. No dynamics are cancelled, so the angle follows its command
more slowly than that. Damping L_p slows bank down to w^2 / 3 (w - L_p). Pitch works against the short period's stiffness, and
the path follows it by Z_alpha = -dw_dot/dalpha / V (Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed.,
sec. 4.2). The loops around them are slower than these. Airspeed is a third of the slowest engine.
"""

from __future__ import annotations

import math

import numpy as np

from testbed.aircraft.design_model import ROWS
from testbed.common.signals import RATES
from testbed.controllers.config import PidSettings
from testbed.controllers.records import D_ALPHA, D_P, D_Q, P_DOT, Q_DOT
from testbed.controllers.released_axes import authorities
from testbed.controllers.setup import Setup

_OF_LAG = 2.0 / 3.0
"""Crossover of a rate loop over the corner of the servo's lag."""
_OF_AUTHORITY = 2.0 / 3.0
_LARGEST_ANGLES = {"q_dot": 0.11, "p_dot": 0.44, "r_dot": 0.15}
"""Largest angle that each cascade demands at once [rad]: a path of 6.4 deg, a bank of 25 deg, and the yaw of a turn."""
_OF_PITCH, _INTEGRAL = 0.8, 0.125
"""Altitude loop in units of the pitch loop's bandwidth; integral gains of altitude and airspeed over the squares of the others."""
_AIRSPEED_KP_MAX = 1.9
"""Airspeed is no faster than this [1/s], however fast its engines are: it was best for a propeller without a lag to speak of."""


def suited(settings: PidSettings, setup: Setup) -> PidSettings:
    """The settings with each gain and limit that is not given replaced by the one that suits the aircraft."""
    chosen = {name for name in settings.model_fields_set if getattr(settings, name) is not None}
    gains = {**_limits(setup), **_longitudinal(setup), **_lateral(setup)}
    return settings.model_copy(update={name: gains[name] for name in gains.keys() - chosen})


def _limits(setup: Setup) -> dict[str, float]:
    """Those of the other controllers' outer loops; airspeed may ask for all the thrust that there is."""
    loops = setup.control.loops
    return {
        "climb_max": loops.climb_max,
        "roll_max_deg": loops.roll_max_deg,
        "u_dot_max": _authority(setup).get("u_dot", loops.u_dot_max),
        "altitude_error_max_m": loops.altitude_error_max_m,
        "airspeed_error_max_m_s": loops.airspeed_error_max_m_s,
    }


def _longitudinal(setup: Setup) -> dict[str, float]:
    model, w = setup.model, _crossover(setup, "q_dot")
    derivatives, v = np.array(model.derivatives), model.airspeed_m_s
    path = max(-derivatives[ROWS.index("w_dot"), D_ALPHA] / v, 0.05)  # Z_alpha [1/s]
    short_period = max(
        -derivatives[Q_DOT, D_ALPHA] - path * derivatives[Q_DOT, D_Q], 0.0
    )  # its frequency, squared
    pitch = w * w / 3.0 * path / (short_period + w * path)
    altitude = min(w / 9.0, path / 2.0, pitch * _OF_PITCH)
    lags = [lag for lag, kind in zip(setup.lags, model.kinds, strict=True) if kind != "servo"]
    airspeed = min([_AIRSPEED_KP_MAX, *(lag / 3.0 for lag in lags)])
    return {
        "q_kp": w,
        "pitch_kp": w / 3.0,
        "altitude_kp": altitude,
        "altitude_ki": _INTEGRAL * altitude**2 / v,
        "airspeed_kp": airspeed,
        "airspeed_ki": _INTEGRAL * airspeed**2,
    }


def _lateral(setup: Setup) -> dict[str, float]:
    p, r = _crossover(setup, "p_dot"), _crossover(setup, "r_dot")
    bank = p * p / 3.0 / (p - min(setup.model.derivatives[P_DOT][D_P], 0.0))
    heading = r / 8.0 if "p_dot" in setup.released else bank / 3.0
    return {
        "p_kp": p,
        "bank_kp": p / 3.0,
        "r_kp": r,
        "roll_kp": r / 8.0,
        "heading_kp": heading,
        "heading_ki": heading**2 / 12.0,
    }


def _crossover(setup: Setup, axis: str) -> float:
    """w of an axis [rad/s]: authority allows a stiffness w^2 / 3 of `_OF_AUTHORITY` of it over the largest angle."""
    servos = [lag for lag, kind in zip(setup.lags, setup.model.kinds, strict=True) if kind == "servo"]
    most = 3.0 * _OF_AUTHORITY * _authority(setup).get(axis, math.inf) / _LARGEST_ANGLES[axis]
    return min(_OF_LAG * min(servos, default=30.0), math.sqrt(max(most, 1e-2)))


def _authority(setup: Setup) -> dict[str, float]:
    """Authority over each kept axis [rad/s2; u_dot m/s2]."""
    stops = setup.limits * setup.scale[:, None]
    kept = [axis for axis in RATES if axis not in setup.released]
    return {each.axis: each.authority for each in authorities(setup.model, stops, kept, range(len(stops)))}
