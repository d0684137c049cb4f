"""The end of every control step: positions become commands, and a row of telemetry is written for the log.

Letters: m design model (`records.MODEL`), s memory (`records.MEMORY`).
"""

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.actuator_model import engine_throttle_for, throttle_for


@compiled
def command_actuators(axial, m, s):
    """Fill `s.command` for the positions `s.u` [scaled]: servo deflections [rad], and the throttles that give the thrusts."""
    for i in range(len(s.u)):
        if m.servo[i]:
            s.command[i] = s.u[i] * m.scale[i]
        elif m.engine[i]:
            s.command[i] = engine_throttle_for(i, s.u[i], axial, m)
        else:
            s.command[i] = throttle_for(i, s.u[i] * m.scale[i], axial, m, s)


@compiled
def write_telemetry(row, released, s):
    """Fill one row of telemetry, in the order of `signals.TELEMETRY`.

    Args:
        row: [`signals.telemetry_width`] to be filled.
        released: [4] flags of the rates that are given up.
    """
    n = len(s.u)
    for i in range(n):
        row[i] = s.r[i]
        row[n + i] = s.u[i]
        row[2 * n + i] = 0.0 if s.jammed[i] else s.lambda_hat[i]  # of a jammed one this is its position
        row[3 * n + i] = s.failed[i]
    for i in range(4):
        row[4 * n + i] = s.x_dc_dot[i]
        row[4 * n + 4 + i] = released[i]
