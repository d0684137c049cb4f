"""Stuck sensors: a reading that repeats itself exactly is not believed, and what the others say takes its place.

Noise and turbulence change the last digits of every reading that lives. Of a vane or the pitot tube that has not changed for
`REPEATS_S`, or a gyro for `GYRO_REPEATS`, and of a pitot tube whose reading halves in one step, the law takes

* angle of attack from pitch and the path through the air, with the sink of the air as it was known last,
* sideslip from the side force of the design model, the weight of a bank and the turn, about the mode's trim,
* airspeed from the forward acceleration, and in the long run that at which the angle of attack carries the weight; the reference,
  where that angle is not known either,
* rates of rotation, and how fast they change, from the attitude.

These leave out what gusts do to the flow. So while a vane is stuck, that is expected of the model error b (`unseen`), which is made
up for.

Letters: those of `records`; raw is the measured state, and y the one that is believed.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

import math

from testbed.common import angles
from testbed.common.jit import compiled
from testbed.common.signals import GUARDED
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.commands import write_guard
from testbed.controllers.inversion.law import lag_gain, pressure_ratio_of
from testbed.controllers.records import BETA, D_ALPHA, D_BETA, ROLL

REPEATS_S = 0.2
"""How long a reading must be the same to the last digit [s]. A 12 bit vane in calm air repeats itself for less than 0.1 s."""
GYRO_REPEATS = 10
"""How many control steps a gyro must read the same. Its noise is several digits, and a rate that stands still looks like a lost
surface at once."""
LEAST_SHARE = 0.5
"""Airspeed is not believed where it is less than this share of what it was one step before."""
RECALL_S = 10.0
"""Time constant with which the integrated airspeed goes to `airspeed_by_lift` [s]: an accelerometer's bias of 0.1 m/s2 is then
1 m/s. Gusts across the flow, which change the angle of attack, last about as long."""
LEAST_LIFT = 0.25
"""Least lift at V_0 from which airspeed is computed [weights]: less would be more than twice V_0."""
UNSEEN_GUST = 0.76
"""Standard deviation of gusts across the flow [m/s] at W20 = 25 ft/s (MIL-F-8785C, 3.7.3). At 18 m/s they last for 10 s, as the
model error does."""
G_ALPHA, G_BETA, G_AIRSPEED, G_P, G_Q, G_R = range(len(GUARDED))
wrap = compiled(angles.wrap)


@compiled
def believe(step, states, believed, ref, row, m, c, k, s):
    """Fill a step of the channel `believed` from the measured states, and of telemetry, its `row`; returns 1 as `guard` does."""
    believed[step] = states[step]
    if not c.guards:
        return 0
    changed = guard(states[step], ref, believed[step], m, c, k, s)
    write_guard(row, s)
    return changed


@compiled
def guard(raw, ref, y, m, c, k, s):
    """Replace what a copy y of the raw state has from stuck sensors; returns 1 when one is taken for stuck, or lives again."""
    changed = watch(raw, c, s)
    attitude_rates(raw, c, s)
    if s.stuck[G_AIRSPEED] or raw.airspeed < LEAST_SHARE * s.inertial_airspeed:
        known = ref.airspeed if s.stuck[G_ALPHA] else airspeed_by_lift(raw, ref, m)
        s.inertial_airspeed += c.dt * (raw.u_dot + (known - s.inertial_airspeed) / RECALL_S)
        y.airspeed = s.inertial_airspeed
    else:
        s.inertial_airspeed = raw.airspeed
    if s.stuck[G_ALPHA]:
        slope = (raw.climb_rate + s.sink) / max(y.airspeed, 1.0)
        y.alpha = (raw.pitch - slope) / max(math.cos(raw.roll), 0.5)
    if s.stuck[G_P]:
        y.p, y.p_dot = s.lagged_rate[0], s.attitude_dot[0]
    if s.stuck[G_Q]:
        y.q, y.q_dot = s.lagged_rate[1], s.attitude_dot[1]
    if s.stuck[G_R]:
        y.r, y.r_dot = s.lagged_rate[2], s.attitude_dot[2]
    if s.stuck[G_BETA]:
        s.modelled_sideslip += c.dt * sideslip_rate(s.modelled_sideslip, y, m, k)
        y.beta = s.modelled_sideslip
    else:
        s.modelled_sideslip = y.beta
    return changed


@compiled
def airspeed_by_lift(y, ref, m):
    """Airspeed at which the lift of this angle of attack, linear in it, carries the weight in a level turn at this bank [m/s]; the
    reference where the design model has no such lift."""
    weight_angle = m.alpha - m.zero_lift_alpha  # of the lift that is the weight at V_0
    if math.isinf(weight_angle):
        return ref.airspeed
    lift = max((y.alpha - m.zero_lift_alpha) / weight_angle, LEAST_LIFT) * max(math.cos(y.roll), 0.5)
    return m.airspeed / math.sqrt(lift)


@compiled
def sideslip_rate(beta, y, m, k):
    """Rate of change of a sideslip beta in still air [rad/s], v' / V: of the side force and of weight beside what they are at the
    mode's trim, and of the turn of the body axes. What actuators and rates of rotation do to the side force is left out. It also
    fades within `RECALL_S`, so that it does not grow without end where the design model has no side force."""
    speed = max(y.airspeed, 1.0)
    side = pressure_ratio_of(y, m) * m.side_slope * (beta - k.x_trim[BETA])
    weight = GRAVITY_M_S2 * math.cos(y.pitch) * (math.sin(y.roll) - math.sin(k.x_trim[ROLL]))
    turn = y.p * math.sin(y.alpha) - y.r * math.cos(y.alpha)
    return (side + weight) / speed + turn - (beta - k.x_trim[BETA]) / RECALL_S


@compiled
def watch(raw, c, s):
    """Update which sensors are `stuck` by how long each reading has repeated itself; returns 1 when that changed."""
    changed = 0
    readings = (raw.alpha, raw.beta, raw.airspeed, raw.p, raw.q, raw.r)
    for i in range(len(readings)):
        s.repeated[i] = s.repeated[i] + c.dt if readings[i] == s.last_reading[i] else 0.0
        s.last_reading[i] = readings[i]
        stuck = 1 if s.repeated[i] > (REPEATS_S if i < G_P else GYRO_REPEATS * c.dt) else 0
        if stuck != s.stuck[i]:
            s.stuck[i], changed = stuck, 1
    return changed


@compiled
def attitude_rates(raw, c, s):
    """Advance the rates of rotation that the attitude shows, and how fast they change. The rates pass a lag, for the outer loops.
    Their changes do not, since the regression filters them with its other side: with a lag of their own each actuator was late."""
    roll = wrap(raw.roll - s.last_attitude[0]) / c.dt
    pitch = wrap(raw.pitch - s.last_attitude[1]) / c.dt
    turn = wrap(raw.heading - s.last_attitude[2]) / c.dt
    s.last_attitude[0], s.last_attitude[1], s.last_attitude[2] = raw.roll, raw.pitch, raw.heading
    sin, cos, level = math.sin(raw.roll), math.cos(raw.roll), turn * math.cos(raw.pitch)
    rates = (roll - turn * math.sin(raw.pitch), pitch * cos + level * sin, level * cos - pitch * sin)
    gain = lag_gain(c.filter_rate * c.dt)
    for i in range(3):
        s.attitude_dot[i] = (rates[i] - s.attitude_rate[i]) / c.dt
        s.attitude_rate[i] = rates[i]
        s.lagged_rate[i] += gain * (rates[i] - s.lagged_rate[i])


@compiled
def vane_is_stuck(s):
    """Whether angle of attack or sideslip is not measured."""
    return s.stuck[G_ALPHA] or s.stuck[G_BETA]


@compiled
def unseen(row, m, s):
    """Variance of what gusts do to a rate by the angles that are not measured [x_c^2]; 0 while both vanes live."""
    variance = 0.0
    for stuck, column in ((s.stuck[G_ALPHA], D_ALPHA), (s.stuck[G_BETA], D_BETA)):
        if stuck:
            effect = m.A[row, column] * UNSEEN_GUST / m.airspeed
            variance += effect * effect
    return variance
