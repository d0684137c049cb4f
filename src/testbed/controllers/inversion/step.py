"""One control step of the adaptive inversion controller: the block diagram of the paper's figure 2, top to bottom."""

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance, throttle_for
from testbed.controllers.inversion.diagnosis import adapt_weighted, doubt, suspect
from testbed.controllers.inversion.law import (
    adapt,
    compensate,
    give_up_speed,
    invert,
    measured_error,
    monitor,
    redistribute,
    regressor,
    state_function,
)
from testbed.controllers.outer_loops import pid, regulate


@compiled
def low_pass(x, memory, a):
    """Two equal first-order lags in series on each element of x, in place; a = w dt, 0 for none."""
    if a > 0.0:
        gain = 1.0 - math.exp(-a)
        for i in range(len(x)):
            memory[0, i] += gain * (x[i] - memory[0, i])
            memory[1, i] += gain * (memory[0, i] - memory[1, i])
            x[i] = memory[1, i]


@compiled
def adaptive_step(step, parts):
    """Estimate, monitor, invert and command for one measured state; returns 1 when the set of failures changed, and
    then has not commanded: the mode must be put in force first (`command_step`).

    Args:
        step: row of the channels.
        parts: states, setpoints, telemetry (see `Controller.bind`), then model, settings, mode and memory (record
            arrays of one, see `records`), then working memory [4, 6 + n], so that nothing is allocated. One tuple,
            because numba takes it in a third of the time.
    """
    states, _, _, models, settings, _, memories, work = parts
    y, m, c, s = states[step], models[0], settings[0], memories[0]
    f, z, e, phi = work[:, 0], work[:, 1], work[:, 2], work[:, 6:]
    pressure = (y.airspeed / m.airspeed) * (y.airspeed / m.airspeed)
    axial = y.airspeed * math.cos(y.alpha) * math.cos(y.beta)

    advance(c.dt, axial, m, s)
    state_function(y, m, f)
    if c.adapts > 0.5:
        z[0], z[1], z[2], z[3] = y.p_dot - f[0], y.q_dot - f[1], y.r_dot - f[2], y.u_dot - f[3]
        for i in range(4):
            z[i] += m.offset[i] * pressure  # in f_m as if all propellers were whole; Phi has it for each
        regressor(pressure, m, s, phi)
        low_pass(z, s.filtered, c.filter * c.dt)
        for i in range(4):
            low_pass(phi[i], s.filtered_phi[:, i], c.filter * c.dt)
        doubt(y, pressure, phi, m, c, s)
        measured_error(z, phi, s, e)
        if c.weighted > 0.5:
            adapt_weighted(z, phi, m, c, s)
        else:
            adapt(e, pressure, m, c, s)
        if c.monitors > 0.5 and (monitor(c, s) or suspect(e, pressure, m, c, s)):
            return 1
    command_step(step, parts)
    return 0


@compiled
def command_step(step, parts):
    """Outer loops, inversion and commands with the mode in force."""
    states, setpoints, telemetry, models, settings, modes, memories, work = parts
    y, ref = states[step], setpoints[step]
    m, c, k, s = models[0], settings[0], modes[0], memories[0]
    f, wanted = work[:, 0], work[:, 3]
    pressure = (y.airspeed / m.airspeed) * (y.airspeed / m.airspeed)
    axial = y.airspeed * math.cos(y.alpha) * math.cos(y.beta)
    if k.regulated > 0.5:
        regulate(y, ref, m, c, k, s, f, wanted)
    else:
        pid(y, ref, m, c, k, s, f, wanted)
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


@compiled
def tell(row, k, s):
    """Fill one row of telemetry, in the order of `signals.TELEMETRY`."""
    n = len(s.u)
    for i in range(n):
        row[i] = s.r[i]
        row[n + i] = s.u[i]
        row[2 * n + i] = 0.0 if s.jammed[i] > 0.5 else s.lambda_hat[i]
        row[3 * n + i] = s.failed[i]
    for i in range(4):
        row[4 * n + i] = s.x_dot_desired[i]
        row[4 * n + 4 + i] = k.released[i]


def scratch(n: int) -> np.ndarray:
    """Working memory for `adaptive_step`."""
    return np.zeros((4, 6 + n))
