"""Incremental nonlinear dynamic inversion: what the model does not know is measured, not modelled.

u = u_f + B^-1 (nu - x_c_dot_f) (Sieberling, Chu and Mulder, J. Guidance 33 (2010) 1732; Smeur, Chu and de Croon,
J. Guidance 39 (2016) 450): the position that the modelled actuators have reached, plus what the difference between the
rates wanted and the rates measured asks for. Rates are noisy and must be filtered; the actuators' positions go through
the same filter, or the increments would be of another moment than the rates (Smeur's synchronisation).

Positions enter as their effect, Phi 1 (`law.regressor`), so that dynamic pressure and motor torque are those of the
moment: B u_f = (Phi 1)_f. With all axes controlled, nu is what the paper's outer loops want. With an axis released the
outer loop is the adaptive law's regulator, which asks for f_m(x) + v and so keeps what is stable; nu - x_c_dot then
is v less the residual x_c_dot - f_m - Phi 1, and all of the residual is filtered alike.

It neither estimates nor monitors; a lost actuator is one more error that the next increment is to make up for.
"""

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import bound, compiled
from testbed.controllers.actuator_model import advance, throttle_for
from testbed.controllers.config import IndiSettings
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.law import (
    compensate,
    give_up_speed,
    invert,
    redistribute,
    regressor,
    state_function,
)
from testbed.controllers.inversion.step import low_pass, tell
from testbed.controllers.outer_loops import pid, regulate
from testbed.controllers.setup import Setup


@compiled
def measured_remainder(y, pressure, m, c, k, s, f, phi, z):
    """z = (x_c_dot - Phi 1)_f: what moves the rates beside the actuators, as measured; less f_m in a regulated mode."""
    regressor(pressure, m, s, phi)
    z[0], z[1], z[2], z[3] = y.p_dot, y.q_dot, y.r_dot, y.u_dot
    for i in range(4):
        z[i] += m.offset[i] * pressure - k.regulated * f[i]
        for j in range(len(s.position)):
            z[i] -= phi[i, j]
    low_pass(z, s.filtered, c.filter * c.dt)


@compiled
def indi_step(step, parts):
    """Measure, ask the outer loops, increment, allocate and command."""
    states, setpoints, telemetry, models, settings, modes, memories, work = parts
    y, ref = states[step], setpoints[step]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    f, z, wanted, phi = work[:, 0], work[:, 1], work[:, 3], work[:, 6:]
    pressure = (y.airspeed / m.airspeed) ** 2
    axial = y.airspeed * math.cos(y.alpha) * math.cos(y.beta)
    advance(c.dt, axial, m, s)
    state_function(y, m, f)
    measured_remainder(y, pressure, m, c, k, s, f, phi, z)
    if k.regulated > 0.5:
        regulate(y, ref, m, c, k, s, f, wanted)
    else:
        pid(y, ref, m, c, k, s, f, wanted)
    for i in range(4):
        wanted[i] = (wanted[i] if k.regulated > 0.5 else s.x_dot_desired[i]) - z[i]
    invert(wanted, pressure, m, k, s)
    redistribute(wanted, pressure, m, c, k, s)
    give_up_speed(m, c, k, s)
    compensate(m, c, k, s)
    for i in range(len(s.u)):
        if m.servo[i] > 0.5:
            s.command[i] = s.u[i] * m.scale[i]
        else:
            s.command[i] = throttle_for(i, s.u[i] * m.scale[i], axial, m, s)
    tell(telemetry[step], k, s)


class IndiController(InversionController):
    """Incremental inversion on the records, modes and outer loops of the inversion controller, without its estimates:
    they are logged as 1, for it acts as if all were whole."""

    def __init__(self, setup: Setup) -> None:
        super().__init__(setup, adapts=False)
        self.settings[0].filter = setup.settings_as(IndiSettings).filter_rad_s

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight (see `controllers.Controller`)."""
        super().bind(states, setpoints, telemetry)
        self._step = bound(indi_step, 0, self._parts)

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        self._step(step, self._parts)
        return self._told
