"""A conventional autopilot: a mixer and cascaded loops, gains scheduled with dynamic pressure.

What a designer would fly on this aircraft without an inversion: the tails are mixed into an elevator (their sum) and a
rudder (their difference), the propellers into one throttle. Altitude commands pitch, pitch the elevator; heading
commands bank, and bank, which has no control of its own, the rudder: yaw makes sideslip, and dihedral rolls. Nothing is
cancelled, nothing is estimated; integrators find the trim. The design model gives the mixer (so that gains are rates
per error, and gains of one aircraft are near those of another), the trim to start from, and the motors' throttle curve.

Structure: Stevens, Lewis and Johnson, Aircraft Control and Simulation, 3rd ed., sec. 4.4 to 4.6; bank by rudder and
dihedral as on a two-axis glider. Gains were searched for on healthy flights alone (see `PidSettings`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from testbed.common.jit import bound, compiled
from testbed.common.signals import RATES
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.actuator_model import advance, throttle_for
from testbed.controllers.config import PidSettings
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.outer_loops import clip, wrap
from testbed.controllers.setup import Setup

GAINS = (
    "airspeed_kp", "airspeed_ki", "u_dot_max", "altitude_kp", "altitude_ki", "climb_max", "pitch_kp", "q_kp",
    "heading_kp", "heading_ki", "roll_kp", "roll_max", "r_kp",
)  # fmt: skip
"""Fields of the gains' record; those of `PidSettings`, angles in radians."""


@compiled
def longitudinal(y, ref, dt, g, s, wanted):
    """q_dot from altitude and u_dot from airspeed [rad/s2, m/s2], about the trim."""
    v = max(y.airspeed, 1.0)
    e_speed = clip(ref.airspeed - y.airspeed, 2.0)
    e_height = clip(ref.altitude - y.altitude, 5.0)
    s.integral[3] = clip(s.integral[3] + g.airspeed_ki * e_speed * dt, g.u_dot_max)
    wanted[3] = clip(g.airspeed_kp * e_speed + s.integral[3] + ref.airspeed_rate, g.u_dot_max)

    s.integral[1] += g.altitude_ki * e_height * dt
    climb = clip(g.altitude_kp * e_height + ref.altitude_rate, g.climb_max)
    pitch = s.integral[1] + climb / v
    turn = GRAVITY_M_S2 / v * math.tan(y.roll) * math.sin(y.roll)
    wanted[1] = g.q_kp * (g.pitch_kp * (pitch - y.pitch) + turn - y.q)


@compiled
def lateral(y, ref, dt, g, s, wanted):
    """r_dot from heading [rad/s2]: turn rate, then bank, then the yaw rate that will roll to it."""
    v = max(y.airspeed, 1.0)
    e_heading = clip(wrap(ref.heading - y.heading), 0.35)
    s.integral[0] = clip(s.integral[0] + g.heading_ki * e_heading * dt, 0.3)
    rate = g.heading_kp * e_heading + ref.heading_rate + s.integral[0]
    bank = clip(math.atan(v / GRAVITY_M_S2 * rate), g.roll_max)
    r = GRAVITY_M_S2 / v * math.sin(y.roll) + g.roll_kp * (bank - y.roll)
    wanted[2] = g.r_kp * (r - y.r)


@compiled
def mix(wanted, pressure, mixer, m, s):
    """Scaled positions about the trim: elevator, rudder and thrust; surfaces by 1/dynamic pressure; within stops."""
    for i in range(len(s.u)):
        x = 0.0
        for j in range(4):
            x += mixer[i, j] * wanted[j]
        s.r[i] = m.hold[i] + (x / pressure if m.servo[i] > 0.5 else x)
        s.u[i] = min(max(s.r[i], m.low[i]), m.high[i])


@compiled
def pid_step(step, parts):
    """Loops, mixer, commands for one measured state."""
    states, setpoints, telemetry, models, gains, memories, mixer, wanted, dt = parts
    y, ref, m, g, s = states[step], setpoints[step], models[0], gains[0], memories[0]
    pressure = max((y.airspeed / m.airspeed) ** 2, 0.2)
    axial = y.airspeed * math.cos(y.alpha) * math.cos(y.beta)
    advance(dt, axial, m, s)
    longitudinal(y, ref, dt, g, s, wanted)
    lateral(y, ref, dt, g, s, wanted)
    mix(wanted, pressure, mixer, m, s)
    n = len(s.u)
    for i in range(n):
        if m.servo[i] > 0.5:
            s.command[i] = s.u[i] * m.scale[i]
        else:
            s.command[i] = throttle_for(i, s.u[i] * m.scale[i], axial, m, s)
        telemetry[step, i], telemetry[step, n + i], telemetry[step, 2 * n + i] = s.r[i], s.u[i], 1.0
    for i in range(4):
        telemetry[step, 4 * n + i] = wanted[i]


class PidController:
    """Mixer and loops. Estimates are logged as 1, for it acts as if all were whole; no axis is ever released.

    Args:
        setup: design model (mixer, trim, throttle curve), stops, gains in `settings`.
    """

    reasons: Sequence[tuple[int, str]] = ()

    def __init__(self, setup: Setup) -> None:
        self.model, self.memory = model_record(setup), trimmed_memory(setup)
        self.gains = np.zeros(1, np.dtype((np.record, [(name, np.float64) for name in GAINS])))
        chosen = setup.settings_as(PidSettings)
        for name in GAINS:
            self.gains[0][name] = (
                math.radians(chosen.roll_max_deg) if name == "roll_max" else getattr(chosen, name)
            )
        self.mixer = mixer_of(np.array(setup.model.input_matrix)[:4] * setup.scale, setup.model.kinds)
        s = self.memory[0]
        self._command: np.ndarray = s.command
        self._own = (self.model, self.gains, self.memory, self.mixer, np.zeros(4), setup.dt_s)

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `controllers.Controller`)."""
        self._parts = (states, setpoints, telemetry, *self._own)
        self._step = bound(pid_step, 0, self._parts)

    def step(self, step: int) -> np.ndarray:
        """Commands [n] for row `step`."""
        self._step(step, self._parts)
        return self._command


def mixer_of(b: np.ndarray, kinds: tuple[str, ...]) -> np.ndarray:
    """[n, 4] from rates to actuators: q_dot and r_dot by the surfaces, u_dot by equal thrust; p_dot by nothing.

    Args:
        b: [4, n] scaled input matrix.
        kinds: `servo` or `motor` each.
    """
    q, r, u = (RATES.index(name) for name in ("q_dot", "r_dot", "u_dot"))
    surfaces = [i for i, kind in enumerate(kinds) if kind == "servo"]
    motors = [i for i, kind in enumerate(kinds) if kind == "motor"]
    mixer = np.zeros((b.shape[1], 4))
    mixer[np.ix_(surfaces, [q, r])] = np.linalg.pinv(b[np.ix_([q, r], surfaces)])
    mixer[motors, u] = 1.0 / b[u, motors].sum()
    return mixer
