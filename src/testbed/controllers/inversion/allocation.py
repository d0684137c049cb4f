"""Allocation: from the virtual control nu to actuator positions within the stops, and to the commands for them.

The paper inverts (29) and compensates (section 2.2.1). Added here is what to do when an actuator would pass its stop: first
leave it at the stop and let redundant actuators make up for it, then give up airspeed control.

Letters: m design model, c settings, k control mode, s memory, nu [4] of the working memory; their fields, shapes and
units are in `records`.
"""

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.commands import command_actuators
from testbed.controllers.inversion.law import compensate, divisor, invert
from testbed.controllers.records import U_DOT


@compiled
def allocate_and_command(nu, pressure_ratio, axial, m, c, k, s):
    """Fill `s` with references r, commanded positions u within the stops, and commands, for a virtual control.

    Args:
        nu: [4] virtual control [rad/s2, m/s2].
        axial: airspeed along the propellers' axis [m/s].
    """
    invert(nu, pressure_ratio, m, k, s)
    redistribute(nu, pressure_ratio, m, c, k, s)
    give_up_airspeed(m, c, k, s)
    compensate(m, c, k, s)
    command_actuators(axial, m, s)


@compiled
def redistribute(nu, pressure_ratio, m, c, k, s):
    """With more actuators than axes, leave the actuator that would pass its stop furthest at the stop, and solve for the
    others (redistributed pseudo-inverse; Bodson, J. Guidance 25 (2002) 703)."""
    worst, excess = -1, 0.0
    for i in range(len(s.r)):
        lam = divisor(i, c, s)
        beyond = max(s.r[i] - m.high[i] * lam, m.low[i] * lam - s.r[i])
        if k.available[i] and beyond > excess:
            worst, excess = i, beyond
    if not k.redundant or worst < 0:
        return
    lam = divisor(worst, c, s)
    at_stop = min(max(s.r[worst], m.low[worst] * lam), m.high[worst] * lam)
    effect = at_stop * (pressure_ratio if m.servo[worst] else 1.0) - k.r_trim[worst]
    for j in range(len(s.r)):
        s.r[j] = k.r_trim[j]
        for i in range(4):
            s.r[j] += k.B_hat_inv_at_stop[worst, j, i] * (nu[i] - m.B[i, worst] * effect)
        if m.servo[j]:
            s.r[j] /= pressure_ratio
    s.r[worst] = at_stop


@compiled
def give_up_airspeed(m, c, k, s):
    """When an actuator would still pass its stop, change the demanded u_dot, and no other rate, by the least that is needed.

    r moves along the u_dot column of B_hat^-1 until no actuator passes its stop. Where no such point exists, it moves
    midway between the demands of the conflicting stops."""
    least, most = -1e9, 1e9
    for i in range(len(s.r)):
        d = k.B_hat_inv[i, U_DOT]
        if not k.available[i] or abs(d) < 1e-6:
            continue
        lam = divisor(i, c, s)
        a, b = (m.low[i] * lam - s.r[i]) / d, (m.high[i] * lam - s.r[i]) / d
        least, most = max(least, min(a, b)), min(most, max(a, b))
    shift = 0.5 * (least + most) if least > most else min(max(0.0, least), most)
    if shift != 0.0:
        for i in range(len(s.r)):
            s.r[i] += k.B_hat_inv[i, U_DOT] * shift
