"""A conventional autopilot: cascaded loops, and an allocation from the design model.

The autopilot that a designer would give an aircraft without an inversion. Airspeed commands thrust. Altitude commands pitch,
and pitch the pitch rate. Heading commands bank. Where the aircraft can roll against gusts, bank commands the roll rate, and
the yaw rate is that of a coordinated turn. Where roll is given up (`released`), as on an aircraft that cannot roll by itself, bank
commands the yaw rate: yawing causes sideslip, and with dihedral sideslip causes roll. No dynamics are cancelled and nothing
is estimated; integrators find the trim. The design model gives the trim to start from, the motors' throttle curve, and the
effect of each actuator. The actuators share each demand as in the other controllers (`inversion.allocation`), so the gains
are rates per error, and those of one aircraft are near those of another.

Structure: Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., sec. 4.4 to 4.6; bank by rudder and
dihedral as on a two-axis glider.

The gains suit the aircraft, by loop shaping on its design model: one rule for every aircraft. Each rotation has a rate loop
inside an angle loop. The rate loop crosses over at w, where the slowest servo takes 34 deg of its phase, or lower: so that the
largest demand for the angle asks for no more than two thirds of the authority. The angle loop is a third of it, w / 3, so both
together have the stiffness w^2 / 3. No dynamics are cancelled, so the angle follows its command more slowly than that. Damping
L_p slows bank down to w^2 / 3 (w - L_p). Pitch works against the short period's stiffness, and the path follows it by Z_alpha =
-dw_dot/dalpha / V (sec. 4.2). The loops around them are slower than these. Airspeed is a third of the slowest engine.

Letters: those of `records`, and g the gains (`PidSettings`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

from testbed.aircraft.design_model import ROWS
from testbed.common.jit import compiled
from testbed.common.signals import RATES, record_dtype
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import write_telemetry
from testbed.controllers.config import ControllerSettings, PidSettings
from testbed.controllers.initial_records import settings_record, trimmed_memory
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.inversion.controller import CompiledController
from testbed.controllers.inversion.law import pressure_ratio_of
from testbed.controllers.inversion.modes import allocation_of
from testbed.controllers.outer_loops import clip, wrap
from testbed.controllers.records import D_ALPHA, D_P, D_Q, P_DOT, Q_DOT, R_DOT, U_DOT, mode_dtype
from testbed.controllers.released_axes import authorities
from testbed.controllers.setup import Setup

HEADING_ERROR_MAX = 0.35  # rad, to which the heading error is limited
HEADING_INTEGRAL_MAX = 0.3  # rad/s
PRESSURE_RATIO_MIN = 0.2
"""Least dynamic pressure over that at the reference that the allocation divides by. So at low airspeed a surface deflects at most
five times as far as at the reference airspeed for the same desired rate."""
_OF_LAG = 2.0 / 3.0
"""Crossover of a rate loop over the corner of the servo's lag."""
_OF_AUTHORITY = 2.0 / 3.0
_LARGEST_ANGLES = {"q_dot": 0.11, "p_dot": 0.44, "r_dot": 0.15}
"""Largest angle that each cascade demands at once [rad]: a path of 6.4 deg, a bank of 25 deg, and the yaw of a turn."""
_OF_PITCH, _INTEGRAL = 0.8, 0.125
"""Altitude loop in units of the pitch loop's bandwidth; integral gains of altitude and airspeed over the squares of the others."""
_AIRSPEED_KP_MAX = 1.9
"""Airspeed is no faster than this [1/s], however fast its engines are: it was best for a propeller without a lag to speak of."""


@compiled
def longitudinal(y, ref, dt, g, k, s):
    """Desired u_dot from airspeed, and q_dot from altitude through pitch and pitch rate, into `s.x_dc_dot`.

    An aircraft that is too slow counts as too high, as in `outer_loops.regulate`.
    """
    v = max(y.airspeed, 1.0)
    e_speed = clip(ref.airspeed - y.airspeed, g.airspeed_error_max_m_s)
    e_height = clip(ref.altitude - y.altitude, g.altitude_error_max_m)
    e_height -= k.slow_descent * max(ref.airspeed - y.airspeed - k.slow_descent_from, 0.0)
    s.airspeed_integral = clip(s.airspeed_integral + g.airspeed_ki * e_speed * dt, g.u_dot_max)
    s.x_dc_dot[U_DOT] = clip(g.airspeed_kp * e_speed + s.airspeed_integral + ref.airspeed_rate, g.u_dot_max)

    s.pitch_integral += g.altitude_ki * e_height * dt
    climb = clip(g.altitude_kp * e_height + ref.altitude_rate, g.climb_max)
    s.x_dc_dot[U_DOT] += GRAVITY_M_S2 * climb / v  # thrust for the energy of the climb
    pitch = s.pitch_integral + climb / v
    turn = GRAVITY_M_S2 / v * math.tan(y.roll) * math.sin(y.roll)
    s.x_dc_dot[Q_DOT] = g.q_kp * (g.pitch_kp * (pitch - y.pitch) + turn - y.q)


