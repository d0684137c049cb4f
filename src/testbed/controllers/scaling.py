"""The control design that suits an aircraft's speed, size and engines, where its YAML does not say otherwise.

Lengths and speeds of the design are times and fractions of the reference airspeed V, so that paths are similar: a climb limited
to V/9 is one of 6.4 deg at any speed. At 18 m/s they are round numbers, those of the v-tail: 2 m/s of climb, V/12 is 1.5 m of
altitude, V/3.6 is 5 m. An integral of altitude acts on pitch, so it is divided by V. An aircraft whose actuators
cannot give the accelerations that the loops ask for has slower loops: all gains of a cascade are those of another unit of time.
What gusts and the model's own errors do to the rates follows from the design model's derivatives.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeVar

import numpy as np

from testbed.aircraft.control_design import LOOP_GAINS, ControlDesign
from testbed.aircraft.design_model import COLUMNS, ROWS, DesignModel
from testbed.common.cache import Cache
from testbed.common.signals import RATES
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.records import D_P, D_Q, D_R, P_DOT, Q_DOT, R_DOT, U_DOT
from testbed.controllers.released_axes import authorities
from testbed.inputs.base import Settings

GUST_M_S, _GUST_SPEED_M_S = 0.0933, 18.0
"""Root of the two-sided spectral density of gusts along each body axis [m/s per sqrt(Hz)]: light turbulence at 5 rad/s, met at this
airspeed. Gusts do not change while an aircraft passes them, so a faster one meets them sooner: above the corner of their spectrum
the density is proportional to airspeed (MIL-F-8785C, 3.7.2.2)."""
_ROTARY_GUSTS = {D_P: 1.64, D_Q: math.pi / 4.0, D_R: math.pi / 3.0}
"""Rotation of the air about each axis of the aircraft, by gusts that vary along it: this times gust velocity over span, above the
corner of its spectrum, pi V / 4 b (after MIL-F-8785C, 3.7.5). Below the corner its density is constant."""
_LOUD_RAD_S, _WIDE_RAD_S, _ESTIMATES_RAD_S = 7.1, 4.0, 1.0
"""Corners of the rotation of the air that were met in the v-tail's flights and by rolling, and the frequency at which effectiveness
is estimated [rad/s].

