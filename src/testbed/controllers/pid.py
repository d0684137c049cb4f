"""A conventional autopilot: cascaded loops, and an allocation from the design model.

The autopilot that a designer would give an aircraft without an inversion. Airspeed commands thrust. Altitude commands pitch,
and pitch the pitch rate. Heading commands bank. Where the aircraft can roll against gusts, bank commands the roll rate, and
the yaw rate is that of a coordinated turn. Where roll is given up (`released`), as on an aircraft that cannot roll by itself, bank
commands the yaw rate: yawing causes sideslip, and with dihedral sideslip causes roll. No dynamics are cancelled and nothing
is estimated; integrators find the trim. The design model gives the trim to start from, the motors' throttle curve, and the
effect of each actuator. The actuators share each demand as in the other controllers (`inversion.allocation`), so the gains
are rates per error, and those of one aircraft are near those of another.

Structure: Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., sec. 4.4 to 4.6; bank by rudder and
dihedral as on a two-axis glider. How the gains were found: `PidSettings`.

Letters: those of `records`, and g the gains (`PidSettings`).
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

import numpy as np

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
from testbed.controllers.pid_design import suited
from testbed.controllers.records import P_DOT, Q_DOT, R_DOT, U_DOT, mode_dtype
from testbed.controllers.setup import Setup

HEADING_ERROR_MAX = 0.35  # rad, to which the heading error is limited
HEADING_INTEGRAL_MAX = 0.3  # rad/s
PRESSURE_RATIO_MIN = 0.2
"""Least dynamic pressure over that at the reference that the allocation divides by. So at low airspeed a surface deflects at most
five times as far as at the reference airspeed for the same desired rate."""


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
