"""Allocation: from the virtual control nu to actuator positions within the stops, and to the commands for them.

The paper inverts (29) and compensates (section 2.2.1). Added here is what to do when an actuator would pass its stop: of all
positions within the stops, those are taken whose rates are closest to nu, by weighted least squares. So the others make up for an
actuator at its stop as far as they can. Where they cannot, the weights (`control.allocation` of the aircraft) say which axis gives
way: airspeed before attitude.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.commands import command_actuators
from testbed.controllers.inversion.bounded_least_squares import bounded_least_squares
from testbed.controllers.inversion.law import compensate, effect_ratio, invert, largest, reach
from testbed.controllers.records import U_DOT


@compiled
def allocate_and_command(nu, pressure_ratio, axial, m, c, k, s, w):
    """Fill `s` with references r, commanded positions u within the stops, and commands, for a virtual control nu [4]."""
    allocate(nu, pressure_ratio, m, c, k, s, w)  # (6), (29): r
    compensate(m, c, k, s)  # (8): u = Lambda_hat^-1 r
    command_actuators(axial, m, s)


@compiled
def allocate(nu, pressure_ratio, m, c, k, s, w):
    """Fill `s` with references r for a virtual control nu [4]: (29), or where an actuator would pass a stop, the nearest within."""
    invert(nu, pressure_ratio, m, k, s)  # (29)
    s.saturated = passes_a_stop(m, c, k, s)
    if s.saturated:
        allocate_within_stops(nu, pressure_ratio, m, c, k, s, w)


@compiled
def passes_a_stop(m, c, k, s):
    """Whether an available actuator would have to pass a stop for its reference r."""
    for i in range(len(s.r)):
        low, high = reach(i, m, c, s)
        if k.available[i] and (s.r[i] > high or s.r[i] < low):
            return True
    return False


@compiled
def allocate_within_stops(nu, pressure_ratio, m, c, k, s, w):
    """References r within the stops whose rates are closest to nu [4]: minimises

        sum over kept rows of weight (B d - nu)^2 + deviation_weight |d|^2,    d = effect_ratio r - trim_effect.

    Actuators that answer to u_dot alone are solved for first, as if they did not turn the aircraft; then the others, which make up
    for what they turn. Because d is the effective deviation, a weak actuator has lambda_hat times its travel.
    """
    set_bounds(pressure_ratio, m, c, k, s, w)
    if largest(k.thrust_alone):
        right_hand_side(nu, True, m, k, w)
        bounded_least_squares(k.thrust_hessian, w.g, w.low, w.high, w.d, s.at_stop, w.factor, w.step)
        for i in range(len(s.r)):
            if k.thrust_alone[i]:
                w.low[i] = w.high[i] = w.d[i]  # the second problem takes these as they are
    right_hand_side(nu, False, m, k, w)
    bounded_least_squares(k.hessian, w.g, w.low, w.high, w.d, s.at_stop, w.factor, w.step)
    for i in range(len(s.r)):
        s.r[i] = (k.trim_effect[i] + w.d[i]) / effect_ratio(i, pressure_ratio, m)
        if k.thrust_alone[i]:
            s.at_stop[i] = 0  # its bounds were made equal above, which is no stop


@compiled
def set_bounds(pressure_ratio, m, c, k, s, w):
    """Fill w.low and w.high [n] with the stops of d, 0 for actuators that are not available, and w.d [n] with the d of (29)."""
    for i in range(len(s.r)):
        ratio = effect_ratio(i, pressure_ratio, m)
        used = ratio if k.available[i] else 0.0
        trim = k.trim_effect[i] if k.available[i] else 0.0
        low, high = reach(i, m, c, s)
        w.low[i], w.high[i] = low * used - trim, high * used - trim
        w.d[i] = s.r[i] * ratio - trim


@compiled
def right_hand_side(nu, thrust_first, m, k, w):
    """Fill w.g [n] with B' diag(row_weight) nu, of the normal equations hessian d = g; with `thrust_first` as if the actuators that
    answer to u_dot alone did not turn the aircraft."""
    for i in range(len(w.g)):
        w.g[i] = 0.0
        for row in range(4):
            if row == U_DOT or not (thrust_first and k.thrust_alone[i]):
                w.g[i] += m.B[row, i] * k.row_weight[row] * nu[row]