The velocity of the air is measured by alpha, beta and airspeed, its rotation is not. So the rotation counts with its density at
the frequency of the estimates. The v-tail's settings have a margin over the density that was measured in its flights, and the
first corner gives other aircraft the same margin. Rolling has less of it, by the second corner, and at least its density above the
corner: with the first, the flag of a lost aileron came too late for light aircraft; without any, whole gliders and wide biplanes
lost their aileron to slow gusts."""
_TURNING_RAD_S = 0.3
"""Pitching and yawing of an aircraft in gusts, by which their velocity enters forward acceleration [rad/s]."""
_MODEL_ANGLE = 0.005
"""Error of the design model at its own trim, as an angle of attack and of sideslip [rad]."""
_MODEL_U_DOT = 0.1  # error of modelled forward acceleration at the trim, m/s2
_ENGINE_MARGIN = 3.0  # the airspeed loop is this much slower than the slowest engine
_DEMANDS = {
    "q_dot": LOOP_GAINS["pitch_kp"].ample * LOOP_GAINS["q_kp"].ample * 0.11,
    "p_dot": LOOP_GAINS["roll_kp"].ample * LOOP_GAINS["p_kp"].ample * math.radians(25.0),
    "r_dot": LOOP_GAINS["sideslip_kp"].ample * LOOP_GAINS["r_kp"].ample * 0.15,
}
"""Acceleration that each cascade asks for at once [rad/s2]: for a climb at its limit (0.11 rad of path), 25 deg of bank, and 0.15
rad of sideslip."""
_NO_AUTHORITY = 1e-3  # authority of an axis below which it has none, rad/s2
_AMPLE, _U_DOT_MAX, _U_DOT_SHARE = 1.5, 0.7, 0.4
"""Authority over demand that counts as ample; largest acceleration [m/s2], and as a share of the authority."""
_AIRSPEED_SHARE = 1.0 / 18.0
"""Deviation of airspeed that is acceptable to a regulator, of the reference airspeed."""
PATH_LAG_S = 0.8
"""Time constant with which the flight path is to follow pitch [s]."""
_THRUST_SHARE = 0.5
"""Share of the excess thrust that a climb may use."""

S = TypeVar("S", bound=Settings)
_scaled: Cache[ControlDesign] = Cache(32)


def scaled(
    control: ControlDesign,
    model: DesignModel,
    limits: np.ndarray,
    lags: Sequence[float],
    released: Sequence[str] = (),
) -> ControlDesign:
    """The control design with each value that is not given replaced by the one that suits the aircraft.

    Args:
        limits: [n, 2] stops [rad or N].
        lags: [n] corners of the actuators' lags [rad/s].
        released: axes that are given up from the start.
    """

    def computed() -> ControlDesign:
        v, weights = model.airspeed_m_s, control.regulator
        kept = [axis for axis in RATES if axis not in released]
        authority = {each.axis: each.authority for each in authorities(model, limits, kept, range(len(lags)))}
        states = {"airspeed": _AIRSPEED_SHARE * v, "altitude": v / 12.0}
        regulator = {
            "states": _completed(weights.states, states),
            "integrals": _completed(weights.integrals, {"airspeed": v / 3.6, "altitude": v / 3.6}),
        }
        loops = _loops(model, limits, lags, authority, control.loops.lost_thrust_height_m)
        return control.model_copy(
            update={
                "loops": _completed(control.loops, loops),
                "allocation": _completed(control.allocation, _allocation(authority, control.priorities)),
                "regulator": weights.model_copy(update=regulator),
                "disturbance": _completed(control.disturbance, _by_rate(gust_density(model))),
                "model_error_std": _completed(control.model_error_std, _by_rate(model_error_std(model))),
            }
        )

    key = (control.model_dump_json(), model, limits.tobytes(), tuple(lags), tuple(released))
    return _scaled.get(key, computed)


def gust_density(model: DesignModel) -> np.ndarray:
    """[4] disturbance of each rate by gusts, as `GustDensity`: gusts change the angles by gust velocity over airspeed, and their
    change along the aircraft is air that rotates about it. Forward acceleration has the product of turning and velocity, which is
    computed with the velocity through the air in place of that over the ground."""
    slopes = np.array(model.derivatives)[:4]
    angles = model.angle_slopes[:4] / model.airspeed_m_s
    rotary = [slopes[:, i] * share for i, share in _rotations(model).items()]
    turning = np.zeros(4)
    turning[U_DOT] = _TURNING_RAD_S
    gust = GUST_M_S * math.sqrt(model.airspeed_m_s / _GUST_SPEED_M_S)
    disturbance = gust * np.sqrt(np.sum(np.square(np.column_stack([angles, turning, *rotary])), axis=1))
    return np.maximum(disturbance, 1e-3)


def _rotations(model: DesignModel) -> dict[int, float]:
    """Rotation of the air about each axis by gust velocity [1/m], by the column of the derivatives."""
    if not model.span_m:
        return {}
    corner = math.pi * model.airspeed_m_s / (4.0 * model.span_m)
    louder = _LOUD_RAD_S / math.hypot(corner, _ESTIMATES_RAD_S)
    above = {column: share / model.span_m for column, share in _ROTARY_GUSTS.items()}
    wide = max(1.0, _WIDE_RAD_S / math.hypot(corner, _ESTIMATES_RAD_S))
    return {D_P: wide * above[D_P], D_Q: louder * above[D_Q], D_R: louder * above[D_R]}


def model_error_std(model: DesignModel) -> np.ndarray:
    """[4] error of the design model in each rate at its own trim, as `TrimModelError`."""
    error = _MODEL_ANGLE * np.linalg.norm(model.angle_slopes[:4], axis=1)
    error[U_DOT] = _MODEL_U_DOT
    return np.maximum(error, 1e-3)


def excess_u_dot(model: DesignModel, limits: np.ndarray) -> float:
    """Acceleration with all thrust that the reference trim leaves [m/s2]; 0 without propulsion."""
    spare = np.array(model.input_matrix)[U_DOT] * (limits[:, 1] - np.array(model.trim))
    return float(sum(x for x, kind in zip(spare, model.kinds, strict=True) if kind != "servo"))


def _loops(
    model: DesignModel,
    limits: np.ndarray,
    lags: Sequence[float],
    authority: Mapping[str, float],
    lost_thrust_height_m: float,
) -> dict[str, float]:
    """Gains and limits of the outer loops, as `Loops`."""
    v, excess = model.airspeed_m_s, excess_u_dot(model, limits)
    faster = math.sqrt(v * v + 2.0 * GRAVITY_M_S2 * lost_thrust_height_m) - v  # with one propeller left [m/s]
    lift = -model.derivatives[ROWS.index("w_dot")][COLUMNS.index("alpha")]  # by angle of attack, per mass
    path_lag = v / max(lift, 1e-3)  # with which the flight path follows pitch [s]
    gains = _gains(model, authority, lags)
    climb = v / 9.0 if not excess else min(v / 9.0, _THRUST_SHARE * excess / GRAVITY_M_S2 * v)
    return {
        **gains,
        "altitude_ki": gains["altitude_ki"] / v,
        "u_dot_max": min(_U_DOT_MAX, max(_U_DOT_SHARE * authority.get("u_dot", math.inf), 0.05)),
        "climb_max": climb,
        "climb_kp": max(path_lag / PATH_LAG_S - 1.0, 0.0),
        "altitude_error_max_m": v / 3.6,
        "airspeed_error_max_m_s": v / 9.0,
        "protect_from_m_s": v / 9.0,
        "fast_climb_s": v / 36.0,
        "lost_thrust_faster_m_s": faster,
        "lost_thrust_protect_from_m_s": faster,
    }


def _allocation(authority: Mapping[str, float], priorities: Sequence[str]) -> dict[str, float]:
    """Weights of the rates of rotation, as `AllocationWeights`: the least authority of an axis and of all more important ones, over
    its own; 1 for an axis without authority, which has nothing to lose.

    With equal weights a weak aileron's missing roll, which asks for accelerations that no rudder can give, took all of the rudder,
    and the yaw that came with it lost the aircraft."""
    weights, least = dict.fromkeys(_DEMANDS, 1.0), math.inf
    for axis in priorities:
        if axis in weights and (own := authority.get(axis, 0.0)) > _NO_AUTHORITY:
            least = min(least, own)
            weights[axis] = least / own
    return weights


def _gains(model: DesignModel, authority: Mapping[str, float], lags: Sequence[float]) -> dict[str, float]:
    """`LOOP_GAINS` at the pace that authority and engines allow, with rate loops no slower than the aircraft's damping."""
    slowest = min((lag for lag, k in zip(lags, model.kinds, strict=True) if k != "servo"), default=math.inf)
    pace = {axis: _pace(authority.get(axis, math.inf), demand) for axis, demand in _DEMANDS.items()}
    pace["u_dot"] = min(1.0, slowest / _ENGINE_MARGIN / LOOP_GAINS["airspeed_kp"].ample)
    gains = {
        name: gain.ample * (pace[gain.axis] ** 2 if name.endswith("_ki") else pace[gain.axis])
        for name, gain in LOOP_GAINS.items()
    }
    for name, own in _dampings(model).items():
        gains[name] = max(gains[name], own)
    return gains


def _dampings(model: DesignModel) -> dict[str, float]:
    """The aircraft's own damping of each rate [1/s], by the gain of that rate's loop, which is to be no slower.

    The inversion cancels f_m, and with it the damping. The air's rotation in gusts is not measured: it acts through the damping,
    and a slower loop is moved by it for longer than the aircraft alone would be. At the same pace there is nothing to cancel.
    """
    places = {"p_kp": (P_DOT, D_P), "q_kp": (Q_DOT, D_Q), "r_kp": (R_DOT, D_R)}
    return {name: -model.derivatives[row][column] for name, (row, column) in places.items()}


def _pace(authority: float, demand: float) -> float:
    """How fast a cascade can be, as a fraction of that with ample authority: accelerations go with its square."""
    return min(1.0, math.sqrt(max(authority, _NO_AUTHORITY) / (_AMPLE * demand)))


def _by_rate(values: np.ndarray) -> dict[str, float]:
    return dict(zip(RATES, map(float, values), strict=True))


def _completed(settings: S, derived: Mapping[str, float]) -> S:
    """Settings with derived values in place of those that are not given."""
    return settings.model_copy(
        update={name: value for name, value in derived.items() if name not in settings.model_fields_set}
    )
