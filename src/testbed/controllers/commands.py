"""The end of every control step: positions become commands, and a row of telemetry is written for the log.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.common.signals import Belief
from testbed.controllers.actuator_model import engine_throttle_for, throttle_for
from testbed.controllers.inversion.offset_detection import is_late, is_offset

# Compiled functions take the codes as plain numbers.
WORKS, DOUBTED, LOST, HELD = map(int, (Belief.works, Belief.doubted, Belief.lost, Belief.held))
REVERSED, OFFSET, LATE = map(int, (Belief.reversed, Belief.offset, Belief.late))


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
    """Fill one row of telemetry with what every law says: references, commands, desired rates and released ones.

    Args:
        row: [`signals.telemetry_width`] to be filled.
        released: [4] flags of the rates that are given up.
    """
    n = len(s.u)
    for i in range(n):
        row[i] = s.r[i]
        row[n + i] = s.u[i]
    for i in range(4):
        row[4 * n + i] = s.x_dc_dot[i]
        row[4 * n + 4 + i] = released[i]


@compiled
def belief(i, c, s):
    """What the law takes actuator i for: a code of `signals.Belief`.

    One is doubted while it `moved` and it is not known why, or while its flag is taken back (`early`) and its estimate is not as
    high as that of one that works again."""
    if s.reversed[i]:
        return REVERSED
    if s.jammed[i]:
        return HELD
    if s.failed[i]:
        return LOST
    if is_offset(i, s):
        return OFFSET
    if s.moved[i] != 0.0 or (s.early[i] and s.lambda_hat[i] < c.recovery):
        return DOUBTED
    return LATE if is_late(i, s) else WORKS


@compiled
def write_diagnosis(row, c, s):
    """Fill the estimates of a row of telemetry, its flags and its `signals.BELIEFS`: nothing that the law does not make.

    Args:
        row: [`signals.telemetry_width`]
        c, s: settings and memory of the diagnosis.
    """
    n = len(s.u)
    if c.estimates:
        for i in range(n):
            row[2 * n + i] = 0.0 if s.jammed[i] else s.lambda_hat[i]  # of a jammed one this is its position
    if not (c.monitors or c.tests_jams):
        return
    for i in range(n):
        believed = belief(i, c, s)
        row[3 * n + i] = s.failed[i]
        row[4 * n + 8 + i] = believed
        row[5 * n + 8 + i] = s.lambda_hat[i] if believed == HELD else math.nan


@compiled
def write_guard(row, s):
    """Fill which of `signals.GUARDED` are taken for stuck, in a row of telemetry."""
    first = len(row) - len(s.stuck)
    for i in range(len(s.stuck)):
        row[first + i] = s.stuck[i]
