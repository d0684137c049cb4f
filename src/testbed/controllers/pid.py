"""A conventional autopilot: a mixer and cascaded loops, gains scheduled with dynamic pressure.

The autopilot that a designer would give this aircraft without an inversion. The tails are mixed into an elevator (their sum) and a
rudder (their difference), the propellers into one throttle. Altitude commands pitch, and pitch the elevator. Heading
commands bank. There are no ailerons, so bank commands the rudder: yawing causes sideslip, and with dihedral sideslip causes
roll. No dynamics are cancelled and nothing is estimated; integrators find the trim. The design model gives the trim to start
from, the motors' throttle curve, and the mixer. With this mixer the gains are rates per error, so those of one aircraft are
near those of another.

Structure: Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., sec. 4.4 to 4.6; bank by rudder and
dihedral as on a two-axis glider. How the gains were found: `PidSettings`.

Letters: y state, ref references, m design model, s memory (`records`), g gains (GAINS), mixer [n, 4] of `mixer_of`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from testbed.common.jit import bound, compiled
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators, write_telemetry
from testbed.controllers.config import PidSettings
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.inversion.law import pressure_ratio_of
from testbed.controllers.outer_loops import clip, wrap
from testbed.controllers.records import Q_DOT, R_DOT, U_DOT
from testbed.controllers.setup import Setup

GAINS = (
    "airspeed_kp", "airspeed_ki", "u_dot_max", "altitude_kp", "altitude_ki", "climb_max", "pitch_kp", "q_kp",
    "heading_kp", "heading_ki", "roll_kp", "roll_max", "r_kp",
)  # fmt: skip
"""Fields of the gains' record: those of `PidSettings`, with `roll_max` in radians."""

# Errors are limited to these before they enter the loops.
AIRSPEED_ERROR_MAX = 2.0  # m/s
ALTITUDE_ERROR_MAX = 5.0  # m
HEADING_ERROR_MAX = 0.35  # rad
HEADING_INTEGRAL_MAX = 0.3  # rad/s
PRESSURE_RATIO_MIN = 0.2
"""Least dynamic pressure over that at the reference that the mixer divides by. So at low airspeed a surface deflects at most
five times as far as at the reference airspeed for the same desired rate."""


@compiled
def longitudinal(y, ref, dt, g, s):
    """Desired u_dot from airspeed, and q_dot from altitude through pitch and pitch rate, into `s.x_dc_dot`."""
    v = max(y.airspeed, 1.0)
    e_speed = clip(ref.airspeed - y.airspeed, AIRSPEED_ERROR_MAX)
    e_height = clip(ref.altitude - y.altitude, ALTITUDE_ERROR_MAX)
    s.airspeed_integral = clip(s.airspeed_integral + g.airspeed_ki * e_speed * dt, g.u_dot_max)
    s.x_dc_dot[U_DOT] = clip(g.airspeed_kp * e_speed + s.airspeed_integral + ref.airspeed_rate, g.u_dot_max)

    s.pitch_integral += g.altitude_ki * e_height * dt
    climb = clip(g.altitude_kp * e_height + ref.altitude_rate, g.climb_max)
    pitch = s.pitch_integral + climb / v
    turn = GRAVITY_M_S2 / v * math.tan(y.roll) * math.sin(y.roll)
    s.x_dc_dot[Q_DOT] = g.q_kp * (g.pitch_kp * (pitch - y.pitch) + turn - y.q)


@compiled
def lateral(y, ref, dt, g, s):
    """Desired r_dot from heading, into `s.x_dc_dot`: turn rate, then bank, then the yaw rate that brings this bank about."""
    v = max(y.airspeed, 1.0)
    e_heading = clip(wrap(ref.heading - y.heading), HEADING_ERROR_MAX)
    s.heading_integral = clip(s.heading_integral + g.heading_ki * e_heading * dt, HEADING_INTEGRAL_MAX)
    turn_rate = g.heading_kp * e_heading + ref.heading_rate + s.heading_integral
    bank = clip(math.atan(v / GRAVITY_M_S2 * turn_rate), g.roll_max)
    r = GRAVITY_M_S2 / v * math.sin(y.roll) + g.roll_kp * (bank - y.roll)
    s.x_dc_dot[R_DOT] = g.r_kp * (r - y.r)


