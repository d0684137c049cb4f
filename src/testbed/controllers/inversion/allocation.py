"""Allocation: from the virtual control nu to actuator positions within the stops, and to the commands for them.

The paper inverts (29) and compensates (section 2.2.1). Added here is what to do when an actuator would pass its stop: of all
positions within the stops, those are taken whose rates are closest to nu, by weighted least squares. So the others make up for an
actuator at its stop as far as they can. Where they cannot, the weights (`control.allocation` of the aircraft) say which axis gives
way: airspeed before attitude.

The least squares within bounds are solved by an active-set method (Harkegard, IEEE CDC 2002, 1295; Bodson, J. Guidance 25 (2002)
703; Bodson and Frost, J. Guidance 34 (2011) 409). It minimises 1/2 d'H d - g'd with low <= d <= high, where H is positive
definite. In each iteration the variables in the active set stand at a bound, and the others solve the remaining equations. If
these pass a bound, the step ends at the first bound that it meets, and that variable becomes active. Otherwise, of the active
variables, the one whose bound costs most is freed. When no bound costs anything, the minimum is reached: for a strictly convex
function this takes finitely many iterations.

The start is the result of the step before (warm start): from one control step to the next the active set seldom changes.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common.jit import compiled
from testbed.controllers.commands import command_actuators
from testbed.controllers.inversion.law import compensate, effect_ratio, invert, reach
from testbed.controllers.records import Q_DOT

MOST_ITERATIONS = 200
"""Far more than are needed: with 12 variables, at most about 40 were seen. A loop without an end must not fly."""
ROUNDING = 1e-12
"""Cost of a bound, in units of the largest term that it is the sum of, which is taken for rounding."""


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
    s.saturated, s.pitch_beyond_stop = passes_a_stop(m, c, k, s), 0.0
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

    Because d is the effective deviation, a weak actuator has lambda_hat times its travel.
    """
    set_bounds(pressure_ratio, m, c, k, s, w)
    right_hand_side(nu, m, k, w)
    bounded_least_squares(k.hessian, w.g, w.low, w.high, w.d, s.at_stop, w.factor, w.step)
    s.pitch_beyond_stop = beyond_stop(Q_DOT, nu, m, k, s, w)
    for i in range(len(s.r)):
        s.r[i] = (k.trim_effect[i] + w.d[i]) / effect_ratio(i, pressure_ratio, m)


@compiled
def beyond_stop(row, nu, m, k, s, w):
    """What the positions within the stops leave of one rate's virtual control, if the surface with the most effect on that rate
    is at its stop and would have to go beyond; else 0: the least squares leave a little of each rate for another's sake."""
    strongest, effect, left = -1, 0.0, nu[row]
    for i in range(len(s.r)):
        left -= m.B[row, i] * w.d[i]
        if m.servo[i] and k.available[i] and abs(m.B[row, i]) > abs(effect):
            strongest, effect = i, m.B[row, i]
    if strongest < 0 or k.row_weight[row] == 0.0 or s.at_stop[strongest] * effect * left <= 0.0:
        return 0.0
    return left


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
def right_hand_side(nu, m, k, w):
    """Fill w.g [n] with B' diag(row_weight) nu, of the normal equations hessian d = g."""
    for i in range(len(w.g)):
        w.g[i] = 0.0
        for row in range(4):
            w.g[i] += m.B[row, i] * k.row_weight[row] * nu[row]


@compiled
def bounded_least_squares(H, g, low, high, d, at_bound, factor, step):
    """Fill `d` with the minimum, and `at_bound` with its active set.

    Args:
        H: [n, n] positive definite matrix.
        g: [n] right-hand side.
        low, high: [n] bounds; an equal pair fixes its variable.
        d: [n] start, which is first brought within the bounds; then the result.
        at_bound: [n] -1 at the lower bound, 1 at the upper, 0 between; of the start, then of the result.
        factor: [n, n] working memory.
        step: [n] working memory.
    """
    bring_within(low, high, d, at_bound)
    for _ in range(MOST_ITERATIONS):
        solve_for_free(H, g, d, at_bound, factor, step)
        if advance(low, high, d, at_bound, step) and release_costliest(H, g, low, high, d, at_bound) == 0:
            return


@compiled
def bring_within(low, high, d, at_bound):
    """Put active variables at their bounds, and the others within theirs."""
    for i in range(len(d)):
        if low[i] >= high[i] or at_bound[i] < 0:
            d[i], at_bound[i] = low[i], -1
        elif at_bound[i] > 0:
            d[i] = high[i]
        else:
            d[i] = min(max(d[i], low[i]), high[i])


@compiled
def solve_for_free(H, g, d, at_bound, factor, step):
    """Fill `step` with the change of the free variables that minimises the function while the active ones stay: a Cholesky
    factorisation of the free rows and columns of H, in place (active ones get a row and column of the unit matrix)."""
    n = len(d)
    for i in range(n):
        step[i] = 0.0 if at_bound[i] else g[i]
        for j in range(n):
            if at_bound[i] == 0:
                step[i] -= H[i, j] * d[j]
        for j in range(i + 1):
            free = at_bound[i] == 0 and at_bound[j] == 0
            value = H[i, j] if free else (1.0 if i == j else 0.0)
            for k in range(j):
                value -= factor[i, k] * factor[j, k]
            factor[i, j] = math.sqrt(value) if i == j else value / factor[j, j]
    for i in range(n):
        for k in range(i):
            step[i] -= factor[i, k] * step[k]
        step[i] /= factor[i, i]
    for i in range(n - 1, -1, -1):
        for k in range(i + 1, n):
            step[i] -= factor[k, i] * step[k]
        step[i] /= factor[i, i]


@compiled
def advance(low, high, d, at_bound, step):
    """Take the step as far as the first bound that it meets; returns whether it met none."""
    share, first = 1.0, -1
    for i in range(len(d)):
        if at_bound[i] == 0 and step[i] != 0.0:
            room = (high[i] - d[i] if step[i] > 0.0 else low[i] - d[i]) / step[i]
            if room < share:
                share, first = max(room, 0.0), i
    for i in range(len(d)):
        d[i] += share * step[i]
    if first < 0:
        return True
    up = step[first] > 0.0
    d[first], at_bound[first] = (high[first], 1) if up else (low[first], -1)
    return False


@compiled
def release_costliest(H, g, low, high, d, at_bound):
    """Free the active variable whose bound costs most; returns 0 if no bound costs anything."""
    costliest, most = -1, 0.0
    for i in range(len(d)):
        if at_bound[i] == 0 or low[i] >= high[i]:
            continue
        slope, size = -g[i], abs(g[i])
        for j in range(len(d)):
            slope += H[i, j] * d[j]
            size = max(size, abs(H[i, j] * d[j]))
        cost = at_bound[i] * slope  # above zero where the function falls towards the inside
        if cost > most and cost > ROUNDING * size:
            costliest, most = i, cost
    if costliest < 0:
        return 0
    at_bound[costliest] = 0
    return 1