@compiled
def lateral(y, ref, dt, g, k, s):
    """Desired p_dot and r_dot from heading, into `s.x_dc_dot`: turn rate, then bank, then the rates that bring it about."""
    v = max(y.airspeed, 1.0)
    e_heading = clip(wrap(ref.heading - y.heading), HEADING_ERROR_MAX)
    s.heading_integral = clip(s.heading_integral + g.heading_ki * e_heading * dt, HEADING_INTEGRAL_MAX)
    turn_rate = g.heading_kp * e_heading + ref.heading_rate + s.heading_integral
    bank = clip(math.atan(v / GRAVITY_M_S2 * turn_rate), g.roll_max)
    r = GRAVITY_M_S2 / v * math.sin(y.roll)  # of a coordinated turn
    if k.released[P_DOT]:
        r += g.roll_kp * (bank - y.roll)
    s.x_dc_dot[P_DOT] = g.p_kp * (g.bank_kp * (bank - y.roll) - y.p)
    s.x_dc_dot[R_DOT] = g.r_kp * (r - y.r)


@compiled
def pid_step(step, parts):
    """One control step: loops, allocation and commands for one measured state; the last part is the gains."""
    states, setpoints, telemetry, models, settings, modes, memories, works, gains = parts
    y, ref, g, w = states[step], setpoints[step], gains[0], works[0]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    axial = axial_speed(y)
    advance_actuators(c.dt, axial, m, s)
    longitudinal(y, ref, c.dt, g, k, s)
    lateral(y, ref, c.dt, g, k, s)
    pressure_ratio = max(pressure_ratio_of(y, m), PRESSURE_RATIO_MIN)
    allocate_and_command(s.x_dc_dot, pressure_ratio, axial, m, c, k, s, w)
    write_telemetry(telemetry[step], k.released, s)


def pid(setup: Setup) -> CompiledController:
    """The controller. It takes all actuators for healthy, and says nothing of them.

    Args:
        setup: design model (effects, trim, throttle curve), stops, released axes, gains in `settings`.
    """
    settings, gains = (
        settings_record(setup, None),
        gains_record(suited(setup.settings_as(PidSettings), setup)),
    )
    return CompiledController(setup, pid_step, settings, mode_record(setup), trimmed_memory(setup), (gains,))


def gains_record(settings: PidSettings) -> np.ndarray:
    """The gains as the compiled functions read them: one record of what `PidSettings` has, angles in radians."""
    names = [name for name in PidSettings.model_fields if name not in ControllerSettings.model_fields]
    record = np.zeros(1, record_dtype(tuple(name.removesuffix("_deg") for name in names)))
    for name in names:
        value = getattr(settings, name)
        record[0][name.removesuffix("_deg")] = math.radians(value) if name.endswith("_deg") else value
    return record


def mode_record(setup: Setup) -> np.ndarray:
    """The allocation about the reference trim with every actuator available: one record of `records.MODE`."""
    n, loops = len(setup.actuators), setup.control.loops
    b = np.array(setup.model.input_matrix)[:4] * setup.scale
    kept = [i for i, axis in enumerate(RATES) if axis not in setup.released]
    record = np.zeros(1, mode_dtype(n))
    k = record[0]
    k.available[:], k.released[:] = 1, [axis in setup.released for axis in RATES]
    k.B_hat_inv[:, kept] = np.linalg.pinv(b[kept])
    k.row_weight[:], k.hessian[:] = allocation_of(b, setup.released, setup.control.allocation)
    k.trim_effect[:] = np.array(setup.model.trim) / setup.scale
    k.slow_descent, k.slow_descent_from = loops.slow_descent_s, loops.protect_from_m_s
    return record


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