@compiled
def mix(pressure_ratio, mixer, m, s):
    """Positions for the desired rates `s.x_dc_dot`: the mixer's, about the trim, into `s.r`; limited to the stops, into `s.u`."""
    for i in range(len(s.u)):
        x = 0.0
        for j in range(4):
            x += mixer[i, j] * s.x_dc_dot[j]
        s.r[i] = m.trim_position[i] + (x / pressure_ratio if m.servo[i] else x)
        s.u[i] = min(max(s.r[i], m.low[i]), m.high[i])


@compiled
def pid_step(step, parts):
    """One control step: loops, mixer and commands for one measured state.

    Args:
        step: row of the channels.
        parts: states, setpoints and telemetry (see `Controller.bind`), then model, gains and memory, each an array of one
            record, the mixer [n, 4], the flags of released axes [4] (all 0), and the control step [s].
    """
    states, setpoints, telemetry, models, gains, memories, mixer, released, dt = parts
    y, ref, m, g, s = states[step], setpoints[step], models[0], gains[0], memories[0]
    axial = axial_speed(y)
    advance_actuators(dt, axial, m, s)
    longitudinal(y, ref, dt, g, s)
    lateral(y, ref, dt, g, s)
    mix(max(pressure_ratio_of(y, m), PRESSURE_RATIO_MIN), mixer, m, s)
    command_actuators(axial, m, s)
    write_telemetry(telemetry[step], released, s)


class PidController:
    """Mixer and loops. It takes all actuators for healthy, so its estimates are logged as 1; it never releases an axis.

    Args:
        setup: design model (mixer, trim, throttle curve), stops, gains in `settings`.
    """

    reasons: Sequence[tuple[int, str]] = ()

    def __init__(self, setup: Setup) -> None:
        memory = trimmed_memory(setup)
        mixer = mixer_of(np.array(setup.model.input_matrix)[:4] * setup.scale, setup.model.kinds)
        gains = gains_record(setup.settings_as(PidSettings))
        self._own = (model_record(setup), gains, memory, mixer, np.zeros(4, np.int8), setup.dt_s)
        self._commands = memoryview(memory[0].command)  # quicker to go through than the array

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `controllers.Controller`)."""
        self._parts = (states, setpoints, telemetry, *self._own)
        self._step = bound(pid_step, 0, self._parts)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        self._step(step, self._parts)
        return self._commands


def gains_record(settings: PidSettings) -> np.ndarray:
    """The gains as the compiled functions read them: one record of GAINS."""
    record = np.zeros(1, np.dtype((np.record, [(name, np.float64) for name in GAINS])))
    for name in GAINS:
        record[0][name] = (
            math.radians(settings.roll_max_deg) if name == "roll_max" else getattr(settings, name)
        )
    return record


def mixer_of(b: np.ndarray, kinds: tuple[str, ...]) -> np.ndarray:
    """[n, 4] from desired rates to scaled positions: surfaces make q_dot and r_dot, equal thrusts make u_dot, nothing makes p_dot.

    Args:
        b: [4, n] scaled input matrix.
        kinds: [n] `servo` or `motor`.
    """
    surfaces = [i for i, kind in enumerate(kinds) if kind == "servo"]
    motors = [i for i, kind in enumerate(kinds) if kind == "motor"]
    mixer = np.zeros((b.shape[1], 4))
    mixer[np.ix_(surfaces, [Q_DOT, R_DOT])] = np.linalg.pinv(b[np.ix_([Q_DOT, R_DOT], surfaces)])
    mixer[motors, U_DOT] = 1.0 / b[U_DOT, motors].sum()
    return mixer
