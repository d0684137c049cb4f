"""The law's own regression (10), run over a log: z = x_c_dot - f_m and Phi, by the compiled functions of the law.

Letters: y measured state, m design model, s memory, f working memory; their fields, shapes and units are in `controllers.records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators
from testbed.controllers.inversion.law import pressure_ratio_of, regressor, state_function


@compiled
def replay(states, commands, thrusts, dt, m, s, f, z, phi):
    """Run the actuators' model over a log, and fill both sides of (10).

    Args:
        states: [rows] records of `signals.STATE`.
        commands: [rows, n] rad or throttle; where `thrusts` [n] is set, the commanded position in scaled units.
        dt: time between two rows [s].
        f: [4] working memory.
        z: [rows, 4] filled with x_c_dot - f_m.
        phi: [rows, 4, n] filled with what each actuator adds to the rates if it works.
    """
    for k in range(len(states)):
        y = states[k]
        if k > 0:
            advance_actuators(dt, axial_speed(y), m, s)
        for i in range(len(s.u)):
            s.u[i] = commands[k, i]
        command_actuators(axial_speed(y), m, s)
        for i in range(len(s.u)):
            if not thrusts[i]:
                s.command[i] = commands[k, i]
        pressure_ratio = pressure_ratio_of(y, m)
        state_function(y, m, f)
        z[k, 0], z[k, 1], z[k, 2], z[k, 3] = y.p_dot - f[0], y.q_dot - f[1], y.r_dot - f[2], y.u_dot - f[3]
        for i in range(
            4
        ):  # both f and Phi contain the constant part of the propellers' torque: count it once
            z[k, i] += m.offset[i] * pressure_ratio
        regressor(pressure_ratio, m, s, phi[k])
